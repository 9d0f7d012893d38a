//! Tangents of published elements, written anew from their formulas, and their errors over random pairs of beams.
//!
//! Nothing here is code of others. The sources are those that [`Published::source`] names.

mod pairs;
mod without_friction;

use super::DOFS;
use super::terms::{Components, Tangent, Term};
use crate::contact::{State, Work};
use nalgebra::{DMatrix, DVector};
use pairs::RandomPair;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

enumeration! {
    /// A published tangent.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Published {
        /// A penalty element without friction whose negative tangent is assembled.
        FourC => "4C, without friction",
        /// The same with the stiffness that it uses at deep penetration.
        FourCBasic => "4C, basic stiffness",
        /// Friction with contravariant components, and the tangent in slip without the change of the direction.
        Giraffe => "GIRAFFE, friction",
        /// Friction with normal force and tangents of the last iteration.
        Lagged => "IPC Toolkit, lagged friction",
    }
}

impl Published {
    /// The file of the formulas, the function in it, and the commit that was read.
    pub fn source(self) -> &'static str {
        match self {
            Self::FourC | Self::FourCBasic => {
                "4C-multiphysics/4C, src/beamcontact/4C_beamcontact_beam3contact.cpp, evaluate_stiffc_contact, 0538775"
            }
            Self::Giraffe => "alfredogneto/GIRAFFE, src/LRLR.cpp, LRLR::Mount, 526eaa4",
            Self::Lagged => {
                "ipc-sim/ipc-toolkit, src/ipc/potentials/tangential_potential.cpp, TangentialPotential::hessian, 011132a"
            }
        }
    }

    /// What its tangent lacks.
    pub fn lacks(self) -> &'static str {
        match self {
            Self::FourC => "nothing: -K of 4C is K",
            Self::FourCBasic => "-F_N Hess g_N",
            Self::Giraffe => "in slip mu F_N (A grad m' + A_bar grad m_bar')",
            Self::Lagged => {
                "mu (m A + m_bar A_bar) grad F_N' in slip, F g grad t', F t Hess xi, and grad c and (xi - xi_n) grad t in grad F"
            }
        }
    }

    /// The states that it has formulas for.
    pub fn states(self) -> &'static [State] {
        match self {
            Self::FourC | Self::FourCBasic => &[State::Frictionless],
            Self::Giraffe | Self::Lagged => &[State::Stick, State::Slip],
        }
    }

    /// The tangent for Newton's method, and the virtual work of its element.
    ///
    /// That of 4C is the exact one.
    pub fn tangent(self) -> (Tangent, Work) {
        match self {
            Self::FourC => (Tangent::EXACT, Work::Rate),
            Self::FourCBasic => (Tangent::EXACT.without(Term::NormalHessian), Work::Rate),
            Self::Giraffe => (Tangent::CONTRAVARIANT.without(Term::Direction), Work::Paper),
            Self::Lagged => (Tangent::LAGGED, Work::Rate),
        }
    }

    /// Its residual and its tangent K at a pair of beams, and the derivative of that residual.
    ///
    /// None if it has another state there: its cone is another one.
    fn at(self, pair: &RandomPair, state: State) -> Option<(DVector<f64>, DMatrix<f64>, DMatrix<f64>)> {
        let (tangent, work) = self.tangent();
        let terms = pair.terms(state, tangent.components, work);
        if terms.state != state {
            return None;
        }
        let exact = terms.tangent();
        let published = match self {
            Self::FourC => -without_friction::stiffness(pair),
            Self::FourCBasic => terms.without(Term::NormalHessian),
            Self::Giraffe => terms.without(Term::Direction),
            Self::Lagged => terms.lagged(),
        };
        Some((terms.residual, published, exact))
    }
}

/// The errors of a published tangent over random pairs of beams, in the norm of the largest entry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// The pairs.
    pub pairs: usize,
    /// |K - dR/dQ|/|dR/dQ| with the R of the element: the median and the largest.
    pub tangent: [f64; 2],
    /// |R - R₀|/|R₀ - R_N| with the friction of [`Components::Covariant`] and [`Work::Rate`] in R₀: the median and the largest.
    /// Without friction, 0.
    pub residual: [f64; 2],
}

