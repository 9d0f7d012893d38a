//! Each way as a point: how far off its numbers are, against how long they take.

use super::{Axis, COLOURS, dot, frame, picture, text};
use crate::report::benchmark::{Benchmark, Measured};
use crate::report::number::{error, time};
use crate::report::{ReportError, Task};
use plotters::style::text_anchor::HPos;

const SIZE: (u32, u32) = (860, 480);

impl Benchmark {
    /// Error over time, of all ways with the pair of Hermite beams.
    ///
    /// # Errors
    /// [`ReportError::Draw`].
    pub fn accuracy_to_svg(&self) -> Result<String, ReportError> {
        picture(SIZE, |area| {
            let tasks = [Task::Distance, Task::All];
            let of_tasks: Vec<&Measured> = tasks
                .into_iter()
                .flat_map(|task| self.of(task))
                .filter(|of| of.family == "hermite")
                .collect();
            let mut ways: Vec<&str> = Vec::new();
            for of in &of_tasks {
                if !ways.contains(&of.way.as_str()) {
                    ways.push(&of.way);
                }
            }
            let x = Axis::decades(of_tasks.iter().map(|of| of.median), (90, 580), "time of a pair", time);
            let label = |value: f64| error(Some(value));
            let name = "largest error, of the largest number of its kind";
            let y = Axis::decades(of_tasks.iter().map(|of| of.error), (420, 60), name, label);
            frame(area, &x, &y, "Error over time, two Hermite beams, 24 dofs")?;
            for (i, task) in tasks.into_iter().enumerate() {
                let legend = 64 + 20 * i32::try_from(i)?;
                dot(area, (604, legend), COLOURS[i])?;
                text(area, task.name(), (616, legend), 13, HPos::Left)?;
            }
            for (i, way) in ways.iter().enumerate() {
                let legend = 124 + 20 * i32::try_from(i)?;
                text(area, &format!("{}  {way}", i + 1), (600, legend), 13, HPos::Left)?;
            }
            for of in of_tasks {
                let number = ways.iter().position(|way| *way == of.way).map_or(0, |i| i + 1);
                let colour = COLOURS[usize::from(of.task == Task::All.name())];
                let (across, up) = (x.at(of.median), y.at(of.error));
                dot(area, (across, up), colour)?;
                text(area, &number.to_string(), (across + 7, up - 7), 11, HPos::Left)?;
            }
            Ok(())
        })
    }
}
