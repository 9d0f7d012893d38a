//! Where the closed form stands below what the machine can do.

use super::{Axis, COLOURS, dot, frame, line, picture, text};
use crate::report::benchmark::{Benchmark, Measured};
use crate::report::number::{number, plain};
use crate::report::{Floor, ReportError, Task};
use plotters::style::BLACK;
use plotters::style::text_anchor::HPos;

const SIZE: (u32, u32) = (860, 400);

impl Benchmark {
    /// The roofline: multiply-adds in a nanosecond over multiply-adds for a byte stored.
    ///
    /// # Errors
    /// [`ReportError::Draw`].
    pub fn roofline_to_svg(&self) -> Result<String, ReportError> {
        picture(SIZE, |area| {
            let rows = self.below_the_roof();
            let rates = || rows.iter().map(|row| row.rate).chain([self.floors.multiply_adds]);
            let density = rows.iter().map(|row| row.density);
            let ridge = self.floors.multiply_adds / self.floors.bytes;
            let x = Axis::decades(
                density.chain([ridge]),
                (90, 600),
                "multiply-adds for a byte stored, at least",
                plain,
            );
            let y = Axis::decades(rates(), (340, 60), "multiply-adds in a nanosecond", plain);
            frame(area, &x, &y, "Below the roof: two Hermite beams, 24 dofs")?;
            let roof = |density: f64| {
                (x.at(density), y.at((density * self.floors.bytes).min(self.floors.multiply_adds)))
            };
            line(area, roof(x.range.0.max(y.range.0 / self.floors.bytes)), roof(ridge), BLACK)?;
            line(area, roof(ridge), roof(x.range.1), BLACK)?;
            for (i, row) in rows.iter().enumerate() {
                let (colour, legend) = (COLOURS[i % COLOURS.len()], 80 + 22 * i32::try_from(i)?);
                dot(area, (x.at(row.density), y.at(row.rate)), colour)?;
                dot(area, (616, legend), colour)?;
                text(
                    area,
                    &format!("{}, {}", row.measured.task, row.measured.way),
                    (628, legend),
                    13,
                    HPos::Left,
                )?;
            }
            Ok(())
        })
    }

    /// The closed forms of the pair of Hermite beams, in terms of what their tasks ask for at least.
    pub(in crate::report) fn below_the_roof(&self) -> Vec<Below<'_>> {
        let closed = |task: Task| {
            let rows = self.of(task).filter(|of| of.family == "hermite" && is_in_blocks(of));
            rows.filter_map(move |measured| {
                let least = |floor: Floor| floor.least(task, measured.stored());
                let (adds, bytes) = (least(Floor::MultiplyAdds)?, least(Floor::Bytes)?);
                let (density, rate) = (number(adds) / number(bytes), number(adds) / measured.median);
                Some(Below { measured, adds, bytes, density, rate })
            })
        };
        [Task::Distance, Task::All].into_iter().flat_map(closed).collect()
    }
}

/// Term by term there are more products than the floor counts.
fn is_in_blocks(of: &Measured) -> bool {
    of.way.starts_with("closed form") && !of.way.ends_with("term by term")
}

/// A closed form, in terms of what its task asks for at least.
pub(in crate::report) struct Below<'a> {
    pub(in crate::report) measured: &'a Measured,
    pub(in crate::report) adds: usize,
    pub(in crate::report) bytes: usize,
    density: f64,
    rate: f64,
}
