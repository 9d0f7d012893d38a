//! The record of the equations, `beamgap-equations/3`.

use super::{Environment, Record};
use crate::equations::EquationTable;
use serde::{Deserialize, Serialize};

/// What became of each equation, and where it ran.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Equations {
    /// `beamgap-equations/3`.
    pub schema: String,
    /// Where and with what it ran.
    pub environment: Environment,
    /// What was found.
    #[serde(flatten)]
    pub table: EquationTable,
}

impl Record for Equations {
    const SCHEMA: &'static str = "beamgap-equations/3";

    fn schema(&self) -> &str {
        &self.schema
    }
}

impl Equations {
    /// The record of a run.
    pub fn new(table: EquationTable, environment: Environment) -> Self {
        Self { schema: Self::SCHEMA.to_owned(), environment, table }
    }
}
