function contact(vectors, answers)
% Answers the cases of `beamgap export --element` with your own contact element with friction.
%
%     beamgap export --element --family segment -o vectors.jsonl
%     beamgap verify vectors.jsonl --run "octave-cli --eval contact"
%     beamgap verify vectors.jsonl --run "matlab -batch contact"
%
% With two arguments, contact('vectors.jsonl', 'answers.jsonl') reads and writes files.
%
% This program is for two straight beams, the family `segment`. For yours, change
% 1. family, the name of the family,
% 2. `element`, and what is printed of it,
% 3. head: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
%
% Equation numbers are those of Zavarise (2007). The other formulas are in docs/contact-element.md.
family = 'segment';
head = '{"schema":"beamgap-answers/1","program":"contact.m","only":["residual","tangent"]}';
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
            error('contact.m is for the family %s; a case is of the family %s. Change family and element.', family, name{1});
        end
    end
    if strcmp(one.result, 'valid')
        if ~isfield(one, 'element')
            error('contact.m: a case has no element. Write the cases with `beamgap export --element`.');
        end
        radii = one.contact.radius + one.contact.radius_bar;
        [state, forces, R, K] = element([one.beam.q; one.bar.q], one.point.xi, one.point.xi_bar, ...
            one.held, radii, one.element);
        fprintf(to, '{"id":"%s","state":"%s","F_N":%.17g,"F":%.17g,"F_bar":%.17g,', one.id, state, forces);
        fprintf(to, '"residual":%s,"tangent":%s}\n', list(R), list(K'));
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

function [state, forces, R, K] = element(q, xi, xi_bar, held, radii, data)
% YOUR ELEMENT. Here: two straight beams, 12 dofs; t,xi and all that has it is zero.
%
% q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1].
% held: the parameters that are held at an end of their beam: none, xi, xi_bar or both.
% radii: r + r_bar. data: law, eps_T, mu, work and history. forces: F_N, F, F_bar.

% Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar.
shapes = [1 - xi; 1 + xi; -(1 - xi_bar); -(1 + xi_bar)] / 2;
slopes = [-0.5; 0.5; 0; 0];
slopes_bar = [0; 0; -0.5; 0.5];
points = reshape(q, 3, 4);
d = points * shapes;
t = points * slopes;
t_bar = points * slopes_bar;
% The gradient of w . delta u for a vector w. That of d is along G, those of t and t_bar are along A1 and B1.
along = @(of, w) reshape(w * of', 12, 1);
A1 = @(w) along(slopes, w);
B1 = @(w) along(slopes_bar, w);
both = @(v, w) v * w' + w * v';
blocks = @(of, with) kron(of * with', eye(3));

% Geometry. Eq. (50) and (52), reduced to one equation or none if parameters are held at an end.
a = dot(t, t);
b = dot(t, t_bar);
a_bar = -dot(t_bar, t_bar);
inverse = zeros(2);
switch held
    case 'none'
        inverse = [a_bar, b; -b, a] / (a * a_bar + b^2);
    case 'xi'
        inverse(2, 2) = 1 / a_bar;
    case 'xi_bar'
        inverse(1, 1) = 1 / a;
end
Gt = along(shapes, t);
Gt_bar = along(shapes, t_bar);
r = -Gt - A1(d);
r_bar = -Gt_bar - B1(d);
g = inverse(1, 1) * r + inverse(1, 2) * r_bar;
g_bar = inverse(2, 1) * r + inverse(2, 2) * r_bar;
% n = d/|d|; t x t_bar has the same direction, also where the beams cross. It keeps the side of the last step.
n = d / norm(d);
if strcmp(held, 'none')
    n = cross(t, t_bar) / norm(cross(t, t_bar));
end
before = data.history.normal;
if isempty(before)
    before = d;
end
if dot(n, before) < 0
    n = -n;
end
d_s = dot(n, d);
grad_gap = along(shapes, n);  % eq. (37)
A1n = A1(n);
B1n = B1(n);

% Normal.
[F_N, k] = normal_law(data, d_s - radii);
grad_F_N = -k * grad_gap;
% The Hessian of the gap: eq. (40), or if both parameters are free a form that also holds at d = 0.
if strcmp(held, 'none')
    turned = inverse(1, 1) * (A1n * A1n') + inverse(1, 2) * both(A1n, B1n) - inverse(2, 2) * (B1n * B1n');
    H_gap = both(A1n, g) - both(B1n, g_bar) + d_s * turned;
else
    moved = Gt * g' - Gt_bar * g_bar';
    H_gap = (blocks(shapes, shapes) + moved - grad_gap * grad_gap') / d_s + A1n * g' - B1n * g_bar';
end
R = -F_N * grad_gap;
K = k * (grad_gap * grad_gap') - F_N * H_gap;
forces = [F_N, 0, 0];
slips = data.history.slips;
state = 'frictionless';
if F_N == 0
    state = 'open';
end
if F_N == 0 || data.mu == 0 || isempty(slips) || strcmp(held, 'both')
    return
end

% Slip, eq. (15) and (20), and trial.
abs_t = norm(t);
abs_t_bar = norm(t_bar);
tau = t / abs_t;
tau_bar = t_bar / abs_t_bar;
c = dot(tau, tau_bar);
u = (xi - slips.xi) * ~strcmp(held, 'xi');
u_bar = (xi_bar - slips.xi_bar) * ~strcmp(held, 'xi_bar');
e = slips.e;
e_bar = slips.e_bar;
if ~any(strcmp(held, {'none', slips.held}))
    % A parameter that becomes held loses its part.
    e = (slips.e - slips.cosine * slips.e_bar) * (strcmp(slips.held, 'none') && strcmp(held, 'xi_bar'));
    e_bar = (slips.e_bar - slips.cosine * slips.e) * (strcmp(slips.held, 'none') && strcmp(held, 'xi'));
end
e = e + abs_t * u;
e_bar = e_bar + abs_t_bar * u_bar;
s = e * tau - e_bar * tau_bar;
gamma = norm(s);
l = dot(s, tau) * ~strcmp(held, 'xi');  % e - c e_bar
l_bar = -dot(s, tau_bar) * ~strcmp(held, 'xi_bar');  % e_bar - c e
grad_t = A1(tau);
grad_t_bar = B1(tau_bar);
grad_e = abs_t * g + u * grad_t;
grad_e_bar = abs_t_bar * g_bar + u_bar * grad_t_bar;
grad_c = A1(tau_bar - c * tau) / abs_t + B1(tau - c * tau_bar) / abs_t_bar;
grad_l = grad_e - c * grad_e_bar - e_bar * grad_c;
grad_l_bar = grad_e_bar - c * grad_e - e * grad_c;

% Return to the cone.
state = 'stick';
rho = 1;
grad_rho = zeros(12, 1);
if data.eps_T * gamma > data.mu * F_N
    state = 'slip';
    rho = data.mu * F_N / (data.eps_T * gamma);
    grad_gamma = (l * grad_e + l_bar * grad_e_bar - e * e_bar * grad_c) / gamma;
    grad_rho = data.mu / (data.eps_T * gamma) * grad_F_N - rho / gamma * grad_gamma;
end
F = data.eps_T * rho * l;
F_bar = data.eps_T * rho * l_bar;
grad_F = data.eps_T * (rho * grad_l + l * grad_rho);
grad_F_bar = data.eps_T * (rho * grad_l_bar + l_bar * grad_rho);
forces = [F_N, F, F_bar];

% Work. The derivatives of eq. (50), solved as eq. (52).
grad_a = 2 * A1(t);
grad_b = A1(t_bar) + B1(t);
grad_a_bar = -2 * B1(t_bar);
r = -blocks(shapes, slopes) - blocks(slopes, shapes) - both(grad_a, g) + both(grad_b, g_bar);
r_bar = -blocks(shapes, slopes_bar) - blocks(slopes_bar, shapes) - both(grad_b, g) - both(grad_a_bar, g_bar);
H_xi = inverse(1, 1) * r + inverse(1, 2) * r_bar;
H_xi_bar = inverse(2, 1) * r + inverse(2, 2) * r_bar;
A = abs_t * g;
A_bar = abs_t_bar * g_bar;
H_A = g * grad_t' + abs_t * H_xi;
H_A_bar = g_bar * grad_t_bar' + abs_t_bar * H_xi_bar;
if strcmp(data.work, 'paper')
    % A = grad g_T.
    A = A + u * grad_t;
    A_bar = A_bar + u_bar * grad_t_bar;
    H_A = H_A + grad_t * g' + u * (blocks(slopes, slopes) - grad_t * grad_t') / abs_t;
    H_A_bar = H_A_bar + grad_t_bar * g_bar' + u_bar * (blocks(slopes_bar, slopes_bar) - grad_t_bar * grad_t_bar') / abs_t_bar;
end
R = R + F * A + F_bar * A_bar;
K = K + A * grad_F' + A_bar * grad_F_bar' + F * H_A + F_bar * H_A_bar;
end

function [F_N, k] = normal_law(data, gap)
% Laws: F_N, and k = -dF_N/dg_N.
k = data.eps_N;
F_N = -k * gap;
switch data.law
    case 'augmented'
        F_N = data.lambda - k * gap;
    case 'lpqp'
        F_N = k * (data.g_0 / 2 - gap);
        if gap > 0
            rest = max(data.g_0 - gap, 0);
            F_N = k * rest^2 / (2 * data.g_0);
            k = k * rest / data.g_0;
        end
end
if F_N <= 0
    F_N = 0;
    k = 0;
end
end

function text = list(numbers)
text = ['[', strjoin(arrayfun(@(x) sprintf('%.17g', x), numbers(:)', 'UniformOutput', false), ','), ']'];
end
