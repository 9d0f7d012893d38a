// Answers the cases of `beamgap export` with your own element.
//
//     beamgap export --family segment -o vectors.jsonl
//     c++ -O2 -std=c++17 adapter.cpp -o adapter
//     beamgap verify vectors.jsonl --run ./adapter
//
// This program is for two straight beams, the family `segment`. For yours, change
// 1. `family` and `beam_dofs`, the name of the family and its dofs a beam,
// 2. `element`, and what `main` prints of it,
// 3. `head`: "only" lists what you answer, and conventions that differ are stated there (beamgap schema answers).
#include <array>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

using Vector = std::array<double, 3>;
using Row = std::vector<double>;
const std::string family = "segment";
const char *const head =
    R"({"schema":"beamgap-answers/1","program":"adapter.cpp","only":["d","xi:value","xi:first","xi_bar:value","xi_bar:first"]})";
constexpr int beam_dofs = 6, dofs = 2 * beam_dofs;

struct Quantity {
    std::optional<double> value;
    Row gradient, hessian;  // the Hessian row by row; empty if not computed
};

struct Answers {
    Quantity d, xi, xi_bar;
};

static double dot(const Vector &u, const Vector &v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

// The gradient of w . delta u for a vector w.
static Row along(const std::array<double, 4> &shapes, const Vector &w) {
    Row row(dofs);
    for (int i = 0; i < dofs; i++) row[i] = shapes[i / 3] * w[i % 3];
    return row;
}

// YOUR ELEMENT. Here: two straight beams, 12 dofs, by the equations of Zavarise (2007).
// q: both ends of the beam, then of the bar beam. xi, xi_bar: the closest point, in [-1, 1].
// held: the parameters that are held at an end of their beam: none, xi, xi_bar or both.
static Answers element(const Row &q, double xi, double xi_bar, const std::string &held) {
    // Shape functions of d = x - x_bar, and derivatives of the shape functions of x and x_bar.
    const std::array<double, 4> shapes{(1 - xi) / 2, (1 + xi) / 2, -(1 - xi_bar) / 2, -(1 + xi_bar) / 2};
    const std::array<double, 4> slopes{-0.5, 0.5, 0, 0}, slopes_bar{0, 0, -0.5, 0.5};
    Vector d{}, t{}, t_bar{}, n{};
    for (int i = 0; i < dofs; i++) {
        d[i % 3] += shapes[i / 3] * q[i];
        t[i % 3] += slopes[i / 3] * q[i];
        t_bar[i % 3] += slopes_bar[i / 3] * q[i];
    }
    const double length = std::sqrt(dot(d, d));
    for (int c = 0; c < 3; c++) n[c] = d[c] / length;
    const Row A1d = along(slopes, d), B1d = along(slopes_bar, d);
    const Row Gt = along(shapes, t), Gt_bar = along(shapes, t_bar);
    const Row gradient = along(shapes, n);  // eq. (37)
    const double a = dot(t, t), b = dot(t, t_bar), a_bar = -dot(t_bar, t_bar);
    const double det = a * a_bar + b * b;
    Row g(dofs), g_bar(dofs), hessian(dofs * dofs);
    for (int i = 0; i < dofs; i++) {
        // Eq. (50) and (52), reduced to one equation or none if parameters are held at an end.
        const double r = -Gt[i] - A1d[i], r_bar = -Gt_bar[i] - B1d[i];
        if (held == "none") {
            g[i] = (a_bar * r + b * r_bar) / det;
            g_bar[i] = (-b * r + a * r_bar) / det;
        } else if (held == "xi") {
            g_bar[i] = r_bar / a_bar;
        } else if (held == "xi_bar") {
            g[i] = r / a;
        }
    }
    for (int i = 0; i < dofs; i++)
        for (int j = 0; j < dofs; j++) {
            // Eq. (40).
            const double GG = i % 3 == j % 3 ? shapes[i / 3] * shapes[j / 3] : 0;
            const double moved = Gt[i] * g[j] - Gt_bar[i] * g_bar[j];
            const double turned = A1d[i] * g[j] - B1d[i] * g_bar[j];
            hessian[i * dofs + j] = (GG + moved + turned - gradient[i] * gradient[j]) / length;
        }
    return {{length, gradient, hessian}, {xi, g, {}}, {xi_bar, g_bar, {}}};
}

// A line of JSON. Its keys are searched in order.
class Line {
  public:
    explicit Line(const std::string &text) : text(text) {}

    // Moves to the text after a key. Returns whether the key exists.
    bool to(const std::string &key) {
        const auto found = text.find(key, at);
        if (found == std::string::npos) return false;
        at = found + key.size();
        return true;
    }

    std::string word() const { return text.substr(at, text.find('"', at) - at); }

    Row numbers(int count) const {
        Row row;
        const char *from = text.c_str() + at;
        for (char *end; count-- > 0; from = end + 1) row.push_back(std::strtod(from, &end));
        return row;
    }

  private:
    const std::string &text;
    std::size_t at = 0;
};

static void print(const char *name, const Quantity &of) {
    std::cout << ",\"" << name << "\":{";
    const char *comma = "";
    if (of.value) {
        std::cout << "\"value\":" << *of.value;
        comma = ",";
    }
    const auto row = [&](const char *part, const Row &numbers) {
        if (numbers.empty()) return;
        std::cout << comma << '"' << part << "\":[";
        for (std::size_t i = 0; i < numbers.size(); i++) std::cout << (i ? "," : "") << numbers[i];
        std::cout << ']';
        comma = ",";
    };
    row("gradient", of.gradient);
    row("hessian", of.hessian);
    std::cout << '}';
}

int main() {
    std::string text;
    std::getline(std::cin, text);  // the head of the cases
    std::cout << std::setprecision(17);
    std::cout << head << '\n';
    while (std::getline(std::cin, text)) {
        Line line(text);
        if (!line.to("\"id\":\"")) return 1;
        std::cout << "{\"id\":\"" << line.word() << '"';
        Row q;
        for (const char *beam : {"\"beam\":{\"family\":\"", "\"bar\":{\"family\":\""}) {
            if (!line.to(beam) || line.word() != family) {
                std::cerr << "adapter.cpp is for the family " << family << "; a case is of the family " << line.word()
                          << ". Change family, beam_dofs and element." << std::endl;
                return 1;
            }
            line.to("\"q\":[");
            for (double number : line.numbers(beam_dofs)) q.push_back(number);
        }
        bool is_regular = line.to("\"point\":{\"xi\":");
        const double xi = line.numbers(1)[0];
        is_regular = is_regular && line.to("\"xi_bar\":");
        const double xi_bar = line.numbers(1)[0];
        if (is_regular && line.to("\"held\":\"")) {
            const Answers answers = element(q, xi, xi_bar, line.word());
            print("d", answers.d);
            print("xi", answers.xi);
            print("xi_bar", answers.xi_bar);
        } else {
            std::cout << ",\"result\":\"degenerate\"";  // the case has no regular closest point
        }
        std::cout << '}' << std::endl;
    }
}
