// Answers the cases of `beamgap export --element` with your own contact element with friction.
//
//     beamgap export --element --family segment -o vectors.jsonl
//     c++ -O2 -std=c++17 contact.cpp -o contact
//     beamgap verify vectors.jsonl --run ./contact
//
// This program is for two straight beams, the family `segment`. For yours, change
// 1. `family` and `beam_dofs`, the name of the family and its dofs a beam,
// 2. `element`,
// 3. `head`: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
//
// Equation numbers are those of Zavarise (2007). The other formulas are in docs/contact-element.md.
#include <array>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>

const std::string family = "segment";
const char *const head = R"({"schema":"beamgap-answers/1","program":"contact.cpp","only":["residual","tangent"]})";
constexpr int beam_dofs = 6, dofs = 2 * beam_dofs;
using Vector = std::array<double, 3>;
using Shapes = std::array<double, 4>;
using Row = std::array<double, dofs>;

// Parameters and history. Numbers that a case does not have are zero. xi to held are the slips and what was held.
struct Data {
    std::string law, work;
    double eps_N = 0, g_0 = 0, lambda = 0, eps_T = 0, mu = 0;
    bool has_normal = false, has_slips = false;
    Vector normal{};
    double xi = 0, xi_bar = 0, e = 0, e_bar = 0, cosine = 0;
    std::string held;
};

struct Answers {
    std::string state;
    double F_N, F = 0, F_bar = 0;
    Row residual{};
    std::array<Row, dofs> tangent{};
};

