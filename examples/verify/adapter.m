function adapter(vectors, answers)
% Answers the cases of `beamgap export` with your own element.
%
%     beamgap export --family segment -o vectors.jsonl
%     matlab -batch "adapter('vectors.jsonl', 'answers.jsonl')"
%     beamgap verify vectors.jsonl answers.jsonl
%
% Replace `element` by yours. Omit quantities that you do not compute: they are reported as not answered.
from = fopen(vectors, 'r');
to = fopen(answers, 'w');
fgetl(from);  % the head of the cases
% Declare here each convention that differs, such as "parameter":"[0,1]" (beamgap schema answers).
fprintf(to, '{"schema":"beamgap-answers/1","program":"adapter.m"}\n');
line = fgetl(from);
while ischar(line)
    one = jsondecode(line);
    if strcmp(one.result, 'valid') && strcmp(one.beam.family, 'segment') && strcmp(one.bar.family, 'segment')
        [d, gradient, hessian, g, g_bar] = element([one.beam.q; one.bar.q], one.point.xi, one.point.xi_bar, one.held);
        fprintf(to, '{"id":"%s","d":{"value":%.17g,"gradient":%s,"hessian":%s},', one.id, d, list(gradient), list(hessian'));
        fprintf(to, '"xi":{"gradient":%s},"xi_bar":{"gradient":%s}}\n', list(g), list(g_bar));
    else
        fprintf(to, '{"id":"%s","result":"degenerate"}\n', one.id);  % not answered
    end
    line = fgetl(from);
end
fclose(from);
fclose(to);
end

function [len, gradient, hessian, g, g_bar] = element(q, xi, xi_bar, held)
% YOUR ELEMENT. Here: two straight beams, 12 dofs, by the equations of Zavarise (2007).
%
% q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1].
% held: the parameters that are held at an end of their beam: none, xi, xi_bar or both.

% Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar.
shapes = [1 - xi; 1 + xi; -(1 - xi_bar); -(1 + xi_bar)] / 2;
slopes = [-0.5; 0.5; 0; 0];
slopes_bar = [0; 0; -0.5; 0.5];
points = reshape(q, 3, 4);
d = points * shapes;
t = points * slopes;
t_bar = points * slopes_bar;
% The gradient of w . delta u for a vector w.
along = @(of, w) reshape(w * of', 12, 1);
len = norm(d);
gradient = along(shapes, d / len);  % eq. (37)
A1d = along(slopes, d);
B1d = along(slopes_bar, d);
Gt = along(shapes, t);
Gt_bar = along(shapes, t_bar);
% Eq. (50) and (52), reduced to one equation or none if parameters are held at an end.
r = -Gt - A1d;
r_bar = -Gt_bar - B1d;
a = dot(t, t);
b = dot(t, t_bar);
a_bar = -dot(t_bar, t_bar);
det = a * a_bar + b * b;
g = zeros(12, 1);
g_bar = zeros(12, 1);
switch held
    case 'none'
        g = (a_bar * r + b * r_bar) / det;
        g_bar = (-b * r + a * r_bar) / det;
    case 'xi'
        g_bar = r_bar / a_bar;
    case 'xi_bar'
        g = r / a;
end
% Eq. (40).
moved = Gt * g' - Gt_bar * g_bar';
turned = A1d * g' - B1d * g_bar';
hessian = (kron(shapes * shapes', eye(3)) + moved + turned - gradient * gradient') / len;
end

function text = list(numbers)
text = ['[', strjoin(arrayfun(@(x) sprintf('%.17g', x), numbers(:)', 'UniformOutput', false), ','), ']'];
end
