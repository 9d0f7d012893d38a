//! Which entries of a gradient or a Hessian are wrong, and what they are.

mod permuted;

pub(super) use permuted::permuted;

/// A dof of a program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dof {
    /// Whether it belongs to the bar beam.
    pub(super) is_bar: bool,
    /// Whether the element has it.
    pub(super) is_there: bool,
    /// The vector of the beam that it is a component of, and which component; nothing if it is of no vector.
    pub(super) vector: Option<[usize; 2]>,
}

/// The entries of an array, row by row.
pub(super) struct Entries<'a> {
    pub(super) answered: &'a [f64],
    pub(super) expected: &'a [f64],
    pub(super) is_wrong: &'a [bool],
    pub(super) dofs: &'a [Dof],
    /// The index of the first dof.
    pub(super) first: usize,
}

/// Dofs in words, and whether each is meant.
type Set = (String, Vec<bool>);
/// Entries in words, and whether the entry of a row and a column is meant.
type Statement<'a> = (String, Box<dyn Fn(usize, usize) -> bool + 'a>);

/// The beams that dofs belong to: whether it is the bar beam.
const BEAMS: [(Option<bool>, &str); 3] =
    [(None, ""), (Some(false), " of the beam"), (Some(true), " of the bar beam")];
/// Whether the entry of a row and a column is meant.
type Meant<'a> = &'a dyn Fn(usize, usize) -> bool;
/// The entry that stands at a place.
type Predicted<'a> = Box<dyn Fn(usize) -> f64 + 'a>;

/// An expected entry that is smaller, over the largest, is zero by rounding.
const ZERO: f64 = 1e-12;
/// The largest difference of entries that are taken for equal, over the largest expected entry.
const SAME: f64 = 1e-6;