static double dot(const Vector &u, const Vector &v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

static Vector cross(const Vector &u, const Vector &v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// u v + w z, for vectors and rows.
template <typename V>
static V sum(double u, const V &v, double w, const V &z) {
    V to{};
    for (std::size_t i = 0; i < v.size(); i++) to[i] = u * v[i] + w * z[i];
    return to;
}

// The gradient of w . delta u for a vector w. That of d is along G, those of t and t_bar are along A1 and B1.
static Row along(const Shapes &shapes, const Vector &w) {
    Row row{};
    for (int i = 0; i < dofs; i++) row[i] = shapes[i / 3] * w[i % 3];
    return row;
}

// Laws: F_N, and k = -dF_N/dg_N.
static std::array<double, 2> normal_law(const Data &of, double gap) {
    const bool is_between = of.law == "lpqp" && gap > 0;
    const double k = is_between ? of.eps_N * (of.g_0 - gap) / of.g_0 : of.eps_N;
    const double force = is_between ? k * (of.g_0 - gap) / 2 : of.lambda + of.eps_N * (of.g_0 / 2 - gap);
    if (k > 0 && force > 0) return {force, k};
    return {0, 0};
}

// YOUR ELEMENT. Here: two straight beams, 12 dofs; t,xi and all that has it is zero.
// q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1]. radii: r + r_bar.
// held: the parameters that are held at an end of their beam: none, xi, xi_bar or both.
static Answers element(const Row &q, double xi, double xi_bar, const std::string &held, double radii, const Data &of) {
    // Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar.
    const Shapes shapes{(1 - xi) / 2, (1 + xi) / 2, -(1 - xi_bar) / 2, -(1 + xi_bar) / 2};
    const Shapes slopes{-0.5, 0.5, 0, 0}, slopes_bar{0, 0, -0.5, 0.5};
    const bool is_free = held == "none", free = is_free || held == "xi_bar", free_bar = is_free || held == "xi";
    Vector d{}, t{}, t_bar{};
    for (int i = 0; i < dofs; i++) {
        d[i % 3] += shapes[i / 3] * q[i];
        t[i % 3] += slopes[i / 3] * q[i];
        t_bar[i % 3] += slopes_bar[i / 3] * q[i];
    }

    // Geometry. Eq. (50) and (52), reduced to one equation or none if parameters are held at an end.
    const double a = dot(t, t), b = dot(t, t_bar), a_bar = -dot(t_bar, t_bar), det = a * a_bar + b * b;
    std::array<std::array<double, 2>, 2> inverse{{{free / a, 0}, {0, free_bar / a_bar}}};
    if (is_free) inverse = {{{a_bar / det, b / det}, {-b / det, a / det}}};
    const Row Gt = along(shapes, t), Gt_bar = along(shapes, t_bar);
    const Row r = sum(-1, Gt, -1, along(slopes, d)), r_bar = sum(-1, Gt_bar, -1, along(slopes_bar, d));
    const Row g = sum(inverse[0][0], r, inverse[0][1], r_bar), g_bar = sum(inverse[1][0], r, inverse[1][1], r_bar);
    // n = d/|d|; t x t_bar has the same direction, also where the beams cross. It keeps the side of the last step.
    Vector n = is_free ? cross(t, t_bar) : d;
    const double side = dot(n, of.has_normal ? of.normal : d) < 0 ? -1 : 1, length = side * std::sqrt(dot(n, n));
    for (double &component : n) component /= length;
    const double d_s = dot(n, d);
    const Row grad_gap = along(shapes, n), A1n = along(slopes, n), B1n = along(slopes_bar, n);  // eq. (37)

    // Normal.
    const auto [F_N, k] = normal_law(of, d_s - radii);
    const bool has_friction = F_N > 0 && of.mu > 0 && of.has_slips && held != "both";
    Answers to{F_N > 0 ? "frictionless" : "open", F_N};

    // Slip, eq. (15) and (20), and trial. A parameter that becomes held loses its part of the elastic slip.
    const double abs_t = std::sqrt(a), abs_t_bar = std::sqrt(-a_bar), c = b / (abs_t * abs_t_bar);
    const double u = free && has_friction ? xi - of.xi : 0, u_bar = free_bar && has_friction ? xi_bar - of.xi_bar : 0;
    double e = of.e, e_bar = of.e_bar;
    if (!is_free && held != of.held) {
        e = of.held == "none" && free ? of.e - of.cosine * of.e_bar : 0;
        e_bar = of.held == "none" && free_bar ? of.e_bar - of.cosine * of.e : 0;
    }
    e += abs_t * u;
    e_bar += abs_t_bar * u_bar;
    const Vector tau = sum(1 / abs_t, t, 0, t), tau_bar = sum(1 / abs_t_bar, t_bar, 0, t_bar);
    const Vector s = sum(e, tau, -e_bar, tau_bar);
    const double gamma = std::sqrt(dot(s, s));
    const double l = free * dot(s, tau), l_bar = -free_bar * dot(s, tau_bar);  // e - c e_bar, e_bar - c e
    const Row grad_t = along(slopes, tau), grad_t_bar = along(slopes_bar, tau_bar);
    const Row grad_e = sum(abs_t, g, u, grad_t), grad_e_bar = sum(abs_t_bar, g_bar, u_bar, grad_t_bar);
    const Row grad_c = sum(1 / abs_t, along(slopes, sum(1, tau_bar, -c, tau)),
                           1 / abs_t_bar, along(slopes_bar, sum(1, tau, -c, tau_bar)));
    const Row grad_l = sum(1, sum(1, grad_e, -c, grad_e_bar), -e_bar, grad_c);
    const Row grad_l_bar = sum(1, sum(1, grad_e_bar, -c, grad_e), -e, grad_c);

    // Return to the cone.
    double rho = 0;
    Row grad_rho{};
    if (has_friction) {
        to.state = "stick";
        rho = 1;
    }
    if (has_friction && of.eps_T * gamma > of.mu * F_N) {
        to.state = "slip";
        rho = of.mu * F_N / (of.eps_T * gamma);
        const Row grad_gamma = sum(1 / gamma, sum(l, grad_e, l_bar, grad_e_bar), -e * e_bar / gamma, grad_c);
        grad_rho = sum(-of.mu / (of.eps_T * gamma) * k, grad_gap, -rho / gamma, grad_gamma);
    }
    const double F = to.F = of.eps_T * rho * l, F_bar = to.F_bar = of.eps_T * rho * l_bar;
    const Row grad_F = sum(of.eps_T * rho, grad_l, of.eps_T * l, grad_rho);
    const Row grad_F_bar = sum(of.eps_T * rho, grad_l_bar, of.eps_T * l_bar, grad_rho);

    // Work: with "paper", A = grad g_T.
    const double paper = of.work == "paper" ? 1 : 0;
    const Row A = sum(abs_t, g, paper * u, grad_t), A_bar = sum(abs_t_bar, g_bar, paper * u_bar, grad_t_bar);
    to.residual = sum(-F_N, grad_gap, 1, sum(F, A, F_bar, A_bar));

    // Tangent.
    const Row grad_a = along(slopes, sum(2, t, 0, t)), grad_a_bar = along(slopes_bar, sum(-2, t_bar, 0, t_bar));
    const Row grad_b = sum(1, along(slopes, t_bar), 1, along(slopes_bar, t));
    for (int i = 0; i < dofs; i++)
        for (int j = 0; j < dofs; j++) {
            // An entry of v w^T + w v^T, and of the matrix of delta u . Delta u.
            const auto both = [=](const Row &v, const Row &w) { return v[i] * w[j] + w[i] * v[j]; };
            const auto block = [=](const Shapes &v, const Shapes &w) { return i % 3 == j % 3 ? v[i / 3] * w[j / 3] : 0; };
            // The Hessian of the gap: eq. (40), or if both parameters are free a form that also holds at d = 0.
            const double turning = inverse[0][0] * A1n[i] * A1n[j] + inverse[0][1] * both(A1n, B1n) -
                                   inverse[1][1] * B1n[i] * B1n[j];
            const double moved = Gt[i] * g[j] - Gt_bar[i] * g_bar[j] - grad_gap[i] * grad_gap[j];
            const double H_gap = is_free ? both(A1n, g) - both(B1n, g_bar) + d_s * turning
                                         : (block(shapes, shapes) + moved) / d_s + A1n[i] * g[j] - B1n[i] * g_bar[j];
            // The derivatives of eq. (50), solved as eq. (52).
            const double GA = block(shapes, slopes) + block(slopes, shapes);
            const double GB = block(shapes, slopes_bar) + block(slopes_bar, shapes);
            const double H_r = -GA - both(grad_a, g) + both(grad_b, g_bar);
            const double H_r_bar = -GB - both(grad_b, g) - both(grad_a_bar, g_bar);
            const double H_xi = inverse[0][0] * H_r + inverse[0][1] * H_r_bar;
            const double H_xi_bar = inverse[1][0] * H_r + inverse[1][1] * H_r_bar;
            const double H_t = (block(slopes, slopes) - grad_t[i] * grad_t[j]) / abs_t;
            const double H_t_bar = (block(slopes_bar, slopes_bar) - grad_t_bar[i] * grad_t_bar[j]) / abs_t_bar;
            const double H_A = g[i] * grad_t[j] + abs_t * H_xi + paper * (grad_t[i] * g[j] + u * H_t);
            const double H_A_bar = g_bar[i] * grad_t_bar[j] + abs_t_bar * H_xi_bar +
                                   paper * (grad_t_bar[i] * g_bar[j] + u_bar * H_t_bar);
            const double K_N = k * grad_gap[i] * grad_gap[j] - F_N * H_gap;
            const double K_T = A[i] * grad_F[j] + A_bar[i] * grad_F_bar[j] + F * H_A + F_bar * H_A_bar;
            to.tangent[i][j] = K_N + K_T;
        }
    return to;
}

// A line of JSON, from a place on.
class Line {
  public:
    explicit Line(const std::string &text, std::size_t at = 0) : text(text), at(at) {}

    // The text after a key.
    Line after(const std::string &key) const {
        const auto found = at == std::string::npos ? at : text.find(key, at);
        return Line(text, found == std::string::npos ? found : found + key.size());
    }

    explicit operator bool() const { return at != std::string::npos; }

    std::string word() const { return *this ? text.substr(at, text.find('"', at) - at) : ""; }

    // The number after a key; zero if there is none.
    double number(const std::string &key) const {
        const Line found = after('"' + key + "\":");
        return found ? std::strtod(text.c_str() + found.at, nullptr) : 0;
    }

    void numbers(double *to, int count) const {
        const char *from = text.c_str() + at;
        for (char *end; count-- > 0; from = end + 1) *to++ = std::strtod(from, &end);
    }

  private:
    const std::string &text;
    std::size_t at;
};

static Data read_data(const Line &at) {
    const Line normal = at.after("\"normal\":["), slips = at.after("\"slips\":{");
    Data of{at.after("\"law\":\"").word(), at.after("\"work\":\"").word(),
            at.number("eps_N"), at.number("g_0"), at.number("lambda"), at.number("eps_T"), at.number("mu"),
            bool(normal), bool(slips), {},
            slips.number("xi"), slips.number("xi_bar"), slips.number("e"), slips.number("e_bar"), slips.number("cosine"),
            slips.after("\"held\":\"").word()};
    if (normal) normal.numbers(of.normal.data(), 3);
    return of;
}

static void print(const Row &row) {
    for (int i = 0; i < dofs; i++) std::cout << (i ? "," : "") << row[i];
}

int main() {
    std::string text;
    std::getline(std::cin, text);  // the head of the cases
    std::cout << std::setprecision(17);
    std::cout << head << '\n';
    while (std::getline(std::cin, text)) {
        const Line line(text), beam = line.after("\"beam\":{"), bar = beam.after("\"bar\":{");
        const Line point = bar.after("\"point\":{"), held = point.after("\"held\":\""), data = bar.after("\"element\":{");
        for (const Line &one : {beam, bar})
            if (const std::string is = one.after("\"family\":\"").word(); is != family) {
                std::cerr << "contact.cpp is for the family " << family << "; a case is of the family " << is
                          << ". Change family, beam_dofs and element." << std::endl;
                return 1;
            }
        if (held && !data) {
            std::cerr << "contact.cpp: a case has no element. Write the cases with `beamgap export --element`." << std::endl;
            return 1;
        }
        std::cout << "{\"id\":\"" << line.after("\"id\":\"").word() << "\",";
        if (held) {
            Row q;
            beam.after("\"q\":[").numbers(q.data(), beam_dofs);
            bar.after("\"q\":[").numbers(q.data() + beam_dofs, beam_dofs);
            const double radii = bar.number("radius") + bar.number("radius_bar");
            const Answers to = element(q, point.number("xi"), point.number("xi_bar"), held.word(), radii, read_data(data));
            std::cout << "\"state\":\"" << to.state << "\",\"F_N\":" << to.F_N << ",\"F\":" << to.F
                      << ",\"F_bar\":" << to.F_bar << ",\"residual\":[";
            print(to.residual);
            std::cout << "],\"tangent\":[";
            for (int i = 0; i < dofs; i++) {
                std::cout << (i ? "," : "");
                print(to.tangent[i]);
            }
            std::cout << "]}" << std::endl;
        } else {
            std::cout << "\"result\":\"degenerate\"}" << std::endl;  // the case has no regular closest point
        }
    }
}
