//! A case as the source of a Rust test, to be pasted into the tests of a user of the library.

use super::CaseData;
use super::verdict::{Comparison, Order};
use crate::linearization::{Quantity, Varied};
use crate::pair::Contact;
use crate::test_beam::{Family, TestBeam};

/// A test of one entry at one of the minima of a case, with the number of the case in its name. It passes if the two sides agree in the tolerance of the check.
///
/// It only needs the library without its features. Numbers are written with all their digits.
pub fn test_source(case: &CaseData, minimum: usize, entry: &Comparison, number: Option<u64>) -> String {
    let [beam, bar] = &case.test_beams;
    let mut curves = [beam, bar].map(|test_beam| type_name(test_beam.family)).to_vec();
    curves.sort_unstable();
    curves.dedup();
    let curves = if let [one] = curves[..] { one.into() } else { format!("{{{}}}", curves.join(", ")) };
    // Other layouts contain the numbers of `linearize`; lanes compute them in another order.
    let layout = match entry.order {
        Order::Function if !is_d_alone(entry) => {
            format!("    // Found in \"{}\": this test compares what `linearize` returns.\n", entry.against)
        }
        _ => String::new(),
    };
    let side = match entry.order {
        Order::Value | Order::First | Order::Second => "{ad, closed_form}",
        Order::Symmetry | Order::Matrix | Order::Function => "closed_form",
    };
    let vectors = |of: fn(&TestBeam) -> &Vec<f64>| {
        format!(
            "DofVector {{\n        beam: SVector::from({:?}),\n        bar: SVector::from({:?}),\n    }}",
            of(beam),
            of(bar)
        )
    };
    let (q, dq, linear_dq) = (vectors(|s| &s.q), vectors(|s| &s.dq), vectors(|s| &s.linear_dq));
    format!(
        "#[test]
fn {name}{of_case}() {{
    use beamgap::curve::{curves};
    use beamgap::linearization::{side};
    use beamgap::nalgebra::SVector;
    use beamgap::pair::{{Contact, DofVector, Pair}};

    let contact = {contact};
    let pair = Pair::new({curve}, {curve_bar}).with_contact(contact);
    let q = {q};
    let dq = {dq};
    let linear_dq = {linear_dq};
    let found = pair.closest_points(&q).unwrap();
    let point = &found.minima[{minimum}];

{layout}    let closed = closed_form::vary(&pair, &q, point, &dq, &linear_dq).{field};
    let other = {other};
    assert!((closed - other).abs() <= {tolerance}, \"{{closed:e}}, not {{other:e}}\");
}}
",
        name = name(entry),
        of_case = number.map_or_else(String::new, |number| format!("_of_case_{number}")),
        contact = contact(&case.contact),
        curve = constructor(beam),
        curve_bar = constructor(bar),
        field = field(entry),
        other = other(entry),
        tolerance = rounded_up(entry.tolerance),
    )
}

/// Whether the number is what the function for d alone returns.
fn is_d_alone(entry: &Comparison) -> bool {
    entry.order == Order::Function && entry.against.starts_with("write DistanceAlone, ")
}

/// The reference of the number, as an expression.
fn other(entry: &Comparison) -> String {
    let route = match (entry.order, entry.against) {
        (Order::Symmetry, _) => {
            return format!("closed_form::vary(&pair, &q, point, &linear_dq, &dq).{}", field(entry));
        }
        (Order::Matrix | Order::Function, _) => {
            let contracted = match entry.part {
                "value" => "value",
                "delta" => "gradient.along(&dq)",
                "Delta" => "gradient.along(&linear_dq)",
                _ => "hessian.along(&dq, &linear_dq)",
            };
            if is_d_alone(entry) {
                return format!(
                    "{{\n        let mut d = beamgap::linearization::Derivatives::zero();\n        \
                     pair.write(&q, point, closed_form::kernel::DistanceAlone {{ d: &mut d }});\n        d.{contracted}\n    }}"
                );
            }
            let scalar = match entry.quantity {
                Quantity::GN => "g_n()".to_owned(),
                quantity => self::quantity(quantity),
            };
            return format!("pair.linearize(&q, point).{scalar}.{contracted}");
        }
        (_, "hyper-dual, stationary") => "ad::Route::Stationary",
        (_, "own hyper-dual, chord") => "ad::Route::Chord(ad::chord(&pair, &q, point), 2)",
        _ => "ad::Route::Newton",
    };
    format!("ad::vary({route}, &pair, &q, point, &dq, &linear_dq).{}", field(entry))
}

/// The number among the varied quantities.
fn field(entry: &Comparison) -> String {
    let part = match Varied::<f64>::PARTS.iter().position(|&part| part == entry.part) {
        Some(0) => "value",
        Some(1) => "delta",
        Some(2) => "linear",
        _ => "second",
    };
    let axis = entry.axis.map(|axis| format!("{axis}.")).unwrap_or_default();
    format!("{}.{axis}{part}", quantity(entry.quantity))
}

fn quantity(quantity: Quantity) -> String {
    quantity.name().to_lowercase()
}

/// The tested number, as the name of a function.
fn name(entry: &Comparison) -> String {
    let order = match entry.order {
        Order::Symmetry => "symmetry_of_",
        Order::Matrix => "matrix_of_",
        Order::Function => "function_of_",
        _ => "",
    };
    format!("{order}{}", field(entry).replace('.', "_"))
}

fn contact(contact: &Contact) -> String {
    if *contact == Contact::default() { "Contact::default()".into() } else { format!("{contact:?}") }
}

fn type_name(family: Family) -> &'static str {
    match family {
        Family::Segment => "Segment",
        Family::Quadratic => "Quadratic",
        Family::Cubic => "Cubic",
        Family::Hermite | Family::HermiteScaled => "Hermite",
        Family::Bezier => "Bezier",
        Family::BSpline => "BSpline",
        Family::Nurbs => "Nurbs",
        Family::NurbsWeighted => "NurbsWeighted",
        Family::Arc => "Arc",
        Family::Helix => "Helix",
    }
}

fn constructor(test_beam: &TestBeam) -> String {
    let (name, knots) = (type_name(test_beam.family), test_beam.parameter("knots"));
    let first = test_beam.parameters.first().copied().unwrap_or_default();
    match test_beam.family {
        Family::Segment | Family::Quadratic | Family::Cubic | Family::Hermite => format!("{name}::new()"),
        Family::HermiteScaled => format!("{name}::scaled_by({first:?})"),
        Family::Bezier => format!("{name}::<6>::new()"),
        Family::BSpline | Family::NurbsWeighted => format!("{name}::<4>::new(&{knots:?}).unwrap()"),
        Family::Nurbs => {
            format!("{name}::<3>::new(&{knots:?}, {:?}).unwrap()", test_beam.parameter("weights"))
        }
        Family::Arc | Family::Helix => format!("{name}::new({first:?})"),
    }
}

/// Two digits, rounded up.
fn rounded_up(number: f64) -> String {
    let text = format!("{number:.1e}");
    if text.parse().is_ok_and(|rounded: f64| rounded >= number) {
        text
    } else {
        format!("{:.1e}", 1.05 * number)
    }
}
