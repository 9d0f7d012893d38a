//! A case without the seed and the number that drew it: all its numbers.

use super::compare::{Compared, compare_beams};
use super::trial::{Oracles, Trial};
use crate::pair::Contact;
use crate::specimen::{AnyBeam, Specimen, SpecimenError};

/// A pair of beams written out as numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    /// Beam and bar beam.
    pub specimens: [Specimen; 2],
    /// Radii and reference parameters.
    pub contact: Contact,
}

impl Written {
    /// The same with every length times 2^`power`: the same numbers in another unit.
    #[must_use]
    pub fn scaled(&self, power: i32) -> Self {
        let factor = 2.0_f64.powi(power);
        let Contact { radius, radius_bar, xi_0, xi_bar_0 } = self.contact;
        Self {
            specimens: self.specimens.each_ref().map(|specimen| specimen.scaled(power)),
            contact: Contact { radius: radius * factor, radius_bar: radius_bar * factor, xi_0, xi_bar_0 },
        }
    }

    /// Compares it with the oracles at each of its closest points.
    ///
    /// # Errors
    /// If the numbers make no beam.
    pub fn compare(&self, trial: &Trial) -> Result<Compared, SpecimenError> {
        let beams = self.beams()?;
        let asked = trial.oracles == Oracles::All;
        Ok(compare_beams(trial, asked, beams.each_ref().map(|beam| &**beam), &self.contact))
    }

    pub(super) fn beams(&self) -> Result<[Box<dyn AnyBeam>; 2], SpecimenError> {
        let [beam, bar] = &self.specimens;
        Ok([beam.beam()?, bar.beam()?])
    }
}
