//! The history of a contact: what a converged step leaves to the next one.
//!
//! It belongs to a pair of beams and to one minimum of their distance. It is written at convergence only. Every iteration of a
//! step starts from the history of the last converged step.

use super::ContactError;
use crate::closest_point::Held;
use nalgebra::Vector3;

/// The contact at the last converged step.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct History {
    /// n, the unit normal from the bar beam to the beam, if it is known. It tells on which side the beam is, also after the
    /// centroids have crossed.
    pub normal: Option<Vector3<f64>>,
    /// The slips, if the beams were in contact.
    pub slips: Option<Slips>,
}

/// The slips at the last converged step.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Slips {
    /// xi_n, the parameter of the contact point. It lies outside [-1, 1] after a change of the element.
    pub xi: f64,
    /// xi_bar_n, the same on the bar beam.
    pub xi_bar: f64,
    /// e_n, the elastic slip along the beam, a length.
    pub e: f64,
    /// e_bar_n, the elastic slip along the bar beam.
    pub e_bar: f64,
    /// Which parameters were held.
    pub held: Held,
    /// c_n, the cosine of the angle between the tangents.
    pub cosine: f64,
    /// Whether the beams slipped.
    pub is_slipping: bool,
}

/// The start of the slips of a step: [`Slips`] for the parameters that are held now. All numbers are constants of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// xi_n.
    pub xi: f64,
    /// xi_bar_n.
    pub xi_bar: f64,
    /// e_n; 0 if xi is held.
    pub e: f64,
    /// e_bar_n; 0 if xi_bar is held.
    pub e_bar: f64,
}

/// How much n·n may differ from 1.
const UNIT: f64 = 1e-9;

impl History {
    /// The start of the slips with these parameters held, if the beams were in contact.
    ///
    /// A parameter that becomes held loses its elastic slip, and the slip along the other beam keeps the force along that
    /// beam: e_bar_n becomes e_bar_n - c_n e_n. If both are held, or one takes the place of the other, no slip is left.
    pub fn start(&self, held: Held) -> Option<Start> {
        let Slips { xi, xi_bar, e, e_bar, held: before, cosine, .. } = self.slips?;
        let changes = held.xi != before.xi && held.xi_bar != before.xi_bar;
        let (e, e_bar) = match (held.xi, held.xi_bar) {
            (true, true) => (0.0, 0.0),
            _ if changes && (before.xi || before.xi_bar) => (0.0, 0.0),
            (true, false) => (0.0, e_bar - cosine * e),
            (false, true) => (e - cosine * e_bar, 0.0),
            (false, false) => (e, e_bar),
        };
        Some(Start { xi, xi_bar, e, e_bar })
    }

    /// The history without contact.
    #[must_use]
    pub fn opened(self) -> Self {
        Self { slips: None, ..self }
    }

    /// Checks that all numbers are finite and in their ranges.
    ///
    /// # Errors
    /// [`ContactError::History`] with the first number that is not.
    pub fn check(&self) -> Result<(), ContactError> {
        let mut invalid = None;
        let mut check = |name, value: f64, is_valid: bool| {
            if !is_valid && invalid.is_none() {
                invalid = Some(ContactError::History { name, value });
            }
        };
        if let Some(n) = self.normal {
            let square = n.dot(&n);
            check("n.n", square, (square - 1.0).abs() < UNIT);
        }
        if let Some(Slips { xi, xi_bar, e, e_bar, held, cosine, .. }) = self.slips {
            check("xi_n", xi, xi.is_finite());
            check("xi_bar_n", xi_bar, xi_bar.is_finite());
            check("e_n", e, e.is_finite() && !(held.xi && e != 0.0));
            check("e_bar_n", e_bar, e_bar.is_finite() && !(held.xi_bar && e_bar != 0.0));
            check("c_n", cosine, cosine.abs() <= 1.0 + UNIT);
        }
        invalid.map_or(Ok(()), Err)
    }
}
