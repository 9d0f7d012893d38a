# Answers the cases of `beamgap export --element` with your own contact element with friction.
#
#     beamgap export --element --family segment -o vectors.jsonl
#     beamgap verify vectors.jsonl --run "julia contact.jl"
#
# This program is for two straight beams, the family `segment`. For yours, change
# 1. FAMILY, the name of the family,
# 2. `element`, and what `main` prints of it,
# 3. HEAD: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
#
# Equation numbers are those of Zavarise (2007). The other formulas are in docs/contact-element.md.
using LinearAlgebra

const FAMILY = "segment"
const HEAD = """{"schema":"beamgap-answers/1","program":"contact.jl","only":["residual","tangent"]}"""

"Laws: F_N, and k = -dF_N/dg_N."
function normal_law(data, gap)
    eps = data.eps_N
    if data.law == "lpqp" && gap > 0
        rest = max(data.g_0 - gap, 0.0)
        return eps * rest^2 / (2 * data.g_0), eps * rest / data.g_0
    end
    force = data.lambda + eps * data.g_0 / 2 - eps * gap
    return force > 0 ? (force, eps) : (0.0, 0.0)
end

"""
YOUR ELEMENT. Here: two straight beams, 12 dofs; t,xi and all that has it is zero.

q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1].
held: the parameters that are held at an end of their beam: none, xi, xi_bar or both.
radii: r + r_bar. data: law, eps_T, mu, work and history.
"""
function element(q, xi, xi_bar, held, radii, data)
    # Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar.
    shapes = [1 - xi, 1 + xi, -(1 - xi_bar), -(1 + xi_bar)] / 2
    slopes, slopes_bar = [-0.5, 0.5, 0.0, 0.0], [0.0, 0.0, -0.5, 0.5]
    points = reshape(q, 3, 4)
    d, t, t_bar = points * shapes, points * slopes, points * slopes_bar
    # The gradient of w . delta u for a vector w. That of d is along G, those of t and t_bar are along A1 and B1.
    along(of, w) = vec(w * of')
    A1(w) = along(slopes, w)
    B1(w) = along(slopes_bar, w)
    both(v, w) = v * w' + w * v'
    blocks(of, with) = kron(of * with', I(3))

    # Geometry. Eq. (50) and (52), reduced to one equation or none if parameters are held at an end.
    a, b, a_bar = dot(t, t), dot(t, t_bar), -dot(t_bar, t_bar)
    inverse = zeros(2, 2)
    if held == "none"
        inverse = [a_bar b; -b a] / (a * a_bar + b^2)
    elseif held == "xi"
        inverse[2, 2] = 1 / a_bar
    elseif held == "xi_bar"
        inverse[1, 1] = 1 / a
    end
    Gt, Gt_bar = along(shapes, t), along(shapes, t_bar)
    r, r_bar = -Gt - A1(d), -Gt_bar - B1(d)
    g, g_bar = inverse[1, 1] * r + inverse[1, 2] * r_bar, inverse[2, 1] * r + inverse[2, 2] * r_bar
    # n = d/|d|; t x t_bar has the same direction, also where the beams cross. It keeps the side of the last step.
    side = held == "none" ? cross(t, t_bar) : d
    before = data.normal === nothing ? d : data.normal
    n = (dot(side, before) < 0 ? -side : side) / norm(side)
    d_s = dot(n, d)
    grad_gap, A1n, B1n = along(shapes, n), A1(n), B1(n)  # eq. (37)

    # Normal. The Hessian of the gap: eq. (40), or if both parameters are free a form that also holds at d = 0.
    F_N, k = normal_law(data, d_s - radii)
    grad_F_N = -k * grad_gap
    if held == "none"
        turned = inverse[1, 1] * A1n * A1n' + inverse[1, 2] * both(A1n, B1n) - inverse[2, 2] * B1n * B1n'
        H_gap = both(A1n, g) - both(B1n, g_bar) + d_s * turned
    else
        moved = Gt * g' - Gt_bar * g_bar'
        H_gap = (blocks(shapes, shapes) + moved - grad_gap * grad_gap') / d_s + A1n * g' - B1n * g_bar'
    end
    R = -F_N * grad_gap
    K = k * grad_gap * grad_gap' - F_N * H_gap
    slips = data.slips
    if F_N == 0 || data.mu == 0 || slips === nothing || held == "both"
        return F_N == 0 ? "open" : "frictionless", F_N, 0.0, 0.0, R, K
    end

    # Slip, eq. (15) and (20), and trial.
    abs_t, abs_t_bar = norm(t), norm(t_bar)
    tau, tau_bar = t / abs_t, t_bar / abs_t_bar
    c = dot(tau, tau_bar)
    u = held == "xi" ? 0.0 : xi - slips.xi
    u_bar = held == "xi_bar" ? 0.0 : xi_bar - slips.xi_bar
    e_n, e_bar_n = slips.e, slips.e_bar
    if held != "none" && held != slips.held  # a parameter that becomes held loses its part
        was_free = slips.held == "none"
        e_n = was_free && held == "xi_bar" ? slips.e - slips.cosine * slips.e_bar : 0.0
        e_bar_n = was_free && held == "xi" ? slips.e_bar - slips.cosine * slips.e : 0.0
    end
    e, e_bar = e_n + abs_t * u, e_bar_n + abs_t_bar * u_bar
    s = e * tau - e_bar * tau_bar
    gamma = norm(s)
    l = held == "xi" ? 0.0 : dot(s, tau)  # e - c e_bar
    l_bar = held == "xi_bar" ? 0.0 : -dot(s, tau_bar)  # e_bar - c e
    grad_t, grad_t_bar = A1(tau), B1(tau_bar)
    grad_e, grad_e_bar = abs_t * g + u * grad_t, abs_t_bar * g_bar + u_bar * grad_t_bar
    grad_c = A1(tau_bar - c * tau) / abs_t + B1(tau - c * tau_bar) / abs_t_bar
    grad_l = grad_e - c * grad_e_bar - e_bar * grad_c
    grad_l_bar = grad_e_bar - c * grad_e - e * grad_c

    # Return to the cone.
    state, rho, grad_rho = "stick", 1.0, zeros(12)
    if data.eps_T * gamma > data.mu * F_N
        state, rho = "slip", data.mu * F_N / (data.eps_T * gamma)
        grad_gamma = (l * grad_e + l_bar * grad_e_bar - e * e_bar * grad_c) / gamma
        grad_rho = data.mu / (data.eps_T * gamma) * grad_F_N - rho / gamma * grad_gamma
    end
    F, F_bar = data.eps_T * rho * l, data.eps_T * rho * l_bar
    grad_F = data.eps_T * (rho * grad_l + l * grad_rho)
    grad_F_bar = data.eps_T * (rho * grad_l_bar + l_bar * grad_rho)

    # Work. The derivatives of eq. (50), solved as eq. (52).
    grad_a, grad_b, grad_a_bar = 2 * A1(t), A1(t_bar) + B1(t), -2 * B1(t_bar)
    H_r = -blocks(shapes, slopes) - blocks(slopes, shapes) - both(grad_a, g) + both(grad_b, g_bar)
    H_r_bar = -blocks(shapes, slopes_bar) - blocks(slopes_bar, shapes) - both(grad_b, g) - both(grad_a_bar, g_bar)
    H_xi = inverse[1, 1] * H_r + inverse[1, 2] * H_r_bar
    H_xi_bar = inverse[2, 1] * H_r + inverse[2, 2] * H_r_bar
    A, A_bar = abs_t * g, abs_t_bar * g_bar
    H_A = g * grad_t' + abs_t * H_xi
    H_A_bar = g_bar * grad_t_bar' + abs_t_bar * H_xi_bar
    if data.work == "paper"  # A = grad g_T
        A += u * grad_t
        A_bar += u_bar * grad_t_bar
        H_A += grad_t * g' + u / abs_t * (blocks(slopes, slopes) - grad_t * grad_t')
        H_A_bar += grad_t_bar * g_bar' + u_bar / abs_t_bar * (blocks(slopes_bar, slopes_bar) - grad_t_bar * grad_t_bar')
    end
    R += F * A + F_bar * A_bar
    K += A * grad_F' + A_bar * grad_F_bar' + F * H_A + F_bar * H_A_bar
    return state, F_N, F, F_bar, R, K
end

numbers(text) = parse.(Float64, split(text, ','))
list(row) = "[" * join(row, ",") * "]"
# The first word, number or list after a key.
word(text, key) = match(Regex("\"$key\":\"([^\"]*)\""), text)[1]
number(text, key) = parse(Float64, match(Regex("\"$key\":([^,}]*)"), text)[1])

"Parameters and history of an element, from the text after its key."
function read_element(text)
    law = word(text, "law")
    g_0 = law == "lpqp" ? number(text, "g_0") : 0.0
    lambda = law == "augmented" ? number(text, "lambda") : 0.0
    normal = match(r"\"normal\":\[([^]]*)\]", text)
    at_slips = match(r"\"slips\":(null|\{[^}]*\})", text)[1]
    slips = at_slips == "null" ? nothing :
            (xi=number(at_slips, "xi"), xi_bar=number(at_slips, "xi_bar"), e=number(at_slips, "e"),
             e_bar=number(at_slips, "e_bar"), cosine=number(at_slips, "cosine"), held=word(at_slips, "held"))
    return (law=law, eps_N=number(text, "eps_N"), g_0=g_0, lambda=lambda, eps_T=number(text, "eps_T"),
            mu=number(text, "mu"), work=word(text, "work"),
            normal=normal === nothing ? nothing : numbers(normal[1]), slips=slips)
end

function main()
    readline()  # the head of the cases
    println(HEAD)
    for line in eachline()
        id = word(line, "id")
        beams = match(r"\"beam\":\{\"family\":\"([a-z-]*)\".*?\"q\":\[([^]]*)\].*\"bar\":\{\"family\":\"([a-z-]*)\".*?\"q\":\[([^]]*)\]", line)
        for family in (beams[1], beams[3])
            family == FAMILY || error("contact.jl is for the family $FAMILY; a case is of the family $family. Change FAMILY and element.")
        end
        point = match(r"\"point\":\{\"xi\":([^,]*),\"xi_bar\":([^}]*)\}.*?\"held\":\"([a-z_]*)\"", line)
        if point === nothing
            println("{\"id\":\"$id\",\"result\":\"degenerate\"}")  # the case has no regular closest point
        else
            parts = split(line, "\"element\":"; limit=2)
            length(parts) == 2 || error("contact.jl: a case has no element. Write the cases with `beamgap export --element`.")
            q = vcat(numbers(beams[2]), numbers(beams[4]))
            radii = number(line, "radius") + number(line, "radius_bar")
            state, F_N, F, F_bar, R, K =
                element(q, parse(Float64, point[1]), parse(Float64, point[2]), point[3], radii, read_element(parts[2]))
            println("{\"id\":\"$id\",\"state\":\"$state\",\"F_N\":$F_N,\"F\":$F,\"F_bar\":$F_bar,",
                "\"residual\":$(list(R)),\"tangent\":$(list(permutedims(K)))}")
        end
        flush(stdout)
    end
end

main()