impl Entries<'_> {
    /// The wrong entries in words: those of some dofs, of a block, the diagonal, and that they are zero or a multiple of the
    /// expected ones. Nothing if there is nothing to tell.
    pub(super) fn words(&self) -> Option<String> {
        let (what, predicted) = self.what().unzip();
        // Where what stands there is what is expected, nothing is seen.
        let is_open: Vec<bool> = (0..self.expected.len())
            .map(|k| predicted.as_ref().is_some_and(|of| self.is_near(of(k), self.expected[k])))
            .collect();
        let is_told = |is_meant: Meant| self.is_told(&is_open, is_meant);
        let which = if is_told(&|_, _| true) { Some("all".to_owned()) } else { self.which(&is_told) };
        match (which.as_deref(), what) {
            (None | Some("all"), None) => None,
            (None, Some(what)) => Some(what.replacen("which", "they", 1)),
            (Some(which), None) => Some(which.to_owned()),
            (Some(which), Some(what)) => Some(format!("{which}, {what}")),
        }
    }

    fn is_matrix(&self) -> bool {
        self.expected.len() > self.dofs.len()
    }

    fn largest(&self) -> f64 {
        self.expected.iter().fold(0.0, |largest, entry| largest.max(entry.abs()))
    }

    fn is_near(&self, one: f64, other: f64) -> bool {
        (one - other).abs() <= SAME * self.largest()
    }

    /// Whether these entries are wrong, and no others. Where zero is expected and answered, nothing is seen.
    fn is_told(&self, is_open: &[bool], is_meant: Meant) -> bool {
        let (size, largest) = (self.dofs.len(), self.largest());
        (0..self.expected.len()).all(|k| {
            let [i, j] = if self.is_matrix() { [k / size, k % size] } else { [k, k] };
            let is_there = self.dofs[i].is_there && self.dofs[j].is_there;
            let is_zero = !is_there || self.expected[k].abs() <= ZERO * largest;
            (!self.is_wrong[k] && (is_zero || is_open[k])) || self.is_wrong[k] == is_meant(i, j)
        })
    }

    /// The first of the sets of entries that are told to be the wrong ones.
    fn which(&self, is_told: &dyn Fn(Meant) -> bool) -> Option<String> {
        let sets = self.sets();
        if !self.is_matrix() {
            return sets.iter().find(|(_, set)| is_told(&|i, _| set[i])).map(|(of, _)| format!("those {of}"));
        }
        let is_bar = |i: usize| self.dofs[i].is_bar;
        let mut all: Vec<Statement> = vec![
            ("the diagonal".into(), Box::new(|i, j| i == j)),
            ("all off the diagonal".into(), Box::new(|i, j| i != j)),
            ("all above the diagonal".into(), Box::new(|i, j| i < j)),
            ("all below the diagonal".into(), Box::new(|i, j| i > j)),
            ("the blocks of both beams".into(), Box::new(move |i, j| is_bar(i) != is_bar(j))),
            ("the blocks of one beam".into(), Box::new(move |i, j| is_bar(i) == is_bar(j))),
        ];
        for [row, column] in [[false, true], [true, false]] {
            let name = |bar: bool| if bar { "bar beam" } else { "beam" };
            let words = format!("the block of the {}'s rows and the {}'s columns", name(row), name(column));
            all.push((words, Box::new(move |i, j| [is_bar(i), is_bar(j)] == [row, column])));
        }
        for (of, set) in &sets {
            all.push((format!("the block {of}"), Box::new(|i, j| set[i] && set[j])));
            all.push((format!("the rows {of}"), Box::new(|i, _| set[i])));
            all.push((format!("the columns {of}"), Box::new(|_, j| set[j])));
            all.push((format!("the rows and columns {of}"), Box::new(|i, j| set[i] || set[j])));
        }
        all.into_iter().find(|(_, is_meant)| is_told(is_meant)).map(|(words, _)| words)
    }

    /// The sets of dofs that a program takes together, the simplest first.
    fn sets(&self) -> Vec<Set> {
        let dofs = self.dofs;
        let of = |is_meant: &dyn Fn(usize, &Dof) -> bool| -> Vec<bool> {
            dofs.iter().enumerate().map(|(i, dof)| is_meant(i, dof)).collect()
        };
        let is_of = |beam: Option<bool>, dof: &Dof| beam.is_none_or(|bar| dof.is_bar == bar);
        let vectors = dofs.iter().filter_map(|dof| dof.vector).map(|of| of[0] + 1).max().unwrap_or(0);
        let mut all: Vec<Set> = Vec::new();
        for (beam, of_beam) in BEAMS {
            if beam.is_some() {
                all.push((of_beam.trim().into(), of(&|_, dof| is_of(beam, dof))));
            }
            for (axis, name) in ["x", "y", "z"].iter().enumerate() {
                let is_along = |of: [usize; 2]| of[1] == axis;
                let is_meant = |_, dof: &Dof| is_of(beam, dof) && dof.vector.is_some_and(is_along);
                all.push((format!("along {name}{of_beam}"), of(&is_meant)));
            }
            for first in 0..2 {
                let is_one = |of: [usize; 2]| of[0] % 2 == first;
                let is_meant = |_, dof: &Dof| is_of(beam, dof) && dof.vector.is_some_and(is_one);
                all.push((format!("of every second vector{of_beam}, from {}", first + 1), of(&is_meant)));
            }
            for vector in 0..vectors {
                let is_one = |of: [usize; 2]| of[0] == vector;
                let is_meant = |_, dof: &Dof| is_of(beam, dof) && dof.vector.is_some_and(is_one);
                all.push((format!("of vector {}{of_beam}", vector + 1), of(&is_meant)));
            }
        }
        for k in 0..dofs.len() {
            let index = k + self.first;
            all.push((format!("of dof {index}"), of(&|i, _| i == k)));
            all.push((format!("before dof {index}"), of(&|i, _| i < k)));
            all.push((format!("from dof {index} on"), of(&|i, _| i >= k)));
        }
        all
    }

    /// What the wrong entries are, with the entry that stands at a place.
    fn what(&self) -> Option<(String, Predicted<'_>)> {
        let size = self.dofs.len();
        let times = |factor: f64| -> Predicted { Box::new(move |k| factor * self.expected[k]) };
        let mut all: Vec<(String, Predicted)> = vec![
            ("which are zero".into(), times(0.0)),
            ("which have the wrong sign".into(), times(-1.0)),
            ("which are twice the expected ones".into(), times(2.0)),
            ("which are half the expected ones".into(), times(0.5)),
        ];
        if self.is_matrix() {
            let transposed = move |k: usize| self.expected[(k % size) * size + k / size];
            all.push(("which are those of the transpose".into(), Box::new(transposed)));
            let bars = self.dofs.iter().filter(|dof| dof.is_bar).count();
            if 2 * bars == size {
                let other = move |i: usize| (i + bars) % size;
                let of_block = move |k: usize| self.expected[other(k / size) * size + other(k % size)];
                let words = "which are those of the block with the beams exchanged".into();
                all.push((words, Box::new(of_block)));
            }
            all.extend(permuted(self).map(|(order, places)| -> (String, Predicted) {
                let words = format!("which are those with the {order}");
                (words, Box::new(move |k| self.expected[places[k]]))
            }));
        }
        let is_meant = |predicted: &Predicted| {
            let mut wrong = (0..self.expected.len()).filter(|k| self.is_wrong[*k]);
            wrong.all(|k| self.is_near(self.answered[k], predicted(k)))
        };
        all.into_iter().find(|(_, predicted)| is_meant(predicted))
    }
}

