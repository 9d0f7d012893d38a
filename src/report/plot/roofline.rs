//! Where the closed form stands below what the machine can do.

use super::{Axis, COLOURS, dot, frame, line, picture, text};
use crate::report::ReportError;
use crate::report::benchmark::Benchmark;
use crate::report::number::plain;
use crate::report::roof::Below;
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
            let [most, bytes] = self.roof();
            let rows: Vec<_> = self.below_the_roof().collect();
            let rates = || rows.iter().map(Below::rate).chain([most]);
            let density = rows.iter().map(Below::density);
            let ridge = most / bytes;
            let x =
                Axis::decades(density.chain([ridge]), (90, 600), "multiply-adds for a byte stored", plain);
            let y = Axis::decades(rates(), (340, 60), "multiply-adds in a nanosecond", plain);
            frame(area, &x, &y, "Below the roof: two Hermite beams, 24 dofs")?;
            let roof = |density: f64| (x.at(density), y.at((density * bytes).min(most)));
            line(area, roof(x.range.0.max(y.range.0 / bytes)), roof(ridge), BLACK)?;
            line(area, roof(ridge), roof(x.range.1), BLACK)?;
            for (i, row) in rows.iter().enumerate() {
                let (colour, legend) = (COLOURS[i % COLOURS.len()], 80 + 22 * i32::try_from(i)?);
                dot(area, (x.at(row.density()), y.at(row.rate())), colour)?;
                dot(area, (616, legend), colour)?;
                text(area, &row.name(), (628, legend), 13, HPos::Left)?;
            }
            Ok(())
        })
    }
}
