//! The table of the errors, `tests/elements/errors.csv`.

use super::conditions::Condition;
use beamgap::check::Order;
use std::fmt;

/// An error that can be put into an element.
pub(super) struct Row {
    pub(super) number: u32,
    pub(super) style: String,
    /// What is wrong.
    pub(super) wrong: String,
    /// The quantity that is wrong first in the order of evaluation.
    pub(super) quantity: String,
    /// Its value, gradient or Hessian.
    pub(super) order: Order,
    /// What a case must have to show it.
    pub(super) needs: Condition,
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.number, self.wrong)
    }
}

const TITLES: &str = "number,style,wrong,quantity,order,stage,equation,needs";
const STAGES: [&str; 5] = ["closest point", "d", "first order", "second order", "slips"];

/// All rows.
pub(super) fn rows() -> Vec<Row> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/elements/errors.csv");
    let text = std::fs::read_to_string(path).unwrap();
    let (titles, rest) = text.split_once('\n').unwrap();
    assert_eq!(titles, TITLES);
    let rows: Vec<Row> = rest.lines().map(row).collect();
    assert!(rows.is_sorted_by(|one, two| one.number < two.number), "each error has a number of its own");
    rows
}

fn row(line: &str) -> Row {
    let fields: Vec<_> = line.split(',').collect();
    let [number, style, wrong, quantity, order, stage, equation, needs] = fields[..] else {
        panic!("eight fields expected: {line}")
    };
    let equation: u32 = equation.parse().unwrap();
    assert!(STAGES.contains(&stage) && (1..=59).contains(&equation) && !wrong.is_empty(), "{line}");
    let order = match order {
        "value" => Order::Value,
        "gradient" => Order::First,
        "hessian" => Order::Second,
        _ => panic!("value, gradient or hessian expected: {line}"),
    };
    Row {
        number: number.parse().unwrap(),
        style: style.to_owned(),
        wrong: wrong.to_owned(),
        quantity: quantity.to_owned(),
        order,
        needs: Condition::new(needs),
    }
}
