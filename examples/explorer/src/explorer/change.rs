//! What the controls of the explorer change.

use crate::formulas::formulas;
use crate::frame::Frame;
use crate::presets::preset;
use crate::state::{BeamState, ContactState, Dragged, Parameter, Shown, State};
use beamgap::check::external::VECTORS;
use beamgap::test_beam::Family;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::collections::BTreeMap;

/// A case file, as far as the explorer reads it.
#[derive(Deserialize)]
struct CaseFile {
    beam: BeamState,
    bar: BeamState,
    #[serde(default)]
    contact: PartOfContact,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct PartOfContact {
    radius: f64,
    radius_bar: f64,
    xi_0: f64,
    xi_bar_0: f64,
}

impl State {
    /// Sets a control.
    ///
    /// # Errors
    /// Why the value cannot be taken.
    pub(super) fn change(&mut self, name: &str, value: &str) -> Result<(), String> {
        match name {
            "family-beam" => self.beam = of_family(value, false)?,
            "family-bar" => self.bar = of_family(value, true)?,
            "radius" => self.contact.radius = of_number(value)?,
            "radius_bar" => self.contact.radius_bar = of_number(value)?,
            "view" => {
                let (azimuth, elevation) = value.split_once(' ').ok_or("two angles expected")?;
                self.change("azimuth", azimuth)?;
                self.change("elevation", elevation)?;
            }
            "azimuth" => {
                self.view.azimuth = (of_number(value)?.round() + 540.0).rem_euclid(360.0) - 180.0;
            }
            "elevation" => self.view.elevation = of_number(value)?.round().clamp(-90.0, 90.0),
            "scale" => self.view.scale = of_number(value)?,
            "step" => self.step = of_number(value)?,
            "along" => self.along_linear = value == "linear_dq",
            "dragged" => self.dragged = of_word(value)?,
            "shown" => self.shown = of_word(value)?,
            "order" => {
                let order = value.parse().ok().filter(|order| (1..=3).contains(order));
                self.order =
                    order.ok_or_else(|| format!("an order from 1 to 3 expected, found {value:?}"))?;
            }
            "minimum" => self.minimum = value.parse().map_err(|_| format!("no minimum {value:?}"))?,
            "fault" => self.fault = (!value.is_empty()).then(|| value.to_owned()),
            "lesson" => self.choose_lesson(value),
            "situation" => self.go_to(value),
            "case" => self.open(value)?,
            _ => return self.change_dof(name, value),
        }
        if let "family-beam" | "family-bar" | "situation" | "case" = name {
            self.minimum = 0;
        }
        Ok(())
    }

    /// Sets a number of a beam, such as `bar dq 3` or `beam curve knots 0`.
    fn change_dof(&mut self, name: &str, value: &str) -> Result<(), String> {
        let unknown = || format!("no control is called {name:?}");
        let mut words = name.split(' ');
        let beam = match words.next() {
            Some("beam") => &mut self.beam,
            Some("bar") => &mut self.bar,
            _ => return Err(unknown()),
        };
        let (list, key) = (words.next().ok_or_else(unknown)?, words.next().ok_or_else(unknown)?);
        let number = if list == "curve" {
            match beam.curve.get_mut(key) {
                Some(Parameter::One(number)) => Some(number),
                Some(Parameter::Many(numbers)) => {
                    words.next().and_then(|i| i.parse().ok()).and_then(|i: usize| numbers.get_mut(i))
                }
                None => None,
            }
        } else {
            let of = of_word::<Dragged>(list)?;
            key.parse().ok().and_then(|i: usize| beam.numbers(of).get_mut(i))
        };
        *number.ok_or_else(unknown)? = of_number(value)?;
        Ok(())
    }

    /// Injects a fault and shows the formula that contains it.
    fn choose_lesson(&mut self, fault: &str) {
        self.fault = (!fault.is_empty()).then(|| fault.to_owned());
        let term = fault.split(" = ").next().unwrap_or_default();
        let has_term = |formula: &&crate::formulas::Formula| formula.terms().any(|known| known.name == term);
        let group = formulas().iter().find(has_term).and_then(|formula| formula.groups.first());
        if let Some((shown, order)) = group.and_then(|(group, _)| group.split_at_checked(group.len() - 1))
            && let (Ok(shown), Ok(order)) = (of_word(shown), order.parse())
        {
            (self.shown, self.order) = (shown, order);
        }
    }

