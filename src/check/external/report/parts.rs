//! The results by part as a list, each with its quantity and order. Their keys are those of the worst numbers.

use super::PartFound;
use crate::check::external::compare::Judged;
use crate::check::external::only::{PartKey, is_of_element};
use crate::linearization::Quantity;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::BTreeMap;

#[derive(Serialize)]
struct Part<'a> {
    quantity: Quantity,
    order: &'static str,
    #[serde(flatten)]
    found: &'a PartFound,
}

pub(super) fn serialize<S: Serializer>(
    parts: &BTreeMap<PartKey, PartFound>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(parts.iter().map(|(&(_, quantity, order), found)| Part { quantity, order, found }))
}

pub(super) fn deserialize<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<BTreeMap<PartKey, PartFound>, D::Error> {
    let parts = Vec::<PartFound>::deserialize(deserializer)?;
    Ok(parts.into_iter().map(|part| (key(&part.worst), part)).collect())
}

/// The part that a number belongs to.
pub(super) fn key(judged: &Judged) -> PartKey {
    let comparison = &judged.comparison;
    let name = if is_of_element(comparison.part) { comparison.part } else { comparison.order.name() };
    (comparison.order, comparison.quantity, name)
}
