//! All methods in one figure: the time of d and of all but the slips, and the error beside it.

use super::times;
use crate::Task;
use crate::benchmark::Benchmark;
use crate::methods::Kind;
use crate::peers::Peers;
use beamgap::report::chart::{Anchor, Axis, Chart, INK, Mark, WIDTH, errors};
use beamgap::report::number::time;

/// The top of the rows.
const TOP: f64 = 62.0;
/// The height of a method: its name above, its points below.
const ROW: f64 = 33.0;
/// The height of the name of a group.
const GROUP: f64 = 28.0;
/// The range of the times, with room for the labels beside the first and the last.
const TIMES: [f64; 2] = [8.0, 312.0];
/// The range of the errors.
const ERRORS: [f64; 2] = [332.0, 404.0];
/// The shapes of d and of all but the slips. Their colours are 0 and 1.
const MARKS: [Mark; 2] = [Mark::Dot, Mark::Diamond];

/// A median time, its interval, and the error, if it exists.
type Point = (f64, [f64; 2], Option<f64>);

/// A row: its name, and the time, the interval and the error for d and for all but the slips.
struct Row {
    name: String,
    points: [Option<Point>; 2],
}

impl Benchmark {
    /// The time of every method for d and for all but the slips, with its error; none if no peers were measured.
    pub(crate) fn methods_to_svg(&self) -> Option<String> {
        let mut groups = groups(self.peers.as_ref()?);
        groups.push(("Closest point, which all methods need first".to_owned(), self.searches()));
        let count: usize = groups.iter().map(|(_, rows)| rows.len()).sum();
        #[expect(clippy::cast_precision_loss, reason = "counts of rows")]
        let bottom = TOP + GROUP * groups.len() as f64 + ROW * count as f64;
        let points = || groups.iter().flat_map(|(_, rows)| rows).flat_map(|row| row.points.iter().flatten());
        let [least, most] = Axis::ends(points().map(|(median, ..)| *median));
        // Room for a time beside the first point and the last.
        let x = times([least / 15.0, most * 15.0], TIMES, "time of a pair");
        let range = Axis::decades(points().filter_map(|(.., error)| *error));
        let y = errors(range, ERRORS, "largest error", 2);
        let mut chart = Chart::new("Time and error of one pair of beams, 24 dofs", bottom + 56.0);
        for (k, name) in ["d", "all: d, xi, xi_bar, t, t_bar"].into_iter().enumerate() {
            let at = [18.0, 60.0][k];
            chart.mark([at, 38.0], MARKS[k], k);
            chart.text([at + 9.0, 42.0], Anchor::Start, k, name);
        }
        chart.text([WIDTH - 8.0, 42.0], Anchor::End, INK, "with gradient and Hessian");
        for (axis, every) in [(&x, 2), (&y, 1)] {
            for (i, (value, label)) in axis.ticks().into_iter().enumerate() {
                chart.line([axis.at(value), TOP - 8.0], [axis.at(value), bottom], "grid");
                if i % every == 0 {
                    chart.text([axis.at(value), bottom + 16.0], Anchor::Middle, INK, &label);
                }
            }
            chart.line([axis.pixels[0], bottom], [axis.pixels[1], bottom], "");
            chart.text([axis.pixels[1], bottom + 36.0], Anchor::End, INK, axis.name);
        }
        let mut at = TOP;
        for (name, rows) in &groups {
            chart.strong([TIMES[0], at + 14.0], name);
            at += GROUP;
            for row in rows {
                chart.text([TIMES[0], at + 8.0], Anchor::Start, INK, &row.name);
                draw(&mut chart, row, at + 20.0, [&x, &y]);
                at += ROW;
            }
        }
        Some(chart.svg())
    }

    /// The time to find the closest point, for the pair of Hermite beams.
    fn searches(&self) -> Vec<Row> {
        let of_hermites = self.of(Task::ClosestPoint).filter(|of| of.family == "hermite");
        let row = |of: &crate::Measured| Row {
            name: match of.method.as_str() {
                "search for all minima" => "search for all closest points".to_owned(),
                other => other.replace("Newton from", "Newton's method, started").replace(" off", " away"),
            },
            points: [Some((of.median, of.interval, None)), None],
        };
        of_hermites.map(row).collect()
    }
}

fn groups(peers: &Peers) -> Vec<(String, Vec<Row>)> {
    let timed = peers.timed();
    let of_kind = |kind: Kind| {
        let rows = timed.iter().filter(|timed| timed.method.kind == kind).map(|timed| Row {
            name: timed.method.name.to_owned(),
            points: timed.tasks.map(|task| task.map(|of| (of.ns_median, [of.ns_low, of.ns_high], of.error))),
        });
        (kind.name().to_owned(), rows.collect())
    };
    Kind::ALL.map(of_kind).into_iter().filter(|(_, rows): &(_, Vec<_>)| !rows.is_empty()).collect()
}

/// The points of a row. The label for d is to the left of its point, that for all but the slips to the right.
fn draw(chart: &mut Chart, row: &Row, height: f64, [x, y]: [&Axis; 2]) {
    for (k, point) in row.points.iter().enumerate() {
        let Some((median, [low, high], error)) = point else { continue };
        chart.line([x.at(*low), height], [x.at(*high), height], &format!("thick s{k}"));
        chart.mark([x.at(*median), height], MARKS[k], k);
        let words = time(*median);
        match k {
            0 => chart.text([x.at(*low) - 7.0, height + 4.0], Anchor::End, k, &words),
            _ => chart.text([x.at(*high) + 7.0, height + 4.0], Anchor::Start, k, &words),
        }
        if let Some(error) = error {
            chart.mark([y.at(*error), height], MARKS[k], k);
        }
    }
}
