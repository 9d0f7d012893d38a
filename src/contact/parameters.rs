//! The parameters of the contact element.

use super::{ContactError, Law, NormalLaw};

/// The parameters of the contact element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<L = Law> {
    /// The normal law.
    pub law: L,
    /// eps_T > 0, the penalty of the elastic slip, a force over a length.
    pub eps_t: f64,
    /// mu >= 0, the coefficient of friction; 0 is frictionless.
    pub mu: f64,
    /// The virtual work of friction.
    pub work: Work,
    /// The previous normal is kept while the contact is open and d is at most this multiple of r + r_bar.
    pub normal_memory: f64,
}

/// The virtual work of the friction force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Work {
    /// T·(t δξ − t̄ δξ̄), the power of the friction force on the relative velocity.
    #[default]
    Rate,
    /// F δg_T + F̄ δḡ_T with the variations of eq. (20) of the paper. Beyond the rate it stretches the elements. This part
    /// vanishes as the steps become smaller. Its tangent in stick is almost symmetric.
    Paper,
}

impl<L> Parameters<L> {
    /// No friction.
    pub fn frictionless(law: L) -> Self {
        Self::with_friction(law, 1.0, 0.0)
    }

    /// Coulomb's friction with the penalty eps_T and the coefficient mu, by [`Work::Rate`].
    pub fn with_friction(law: L, eps_t: f64, mu: f64) -> Self {
        Self { law, eps_t, mu, work: Work::Rate, normal_memory: 4.0 }
    }
}

impl<L: NormalLaw> Parameters<L> {
    /// Checks the ranges.
    ///
    /// # Errors
    /// [`ContactError::Parameter`] with the first parameter that is out of range.
    pub fn check(&self) -> Result<(), ContactError> {
        let Self { eps_t, mu, normal_memory, .. } = *self;
        let invalid = self.law.invalid_parameter().or_else(|| {
            if !(eps_t > 0.0 && eps_t.is_finite()) {
                Some(("eps_T", eps_t))
            } else if !(mu >= 0.0 && mu.is_finite()) {
                Some(("mu", mu))
            } else if normal_memory >= 0.0 {
                None
            } else {
                Some(("normal_memory", normal_memory))
            }
        });
        invalid.map_or(Ok(()), |(name, value)| Err(ContactError::Parameter { name, value }))
    }
}
