//! Cases as lines of JSON.

use super::{Drawing, Outcome, StepDofs, VECTORS, Vector, held_name};
use crate::check::candidate::Sides;
use crate::check::evaluation_point::EvaluationPoint;
use crate::check::external::conventions::STATE_AND_FORCES;
use crate::check::external::number::hex;
use crate::check::{CAREFUL, Coverage, ElementData};
use crate::contact::{Law, Slips, Work};
use crate::linearization::{COMPONENTS, Quantity};
use crate::pair::Contact;
use crate::test_beam::TestBeam;
use crate::variant::{Step, Variant};
use std::fmt::Write;

/// The expected numbers that are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Expected {
    /// Nothing.
    None,
    /// Values and variations along the directions.
    #[default]
    Variations,
    /// Also gradients and Hessians.
    All,
}

/// Writes cases, and answers.
#[derive(Clone, Copy, Debug, Default)]
pub struct VectorWriter {
    /// Whether numbers are hexadecimal, as strings.
    pub hex: bool,
    /// The expected numbers that are written beside the case.
    pub expected: Expected,
}

impl VectorWriter {
    /// The head of the file.
    pub fn head(self, drawing: &Drawing) -> String {
        format!(
            "{{\"schema\":\"{VECTORS}\",\"version\":\"{}\",\"seed\":\"{:#x}\",\"count\":{},\"parameter\":\"[-1,1]\",\
             \"d\":\"x - x_bar\",\"dofs\":\"node-major\",\"beams\":\"beam first\",\"matrix\":\"row-major\"}}",
            env!("CARGO_PKG_VERSION"),
            drawing.seed,
            drawing.count()
        )
    }

    /// The line of a case, without its end.
    pub fn line(self, vector: &Vector) -> String {
        self.line_and_sides(vector).0
    }

    /// The line of a case, and on which side of each symmetry its closest point is.
    pub fn line_and_sides(self, vector: &Vector) -> (String, Coverage) {
        let (regime, id) = (quoted(&vector.regime), quoted(&vector.id));
        let mut line = format!("{{\"id\":{id},\"regime\":{regime}");
        for (name, beam) in ["beam", "bar"].into_iter().zip(&vector.case.test_beams) {
            let _ = write!(line, ",\"{name}\":{}", self.beam(beam));
        }
        let Contact { radius, radius_bar, xi_0, xi_bar_0 } = vector.case.contact;
        let contact =
            [("radius", radius), ("radius_bar", radius_bar), ("xi_0", xi_0), ("xi_bar_0", xi_bar_0)];
        let _ = write!(line, ",\"contact\":{}", self.numbers(&contact));
        if let Some(element) = &vector.element {
            line.push_str(&self.element(element, &vector.steps));
        }
        let mut sides = Coverage::default();
        let expected = vector.evaluated(|evaluation| {
            let geometry = evaluation.partial_variations(Step::Now).map(|partial| partial.geometry);
            sides.add_point(&geometry, &evaluation.point, evaluation.contact);
            let jets = self.jets(&evaluation);
            (jets, self.expected(vector, evaluation))
        });
        if let Some((xi, xi_bar)) = vector.point {
            let _ = write!(line, ",\"point\":{}", self.numbers(&[("xi", xi), ("xi_bar", xi_bar)]));
        }
        match expected {
            Ok((jets, expected)) => {
                let _ = write!(line, ",\"result\":\"valid\"{jets}{expected}");
            }
            Err(outcome) => {
                let _ = write!(line, ",\"result\":\"{}\"", outcome.name());
                if let Outcome::Degenerate(reason) = outcome {
                    let _ = write!(line, ",\"reason\":{}", quoted(reason.reason()));
                }
            }
        }
        (line + "}", sides)
    }

    fn beam(self, beam: &TestBeam) -> String {
        let curve = beam.family.parameters().iter().map(|&(name, count)| {
            let numbers = beam.parameter(name);
            let value = if count == 1 { self.number(numbers[0]) } else { self.list(numbers) };
            format!("\"{name}\":{value}")
        });
        let curve = curve.collect::<Vec<_>>().join(",");
        let curve = if curve.is_empty() { curve } else { format!(",\"curve\":{{{curve}}}") };
        let [q, dq, linear_dq] = [&beam.q, &beam.dq, &beam.linear_dq].map(|numbers| self.list(numbers));
        let family = beam.family.name();
        format!("{{\"family\":\"{family}\"{curve},\"q\":{q},\"dq\":{dq},\"linear_dq\":{linear_dq}}}")
    }

