//! The equation of the paper that a term belongs to.

use crate::number::Label;

/// The beginnings of the names of terms, with their equations. The first match is used.
const EQUATIONS: &[(&str, &str)] = &[
    ("d: ", "eq. (5)"),
    ("u_hat: ", "eq. (37)"),
    ("R: ", "eq. (44) and (50)"),
    ("R_bar: ", "eq. (44) and (50)"),
    ("a: ", "eq. (50)"),
    ("b: ", "eq. (50)"),
    ("a_bar: ", "eq. (50)"),
    ("D: ", "eq. (52)"),
    ("u: ", "eq. (52), by cross products"),
    ("u_bar: ", "eq. (52), by cross products"),
    ("xi: ", "eq. (52) and (59)"),
    ("xi_bar: ", "eq. (52) and (59)"),
    ("xi, xi_bar held: ", "eq. (50) at a held end"),
    ("xi_bar, xi held: ", "eq. (50) at a held end"),
    ("dxi: ", "eq. (52), by cross products"),
    ("dxi_bar: ", "eq. (52), by cross products"),
    ("dx: ", "eq. (24)"),
    ("dt: ", "eq. (28)"),
    ("dd: ", "eq. (32)"),
    ("Dd x: ", "eq. (26) and (27)"),
    ("Dd t: ", "eq. (30)"),
    ("Dd d: ", "eq. (32)"),
    ("R2: ", "the right-hand side of eq. (55)"),
    ("R2_bar: ", "the right-hand side of eq. (55)"),
    ("Ddxi: ", "eq. (59), by cross products"),
    ("Ddxi_bar: ", "eq. (59), by cross products"),
    ("|d|: ", "eq. (4)"),
    ("d|d|: ", "eq. (37)"),
    ("Dd|d|: ", "eq. (40)"),
    ("n: ", "eq. (37), along the normal"),
    ("dn: ", "eq. (40), along the normal"),
    ("|t|: ", "eq. (9)"),
    ("d|t|: ", "eq. (41)"),
    ("Dd|t|: ", "eq. (42)"),
    ("g_N: ", "eq. (11)"),
    ("g_T: ", "eq. (15)"),
    ("dg_T: ", "eq. (20)"),
    ("Ddg_T: ", "eq. (21)"),
    ("grad R: ", "eq. (50), as gradients"),
    ("grad R_bar: ", "eq. (50), as gradients"),
    ("grad xi: ", "eq. (52), as gradients"),
    ("grad d: ", "eq. (37), as a gradient"),
    ("grad t: ", "eq. (41), as a gradient"),
    ("grad g_T: ", "eq. (20), as a gradient"),
    ("m: ", "eq. (59), as matrices"),
    ("alpha: ", "eq. (59), as matrices"),
    ("alpha_bar: ", "eq. (59), as matrices"),
    ("beta: ", "eq. (59), as matrices"),
    ("beta_bar: ", "eq. (59), as matrices"),
    ("C: ", "eq. (59), as matrices"),
    ("C_bar: ", "eq. (59), as matrices"),
    ("S: ", "eq. (59), as matrices"),
    ("j: ", "eq. (40), as a matrix along the normal"),
    ("j_bar: ", "eq. (40), as a matrix along the normal"),
    ("H_d: ", "eq. (40), as a matrix"),
    ("H_t: ", "eq. (42), as a matrix"),
    ("H_t_bar: ", "eq. (42), as a matrix"),
    ("H_g_T: ", "eq. (21), as a matrix"),
];

/// The equation of a term.
pub(super) fn equation(label: &Label) -> &'static str {
    equation_of(label.name).unwrap_or("of the closed form")
}

/// The equation of a term, or of a fault, by its name.
pub fn equation_of(name: &str) -> Option<&'static str> {
    EQUATIONS.iter().find(|(formula, _)| name.starts_with(formula)).map(|(_, equation)| *equation)
}

#[cfg(test)]
mod tests {
    use super::{EQUATIONS, equation};
    use crate::variant::terms;

    #[test]
    fn every_term_has_an_equation_and_every_equation_a_term() {
        let all: Vec<_> = terms().iter().flatten().collect();
        for label in &all {
            assert_ne!(equation(label), "of the closed form", "{label}");
        }
        for (formula, _) in EQUATIONS {
            assert!(all.iter().any(|label| label.name.starts_with(formula)), "{formula}");
        }
    }
}
