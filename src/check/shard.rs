//! Parts of the cases, for several machines.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// One of several parts of the cases, written `i/n`: every n-th case, from the i-th on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Shard {
    number: u32,
    of: u32,
}

impl Shard {
    /// All cases.
    pub const WHOLE: Self = Self { number: 1, of: 1 };

    /// Whether the case at this place belongs to it.
    pub(super) fn holds(self, place: u64) -> bool {
        place % u64::from(self.of) == u64::from(self.number - 1)
    }

    /// How many of these places belong to it.
    pub(super) fn count(self, places: Range<u64>) -> u64 {
        let before = |end: u64| (end + u64::from(self.of - self.number)) / u64::from(self.of);
        before(places.end) - before(places.start)
    }

    /// Whether some case may belong to both shards.
    pub fn overlaps(self, other: Self) -> bool {
        let (mut a, mut b) = (self.of, other.of);
        while b > 0 {
            (a, b) = (b, a % b);
        }
        // By the Chinese remainder theorem.
        (self.number - 1) % a == (other.number - 1) % a
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl From<Shard> for String {
    fn from(shard: Shard) -> Self {
        shard.to_string()
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parsed = text.split_once('/').and_then(|(number, of)| {
            let is_plain = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
            if is_plain(number) && is_plain(of) {
                Some((number.parse().ok()?, of.parse().ok()?))
            } else {
                None
            }
        });
        match parsed {
            Some((number, of)) if number > 0 && number <= of => Ok(Self { number, of }),
            _ => Err("i/n expected, with i from 1 to n".to_owned()),
        }
    }
}

impl TryFrom<String> for Shard {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}

#[cfg(test)]
mod tests {
    use super::Shard;

    fn shard(text: &str) -> Shard {
        text.parse().unwrap()
    }

    #[test]
    fn shards_overlap_where_they_share_a_case() {
        for of in 1..=6 {
            for other in 1..=6 {
                for (i, j) in (1..=of).flat_map(|i| (1..=other).map(move |j| (i, j))) {
                    let (one, two) = (shard(&format!("{i}/{of}")), shard(&format!("{j}/{other}")));
                    let share = (0..60).any(|place| one.holds(place) && two.holds(place));
                    assert_eq!(one.overlaps(two), share, "{one} {two}");
                }
            }
        }
    }

    #[test]
    fn places_are_counted() {
        for (of, start, end) in
            (1..=5).flat_map(|of| (0..7).flat_map(move |a| (a..12).map(move |b| (of, a, b))))
        {
            for number in 1..=of {
                let shard = shard(&format!("{number}/{of}"));
                let expected = (start..end).filter(|&place| shard.holds(place)).count() as u64;
                assert_eq!(shard.count(start..end), expected, "{shard} {start} {end}");
            }
        }
    }

    #[test]
    fn a_shard_is_one_of_so_many() {
        assert_eq!(shard("1/1"), Shard::WHOLE);
        assert_eq!(shard("3/8").to_string(), "3/8");
        for wrong in ["", "1", "0/2", "3/2", "1/0", "-1/2", "+1/2", "1/2/3", "a/b", "1/99999999999"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