    /// The parameters and the history of a contact element, and the steps that lead to it.
    fn element(self, element: &ElementData, steps: &[StepDofs]) -> String {
        let ElementData { parameters, history } = element;
        let (law, of_law) = match parameters.law {
            Law::Linear { eps } => ("linear", vec![("eps_N", eps)]),
            Law::Lpqp { eps, g_0 } => ("lpqp", vec![("eps_N", eps), ("g_0", g_0)]),
            Law::Augmented { eps, lambda } => ("augmented", vec![("eps_N", eps), ("lambda", lambda)]),
        };
        let numbers = [&of_law[..], &[("eps_T", parameters.eps_t), ("mu", parameters.mu)]].concat();
        let numbers = self.numbers(&numbers);
        let work = match parameters.work {
            Work::Rate => "rate",
            Work::Paper => "paper",
        };
        let normal = history.normal.map_or("null".into(), |n| self.list(n.as_slice()));
        let slips = history.slips.map_or("null".into(), |slips| {
            let Slips { xi, xi_bar, e, e_bar, held, cosine, .. } = slips;
            let numbers = [("xi", xi), ("xi_bar", xi_bar), ("e", e), ("e_bar", e_bar), ("cosine", cosine)];
            let numbers = self.numbers(&numbers);
            format!("{},\"held\":\"{}\"}}", numbers.trim_end_matches('}'), held_name(held))
        });
        let step =
            |[beam, bar]: &StepDofs| format!("{{\"beam\":{},\"bar\":{}}}", self.list(beam), self.list(bar));
        let steps = if steps.is_empty() {
            String::new()
        } else {
            format!(",\"steps\":[{}]", steps.iter().map(step).collect::<Vec<_>>().join(","))
        };
        format!(
            ",\"element\":{{\"law\":\"{law}\",{},\"work\":\"{work}\",\"history\":{{\"normal\":{normal},\"slips\":{slips}}}{steps}}}",
            numbers.trim_matches(['{', '}'])
        )
    }

    /// Both beams at the closest point, and their variations at fixed parameters.
    fn jets(self, evaluation: &EvaluationPoint) -> String {
        let beam = |partial: &crate::linearization::closed_form::PartialVariations<f64>| {
            let geometry = partial.geometry;
            let of = [
                ("x", geometry.x),
                ("t", geometry.t),
                ("t_xi", geometry.t_xi),
                ("t_xixi", geometry.t_xixi),
                ("delta_u", partial.delta_u[0]),
                ("delta_u_xi", partial.delta_u[1]),
                ("delta_u_xixi", partial.delta_u[2]),
                ("Delta_u", partial.linear_u[0]),
                ("Delta_u_xi", partial.linear_u[1]),
                ("Delta_u_xixi", partial.linear_u[2]),
                ("Delta_delta_u", partial.second_u[0]),
                ("Delta_delta_u_xi", partial.second_u[1]),
            ];
            let entries = of.map(|(name, v)| format!("\"{name}\":{}", self.list(v.as_slice())));
            format!("{{{}}}", entries.join(","))
        };
        let [one, two] = evaluation.partial_variations(Step::Now);
        let held = held_name(evaluation.held);
        format!(",\"held\":\"{held}\",\"jets\":{{\"beam\":{},\"bar\":{}}}", beam(&one), beam(&two))
    }

