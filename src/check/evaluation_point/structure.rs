//! The closed form with a simplification as derivations have it: several terms are missing at once.

use super::{EvaluationPoint, of_value};
use crate::closest_point::Held;
use crate::linearization::closed_form::{Formulation, PartialVariations, variations_in};
use crate::linearization::{COMPONENTS, Varied};
use crate::number::{Faulty, Real};
use crate::test_beam::{Padded, PaddedBeam, map_padded};
use crate::variant::{SCALARS, Step, contracted};
use nalgebra::Vector3;

enumeration! {
    /// A simplification.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub(in crate::check) enum Structure {
        /// The parameters of the closest point do not vary.
        FixedParameters,
        /// The curves are straight at the closest point: t,xi and higher derivatives are zero.
        Straight,
        /// The curves are linear in their dofs.
        LinearInDofs,
    }
}

impl EvaluationPoint<'_> {
    /// The variations, and the matrices contracted.
    pub(in crate::check) fn simplified(
        &self,
        structure: Structure,
    ) -> ([Varied<f64>; COMPONENTS], [[f64; 3]; SCALARS]) {
        let Self { at: (xi, xi_bar), contact, .. } = *self;
        let at = (xi.value, xi_bar.value);
        let form = match structure {
            Structure::FixedParameters => Formulation::paper(Held { xi: true, xi_bar: true }),
            _ => self.form,
        };
        let [beam, bar] = self.partial_variations(Step::Now).map(|beam| structure.of_partial(beam));
        let varied = variations_in(form, &beam, &bar, at, contact).components();
        let at = (Faulty(at.0), Faulty(at.1));
        let rows = if self.has_few_dofs() {
            let beams = self.padded_few(Step::Now).each_ref();
            contracted(&beams.map(|beam| structure.of_padded(map_padded(beam, of_value))), at, form, contact)
        } else {
            let beams = self.padded(Step::Now).each_ref();
            contracted(&beams.map(|beam| structure.of_padded(map_padded(beam, of_value))), at, form, contact)
        };
        (varied, rows.map(|row| row.map(|Faulty(number)| number)))
    }
}

impl Structure {
    fn of_partial(self, mut beam: PartialVariations<f64>) -> PartialVariations<f64> {
        match self {
            Self::FixedParameters => {}
            Self::Straight => {
                (beam.geometry.t_xi, beam.geometry.t_xixi) = (Vector3::zeros(), Vector3::zeros());
                (beam.delta_u[2], beam.linear_u[2]) = (Vector3::zeros(), Vector3::zeros());
            }
            Self::LinearInDofs => beam.second_u = [Vector3::zeros(); 2],
        }
        beam
    }

    fn of_padded<T: Real, const D: usize>(self, (mut jet, vectors): PaddedBeam<T, D>) -> PaddedBeam<T, D> {
        match (self, &mut jet.dofs) {
            (Self::FixedParameters, _) | (Self::LinearInDofs, Padded::Linear(_)) => {}
            (Self::Straight, dofs) => {
                (jet.geometry.t_xi, jet.geometry.t_xixi) = (Vector3::zeros(), Vector3::zeros());
                match dofs {
                    Padded::Linear(shapes) => shapes[2].fill(T::zero()),
                    Padded::Nonlinear(jacobians, _) => jacobians[2].fill(T::zero()),
                }
            }
            (Self::LinearInDofs, Padded::Nonlinear(_, second)) => {
                for second in second {
                    second.fill(T::zero());
                }
            }
        }
        (jet, vectors)
    }
}
