//! How results are serialized: enums by name, maps by their keys, and numbers that JSON does not have as words.
//!
//! A result that is read back is equal to the last bit. Therefore parts of a run can be merged, and pages made again.

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// A name from the code. As `&'static str` it would make serde require text of static lifetime.
pub(crate) type Name = &'static str;

/// Serializes enums by their `name`, and finds them by name in `ALL` for deserialization.
macro_rules! by_name {
    ($($type:ty),* $(,)?) => {$(
        impl serde::Serialize for $type {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.name())
            }
        }

        impl<'de> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let name = String::deserialize(deserializer)?;
                let found = <$type>::ALL.into_iter().find(|one| one.name() == name);
                let names = || <$type>::ALL.map(|one| one.name()).join(", ");
                found.ok_or_else(|| serde::de::Error::custom(format!("one of {} expected, found {name:?}", names())))
            }
        }
    )*};
}
pub(crate) use by_name;

by_name!(crate::linearization::Quantity, crate::test_beam::Family, crate::contact::State);

/// A number, or `"inf"`, `"-inf"` or `"NaN"`.
pub(crate) mod number {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serializer};

    #[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it with a reference")]
    pub(crate) fn serialize<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        if number.is_finite() { serializer.serialize_f64(*number) } else { serializer.collect_str(number) }
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Written {
            Number(f64),
            Word(String),
        }
        match Written::deserialize(deserializer)? {
            Written::Number(number) => Ok(number),
            Written::Word(word) => word.parse().map_err(D::Error::custom),
        }
    }
}

/// The same with two digits, for measured numbers without more meaningful digits.
pub(crate) mod short {
    pub(crate) use super::number::deserialize;
    use serde::Serializer;

    #[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it with a reference")]
    pub(crate) fn serialize<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        super::number::serialize(&format!("{number:.1e}").parse().unwrap_or(*number), serializer)
    }

    #[expect(clippy::ref_option, reason = "serde calls it with a reference")]
    pub(crate) fn option<S: Serializer>(number: &Option<f64>, serializer: S) -> Result<S::Ok, S::Error> {
        match number {
            Some(number) => serialize(number, serializer),
            None => serializer.serialize_none(),
        }
    }
}

/// A map with two keys, as a map of maps.
pub(crate) mod nested {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};
    use std::collections::BTreeMap;

    pub(crate) fn serialize<S, A, B, V>(map: &BTreeMap<(A, B), V>, serializer: S) -> Result<S::Ok, S::Error>
    where
        S: Serializer,
        A: Ord + Serialize,
        B: Ord + Serialize,
        V: Serialize,
    {
        let mut outer: BTreeMap<&A, BTreeMap<&B, &V>> = BTreeMap::new();
        for ((a, b), value) in map {
            outer.entry(a).or_default().insert(b, value);
        }
        outer.serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D, A, B, V>(deserializer: D) -> Result<BTreeMap<(A, B), V>, D::Error>
    where
        D: Deserializer<'de>,
        A: Ord + Copy + Deserialize<'de>,
        B: Ord + Deserialize<'de>,
        V: Deserialize<'de>,
    {
        let outer: BTreeMap<A, BTreeMap<B, V>> = BTreeMap::deserialize(deserializer)?;
        Ok(outer
            .into_iter()
            .flat_map(|(a, inner)| inner.into_iter().map(move |(b, value)| ((a, b), value)))
            .collect())
    }
}

/// A name of the code. Equal names are stored once.
pub(crate) fn name<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Name, D::Error> {
    static NAMES: Mutex<BTreeSet<Name>> = Mutex::new(BTreeSet::new());
    let name = String::deserialize(deserializer)?;
    if name.len() > 100 {
        return Err(D::Error::custom("a name expected, found a longer text"));
    }
    let mut names = NAMES.lock().unwrap_or_else(PoisonError::into_inner);
    let known = names.get(name.as_str()).copied();
    Ok(known.unwrap_or_else(|| {
        let name: Name = Box::leak(name.into_boxed_str());
        names.insert(name);
        name
    }))
}

#[cfg(test)]
mod tests {
    use super::{Name, nested, number, short};
    use crate::test_beam::Family;
    use serde::{Deserialize, Serialize};
    use std::collections::BTreeMap;

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct Record {
        family: Family,
        #[serde(with = "number")]
        x: f64,
        #[serde(with = "short")]
        y: f64,
        #[serde(with = "nested")]
        map: BTreeMap<(Family, Family), u64>,
        #[serde(deserialize_with = "super::name")]
        name: Name,
    }

    #[test]
    fn a_record_is_read_back_to_the_last_bit() {
        let map = [
            ((Family::Arc, Family::Helix), 1),
            ((Family::Arc, Family::Arc), 2),
            ((Family::Segment, Family::Arc), 3),
        ];
        for x in [0.1 + 0.2, -0.0, f64::MAX, 5e-324, f64::INFINITY, f64::NEG_INFINITY] {
            let record = Record { family: Family::BSpline, x, y: 0.5, map: map.into(), name: "a" };
            let text = serde_json::to_string(&record).unwrap();
            let read: Record = serde_json::from_str(&text).unwrap();
            assert!(read == record && read.x.to_bits() == x.to_bits(), "{text}");
            assert_eq!(serde_json::to_string(&read).unwrap(), text);
        }
    }

    #[test]
    fn what_is_written_is_stable() {
        let map = [((Family::Arc, Family::Helix), 1)];
        let record = Record { family: Family::BSpline, x: f64::NAN, y: 1.26e-7, map: map.into(), name: "a" };
        let text = serde_json::to_string(&record).unwrap();
        assert_eq!(text, r#"{"family":"bspline","x":"NaN","y":1.3e-7,"map":{"arc":{"helix":1}},"name":"a"}"#);
        let read: Record = serde_json::from_str(&text).unwrap();
        assert!(read.x.is_nan() && read.y.to_bits() == 1.3e-7_f64.to_bits());
    }

    #[test]
    fn what_is_no_name_and_no_number_is_told() {
        let read = |text: &str| serde_json::from_str::<Record>(text).unwrap_err().to_string();
        let wrong = |family: &str, x: &str, name: &str| {
            read(&format!(r#"{{"family":"{family}","x":{x},"y":1,"map":{{}},"name":"{name}"}}"#))
        };
        assert!(
            wrong("beam", "1", "a").starts_with("one of segment, quadratic, "),
            "{}",
            wrong("beam", "1", "a")
        );
        assert!(wrong("arc", "\"one\"", "a").starts_with("invalid float literal"));
        assert!(wrong("arc", "1", &"a".repeat(200)).starts_with("a name expected"));
    }
}