/// The errors over pairs in a state.
pub fn errors(published: Published, state: State, pairs: usize, seed: u64) -> Errors {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let (mut tangent, mut residual) = (Vec::new(), Vec::new());
    while tangent.len() < pairs {
        let pair = RandomPair::draw(&mut rng, state);
        let Some((r, k, exact)) = published.at(&pair, state) else { continue };
        tangent.push((k - &exact).amax() / exact.amax());
        if state.has_friction() {
            let terms = |state| pair.terms(state, Components::Covariant, Work::Rate).residual;
            let (mechanics, normal) = (terms(state), terms(State::Frictionless));
            residual.push((r - &mechanics).amax() / (mechanics - normal).amax());
        }
    }
    Errors { pairs, tangent: median_and_largest(tangent), residual: median_and_largest(residual) }
}

fn median_and_largest(mut all: Vec<f64>) -> [f64; 2] {
    all.sort_by(f64::total_cmp);
    [all.get(all.len() / 2), all.last()].map(|x| x.copied().unwrap_or(0.0))
}

#[cfg(test)]
mod tests {
    use super::pairs::RandomPair;
    use super::{Components, DOFS, Published, State, Term, Work, errors};
    use crate::contact::Contribution;
    use crate::teaching::terms::Terms;
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;

    fn pairs(state: State) -> impl Iterator<Item = RandomPair> {
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        std::iter::repeat_with(move || RandomPair::draw(&mut rng, state)).take(12)
    }

    /// The sum of the terms is the tangent of the element, which automatic differentiation confirms.
    #[test]
    fn terms_add_up_to_the_tangent_of_the_element() {
        for state in [State::Frictionless, State::Stick, State::Slip] {
            for work in [Work::Rate, Work::Paper] {
                for pair in pairs(state) {
                    let mut to = Contribution::zeros();
                    assert_eq!(pair.element(state, work, &mut to), state);
                    let terms = pair.terms(state, Components::Covariant, work);
                    let (tangent, scale) = (terms.tangent(), to.tangent.to_dense().amax());
                    for i in 0..2 * DOFS {
                        let residual = to.residual.entry(i) - terms.residual[i];
                        assert!(residual.abs() < 1e-13 * terms.residual.amax());
                        for j in 0..2 * DOFS {
                            let deviation = to.tangent.entry(i, j) - tangent[(i, j)];
                            assert!(deviation.abs() < 1e-13 * scale, "{state:?} {work:?} {deviation}");
                        }
                    }
                }
            }
        }
    }

    /// Central differences of the residual, with the closest point found again.
    #[test]
    fn the_tangent_of_contravariant_friction_is_the_derivative_of_its_residual() {
        for pair in pairs(State::Stick).chain(pairs(State::Slip)).step_by(3) {
            let state = pair.state;
            let at =
                |pair: &RandomPair| -> Terms { pair.terms(state, Components::Contravariant, Work::Paper) };
            let (terms, h) = (at(&pair), 1e-6);
            let tangent = terms.tangent();
            for j in 0..2 * DOFS {
                let [more, less] = [h, -h].map(|h| at(&pair.moved(j, h)).residual);
                let column = (more - less) / (2.0 * h);
                let deviation = (column - tangent.column(j)).amax();
                assert!(deviation < 1e-7 * tangent.amax(), "{state:?} {j}: {deviation}");
            }
        }
    }

    #[test]
    fn published_tangents_lack_what_is_said_of_them() {
        let of = |published, state| errors(published, state, 24, 3);
        assert!(of(Published::FourC, State::Frictionless).tangent[1] < 1e-12);
        assert!(of(Published::FourCBasic, State::Frictionless).tangent[0] > 1e-3);
        assert!(of(Published::Giraffe, State::Stick).tangent[1] == 0.0);
        assert!(of(Published::Giraffe, State::Slip).tangent[0] > 1e-3);
        assert!(of(Published::Lagged, State::Slip).tangent[0] > 1e-3);
        // The lagged tangent is the whole one less what is said.
        for pair in pairs(State::Slip) {
            let terms = pair.terms(State::Slip, Components::Covariant, Work::Rate);
            let lagged = terms.lagged();
            assert!((&lagged - lagged.transpose()).amax() < 1e-13 * lagged.amax());
            let lacks = [Term::Cone, Term::Stretch, Term::ParameterHessian, Term::Angle];
            let rest = lacks.iter().fold(terms.tangent(), |sum, &term| sum - terms.term(term).unwrap());
            let by_stretch = (rest - lagged).amax();
            assert!(by_stretch > 0.0 && by_stretch < 0.5 * terms.term(Term::Direction).unwrap().amax());
        }
    }
}
