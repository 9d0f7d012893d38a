//! The input of the user: the beams, the directions, the view, the fault.

use beamgap::check::CaseData;
use beamgap::check::external::VECTORS;
use beamgap::closest_point::ClosestPoint;
use beamgap::pair::Contact;
use beamgap::test_beam::{Family, TestBeam};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::error::Error;

/// Everything that the page depends on. What a link does not hold is as in the standard case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct State {
    /// The beam.
    pub beam: BeamState,
    /// The bar beam.
    pub bar: BeamState,
    /// Radii and reference parameters.
    pub contact: ContactState,
    /// The direction of view.
    pub view: ViewState,
    /// The quantity whose formulas are shown.
    pub shown: Shown,
    /// 1 shows its value and its first variation, 2 its second variation, 3 its gradient and its Hessian.
    pub order: u8,
    /// The name of the fault in the closed form, if there is one.
    pub fault: Option<String>,
    /// The step from the beams to the varied state along the direction.
    pub step: f64,
    /// Whether the direction of the varied state is Delta q instead of delta q.
    pub along_linear: bool,
    /// The index of the closest point among the minima.
    pub minimum: usize,
    /// The vectors that the handles move.
    pub dragged: Dragged,
    /// Whether the equations of the paper are evaluated too.
    pub equations: bool,
    /// Why the last input was not taken over.
    #[serde(skip)]
    pub refused: Option<String>,
}

/// A beam, as in `beamgap-case/1`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BeamState {
    /// The name of its family.
    pub family: String,
    /// The fixed parameters of its curve by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub curve: BTreeMap<String, Parameter>,
    /// The dofs.
    pub q: Vec<f64>,
    /// The direction delta q.
    pub dq: Vec<f64>,
    /// The direction Delta q.
    pub linear_dq: Vec<f64>,
}

/// One number, or several.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Parameter {
    /// One number.
    One(f64),
    /// Several numbers.
    Many(Vec<f64>),
}

/// Radii and reference parameters, as in `beamgap-case/1`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ContactState {
    /// The radius of the beam.
    pub radius: f64,
    /// The radius of the bar beam.
    pub radius_bar: f64,
    /// The reference parameter of the slip on the beam.
    pub xi_0: f64,
    /// The reference parameter of the slip on the bar beam.
    pub xi_bar_0: f64,
}

/// The direction of view, and the scale.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ViewState {
    /// The angle about the vertical axis, in degrees.
    pub azimuth: f64,
    /// The angle above the horizon, in degrees.
    pub elevation: f64,
    /// Pixels per unit of length.
    pub scale: f64,
}

/// A quantity whose formulas can be shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Shown {
    /// The gap g_N, and the distance d.
    Gap,
    /// The parameters xi and xi_bar.
    Xi,
    /// The closest points.
    X,
    /// The vector d.
    D,
    /// The tangents.
    T,
    /// The lengths of the tangents.
    Length,
    /// The slips.
    Slip,
}

/// The vectors that the handles move.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Dragged {
    /// The dofs.
    Q,
    /// The direction delta q.
    Dq,
    /// The direction Delta q.
    LinearDq,
}

/// The case as `beamgap check --case-file` reads it.
#[derive(Serialize)]
struct CaseFile<'a> {
    schema: &'static str,
    beam: &'a BeamState,
    bar: &'a BeamState,
    contact: ContactState,
}

/// The case as a line of a file that `beamgap verify` reads.
#[derive(Serialize)]
struct VectorLine<'a> {
    id: &'static str,
    regime: &'static str,
    beam: &'a BeamState,
    bar: &'a BeamState,
    contact: ContactState,
    #[serde(skip_serializing_if = "Option::is_none")]
    point: Option<BTreeMap<&'static str, f64>>,
}

impl State {
    /// Reads the state from a request.
    ///
    /// # Errors
    /// The error in the request.
    pub fn read(json: &str) -> Result<Self, String> {
        let state: Self = serde_json::from_str(json).map_err(|error| error.to_string())?;
        state.validate().map(|()| state)
    }

