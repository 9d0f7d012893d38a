//! The roofline: how near the closed form is to what the machine can do.

use crate::report::benchmark::Benchmark;
use crate::report::chart::{Anchor, Axis, Chart, INK, Mark, WIDTH, apart};
use crate::report::number::plain;
use crate::report::roof::Below;

const LEFT: f64 = 52.0;
const RIGHT: f64 = WIDTH - 12.0;
const TOP: f64 = 56.0;
const BOTTOM: f64 = 360.0;
/// Where the labels of d end, and where those of all quantities start.
const LABELS: [f64; 2] = [170.0, 268.0];

impl Benchmark {
    /// Multiply-adds in a nanosecond over multiply-adds for a byte stored; nothing if they were not counted.
    pub(in super::super) fn roofline_to_svg(&self) -> Option<String> {
        let rows: Vec<_> = self.below_the_roof().collect();
        let [most, bytes] = self.roof();
        if rows.is_empty() {
            return None;
        }
        let label = |value: f64| plain(value).trim_end_matches('0').trim_end_matches('.').to_owned();
        let ridge = most / bytes;
        let densities = Axis::steps(rows.iter().map(Below::density).chain([0.5 * ridge, 2.0 * ridge]));
        let rates = Axis::steps(rows.iter().map(Below::rate).chain([1.2 * most]));
        let ends = |steps: &[f64]| [steps[0], steps[steps.len() - 1]];
        let (name, room) = ("multiply-adds for a byte stored", 9);
        let x = Axis { range: ends(&densities), pixels: [LEFT, RIGHT], name, room, given: &densities, label };
        let name = "multiply-adds in a nanosecond";
        let label = |value: f64| format!("{value:.0}");
        let y = Axis { range: ends(&rates), pixels: [BOTTOM, TOP], name, room, given: &rates, label };
        let mut chart = Chart::new("Roofline: closed form, 24 dofs", BOTTOM + 46.0);
        chart.frame(&x, &y);
        let roof = |density: f64| [x.at(density), y.at((density * bytes).min(most))];
        chart.curve(&[roof(x.range[0]), roof(ridge), roof(x.range[1])], "thick");
        chart.text(
            [RIGHT - 4.0, y.at(most) - 8.0],
            Anchor::End,
            INK,
            &format!("arithmetic: {} per ns", plain(most)),
        );
        chart.text(
            [roof(x.range[0])[0] + 8.0, roof(x.range[0])[1] - 10.0],
            Anchor::Start,
            INK,
            &format!("stores: {} bytes per ns", plain(bytes)),
        );
        for (k, task) in ["d, ", "all"].into_iter().enumerate() {
            let of: Vec<_> = rows.iter().filter(|row| row.name().starts_with(task)).collect();
            let heights =
                apart(&of.iter().map(|row| y.at(row.rate())).collect::<Vec<_>>(), 16.0, [TOP, BOTTOM]);
            for (row, height) in of.iter().zip(heights) {
                let at = [x.at(row.density()), y.at(row.rate())];
                let (side, anchor) = if k == 0 { (-6.0, Anchor::End) } else { (6.0, Anchor::Start) };
                chart.line(at, [LABELS[k] - side, height], &format!("s{k}"));
                chart.mark(at, [Mark::Dot, Mark::Diamond][k], k);
                let name = row.name().replace("all but the slips", "all");
                chart.text([LABELS[k], height + 4.0], anchor, k, &format!("{name}: {} x", plain(row.times)));
            }
        }
        Some(chart.svg())
    }
}