#[cfg(test)]
mod tests {
    use super::{Dof, Entries};

    /// Two beams with two vectors each.
    fn dofs() -> Vec<Dof> {
        let dof = |k: usize| Dof { is_bar: k >= 6, is_there: true, vector: Some([k % 6 / 3, k % 3]) };
        (0..12).map(dof).collect()
    }

    /// What is told of the entries that are multiplied by a factor.
    fn told(rows: usize, factor: f64, is_meant: impl Fn(usize, usize) -> bool) -> Option<String> {
        let at = |k: usize| (k / 12, k % 12);
        let of = |k: usize| f64::from(u16::try_from((at(k).0 + 1) * (at(k).1 + 1)).unwrap());
        let expected: Vec<f64> = (0..12 * rows).map(of).collect();
        let is_wrong: Vec<bool> = (0..expected.len())
            .map(|k| if rows == 1 { is_meant(k, k) } else { is_meant(at(k).0, at(k).1) })
            .collect();
        let answered: Vec<f64> = expected
            .iter()
            .zip(&is_wrong)
            .map(|(x, is_wrong)| if *is_wrong { factor * x } else { *x })
            .collect();
        let dofs = dofs();
        let entries =
            Entries { answered: &answered, expected: &expected, is_wrong: &is_wrong, dofs: &dofs, first: 0 };
        entries.words()
    }

    #[test]
    fn wrong_entries_are_told() {
        let is_second = |k: usize| k % 6 / 3 == 1;
        assert_eq!(told(1, 3.0, |_, _| true), None);
        assert_eq!(told(1, 0.0, |k, _| k >= 6).unwrap(), "those of the bar beam, which are zero");
        assert_eq!(told(1, 3.0, |k, _| k % 3 == 1).unwrap(), "those along y");
        assert_eq!(
            told(1, 0.0, |k, _| is_second(k)).unwrap(),
            "those of every second vector, from 2, which are zero"
        );
        assert_eq!(told(1, 3.0, |k, _| k < 2).unwrap(), "those before dof 2");
        assert_eq!(told(1, 3.0, |k, _| k == 1 || k == 9), None);
        assert_eq!(told(1, 2.0, |k, _| k == 1 || k == 9).unwrap(), "they are twice the expected ones");
        assert_eq!(told(12, 2.0, |i, j| i == j).unwrap(), "the diagonal, which are twice the expected ones");
        assert_eq!(told(12, 0.0, |i, j| i < j).unwrap(), "all above the diagonal, which are zero");
        assert_eq!(told(12, 3.0, |i, j| (i < 6) != (j < 6)).unwrap(), "the blocks of both beams");
        assert_eq!(
            told(12, 3.0, |i, j| i >= 6 && j < 6).unwrap(),
            "the block of the bar beam's rows and the beam's columns"
        );
        assert_eq!(told(12, -1.0, |i, _| i == 3).unwrap(), "the rows of dof 3, which have the wrong sign");
        assert_eq!(told(12, 3.0, |i, j| i < 2 || j < 2).unwrap(), "the rows and columns before dof 2");
        assert_eq!(
            told(12, 3.0, |i, j| is_second(i) && is_second(j)).unwrap(),
            "the block of every second vector, from 2"
        );
    }

    /// The diagonal of such a block is right by chance.
    #[test]
    fn a_block_that_is_copied_without_transposing_it_is_told() {
        let expected: Vec<f64> = (0..144).map(|k| f64::from((k / 12 + 1) * (k % 12 + 1))).collect();
        let is_block = |k: usize| k / 12 >= 6 && k % 12 < 6;
        let of = |k: usize| if is_block(k) { expected[k - 72 + 6] } else { expected[k] };
        let answered: Vec<f64> = (0..144).map(of).collect();
        let is_wrong: Vec<bool> = (0..144).map(|k| (answered[k] - expected[k]).abs() > 0.5).collect();
        assert_eq!(is_wrong.iter().filter(|wrong| **wrong).count(), 30);
        let dofs = dofs();
        let entries =
            Entries { answered: &answered, expected: &expected, is_wrong: &is_wrong, dofs: &dofs, first: 0 };
        assert_eq!(
            entries.words().unwrap(),
            "the block of the bar beam's rows and the beam's columns, which are those of the block with the beams exchanged"
        );
    }
}