    /// Whether view and step are in range.
    pub(crate) fn validate(&self) -> Result<(), String> {
        let ViewState { azimuth, elevation, scale } = self.view;
        let is_finite = [azimuth, elevation, scale, self.step].into_iter().all(f64::is_finite);
        if is_finite && (1.0..=1e5).contains(&scale) && (0.0..=1.0).contains(&self.step) {
            Ok(())
        } else {
            Err("view and step: a scale from 1 to 1e5 and a step from 0 to 1 expected".to_owned())
        }
    }

    /// Both beams.
    ///
    /// # Errors
    /// The error in the numbers.
    pub fn case(&self) -> Result<CaseData, String> {
        let ContactState { radius, radius_bar, xi_0, xi_bar_0 } = self.contact;
        if ![radius, radius_bar, xi_0, xi_bar_0].into_iter().all(f64::is_finite) {
            return Err("contact: finite numbers expected".to_owned());
        }
        let contact = Contact { radius, radius_bar, xi_0, xi_bar_0 };
        let test_beams = [self.beam.test_beam("beam")?, self.bar.test_beam("bar beam")?];
        Ok(CaseData { test_beams, contact })
    }

    /// The case as a file of the schema `beamgap-case/1`.
    pub(crate) fn case_file(&self) -> String {
        let file =
            CaseFile { schema: "beamgap-case/1", beam: &self.beam, bar: &self.bar, contact: self.contact };
        serde_json::to_string(&file).unwrap_or_default()
    }

    /// The case as a file of cases for `beamgap verify`, with the selected closest point.
    pub(crate) fn vectors(&self, point: Option<&ClosestPoint>) -> String {
        let point = point.map(|point| BTreeMap::from([("xi", point.xi), ("xi_bar", point.xi_bar)]));
        let Self { beam, bar, contact, .. } = self;
        let line = VectorLine { id: "0", regime: "explorer", beam, bar, contact: *contact, point };
        let line = serde_json::to_string(&line).unwrap_or_default();
        format!("{{\"schema\":\"{VECTORS}\",\"count\":1}}\n{line}\n")
    }

    /// The command that checks this case.
    pub(crate) fn command(&self) -> String {
        let json = self.case_file();
        let fault = self.fault.as_ref().map(|fault| format!(" --plant '{fault}'")).unwrap_or_default();
        format!("echo '{json}' | beamgap check --case-file -{fault}")
    }
}

impl BeamState {
    /// Whether both are the same curve, along any directions.
    pub(crate) fn has_same_curve(&self, other: &Self) -> bool {
        self.family == other.family && self.curve == other.curve && self.q == other.q
    }

    /// The beam; `name` is its name in errors.
    ///
    /// # Errors
    /// The error in the numbers.
    pub fn test_beam(&self, name: &str) -> Result<TestBeam, String> {
        let family = Family::from_name(&self.family)
            .ok_or_else(|| format!("{name}: no family is called {:?}", self.family))?;
        let known = family.parameters();
        if let Some(unknown) = self.curve.keys().find(|key| known.iter().all(|(name, _)| key != name)) {
            return Err(format!("{name}: the family has no parameter {unknown:?}"));
        }
        let mut parameters = Vec::new();
        for (parameter, count) in known {
            let found = match self.curve.get(*parameter) {
                Some(Parameter::One(one)) => vec![*one],
                Some(Parameter::Many(many)) => many.clone(),
                None => return Err(format!("{name}: {parameter} is missing")),
            };
            if found.len() != *count {
                return Err(format!("{name}: {parameter} is {count} numbers, not {}", found.len()));
            }
            parameters.extend(found);
        }
        let test_beam = TestBeam {
            family,
            parameters,
            q: self.q.clone(),
            dq: self.dq.clone(),
            linear_dq: self.linear_dq.clone(),
        };
        test_beam.validate().map_err(|error| {
            let source = error.source().map(|source| format!(": {source}")).unwrap_or_default();
            format!("{name}: {error}{source}")
        })?;
        Ok(test_beam)
    }
}
