//! Statements on entries: their beams, axes and control vectors, and their side of the diagonal.

use crate::check::external::stages::condition::{Statement, fewest};
use crate::check::external::stages::sample::{Dof, Node};

const AXES: [&str; 3] = ["x", "y", "z"];

/// The entries that are wrong, as the end of a sentence. Nothing if no statement separates them from the others.
pub(super) fn statement(nodes: &[Vec<Node>; 2], dofs: &[[Dof; 2]], is_wrong: &[bool]) -> Option<String> {
    let is_gradient = dofs.iter().all(|[row, column]| row == column);
    let of =
        |both: &[Dof; 2]| if is_gradient { of_dof(nodes, both[0], "the dof") } else { of_both(nodes, *both) };
    let all: Vec<Vec<Statement>> = dofs.iter().map(of).collect();
    let (mut wrong, mut right) = (Vec::new(), Vec::new());
    for (statements, is_wrong) in all.into_iter().zip(is_wrong) {
        if *is_wrong { wrong.push(statements) } else { right.push(statements) }
    }
    Some(format!(", in the entries where {}", fewest(&wrong, &right)?))
}

/// A statement with its opposite.
fn say(words: String, opposite: String, holds: bool) -> Statement {
    (words.into(), opposite.into(), holds)
}

/// The beam, the axis and the control vector of a dof.
fn of_dof(nodes: &[Vec<Node>; 2], dof: Dof, subject: &str) -> Vec<Statement> {
    let mut all = vec![say(
        format!("{subject} is of the beam"),
        format!("{subject} is of the bar beam"),
        dof.beam == 0,
    )];
    if nodes.iter().any(Vec::is_empty) {
        return all;
    }
    let is = |what: String, holds: bool| {
        say(format!("{subject} is {what}"), format!("{subject} is not {what}"), holds)
    };
    for (axis, name) in AXES.iter().enumerate() {
        all.push(is(format!("along {name}"), dof.number % 3 == axis));
    }
    for k in 0..nodes[0].len().max(nodes[1].len()) {
        all.push(is(format!("of control vector {}", k + 1), dof.number / 3 == k));
    }
    all
}

/// What the dofs of the row and of the column of an entry have in common.
fn of_both(nodes: &[Vec<Node>; 2], [row, column]: [Dof; 2]) -> Vec<Statement> {
    let order = (row.beam, row.number).cmp(&(column.beam, column.number));
    let own =
        |words: &'static str, opposite: &'static str, holds: bool| (words.into(), opposite.into(), holds);
    let mut all = vec![
        own("both dofs are of one beam", "the dofs are of both beams", row.beam == column.beam),
        own("they are on the diagonal", "they are off the diagonal", order.is_eq()),
        own("they are above the diagonal", "they are on or below the diagonal", order.is_lt()),
        own("they are below the diagonal", "they are on or above the diagonal", order.is_gt()),
    ];
    if nodes.iter().all(|of| !of.is_empty()) {
        let (i, j) = (row.number, column.number);
        all.push(own("both dofs are along one axis", "the dofs are along different axes", i % 3 == j % 3));
        let is_one = row.beam == column.beam && i / 3 == j / 3;
        all.push(own(
            "both dofs are of one control vector",
            "the dofs are of different control vectors",
            is_one,
        ));
    }
    all.extend(of_dof(nodes, row, "the row"));
    all.extend(of_dof(nodes, column, "the column"));
    all
}
