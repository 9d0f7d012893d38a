//! One table for every symbol and name that the reports use.

use super::page::{Block, Page};
use crate::check::Regime;

/// The page of the symbols, which the other pages refer to.
pub fn symbols() -> Page {
    let table = |head: [&str; 2], rows: &[(&str, &str)]| {
        let row = |(name, meaning): &(&str, &str)| vec![format!("`{name}`"), (*meaning).to_owned()];
        Block::table(&head, rows.iter().map(row).collect())
    };
    let regimes = Regime::ALL.map(|regime| vec![regime.name().to_owned(), regime.what().to_owned()]);
    let blocks = vec![
        Block::text(
            "Every symbol and name that the reports use. *Bar* marks the second beam. Parameters run over [-1, 1]. Lengths have the \
             unit of the dofs.",
        ),
        Block::heading("Quantities"),
        table(["symbol", "meaning"], &QUANTITIES),
        Block::heading("Variations"),
        table(["symbol", "meaning"], &VARIATIONS),
        Block::heading("The system of the closest point"),
        table(["symbol", "meaning"], &SYSTEM),
        Block::heading("Matrices"),
        Block::text("Gradients and Hessians are in the dofs of both beams. A' is the transpose of A."),
        table(["symbol", "meaning"], &MATRICES),
        Block::heading("Names of faults"),
        Block::text(
            "A fault is named `formula: term = kind`. `H_d: d G11 jj' = sign` is the fault that the term d G11 jj' of the Hessian of \
             d has the opposite sign. `(bar)` is the same term of the bar beam.",
        ),
        Block::heading("Regimes"),
        Block::text("Each regime draws random pairs of beams of all curve families."),
        Block::table(&["regime", "pairs of beams"], regimes.to_vec()),
    ];
    Page::new("Symbols", blocks)
}

const QUANTITIES: [(&str, &str); 13] = [
    ("x, x_bar", "closest points of the beam and of the bar beam"),
    ("xi, xi_bar", "their parameters"),
    ("d_vector", "d = x - x_bar, a vector; in formulas written `d`"),
    ("d", "its length, the distance; in formulas with a bar on each side: |d|"),
    (
        "t_vector, t_bar_vector",
        "tangents x,xi and x_bar,xi_bar: derivatives by the parameter, not of unit length",
    ),
    ("t, t_bar", "their lengths; in formulas |t|"),
    ("t,xi  t,xixi", "first and second derivative of the tangent by the parameter"),
    ("n", "unit normal: d over its length, or t x t_bar over its length"),
    ("c", "t x t_bar"),
    ("g_N", "normal gap: d minus both radii `r` and `r_bar`"),
    ("g_T, g_T_bar", "tangential gaps, or slips: t (xi - xi_0) and its twin"),
    ("slip", "xi - xi_0: the parameter since first contact"),
    ("w", "unit tangent t / |t|"),
];

const VARIATIONS: [(&str, &str); 6] = [
    ("d before a symbol: dx, dt, dxi", "delta: the first variation along the first direction"),
    ("D before a symbol: Dx, Dt, Dxi", "Delta: the first variation along the second direction"),
    ("Dd before a symbol: Ddx, Ddxi", "Delta-delta: the second variation, along both"),
    (
        "du, Du, Ddu",
        "variations of the position at a fixed parameter: delta_u u, Delta_u u, Delta_u delta_u u",
    ),
    ("u_hat", "difference of beam and bar beam: du_hat = du - du_bar"),
    ("rest", "the second variation without the term of Delta-delta xi"),
];

const SYSTEM: [(&str, &str); 7] = [
    ("a", "t.t + d.t,xi, equation (50)"),
    ("a_bar", "-t_bar.t_bar + d.t_bar,xi, equation (50)"),
    ("b", "t.t_bar, equation (50)"),
    ("D", "a a_bar + b b, equation (52): negative at a minimum of the distance"),
    ("R, R_bar", "right-hand sides of the first order, equation (50)"),
    ("R2, R2_bar", "right-hand sides of the second order, equation (55)"),
    (
        "u, u_bar",
        "vectors of the solution by cross products: D u = t_bar x c - (d.t_bar,xi) t; dxi contains u.du_hat",
    ),
];

const MATRICES: [(&str, &str); 13] = [
    ("A0, A1, A2", "derivatives of x, x,xi and x,xixi by the dofs of the beam: 3 rows"),
    ("B0, B1, B2", "the same of the bar beam"),
    ("G", "A0 - B0, the derivative of d at fixed parameters"),
    ("g, g_bar", "gradients of xi and xi_bar"),
    ("H_d, H_t, H_xi, H_g_T", "Hessians of d, t, xi and g_T"),
    (
        "K(v)  K,xi(v)",
        "second derivatives of v.x and v.x,xi by the dofs: zero for curves linear in their dofs",
    ),
    ("S", "Hessian of m.x at fixed second derivatives of xi: m.t,xi gg' + g(A1'm)' + (A1'm)g' + K(m)"),
    ("m", "the vector that S is taken with: a sum of t and t_bar, or u"),
    (
        "j, j_bar",
        "gradients of n.t and n.t_bar with n fixed: J_t'n, where J_t is the derivative of the tangent by all dofs",
    ),
    ("G11, G12, G22", "the inverse of the matrix of t.t, t.t_bar and t_bar.t_bar"),
    ("alpha, beta", "vectors that multiply g and g_bar in the Hessian of d.t, with half of each square term"),
    ("alpha_bar, beta_bar", "the same for d.t_bar"),
    ("C, C_bar", "the terms of both Hessians without g and g_bar: G'A1 + A1'G + K,xi(d)"),
];

#[cfg(test)]
mod tests {
    use super::{MATRICES, QUANTITIES, SYSTEM, VARIATIONS};
    use crate::variant::catalogue;

    /// Every name that a fault starts with is in a table, but for its `d`, `D`, `Dd` or `grad`, and its bars.
    #[test]
    fn every_formula_of_a_fault_is_explained() {
        let known: Vec<&str> = [&QUANTITIES[..], &VARIATIONS, &SYSTEM, &MATRICES]
            .into_iter()
            .flatten()
            .flat_map(|(names, _)| names.split([' ', ',', '(', ':']))
            .filter(|name| !name.is_empty())
            .collect();
        for fault in catalogue() {
            let fault = fault.to_string();
            let formula = fault.split(':').next().unwrap_or(&fault);
            for name in formula.split([' ', ',']).filter(|name| !["", "held", "grad"].contains(name)) {
                let bare = name.trim_matches('|');
                let rest = ["Dd", "D", "d", ""].map(|prefix| bare.strip_prefix(prefix));
                let is_known = rest.into_iter().flatten().any(|rest| {
                    let rest = rest.trim_matches('|');
                    rest.is_empty() || known.contains(&rest) || known.contains(&rest.trim_end_matches("_bar"))
                });
                assert!(is_known, "{fault}: {name}");
            }
        }
    }
}
