//! Results are the same in every layout, by blocks and by matrices.

#![expect(clippy::float_cmp, reason = "layouts hold the same bits")]
#![expect(clippy::large_stack_arrays, reason = "five quantities of 22 dofs")]

use crate::kernel::{flat, flat_expansion, tolerances, without_slips};
use crate::pairs::{Contacting, any_arc, any_helix, contacting, hermite, quadratic};
use beamgap::curve::Curve;
use beamgap::linearization::closed_form::kernel::{DistanceAlone, Full, Gradient, Packed};
use beamgap::linearization::closed_form::{Formulation, Matrices, Points, jets};
use beamgap::linearization::{Derivatives, Linearization};
use beamgap::pair::DofVector;
use nalgebra::SVector;
use proptest::prelude::*;

proptest! {
    #[test]
    fn layouts_agree(case in contacting(quadratic(), hermite())) {
        let Contacting { pair, q, point, .. } = &case;
        let (mut full, mut blocks) = ([Full::<f64, 21>::zeros(); 5], [Derivatives::zero(); 5]);
        let (mut packed, mut gradient) = ([Packed::<f64, 21, 231>::zeros(); 5], [Gradient::<f64, 21>::zeros(); 5]);
        pair.write(q, point, without_slips(&mut full));
        pair.write(q, point, without_slips(&mut blocks));
        pair.write(q, point, without_slips(&mut packed));
        pair.write(q, point, without_slips(&mut gradient));
        let tolerances = tolerances::<_, _, 9, 12, 21>(&case);
        for (i, full) in full.iter().enumerate() {
            let values = [blocks[i].value, packed[i].value, gradient[i].value];
            prop_assert_eq!(values, [full.value; 3]);
            prop_assert!(packed[i].gradient == full.gradient && gradient[i].gradient == full.gradient);
            for (j, row) in full.hessian.iter().enumerate() {
                prop_assert_eq!(blocks[i].gradient.entry(j), full.gradient[j]);
                for (k, entry) in row.iter().enumerate() {
                    // Only one triangle is computed. The other differs by the order of sums.
                    let tolerance = tolerances[i][1 + 21 + 21 * j + k];
                    prop_assert!((packed[i].entry(j, k) - entry).abs() <= tolerance);
                    prop_assert!((blocks[i].hessian.entry(j, k) - entry).abs() <= tolerance);
                    if k <= j {
                        prop_assert_eq!(packed[i].entry(j, k), *entry);
                        // Matrices are stored column by column.
                        prop_assert_eq!(blocks[i].hessian.entry(k, j), *entry);
                    }
                }
            }
        }
        let mut d = Full::<f64, 21>::zeros();
        pair.write(q, point, DistanceAlone { d: &mut d });
        prop_assert!(d == full[0], "d alone is d");
    }

    /// The previous content of the memory does not occur in the result.
    #[test]
    fn linearizations_write_every_number(
        case in contacting(quadratic(), hermite()),
        other in contacting(hermite(), any_arc()),
    ) {
        fn written<A: Curve<N>, B: Curve<M>, const N: usize, const M: usize>(
            Contacting { pair, q, point, .. }: &Contacting<A, B, N, M>,
        ) -> bool {
            let mut number = Derivatives::<f64, N, M>::zero();
            number.value = f64::NAN;
            number.gradient = DofVector { beam: SVector::repeat(f64::NAN), bar: SVector::repeat(f64::NAN) };
            number.hessian.beam.fill(f64::NAN);
            number.hessian.mixed.fill(f64::NAN);
            number.hessian.bar.fill(f64::NAN);
            let mut to = Linearization::zeros();
            [to.d, to.t, to.t_bar, to.xi, to.xi_bar, to.g_t, to.g_t_bar] = [number; 7];
            to.radii = f64::NAN;
            pair.linearize_into(q, point, &mut to);
            let mut clear = Linearization::zeros();
            pair.linearize_into(q, point, &mut clear);
            // A NaN does not equal any number.
            to == clear && *pair.linearize(q, point) == clear
        }
        prop_assert!(written(&case) && written(&other));
    }

    /// Curves without shape functions are linearized too.
    #[test]
    fn curves_without_shape_functions(case in contacting(hermite(), any_arc())) {
        let Contacting { pair, q, point, .. } = &case;
        let mut full = [Full::<f64, 21>::zeros(); 5];
        pair.write(q, point, without_slips(&mut full));
        let at = (point.xi, point.xi_bar);
        let (jet, jet_bar) = jets(pair, q, at);
        let form = Formulation::at(&Points::new(&jet.geometry, &jet_bar.geometry), point.held());
        let Linearization::<f64, 12, 9> { d, xi, xi_bar, t, t_bar, .. } =
            Matrices::in_formulation(&jet, &jet_bar, form).all(at, &pair.contact);
        prop_assert_eq!(full.each_ref().map(flat), [d, xi, xi_bar, t, t_bar].map(flat_expansion));
    }

    /// The packed layout also works for curves without shape functions whose number of dofs is not a multiple of three.
    #[test]
    fn halves_of_curves_without_shape_functions(case in contacting(any_helix(), hermite())) {
        let Contacting { pair, q, point, .. } = &case;
        let (mut full, mut packed) = ([Full::<f64, 22>::zeros(); 5], [Packed::<f64, 22, 253>::zeros(); 5]);
        pair.write(q, point, without_slips(&mut full));
        pair.write(q, point, without_slips(&mut packed));
        for (full, packed) in full.iter().zip(&packed) {
            prop_assert!(packed.gradient == full.gradient && packed.value == full.value);
            let half: Vec<f64> = full.hessian.iter().enumerate().flat_map(|(i, row)| row[..=i].to_vec()).collect();
            prop_assert_eq!(&packed.hessian[..], &half[..]);
        }
    }
}
