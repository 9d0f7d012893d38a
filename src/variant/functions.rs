//! The library's public functions at a closest point, called as a user calls them: with the beams' own numbers of dofs,
//! in each layout, in lanes, and by each route of automatic differentiation.
//!
//! The kernel is compiled for numbers of dofs. The beams of the families are put in as tabulated curves with the numbers
//! of dofs that they have; a beam of 12 dofs is also put in with 15, which no family has. The layouts and the lanes are
//! compiled for three pairs of numbers that reach every branch: the beam with fewer, as many and more dofs; rows of
//! even and odd lengths; up to four control vectors, and more.

mod expansion;
mod linearized;
mod returned;
mod routes;
mod tabulated;
mod typed;

use crate::closest_point::ClosestPoint;
use crate::pair::Contact;
use crate::test_beam::PaddedBeam;
use linearized::{batches, layouts, linearized};
use tabulated::{Beam, TabulatedBeams};

pub(crate) use returned::Returned;
pub(crate) use routes::routes;
pub(crate) use typed::of_curves;

/// The functions for each pair of numbers of dofs.
macro_rules! for_dofs {
    ($beams:expr; $([$n:literal, $m:literal])*) => {
        match $beams.beams.each_ref().map(Beam::dofs) {
            $([$n, $m] => linearized::<{ $n / 3 }, { $m / 3 }, $n, $m>(
                [
                    concat!("linearize, ", $n, " + ", $m, " dofs"),
                    concat!("linearize_into, ", $n, " + ", $m, " dofs"),
                    concat!("write DistanceAlone, ", $n, " + ", $m, " dofs"),
                ],
                $beams,
            ),)*
            _ => Vec::new(),
        }
    };
}

/// The functions for each pair of numbers of dofs, in every layout and in lanes.
macro_rules! in_layouts {
    ($beams:expr; $([$n:literal, $m:literal])*) => {
        match $beams.beams.each_ref().map(Beam::dofs) {
            $([$n, $m] => {
                let mut all = layouts::<
                    { $n / 3 },
                    { $m / 3 },
                    $n,
                    $m,
                    { $n + $m },
                    { ($n + $m) * ($n + $m + 1) / 2 },
                >(
                    [
                        concat!("write WithSlips, blocks of ", $n, " + ", $m),
                        concat!("write WithSlips, full, ", $n, " + ", $m),
                        concat!("write WithSlips, packed, ", $n, " + ", $m),
                        concat!("write WithSlips, gradients, ", $n, " + ", $m),
                        concat!("write WithoutSlips, gradients, ", $n, " + ", $m),
                        concat!("write DistanceAlone, full, ", $n, " + ", $m),
                        concat!("write DistanceAlone, packed, ", $n, " + ", $m),
                        concat!("write_over WithSlips, ", $n, " + ", $m),
                        concat!("write_over WithoutSlips, ", $n, " + ", $m),
                        concat!("write_over DistanceAlone, ", $n, " + ", $m),
                    ],
                    $beams,
                );
                all.extend(batches::<{ $n / 3 }, { $m / 3 }, $n, $m>(
                    [
                        concat!("write_d_batch of 4, ", $n, " + ", $m),
                        concat!("write_d_batch of 5, ", $n, " + ", $m),
                        concat!("write_d_batch of 6, ", $n, " + ", $m),
                        concat!("write_d_batch of 7, ", $n, " + ", $m),
                    ],
                    $beams,
                ));
                all
            })*
            _ => Vec::new(),
        }
    };
}

/// The number of numbers that the functions of the kernel return for these numbers of dofs, written down apart from the
/// functions: values, both first variations and second variations.
pub(crate) fn kernel_entries(dofs: [usize; 2]) -> usize {
    // Seven scalars and g_N twice, and d.
    let each = 2 * 8 * 4 + 4;
    // Three layouts; gradients with and without slips; d in two layouts; over any scalar; batches of four to seven pairs.
    let in_layouts = 3 * 7 * 4 + (7 + 5) * 3 + 2 * 4 + (7 + 5 + 1) * 4 + (4 + 5 + 6 + 7) * 4;
    match dofs {
        [12, 12] => 3 * each + in_layouts,
        [6, 9] | [18, 12] => each + in_layouts,
        _ => each,
    }
}

/// The same of the functions for any curve and of the routes: all 23 components, the scalars, d alone, the scalars without
/// slips, and the vectors.
pub(crate) const ROUTE_ENTRIES: usize = 4 * 23 * 4 + 5 * 8 * 4 + 3 * 4 + 5 * 4 + 15 * 4;

fn of_dofs(beams: &TabulatedBeams<'_>) -> Vec<Returned> {
    for_dofs!(beams;
        [6, 6] [6, 9] [6, 12] [6, 18]
        [9, 6] [9, 9] [9, 12] [9, 18]
        [12, 6] [12, 9] [12, 12] [12, 18]
        [18, 6] [18, 9] [18, 12] [18, 18]
        [15, 12] [12, 15]
    )
}

/// The kernel's functions, with the machine's vector units; none if a curve has no shape functions.
pub(crate) fn kernel_functions(
    padded: &[PaddedBeam<f64>; 2],
    dofs: [usize; 2],
    point: &ClosestPoint,
    contact: Contact,
) -> Vec<Returned> {
    // In a page they would take most of the module.
    if cfg!(target_arch = "wasm32") {
        return Vec::new();
    }
    let [padded, padded_bar] = padded;
    let (Some(beam), Some(bar)) =
        (Beam::new(padded, dofs[0], point.xi), Beam::new(padded_bar, dofs[1], point.xi_bar))
    else {
        return Vec::new();
    };
    let of = |beams: [Beam; 2]| TabulatedBeams { beams, point, contact };
    let own = of([beam.clone(), bar.clone()]);
    let mut all = of_dofs(&own);
    all.extend(in_layouts!(&own; [6, 9] [12, 12] [18, 12]));
    if dofs == [12, 12] {
        all.extend(of_dofs(&of([beam.with_one_more(), bar.clone()])));
        all.extend(of_dofs(&of([beam, bar.with_one_more()])));
    }
    all
}
