//! Counts in sentences.

/// A count with its noun: `1 entry`, `2 entries`.
pub(super) fn count(number: impl TryInto<u64>, noun: &str) -> String {
    let number = number.try_into().unwrap_or(u64::MAX);
    match (number, noun.strip_suffix('y'), noun.strip_suffix("um")) {
        (1, ..) => format!("1 {noun}"),
        (_, Some(stem), _) => format!("{number} {stem}ies"),
        (_, _, Some(stem)) => format!("{number} {stem}a"),
        (_, None, None) => format!("{number} {noun}s"),
    }
}

#[cfg(test)]
mod tests {
    use super::count;

    #[test]
    fn only_one_is_singular() {
        let of = |noun: &str| [0, 1, 2].map(|number: u64| count(number, noun)).join(", ");
        assert_eq!(of("closest point"), "0 closest points, 1 closest point, 2 closest points");
        assert_eq!(of("minimum"), "0 minima, 1 minimum, 2 minima");
        assert_eq!(of("entry"), "0 entries, 1 entry, 2 entries");
    }
}
