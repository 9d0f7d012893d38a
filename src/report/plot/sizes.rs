//! The cost of the closed form over the number of dofs.

use super::{Axis, COLOURS, Drawn, dot, frame, line, picture, text};
use crate::report::benchmark::{Benchmark, Measured};
use crate::report::number::{count, number, time};
use crate::report::{ReportError, Task};
use plotters::style::text_anchor::HPos;

const SIZE: (u32, u32) = (860, 430);

impl Benchmark {
    /// The cost over the dofs.
    ///
    /// # Errors
    /// [`ReportError::Draw`].
    pub fn sizes_to_svg(&self) -> Result<String, ReportError> {
        picture(SIZE, |area| {
            let tasks = [Task::DistanceBySize, Task::AllBySize];
            let of_tasks = || tasks.into_iter().flat_map(|task| self.of(task));
            let ticks = [12, 24, 48, 96].map(|dofs: u32| (f64::from(dofs), count(u64::from(dofs)))).to_vec();
            let x = Axis { range: (10.0, 110.0), pixels: (90, 600), ticks, name: "dofs of both beams" };
            let y = Axis::decades(of_tasks().map(|of| of.median), (370, 60), "time of a pair", time);
            frame(area, &x, &y, "Time of the closed form over the number of dofs")?;
            let mut legend = 80;
            for (i, rows) in tasks.into_iter().flat_map(|task| series(self.of(task))).enumerate() {
                let colour = COLOURS[i % COLOURS.len()];
                let at = |of: &Measured| -> (i32, i32) { (x.at(number(of.dofs)), y.at(of.median)) };
                for pair in rows.windows(2) {
                    line(area, at(pair[0]), at(pair[1]), colour)?;
                }
                rows.iter().try_for_each(|of| dot(area, at(of), colour))?;
                dot(area, (620, legend), colour)?;
                let (task, method) =
                    (rows[0].task.replace(" by size", ""), rows[0].method.replace("closed form", ""));
                let name = format!("{task}, {}{method}", rows[0].family);
                text(area, &name, (632, legend), 13, HPos::Left)?;
                legend += 22;
            }
            proportional(area, &x, &y, of_tasks().max_by_key(|of| of.dofs), legend)
        })
    }
}

/// What would be proportional to the number of entries of a Hessian, through the largest.
fn proportional(area: &super::Area, x: &Axis, y: &Axis, through: Option<&Measured>, legend: i32) -> Drawn {
    let Some(of) = through else { return Ok(()) };
    let at = |n: f64| (x.at(n), y.at(of.median * (n / number(of.dofs)).powi(2)));
    let black = plotters::style::BLACK;
    line(area, at(12.0), at(number(of.dofs)), black)?;
    line(area, (612, legend), (628, legend), black)?;
    text(area, "as the entries of a Hessian", (632, legend), 13, HPos::Left)
}

/// The rows of each family and method, by size.
fn series<'a>(rows: impl Iterator<Item = &'a Measured>) -> Vec<Vec<&'a Measured>> {
    let mut rows: Vec<_> = rows.collect();
    rows.sort_by_key(|of| (&of.family, &of.method, of.dofs));
    rows.chunk_by(|a, b| (&a.family, &a.method) == (&b.family, &b.method)).map(<[_]>::to_vec).collect()
}
