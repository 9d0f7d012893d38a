//! The code under check, and the oracles.

use super::draw::place_in_regime;
use crate::variant::Variant;

/// The closed form under check, and the oracles that it is compared with.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CheckConfig {
    /// The closed form: unmodified by default.
    pub variant: Variant,
    /// Automatic differentiation by default.
    pub oracles: Oracles,
}

/// Which oracles the closed form is compared with.
///
/// Where it disagrees with automatic differentiation, the differences are always computed, to arbitrate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Oracles {
    /// Automatic differentiation.
    #[default]
    Ad,
    /// Also the differences in double-double: in every thirteenth case of each regime, which reaches all pairs of
    /// families, and wherever the tolerance for AD is not meaningful.
    Sample,
    /// Also the differences in double-double, in every case.
    All,
}

impl Oracles {
    pub(super) fn asks_differences(self, number: u64) -> bool {
        match self {
            Self::Ad => false,
            Self::Sample => place_in_regime(number).is_multiple_of(13),
            Self::All => true,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Oracles;
    use crate::check::Regime;

    #[test]
    fn a_sample_is_every_thirteenth_case_of_each_regime() {
        // Badly scaled cases have their own numbers.
        let regimes = Regime::ALL.len() as u64 - 1;
        for number in 0..40 * regimes {
            assert!(!Oracles::Ad.asks_differences(number) && Oracles::All.asks_differences(number));
            assert_eq!(Oracles::Sample.asks_differences(number), (number / regimes).is_multiple_of(13));
        }
    }
}
