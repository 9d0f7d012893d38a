//! Accuracy over time: one point for each method, for all but the slips.

use super::times;
use crate::benchmark::Benchmark;
use crate::methods::Kind;
use beamgap::report::chart::{Anchor, Axis, Chart, Mark, WIDTH, apart, errors};

const LEFT: f64 = 52.0;
const RIGHT: f64 = WIDTH - 24.0;
const TOP: f64 = 56.0;
const BOTTOM: f64 = 470.0;
/// The height of a label.
const LABEL: f64 = 17.0;

impl Benchmark {
    /// Error over time; none if no peers were measured.
    pub(crate) fn trade_to_svg(&self) -> Option<String> {
        let timed = self.peers.as_ref()?.timed();
        // Four pairs at once and the term by term form are variants. The first figure shows them.
        let shown =
            |name: &str| !["four pairs", "linearize", "term by term"].iter().any(|part| name.contains(part));
        let mut points: Vec<(f64, f64, Kind, &str)> = timed
            .iter()
            .filter(|timed| shown(timed.method.short))
            .filter_map(|timed| {
                let of = timed.tasks[1]?;
                Some((of.ns_median, of.error?, timed.method.kind, timed.method.short))
            })
            .collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let x = times(Axis::decades(points.iter().map(|point| point.0)), [LEFT, RIGHT], "time of a pair");
        let range = Axis::decades(points.iter().map(|point| point.1));
        let y = errors(range, [BOTTOM, TOP], "largest error, relative", 12);
        let mut chart = Chart::new("Accuracy over time: all but the slips, 24 dofs", BOTTOM + 46.0);
        chart.frame(&x, &y);
        let colour = |kind: Kind| Kind::ALL.iter().position(|other| *other == kind).unwrap_or(0);
        // Labels of small errors are on flags: the fast methods above, to the right, the slow methods below, to the left.
        let middle = LEFT.midpoint(RIGHT);
        let (exact, rough): (Vec<_>, Vec<_>) = points.into_iter().partition(|point| point.1 < 1e-12);
        let (left, mut right): (Vec<_>, Vec<_>) = exact.into_iter().partition(|point| x.at(point.0) < middle);
        right.reverse();
        let highest = y.at(1e-9);
        for (i, (median, error, kind, name)) in left.iter().chain(&right).enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "counts of labels")]
            let height = highest + LABEL * i as f64;
            let [at, foot] = [x.at(*median), y.at(*error)];
            let colour = colour(*kind);
            chart.line([at, foot], [at, height], &format!("s{colour}"));
            chart.mark([at, foot], Mark::Dot, colour);
            if i < left.len() {
                chart.text([at + 4.0, height + 8.0], Anchor::Start, colour, name);
            } else {
                chart.text([at - 4.0, height + 8.0], Anchor::End, colour, name);
            }
        }
        let heights =
            apart(&rough.iter().map(|point| y.at(point.1)).collect::<Vec<_>>(), LABEL, [TOP, BOTTOM]);
        for ((median, error, kind, name), height) in rough.iter().zip(heights) {
            chart.mark([x.at(*median), y.at(*error)], Mark::Dot, colour(*kind));
            chart.text([x.at(*median) - 8.0, height + 4.0], Anchor::End, colour(*kind), name);
        }
        Some(chart.svg())
    }
}
