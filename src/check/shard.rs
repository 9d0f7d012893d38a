//! Parts of the cases, for several machines.

use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
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
        let common = common_divisor(self.of, other.of);
        // By the Chinese remainder theorem.
        (self.number - 1) % common == (other.number - 1) % common
    }

    /// The shards that complete these, which do not overlap: as large as the numbers of parts of the given ones allow. There
    /// are none if all cases are held, or if the shards are too small to be listed.
    pub fn missing(known: &[Self]) -> Vec<Self> {
        let mut parts: Vec<u32> = known.iter().map(|shard| shard.of).collect();
        let multiple = parts.iter().try_fold(1_u32, |all, &of| {
            (all / common_divisor(all, of)).checked_mul(of).filter(|&all| all <= FINEST)
        });
        let Some(multiple) = multiple else { return Vec::new() };
        parts.push(multiple);
        parts.sort_unstable();
        parts.dedup();
        let held = |place: &u32| known.iter().any(|shard| shard.holds((*place).into()));
        let mut open: BTreeSet<u32> = (0..multiple).filter(|place| !held(place)).collect();
        let mut missing = Vec::new();
        for of in parts {
            for number in 1..=of {
                let of_shard = || (number - 1..multiple).step_by(of as usize);
                if of_shard().all(|place| open.contains(&place)) {
                    open.retain(|place| place % of != number - 1);
                    missing.push(Self { number, of });
                }
            }
        }
        missing
    }
}

/// The most parts into which cases are divided to find missing shards.
const FINEST: u32 = 1 << 16;

fn common_divisor(mut a: u32, mut b: u32) -> u32 {
    while b > 0 {
        (a, b) = (b, a % b);
    }
    a
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
    fn missing_shards_are_named() {
        for (known, missing) in [
            ("1/4", "2/4 3/4 4/4"),
            ("2/2", "1/2"),
            ("1/2 2/4", "4/4"),
            ("4/4 1/2", "2/4"),
            ("1/4 2/6", "3/4 4/6 6/6"),
            ("1/1", ""),
            ("1/99991 2/99991", ""),
        ] {
            let known: Vec<Shard> = known.split(' ').map(shard).collect();
            let found: Vec<String> = Shard::missing(&known).iter().map(Shard::to_string).collect();
            assert_eq!(found.join(" "), missing, "{known:?}");
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
