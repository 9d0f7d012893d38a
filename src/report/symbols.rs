//! The table of all symbols and names that the reports use.

mod terms;

use super::page::{Block, Page};
use crate::check::Regime;
use terms::{CONTACT, NOT_COMPARED, TERMS};

/// The page of the symbols. The other pages refer to it.
pub fn symbols() -> Page {
    let table = |head: [&str; 2], rows: &[(&str, &str)]| {
        let row = |(name, meaning): &(&str, &str)| vec![format!("`{name}`"), (*meaning).to_owned()];
        Block::table(&head, rows.iter().map(row).collect())
    };
    let words = |rows: &[(&str, &str)]| {
        let row = |(name, meaning): &(&str, &str)| vec![(*name).to_owned(), (*meaning).to_owned()];
        Block::table(&["word", "meaning"], rows.iter().map(row).collect())
    };
    let regimes = Regime::ALL.map(|regime| vec![regime.name().to_owned(), regime.what().to_owned()]);
    let blocks = vec![
        Block::text(
            "**This page defines the symbols, names and terms of the reports.** *Bar* marks the second beam. Parameters run over \
             [-1, 1]. Lengths have the unit of the dofs.",
        ),
        Block::heading("Quantities"),
        table(["symbol", "meaning"], &QUANTITIES),
        Block::heading("Variations"),
        Block::text("Letters before a symbol. `D` that stands alone is the determinant of the next table."),
        table(["symbol", "meaning"], &VARIATIONS),
        Block::heading("The system of the closest point"),
        table(["symbol", "meaning"], &SYSTEM),
        Block::heading("Matrices"),
        Block::text("Gradients and Hessians are in the dofs of both beams. A' is the transpose of A."),
        table(["symbol", "meaning"], &MATRICES),
        Block::heading("Letters of the derivation"),
        Block::text(
            "The [derivation](derivation.html) and the module `linearization::closed_form::derivation` write letters. Reports and code \
             write ASCII. This table has the letters with another spelling or without an entry above.",
        ),
        Block::table(
            &["letter", "here", "meaning"],
            LETTERS.map(|row| row.map(str::to_owned).to_vec()).to_vec(),
        ),
        Block::heading("Names of faults"),
        Block::text(
            "A fault is named `formula: term = kind`. `H_d: d G11 jj' = sign` is the fault that the term d G11 jj' of the Hessian of \
             d has the opposite sign. `(bar)` is the same term of the bar beam. The kinds are in [faults](faults.md).",
        ),
        table(["part of a name", "meaning"], &NAMES),
        Block::heading("Beams and contact"),
        words(&CONTACT),
        Block::heading("Closest points that are not compared"),
        words(&NOT_COMPARED),
        Block::heading("Numbers and programs"),
        words(&TERMS),
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
    ("g_T, g_T_bar", "tangential gaps, also called slips: t (xi - xi_0) and its twin"),
    (
        "slip",
        "in names of terms the parameter increment xi - xi_0 since first contact, the factor of t in g_T",
    ),
    ("w", "unit tangent t / |t|"),
];

const VARIATIONS: [(&str, &str); 6] = [
    ("d before a symbol: dx, dt, dxi, dn", "delta: the first variation along the first direction"),
    ("D before a symbol: Dx, Dt, Dxi, Dn", "Delta: the first variation along the second direction"),
    ("Dd before a symbol: Ddx, Ddxi", "Delta-delta: the second variation, along both"),
    (
        "du, Du, Ddu",
        "variations of the position at a fixed parameter: delta_u u, Delta_u u, Delta_u delta_u u, where u is the displacement",
    ),
    ("u_hat", "difference of beam and bar beam: du_hat = du - du_bar"),
    ("rest", "the second variation without the term of Delta-delta xi"),
];

const SYSTEM: [(&str, &str); 7] = [
    ("a", "t.t + d.t,xi, equation (50)"),
    ("a_bar", "-t_bar.t_bar + d.t_bar,xi, equation (50)"),
    ("b", "t.t_bar, equation (50)"),
    (
        "D",
        "the determinant a a_bar + b b, equation (52): negative at a nondegenerate minimum of the distance (positive definite Hessian of d^2/2)",
    ),
    ("R, R_bar", "right-hand sides of the first order, equation (50)"),
    ("R2, R2_bar", "right-hand sides of the second order, equation (55)"),
    (
        "u, u_bar",
        "before a colon or a dot: vectors of the solution by cross products, not displacements; D u = t_bar x c - (d.t_bar,xi) t, \
         and dxi contains u.du_hat",
    ),
];

const MATRICES: [(&str, &str); 14] = [
    ("A0, A1, A2", "derivatives of x, x,xi and x,xixi by the dofs of the beam: 3 rows"),
    ("B0, B1, B2", "the same of the bar beam"),
    ("G", "A0 - B0, the derivative of d at fixed parameters"),
    ("g, g_bar", "gradients of xi and xi_bar"),
    ("grad", "gradient: `grad t`, `grad R`"),
    ("H_d, H_t, H_t_bar, H_xi, H_g_T", "Hessians of d, t, t_bar, xi and g_T"),
    (
        "K(v)  K,xi(v)  K_bar(v)",
        "second derivatives of v.x, v.x,xi and v.x_bar by the dofs: zero for curves linear in their dofs",
    ),
    (
        "S",
        "the Hessian of m.x without the term with the Hessian of xi: m.t,xi gg' + g(A1'm)' + (A1'm)g' + K(m)",
    ),
    ("m", "the vector that S is taken with: a sum of t and t_bar, or u"),
    (
        "j, j_bar",
        "gradients of n.t and n.t_bar with n fixed: J_t'n, where J_t is the derivative of the tangent by all dofs",
    ),
    ("G11, G12, G22", "the inverse of the matrix of t.t, t.t_bar and t_bar.t_bar"),
    ("alpha, beta", "vectors that multiply g and g_bar in the Hessian of d.t, with half of each square term"),
    ("alpha_bar, beta_bar", "the same for d.t_bar"),
    (
        "C, C_bar",
        "the terms of both Hessians without g and g_bar: G'A1 + A1'G + K,xi(d); not the index C of the closest point",
    ),
];

/// The letters of the derivation, their spelling here, and their meaning.
const LETTERS: [[&str; 3]; 19] = [
    [
        "x_C, x̄_C̄",
        "x, x_bar",
        "the index C, C̄ marks the closest point, where the parameter depends on the dofs",
    ],
    ["δ, Δ, Δδ", "d, D, Dd before a symbol", "variations; in code `delta`, `linear`, `second`"],
    ["δᵤ, Δᵤ, Δᵤδᵤ", "du, Du, Ddu", "variations at a fixed parameter"],
    ["X", "", "the point before the deformation: x = X + u; in code `reference`"],
    ["û_C", "u_hat", "u_C - ū_C̄, the difference of the displacements"],
    ["v", "v", "any vector; in (33) to (35) one that is not zero"],
    ["R_δ, R̄_δ", "R, R_bar", "right-hand sides of the first order"],
    ["R_Δδ, R̄_Δδ", "R2, R2_bar", "right-hand sides of the second order"],
    ["r_d, r_t, r̄_t", "rest", "the parts of Δδd, Δδt and Δδt̄ without Δδξ and Δδξ̄"],
    ["r, r̄", "grad R, grad R_bar", "the vectors with R_δ = r·δQ and R̄_δ = r̄·δQ; in italics the radii"],
    ["P, P̄", "", "the matrices with R_Δδ = δQᵀ P ΔQ and R̄_Δδ = δQᵀ P̄ ΔQ"],
    ["p, q, q̄", "", "entries of the inverse matrix [[p, q], [-q, q̄]] of the system (51)"],
    [
        "J_d, J_t, J_t̄",
        "J_t in j",
        "the derivatives of the vectors d, t and t̄ by all dofs, with the parameters moving",
    ],
    [
        "S_x, S_x̄",
        "S",
        "S_x(v): the Hessian of v·x_C without its term with the Hessian of ξ; S is S_x(m) - S_x̄(m)",
    ],
    ["S_t, S_t̄", "", "S_t(v): the Hessian of v·t without its term with the Hessian of ξ"],
    ["K_x, K_x,ξ", "K, K,xi", "second derivatives by the dofs at fixed parameters"],
    ["Γ", "G11, G12, G22", "the inverse of the matrix of t·t, t·t̄ and t̄·t̄; in code `inverse_gram`"],
    ["τ", "w", "the unit tangent t/|t|, in the module `derivation`"],
    ["H (bold)", "", "the Hessian of the half squared distance in the two parameters"],
];

/// Words in names of faults that are not symbols.
const NAMES: [(&str, &str); 3] = [
    ("moved", "in (40) the vector t Dxi - t_bar Dxi_bar: `du_hat.moved` is its product with du_hat"),
    ("turned", "in (40) the vector du,xi Dxi - du_bar,xi Dxi_bar: `d.turned` is its product with d"),
    ("held", "the formula for a parameter that is held: `xi_bar, xi held` is that of xi_bar with xi held"),
];

#[cfg(test)]
mod tests {
    use super::{MATRICES, NAMES, QUANTITIES, SYSTEM, VARIATIONS};
    use crate::number::Label;
    use crate::variant::catalogue;

    /// Every name at the start of a fault is in a table, without its `d`, `D` or `Dd`, and its bars; so is every word in its
    /// term.
    #[test]
    fn every_formula_of_a_fault_is_explained() {
        let known: Vec<&str> = [&QUANTITIES[..], &VARIATIONS, &SYSTEM, &MATRICES, &NAMES]
            .into_iter()
            .flatten()
            .flat_map(|(names, _)| names.split([' ', ',', '(', ':']))
            .filter(|name| !name.is_empty())
            .collect();
        for fault in catalogue() {
            let Label { formula, term, .. } = fault.label;
            for name in formula.name().split([' ', ',']).filter(|name| !name.is_empty()) {
                let bare = name.trim_matches('|');
                let rest = ["Dd", "D", "d", ""].map(|prefix| bare.strip_prefix(prefix));
                let is_known = rest.into_iter().flatten().any(|rest| {
                    let rest = rest.trim_matches('|');
                    rest.is_empty() || known.contains(&rest) || known.contains(&rest.trim_end_matches("_bar"))
                });
                assert!(is_known, "{fault}: {name}");
            }
            let is_word = |word: &&str| word.len() > 4 && word.chars().all(|c| c.is_ascii_lowercase());
            for word in term.split([' ', ',', '.', '(', ')', '\'']).filter(is_word) {
                assert!(known.contains(&word), "{fault}: {word}");
            }
        }
    }
}