    /// Puts the beams into a special position.
    fn go_to(&mut self, situation: &str) {
        let pair = |q: &[f64], q_bar: &[f64]| {
            [(q, false), (q_bar, true)].map(|(q, bar)| {
                let family = if q.len() == 6 { Family::Segment } else { Family::Quadratic };
                BeamState { q: q.to_vec(), ..preset(family, bar) }
            })
        };
        let level = [-1.2, 0.0, 0.3, 1.2, 0.0, 0.3];
        let beams = match situation {
            "parallel" => pair(&level, &[-1.2, 0.0, -0.3, 1.2, 0.0, -0.3]),
            "nearly parallel" => pair(&level, &[-1.2, -0.001, -0.3, 1.2, 0.001, -0.3]),
            "crossing" => pair(&[-1.2, 0.0, 0.0, 1.2, 0.0, 0.0], &[0.0, -1.2, 0.0, 0.0, 1.2, 0.0]),
            "overlap" => pair(&[-1.2, 0.0, 0.09, 1.2, 0.0, 0.09], &[-0.6, -1.0, -0.09, 0.6, 1.0, -0.09]),
            "at an end" => pair(&[-1.4, 0.0, 0.4, -0.2, 0.2, 0.3], &[0.3, -1.2, -0.3, 0.3, 1.2, -0.3]),
            "two minima" => {
                pair(&[-1.2, 1.0, 0.3, 0.0, -0.5, 0.3, 1.2, 1.0, 0.3], &[-1.3, 0.0, -0.3, 1.3, 0.0, -0.3])
            }
            _ => {
                let standard = Self::default();
                self.contact = standard.contact;
                [standard.beam, standard.bar]
            }
        };
        [self.beam, self.bar] = beams;
    }

    /// Takes the beams of a case file over, or those of the first case of a file for `verify`.
    fn open(&mut self, text: &str) -> Result<(), String> {
        let is_of_vectors = text.lines().next().is_some_and(|head| head.contains(VECTORS));
        let text = if is_of_vectors { text.lines().nth(1).unwrap_or_default() } else { text };
        let file: CaseFile =
            serde_json::from_str(text).map_err(|error| format!("the file is not a case: {error}"))?;
        let PartOfContact { radius, radius_bar, xi_0, xi_bar_0 } = file.contact;
        self.contact = ContactState { radius, radius_bar, xi_0, xi_bar_0 };
        (self.beam, self.bar) = (file.beam, file.bar);
        Ok(())
    }

    /// The values of all controls.
    pub(super) fn show_controls(&self, frame: &mut Frame) {
        let word = |value: Result<Value, _>| {
            value.ok().and_then(|value: Value| value.as_str().map(str::to_owned)).unwrap_or_default()
        };
        let along = if self.along_linear { "linear_dq" } else { "dq" };
        frame.controls = BTreeMap::from(
            [
                ("family-beam", self.beam.family.clone()),
                ("family-bar", self.bar.family.clone()),
                ("radius", self.contact.radius.to_string()),
                ("radius_bar", self.contact.radius_bar.to_string()),
                ("azimuth", self.view.azimuth.to_string()),
                ("elevation", self.view.elevation.to_string()),
                ("scale", self.view.scale.to_string()),
                ("step", self.step.to_string()),
                ("along", along.to_owned()),
                ("dragged", word(serde_json::to_value(self.dragged))),
                ("shown", word(serde_json::to_value(self.shown))),
                ("order", self.order.to_string()),
                ("lesson", self.fault.clone().unwrap_or_default()),
                ("fault", self.fault.clone().unwrap_or_default()),
            ]
            .map(|(name, value)| (name.into(), value)),
        );
    }
}

impl BeamState {
    /// The dofs, or a direction.
    pub(super) fn numbers(&mut self, of: Dragged) -> &mut Vec<f64> {
        match of {
            Dragged::Q => &mut self.q,
            Dragged::Dq => &mut self.dq,
            Dragged::LinearDq => &mut self.linear_dq,
        }
    }
}

impl Shown {
    /// Its name in the names of groups.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Gap => "gap",
            Self::Xi => "xi",
            Self::X => "x",
            Self::D => "d",
            Self::T => "t",
            Self::Length => "length",
            Self::Slip => "slip",
        }
    }
}

fn of_family(name: &str, bar: bool) -> Result<BeamState, String> {
    Family::from_name(name)
        .map(|family| preset(family, bar))
        .ok_or_else(|| format!("no family is called {name:?}"))
}

fn of_number(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("a number expected, found {text:?}"))
}

fn of_word<T: DeserializeOwned>(word: &str) -> Result<T, String> {
    serde_json::from_value(Value::from(word)).map_err(|error| error.to_string())
}
