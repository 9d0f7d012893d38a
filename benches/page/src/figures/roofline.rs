//! The roofline: the rate of the closed form, compared with the limits of the machine.

use crate::benchmark::Benchmark;
use crate::roof::Below;
use beamgap::report::chart::{Anchor, Axis, Chart, INK, Mark, WIDTH, apart};
use beamgap::report::number::plain;

const LEFT: f64 = 52.0;
const RIGHT: f64 = WIDTH - 12.0;
const TOP: f64 = 56.0;
const BOTTOM: f64 = 360.0;
/// The distance of the labels from the points.
const BESIDE: f64 = 40.0;

impl Benchmark {
    /// Multiply-adds in a nanosecond over multiply-adds for each stored byte; none if they were not counted.
    pub(crate) fn roofline_to_svg(&self) -> Option<String> {
        let rows: Vec<_> = self.below_the_roof().collect();
        let [most, bytes] = self.roof();
        if rows.is_empty() {
            return None;
        }
        let label = |value: f64| plain(value).trim_end_matches('0').trim_end_matches('.').to_owned();
        let ridge = most / bytes;
        let marked = [0.1, 0.2, 0.5, 1.0, 2.0];
        // Room for labels beside the points.
        let [least, most_dense] = Axis::ends(rows.iter().map(Below::density).chain([ridge]));
        let across = [0.5 * least, 3.2 * most_dense];
        let densities: Vec<f64> =
            marked.into_iter().filter(|x| (across[0]..=across[1]).contains(x)).collect();
        let rates = Axis::steps(rows.iter().map(Below::rate).chain([1.2 * most]));
        let (name, room) = ("multiply-adds for a byte stored", 9);
        let x = Axis { range: across, pixels: [LEFT, RIGHT], name, room, given: &densities, label };
        let name = "multiply-adds in a nanosecond";
        let label = |value: f64| format!("{value:.0}");
        let y = Axis {
            range: [rates[0], rates[rates.len() - 1]],
            pixels: [BOTTOM, TOP],
            name,
            room,
            given: &rates,
            label,
        };
        let mut chart = Chart::new("Roofline: closed form, 24 dofs", BOTTOM + 46.0);
        chart.frame(&x, &y);
        let roof = |density: f64| [x.at(density), y.at((density * bytes).min(most))];
        chart.curve(&[roof(x.range[0]), roof(ridge), roof(x.range[1])], "thick");
        let words =
            [format!("arithmetic: {} per ns", plain(most)), format!("stores: {} bytes per ns", plain(bytes))];
        chart.text([RIGHT - 4.0, y.at(most) - 8.0], Anchor::End, INK, &words[0]);
        chart.text([LEFT + 6.0, TOP + 16.0], Anchor::Start, INK, &words[1]);
        // The labels stand in one column: left of the points is the line of the stores.
        let [_, side] = Axis::ends(rows.iter().map(Below::density)).map(|density| x.at(density));
        // Where they are moved apart, they are moved down.
        let heights = rows.iter().map(|row| y.at(row.rate()) - 18.0).collect::<Vec<_>>();
        for (row, height) in rows.iter().zip(apart(&heights, 16.0, [TOP, BOTTOM])) {
            let k = usize::from(!row.name().starts_with("d, "));
            let at = [x.at(row.density()), y.at(row.rate())];
            chart.line(at, [side + 0.8 * BESIDE, height], &format!("s{k}"));
            chart.mark(at, [Mark::Dot, Mark::Diamond][k], k);
            let name = row.name().replace("all but the slips", "all");
            let label = format!("{name} {} x", plain(row.times));
            chart.text([side + BESIDE, height + 4.0], Anchor::Start, k, &label);
        }
        Some(chart.svg())
    }
}