    fn expected(self, vector: &Vector, evaluation: EvaluationPoint<'_>) -> String {
        if self.expected == Expected::None {
            return String::new();
        }
        let element = self.expected_element(vector, &evaluation);
        let (sides, paper) = Sides::new(evaluation, &vector.case.test_beams);
        let mut arrays = Vec::new();
        if self.expected == Expected::All {
            arrays = paper.dense(&Variant::Unmodified).into_iter().zip(paper.dense_bounds()).collect();
        }
        let entries = (0..COMPONENTS).map(|i| {
            let (quantity, axis) = (Quantity::of_component(i), Quantity::axis_of_component(i));
            let parts = sides.reference[i].parts();
            let tolerance = sides.textbook[i].parts().map(|number| {
                let [near, far] = number.bound;
                CAREFUL * near + far
            });
            let [value, delta, linear, second] = parts.map(|part| self.number(part.value));
            let mut entry = format!(
                "\"{}\":{{\"value\":{value},\"delta\":{delta},\"Delta\":{linear},\"Delta-delta\":{second},\"tolerance\":{}",
                key(quantity, axis),
                self.list(&[0, 1, 2, 3].map(|k| tolerance[k] + parts[k].bound[0]))
            );
            let is_of = |quantity: Quantity, of: Quantity| {
                of == quantity || (of == Quantity::D && quantity == Quantity::GN)
            };
            if let Some((of, bounds)) = arrays.iter().find(|(of, _)| is_of(quantity, of.quantity)) {
                let careful = |numbers: &[f64]| {
                    self.list(&numbers.iter().map(|bound| CAREFUL * bound).collect::<Vec<_>>())
                };
                let (gradient, hessian) = (self.list(&of.gradient), self.list(&of.hessian));
                let _ = write!(entry, ",\"gradient\":{gradient},\"hessian\":{hessian}");
                let (gradient, hessian) = (careful(&bounds.gradient), careful(&bounds.hessian));
                let _ = write!(
                    entry,
                    ",\"gradient_tolerance\":{gradient},\"hessian_tolerance\":{hessian}"
                );
            }
            entry + "}"
        });
        format!(",\"expected\":{{{}{element}}}", entries.collect::<Vec<_>>().join(","))
    }

    /// State and forces of the contact element; with gradients and Hessians also residual and tangent.
    fn expected_element(self, vector: &Vector, evaluation: &EvaluationPoint) -> String {
        let Ok(Some(element)) = vector.element_at(evaluation) else { return String::new() };
        let found = element.with(|decision| (decision.state, evaluation.element(decision)));
        let Some((state, (residual, tangent, values))) = found else { return String::new() };
        let forces = [values.f_n, values.f, values.f_bar].into_iter().zip(&STATE_AND_FORCES[1..]);
        let forces = forces.map(|(force, name)| format!(",\"{name}\":{}", self.number(force)));
        let mut text = format!(",\"state\":\"{}\"{}", state.name(), forces.collect::<String>());
        if self.expected == Expected::All {
            let (residual, tangent) = (self.list(&residual), self.list(&tangent));
            let _ = write!(text, ",\"residual\":{residual},\"tangent\":{tangent}");
        }
        text
    }

    fn numbers(self, entries: &[(&str, f64)]) -> String {
        let entries: Vec<_> =
            entries.iter().map(|(name, number)| format!("\"{name}\":{}", self.number(*number))).collect();
        format!("{{{}}}", entries.join(","))
    }

    pub(in crate::check::external) fn list(self, numbers: &[f64]) -> String {
        let mut text = String::with_capacity(20 * numbers.len() + 2);
        text.push('[');
        for (i, &number) in numbers.iter().enumerate() {
            if i > 0 {
                text.push(',');
            }
            self.push(&mut text, number);
        }
        text.push(']');
        text
    }

    pub(in crate::check::external) fn number(self, number: f64) -> String {
        let mut text = String::new();
        self.push(&mut text, number);
        text
    }

    /// The shortest number that is read back to the same bits. Numbers that JSON does not have are strings.
    fn push(self, text: &mut String, number: f64) {
        let _ = match (number.is_finite(), self.hex) {
            (true, false) => write!(text, "{number:?}"),
            (true, true) => write!(text, "\"{}\"", hex(number)),
            (false, _) => write!(text, "\"{number:?}\""),
        };
    }
}

/// The name of a component.
pub(in crate::check::external) fn key(quantity: Quantity, axis: Option<char>) -> String {
    axis.map_or_else(|| quantity.name().to_owned(), |axis| format!("{}.{axis}", quantity.name()))
}

/// A string of JSON.
pub(in crate::check::external) fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if u32::from(c) < 32 => drop(write!(quoted, "\\u{:04x}", u32::from(c))),
            c => quoted.push(c),
        }
    }
    quoted + "\""
}
