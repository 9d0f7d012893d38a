//! The table as JSON, `beamgap-equations/2`.

use super::Record;
use crate::equations::EquationTable;

impl Record for EquationTable {
    const SCHEMA: &'static str = Self::SCHEMA;

    fn schema(&self) -> &str {
        &self.schema
    }
}
