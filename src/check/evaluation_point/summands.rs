//! The summands of the Hessians as matrix formulas have them: each product of two first variations is one.
//!
//! A program that writes such a formula can lose one of the two transposed products of a sum, write one twice, or miss a
//! division. These are not faults of single terms of the closed form, in which both products are one term.

mod sums;
mod system;

use super::EvaluationPoint;
use crate::linearization::closed_form::Projection;
use crate::linearization::{COMPONENTS, Quantity, Varied};
use crate::number::{Label, Which};
use crate::variant::{Step, Variant};
use nalgebra::Vector3;

/// What is wrong with a summand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::check) enum Error {
    /// It is multiplied. The increment is the summand itself, so that a factor can be fitted.
    Factor,
    /// It is multiplied by a power of the length or of the determinant that its sum is divided by.
    Power(i32),
    /// A term of the matrix of the parameters is multiplied, in second variations alone.
    System(f64),
}

/// A summand, or a sum as a whole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::check) struct Summand {
    /// The sum and the summand.
    pub(in crate::check) label: Label,
    /// How often the sum has it: several products of Jacobians contain it.
    pub(in crate::check) count: u8,
    pub(in crate::check) error: Error,
    /// The index of the same summand with both beams exchanged.
    pub(in crate::check) mirror: Option<usize>,
    /// The index of the transposed summand.
    pub(in crate::check) transposed: Option<usize>,
}

/// The change of the first variations along both directions and of the second variation, of all components.
pub(in crate::check) type Increment = [[f64; 3]; COMPONENTS];

/// The first variations along one direction.
#[derive(Clone, Copy, Debug)]
struct Along {
    /// Of u, u,xi and u,xixi at a fixed parameter, by beam.
    u: [[Vector3<f64>; 3]; 2],
    /// Of the parameters.
    xi: [f64; 2],
    /// Of the lengths of the tangents.
    length: [f64; 2],
    u_hat: Vector3<f64>,
}

/// A closest point with its first variations along both directions.
struct Point {
    directions: [Along; 2],
    t: [Vector3<f64>; 2],
    t_xi: [Vector3<f64>; 2],
    t_xixi: [Vector3<f64>; 2],
    d: Vector3<f64>,
    projection: Projection<f64>,
    /// The differences of the parameters from the reference parameters of the slips.
    slips: [f64; 2],
    varied: [Varied<f64>; COMPONENTS],
}

/// The sums that the Hessians are computed from, contracted with the directions, or changes of them.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    /// P and P_bar, the right-hand sides of eq. (59).
    p: [f64; 2],
    /// The Hessians of xi and xi_bar.
    h: [f64; 2],
    /// H_d.
    d: f64,
    /// H_t and H_t_bar.
    t: [f64; 2],
    /// H_g_T and H_g_T_bar.
    g_t: [f64; 2],
}

impl EvaluationPoint<'_> {
    /// All summands, always in the same order, each with the change of all components by it.
    pub(in crate::check) fn summands(&self) -> Vec<(Summand, Increment)> {
        let point = self.point_along_both();
        let mut all = point.all_summands();
        all.extend(point.system_errors());
        for i in 0..all.len() {
            let Summand { label, error, .. } = all[i].0;
            let is_mirror = |(other, _): &(Summand, Increment)| {
                other.label.name == label.name && other.label.which != label.which && other.error == error
            };
            all[i].0.mirror = all.iter().position(is_mirror);
        }
        all
    }

    fn point_along_both(&self) -> Point {
        let varied = self.plain(&Variant::Unmodified);
        let beams = self.partial_variations(Step::Now);
        let geometry = beams.map(|beam| beam.geometry);
        let along = |u: [[Vector3<f64>; 3]; 2], first: fn(&Varied<f64>) -> f64| Along {
            u,
            xi: Quantity::PARAMETERS.map(|of| first(&varied[of.component()])),
            length: Quantity::LENGTHS.map(|of| first(&varied[of.component()])),
            u_hat: u[0][0] - u[1][0],
        };
        let delta = along(beams.map(|beam| beam.delta_u), |of| of.delta);
        let linear = along(beams.map(|beam| beam.linear_u), |of| of.linear);
        Point {
            directions: [delta, linear],
            t: geometry.map(|of| of.t),
            t_xi: geometry.map(|of| of.t_xi),
            t_xixi: geometry.map(|of| of.t_xixi),
            d: geometry[0].x - geometry[1].x,
            projection: Projection::new(&geometry[0], &geometry[1], self.held),
            slips: [self.at.0.value - self.contact.xi_0, self.at.1.value - self.contact.xi_bar_0],
            varied,
        }
    }
}

impl Point {
    /// The change of all second variations by changes of the sums.
    fn increment(&self, sums: Sums) -> Increment {
        let mut all = Increment::default();
        let solved = self.projection.solve(sums.p[0], sums.p[1]);
        let h = [sums.h[0] + solved.0, sums.h[1] + solved.1];
        for axis in 0..3 {
            for (beam, h) in h.into_iter().enumerate() {
                all[Quantity::POINTS[beam].component() + axis][2] = self.t[beam][axis] * h;
                all[Quantity::TANGENTS[beam].component() + axis][2] = self.t_xi[beam][axis] * h;
            }
            let [x, x_bar] = Quantity::POINTS.map(|of| all[of.component() + axis][2]);
            all[Quantity::DVector.component() + axis][2] = x - x_bar;
        }
        for of in [Quantity::D, Quantity::GN] {
            all[of.component()][2] = sums.d;
        }
        for (beam, h) in h.into_iter().enumerate() {
            let length = self.varied[Quantity::LENGTHS[beam].component()].value;
            let t = self.t[beam].dot(&self.t_xi[beam]) / length * h + sums.t[beam];
            all[Quantity::LENGTHS[beam].component()][2] = t;
            all[Quantity::PARAMETERS[beam].component()][2] = h;
            all[Quantity::SLIPS[beam].component()][2] = self.slips[beam] * t + length * h + sums.g_t[beam];
        }
        all
    }

    /// The change of all first variations of some components by a factor.
    fn of_first(&self, scalars: &[Quantity], factor: f64) -> Increment {
        let mut all = Increment::default();
        for i in scalars.iter().map(|of| of.component()) {
            let Varied { delta, linear, .. } = self.varied[i];
            all[i] = [(factor - 1.0) * delta, (factor - 1.0) * linear, 0.0];
        }
        all
    }
}

const BEAMS: [Which; 2] = [Which::Beam, Which::Bar];
