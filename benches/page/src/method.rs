//! The method of measurement of the benchmarks, and its limits.

use crate::benchmark::{Benchmark, CLOSED_FORM};
use beamgap::report::number::count;
use beamgap::report::page::Block;

impl Benchmark {
    /// The end of the page.
    pub(crate) fn method(&self) -> Vec<Block> {
        let samples = self.scenarios.iter().map(|measured| measured.samples.len()).min().unwrap_or(0);
        vec![
            Block::heading("How it was measured"),
            self.environment.table(Vec::new()),
            Block::List(vec![
                "One thread and one pair, the same each time, unless something else is said; the closest point is given, unless \
                 it is what is timed. Dofs in, all results out."
                    .to_owned(),
                "The pairs are drawn by the generator of the check. They are generic and well-conditioned. Distances and angles are wide, \
                 where the paper's form keeps its digits; only the pair *near* has a smaller distance or angle. The pairs of growing size \
                 are two slightly bent beams that cross.".to_owned(),
                format!(
                    "A time is the median of at least {} samples, none left out. Its 95 % interval lies between two of the \
                     samples (order statistics) and assumes no distribution.",
                    count(samples as u64)
                ),
                format!(
                    "A ratio is the time of the method over the time of the **{CLOSED_FORM}** of the same task and beams: the \
                     median over rounds in each of which both ran, one after the other, with its 95 % interval. If the interval \
                     contains 1, the table says that there is no difference. A machine that changes its speed changes the times \
                     and not the ratios, so these are not always the quotients of the times in their tables."
                ),
                "The error is the largest distance from the closed form in double-double, relative to the largest number of that \
                 value, gradient or Hessian. What is allowed for each number is the sum of the running error bounds of both \
                 linearizations; for differences also what they change by when their steps are doubled. A scenario that \
                 exceeds it anywhere is not timed."
                    .to_owned(),
                "The chord methods take one step for d alone, which is enough there, and two for all but the slips. By orders: the \
                 first derivatives of xi and xi_bar are computed once for each dof, the second derivatives by the implicit function \
                 theorem. Rows of hyper-duals: one evaluation has one dof as its first direction and eight dofs as its second."
                    .to_owned(),
                "All samples are in `benchmark.json`, from which alone this page and its pictures are made.".to_owned(),
            ]),
            Block::heading("What these numbers do not say"),
            Block::List(SILENCE.map(str::to_owned).to_vec()),
        ]
    }
}

const SILENCE: [&str; 5] = [
    "Nothing about other processors, compilers or flags.",
    "Nothing about other programs but those listed. The speed-up over the automatic differentiation of this crate is not the \
     speed-up over that of another program. The tables show how much methods of automatic differentiation differ.",
    "The samples of one time are measured one after the other. Other work of the machine therefore affects some rows and not \
     others. The intervals show the scatter of the samples. They do not show a shift of all samples by a busy machine. \
     Ratios are therefore measured in interleaved rounds.",
    "One pair of each family stands for all; its numbers are in the cache. An assembly that writes every Hessian to memory \
     waits for memory.",
    "The errors are those of one well-conditioned pair. The [accuracy report](accuracy.md) shows how errors grow.",
];
