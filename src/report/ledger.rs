//! The ledger as JSON, `beamgap-ledger/1`.

use super::Record;
use crate::ledger::Ledger;

impl Record for Ledger {
    const SCHEMA: &'static str = Self::SCHEMA;

    fn schema(&self) -> &str {
        &self.schema
    }
}
