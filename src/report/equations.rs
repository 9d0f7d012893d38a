//! The record of the equations, `beamgap-equations/3`.

use super::{Environment, Record};
use crate::equations::EquationTable;
use serde::{Deserialize, Serialize};

/// The verdict on each equation, and the environment of the run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Equations {
    /// `beamgap-equations/3`.
    pub schema: String,
    /// The environment of the run.
    pub environment: Environment,
    /// The results.
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
