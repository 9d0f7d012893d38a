function adapter(vectors, answers)
% Answers the cases of `beamgap export` with your own element.
%
%     beamgap export --family segment -o vectors.jsonl
%     beamgap verify vectors.jsonl --run "octave-cli --eval adapter"
%     beamgap verify vectors.jsonl --run "matlab -batch adapter"
%
% With two arguments, adapter('vectors.jsonl', 'answers.jsonl') reads and writes files.
%
% This program is for two straight beams, the family `segment`. For yours, change
% 1. family, the name of the family,
% 2. `element`, and what is printed of it,
% 3. head: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
family = 'segment';
head = '{"schema":"beamgap-answers/1","program":"adapter.m","only":["d","xi:first","xi_bar:first"]}';
if nargin == 2
    from = fopen(vectors, 'r');
    to = fopen(answers, 'w');
elseif exist('OCTAVE_VERSION', 'builtin')
    from = stdin;
    to = stdout;
else
    from = fopen('/dev/stdin', 'r');
    to = 1;
end
fgetl(from);  % the head of the cases
fprintf(to, '%s\n', head);
line = fgetl(from);
while ischar(line)
    one = jsondecode(line);
    for name = {one.beam.family, one.bar.family}
        if ~strcmp(name{1}, family)
            error('adapter.m is for the family %s; a case is of the family %s. Change family and element.', family, name{1});
        end
    end
    if strcmp(one.result, 'valid')
        [d, gradient, hessian, g, g_bar] = element([one.beam.q; one.bar.q], one.point.xi, one.point.xi_bar, one.held);
        fprintf(to, '{"id":"%s","d":{"value":%.17g,"gradient":%s,"hessian":%s},', one.id, d, list(gradient), list(hessian'));
        fprintf(to, '"xi":{"gradient":%s},"xi_bar":{"gradient":%s}}\n', list(g), list(g_bar));
    else
        fprintf(to, '{"id":"%s","result":"degenerate"}\n', one.id);  % the case has no regular closest point
    end
    if exist('OCTAVE_VERSION', 'builtin')
        fflush(to);
    end
    line = fgetl(from);
end
if nargin == 2
    fclose(from);
    fclose(to);
end
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
