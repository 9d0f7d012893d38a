//! Entries of gradients and Hessians that are wrong: those of a beam, of a pair of beams, along an axis.

use super::list::FORMULAS;
use super::tree::Name;
use super::values::Value;
use crate::number::RunningError;
use nalgebra::Vector3;

/// The dofs of rows and of columns: those of a beam, or those along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Dofs {
    Beams([usize; 2]),
    Axis(usize),
}

/// All of them, in the order of [`parts`].
const BLOCKS: [Dofs; 7] = [
    Dofs::Beams([0, 0]),
    Dofs::Beams([0, 1]),
    Dofs::Beams([1, 0]),
    Dofs::Beams([1, 1]),
    Dofs::Axis(0),
    Dofs::Axis(1),
    Dofs::Axis(2),
];

/// Blocks of a gradient or Hessian by their places in [`BLOCKS`], in words.
pub(super) const OF_GRADIENTS: [(&[usize], &str); 5] = [
    (&[0], "the entries of the dofs of the beam"),
    (&[3], "the entries of the dofs of the bar beam"),
    (&[4], "the entries of the dofs along x"),
    (&[5], "the entries of the dofs along y"),
    (&[6], "the entries of the dofs along z"),
];
pub(super) const OF_HESSIANS: [(&[usize], &str); 10] = [
    (&[0], "the block of the beam"),
    (&[3], "the block of the bar beam"),
    (&[1], "the block of the beam's rows and the bar beam's columns"),
    (&[2], "the block of the bar beam's rows and the beam's columns"),
    (&[1, 2], "the blocks of beam and bar beam"),
    (&[0, 3], "the blocks of each beam alone"),
    (&[0, 1], "the rows of the beam"),
    (&[2, 3], "the rows of the bar beam"),
    (&[0, 2], "the columns of the beam"),
    (&[1, 3], "the columns of the bar beam"),
];

/// These blocks of a Hessian, by their places in [`BLOCKS`], in words.
pub(in crate::check::external::stages) fn words_of_blocks(blocks: &[usize]) -> Option<&'static str> {
    OF_HESSIANS.iter().find(|(known, _)| *known == blocks).map(|(_, words)| *words)
}

/// What is wrong with them.
pub(super) const FACTORS: [(f64, &str); 4] =
    [(-1.0, "the wrong sign"), (0.0, "missing"), (2.0, "twice"), (0.5, "half")];

/// Wrong entries of the gradient or Hessian of a result.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entries {
    pub(super) name: Name,
    /// The same along Delta.
    pub(super) linear: Option<Name>,
    pub(super) blocks: &'static [usize],
    pub(super) factor: f64,
}

impl Entries {
    /// The result, along delta and along Delta.
    pub(super) fn names(&self) -> impl Iterator<Item = Name> {
        [Some(self.name), self.linear].into_iter().flatten()
    }

    /// The value with the wrong entries. `parts` are the values by the dofs of each block.
    pub(super) fn put(&self, name: Name, value: Value, parts: &[Vec<Value>]) -> Value {
        let by = Value::from(self.factor - 1.0);
        self.blocks.iter().fold(value, |value, block| value.plus(parts[*block][name].times(by)))
    }
}

/// The inputs with the variations of the dofs of each block alone.
pub(super) fn inputs_of_parts(inputs: &[Value]) -> Vec<Vec<Value>> {
    let part = |block: Dofs| {
        let mut of = inputs.to_vec();
        for (name, value) in of.iter_mut().enumerate() {
            let varies = FORMULAS.kinds[name].varies;
            let beam = usize::from(FORMULAS.names.0[name].contains("_bar"));
            let is_kept = match block {
                Dofs::Beams([row, column]) => (!varies[0] || row == beam) && (!varies[1] || column == beam),
                Dofs::Axis(_) => true,
            };
            match (block, *value) {
                _ if varies == [false; 2] => {}
                (Dofs::Axis(axis), Value::Vector(vector)) => {
                    let zero = RunningError::from(0.0);
                    *value = Value::Vector(Vector3::from_fn(|c, _| if c == axis { vector[c] } else { zero }));
                }
                _ if !is_kept => *value = Value::Vector(Vector3::repeat(RunningError::from(0.0))),
                _ => {}
            }
        }
        of
    };
    BLOCKS.into_iter().map(part).collect()
}
