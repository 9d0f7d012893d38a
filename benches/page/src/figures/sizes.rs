//! Cost over the number of dofs.

use super::times;
use crate::Task;
use crate::benchmark::{Benchmark, Measured};
use beamgap::report::chart::{Anchor, Axis, Chart, INK, Mark, Place, apart};
use beamgap::report::number::number;

const LEFT: f64 = 56.0;
const RIGHT: f64 = 300.0;
const TOP: f64 = 56.0;
const BOTTOM: f64 = 330.0;

impl Benchmark {
    /// Time over the number of dofs; none if it was not measured.
    pub(crate) fn sizes_to_svg(&self) -> Option<String> {
        let tasks = [Task::AllBySize, Task::DistanceBySize];
        let all = || tasks.into_iter().flat_map(|task| self.of(task));
        let mut dofs: Vec<f64> = all().map(|of| number(of.dofs)).collect();
        dofs.sort_by(f64::total_cmp);
        dofs.dedup();
        let [first, .., last] = dofs[..] else { return None };
        let y = times(Axis::decades(all().map(|of| of.median)), [BOTTOM, TOP], "time of a pair");
        let label = |dofs: f64| format!("{dofs:.0}");
        let (pixels, name) = ([LEFT, RIGHT], "dofs of both beams");
        let x = Axis { range: [first, last], pixels, name, room: 9, given: &dofs, label };
        let mut chart = Chart::new("Cost over dofs: closed form", BOTTOM + 46.0);
        chart.frame(&x, &y);
        let mut ends: Vec<(f64, String, usize)> = Vec::new();
        for (i, rows) in tasks.into_iter().flat_map(|task| series(self.of(task))).enumerate() {
            let place = |of: &&Measured| -> Place { [x.at(number(of.dofs)), y.at(of.median)] };
            let places: Vec<Place> = rows.iter().map(place).collect();
            chart.curve(&places, &format!("thick s{i}"));
            for &at in &places {
                chart.mark(at, Mark::Dot, i);
            }
            let task = if rows[0].task.starts_with("all") { "all" } else { "d" };
            let family = if rows[0].family == "bspline" { "B-spline" } else { "Lagrange" };
            ends.push((places.last().map_or(BOTTOM, |at| at[1]), format!("{task}, {family}"), i));
        }
        // A line proportional to the number of entries of a Hessian, through the largest point.
        let through = all().max_by(|a, b| {
            (a.dofs, a.median).partial_cmp(&(b.dofs, b.median)).unwrap_or(std::cmp::Ordering::Equal)
        })?;
        let at = |n: f64| [x.at(n), y.at(through.median * (n / number(through.dofs)).powi(2)).min(BOTTOM)];
        chart.line(at(first), at(last), "dashed");
        chart.line([LEFT + 12.0, TOP + 16.0], [LEFT + 36.0, TOP + 16.0], "dashed");
        chart.text([LEFT + 42.0, TOP + 20.0], Anchor::Start, INK, "slope 2: dofs squared");
        let heights = apart(&ends.iter().map(|end| end.0).collect::<Vec<_>>(), 16.0, [TOP, BOTTOM]);
        for ((_, name, colour), height) in ends.iter().zip(heights) {
            chart.text([RIGHT + 8.0, height + 4.0], Anchor::Start, *colour, name);
        }
        Some(chart.svg())
    }
}

/// The rows of each family, by size.
fn series<'a>(rows: impl Iterator<Item = &'a Measured>) -> Vec<Vec<&'a Measured>> {
    let mut rows: Vec<_> = rows.collect();
    rows.sort_by_key(|of| (&of.family, &of.method, of.dofs));
    rows.chunk_by(|a, b| (&a.family, &a.method) == (&b.family, &b.method)).map(<[_]>::to_vec).collect()
}
