# Answers the cases of `beamgap export` with your own element.
#
#     beamgap export --family segment -o vectors.jsonl
#     beamgap verify vectors.jsonl --run "julia adapter.jl"
#
# This program is for two straight beams, the family `segment`. For yours, change
# 1. FAMILY, the name of the family,
# 2. `element`, and what `main` prints of it,
# 3. HEAD: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
using LinearAlgebra

const FAMILY = "segment"
const HEAD = """{"schema":"beamgap-answers/1","program":"adapter.jl","only":["d","xi:first","xi_bar:first"]}"""

"""
YOUR ELEMENT. Here: two straight beams, 12 dofs, by the equations of Zavarise (2007).

q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1].
held: the parameters that are held at an end of their beam: none, xi, xi_bar or both.
"""
function element(q, xi, xi_bar, held)
    # Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar.
    shapes = [1 - xi, 1 + xi, -(1 - xi_bar), -(1 + xi_bar)] / 2
    slopes, slopes_bar = [-0.5, 0.5, 0.0, 0.0], [0.0, 0.0, -0.5, 0.5]
    points = reshape(q, 3, 4)
    d, t, t_bar = points * shapes, points * slopes, points * slopes_bar
    # The gradient of w . delta u for a vector w.
    along(of, w) = vec(w * of')
    len = norm(d)
    gradient = along(shapes, d / len)  # eq. (37)
    A1d, B1d, Gt, Gt_bar = along(slopes, d), along(slopes_bar, d), along(shapes, t), along(shapes, t_bar)
    # Eq. (50) and (52), reduced to one equation or none if parameters are held at an end.
    r, r_bar = -Gt - A1d, -Gt_bar - B1d
    a, b, a_bar = dot(t, t), dot(t, t_bar), -dot(t_bar, t_bar)
    det = a * a_bar + b * b
    g, g_bar = zeros(12), zeros(12)
    if held == "none"
        g, g_bar = (a_bar * r + b * r_bar) / det, (-b * r + a * r_bar) / det
    elseif held == "xi"
        g_bar = r_bar / a_bar
    elseif held == "xi_bar"
        g = r / a
    end
    # Eq. (40).
    moved, turned = Gt * g' - Gt_bar * g_bar', A1d * g' - B1d * g_bar'
    hessian = (kron(shapes * shapes', I(3)) + moved + turned - gradient * gradient') / len
    return len, gradient, hessian, g, g_bar
end

numbers(text) = parse.(Float64, split(text, ','))
list(row) = "[" * join(row, ",") * "]"

function main()
    readline()  # the head of the cases
    println(HEAD)
    for line in eachline()
        id = match(r"\"id\":\"([^\"]*)\"", line)[1]
        beams = match(r"\"beam\":\{\"family\":\"([a-z-]*)\".*?\"q\":\[([^]]*)\].*\"bar\":\{\"family\":\"([a-z-]*)\".*?\"q\":\[([^]]*)\]", line)
        for family in (beams[1], beams[3])
            family == FAMILY || error("adapter.jl is for the family $FAMILY; a case is of the family $family. Change FAMILY and element.")
        end
        point = match(r"\"point\":\{\"xi\":([^,]*),\"xi_bar\":([^}]*)\}.*\"held\":\"([a-z_]*)\"", line)
        if point === nothing
            println("{\"id\":\"$id\",\"result\":\"degenerate\"}")  # the case has no regular closest point
        else
            q = vcat(numbers(beams[2]), numbers(beams[4]))
            len, gradient, hessian, g, g_bar = element(q, parse(Float64, point[1]), parse(Float64, point[2]), point[3])
            println("{\"id\":\"$id\",\"d\":{\"value\":$len,\"gradient\":$(list(gradient)),\"hessian\":$(list(vec(hessian')))},",
                "\"xi\":{\"gradient\":$(list(g))},\"xi_bar\":{\"gradient\":$(list(g_bar))}}")
        end
        flush(stdout)
    end
end

main()
