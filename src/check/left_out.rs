//! The points of a regime that were not compared, and when they are too many to be passed over.

/// The largest share of the points of a regime that may be left out without a warning.
pub const LARGEST_SHARE: f64 = 0.02;

/// The points of a regime that were not compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// The regime.
    pub regime: String,
    /// The number of points that were not compared.
    pub not_compared: u64,
    /// The number of points.
    pub of: u64,
}

impl LeftOut {
    /// Whether the share exceeds [`LARGEST_SHARE`].
    #[expect(clippy::cast_precision_loss, reason = "a share")]
    pub fn is_large(&self) -> bool {
        self.not_compared as f64 > LARGEST_SHARE * self.of as f64
    }
}

/// The warning if too many points were left out in some regimes, each given by its name, its points that were not compared,
/// and all its points; `points` names them in the plural.
///
/// ```
/// use beamgap::check::left_out_warning;
///
/// assert_eq!(left_out_warning([("generic", 2, 100)], "points"), None);
/// let told = left_out_warning([("generic", 3, 100), ("slender", 0, 100)], "points").unwrap();
/// assert_eq!(told, "3 of 100 points of generic are not compared.");
/// ```
pub fn left_out_warning<'a>(
    regimes: impl IntoIterator<Item = (&'a str, u64, u64)>,
    points: &str,
) -> Option<String> {
    let all = regimes.into_iter();
    let large: Vec<LeftOut> = all
        .map(|(regime, not_compared, of)| LeftOut { regime: regime.to_owned(), not_compared, of })
        .filter(LeftOut::is_large)
        .collect();
    let words: Vec<String> = large
        .iter()
        .enumerate()
        .map(|(i, LeftOut { regime, not_compared, of })| {
            let points = if i == 0 { format!(" {points}") } else { String::new() };
            format!("{not_compared} of {of}{points} of {regime}")
        })
        .collect();
    let (last, first) = words.split_last()?;
    let list = if first.is_empty() { last.clone() } else { format!("{} and {last}", first.join(", ")) };
    let verb = if large.len() == 1 && large[0].not_compared == 1 { "is" } else { "are" };
    Some(format!("{list} {verb} not compared."))
}

#[cfg(test)]
mod tests {
    use super::{LeftOut, left_out_warning};

    #[test]
    fn more_than_two_percent_of_a_regime_are_too_many() {
        let is_large = |not_compared, of| LeftOut { regime: String::new(), not_compared, of }.is_large();
        assert!(
            !is_large(0, 0) && !is_large(2, 100) && is_large(3, 100) && is_large(1, 49) && !is_large(1, 50)
        );
    }

    #[test]
    fn the_warning_names_each_regime() {
        let told = left_out_warning([("a", 1, 11), ("b", 0, 11), ("c", 2, 11), ("d", 3, 11)], "cases");
        assert_eq!(told.unwrap(), "1 of 11 cases of a, 2 of 11 of c and 3 of 11 of d are not compared.");
    }
}
