//! Each method as a point: how far off its numbers are, against how long they take.

use super::{Area, Axis, COLOURS, Drawn, dot, frame, picture, text};
use crate::report::benchmark::{Benchmark, Measured};
use crate::report::number::{error, time};
use crate::report::{ReportError, Task};
use plotters::style::RGBColor;
use plotters::style::text_anchor::HPos;

const SIZE: (u32, u32) = (860, 480);

/// Where it is, and the number of its method.
type Dot = ((i32, i32), usize);

impl Benchmark {
    /// Error over time, of all methods with the pair of Hermite beams.
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
            let mut methods: Vec<&str> = Vec::new();
            for of in &of_tasks {
                if !methods.contains(&of.method.as_str()) {
                    methods.push(&of.method);
                }
            }
            let number =
                |method: &str| methods.iter().position(|other| *other == method).map_or(0, |i| i + 1);
            let x = Axis::decades(of_tasks.iter().map(|of| of.median), (90, 580), "time of a pair", time);
            let label = |value: f64| error(Some(value));
            let name = "largest error, of the largest number of its kind";
            let y = Axis::decades(of_tasks.iter().map(|of| of.error), (420, 60), name, label);
            frame(area, &x, &y, "Error over time, two Hermite beams, 24 dofs")?;
            for (i, task) in tasks.into_iter().enumerate() {
                let legend = 64 + 20 * i32::try_from(i)?;
                dot(area, (604, legend), COLOURS[i])?;
                text(area, task.name(), (616, legend), 13, HPos::Left)?;
                let of_task = of_tasks.iter().filter(|of| of.task == task.name());
                let mut dots: Vec<_> =
                    of_task.map(|of| ((x.at(of.median), y.at(of.error)), number(&of.method))).collect();
                dots.sort_unstable();
                numbered(area, &dots, COLOURS[i], if i == 0 { HPos::Right } else { HPos::Left })?;
            }
            for (i, method) in methods.iter().enumerate() {
                let legend = 124 + 20 * i32::try_from(i)?;
                text(area, &format!("{}  {method}", i + 1), (600, legend), 13, HPos::Left)?;
            }
            Ok(())
        })
    }
}

/// Dots from left to right, with one text for those that touch: the end `anchor` of the text is next to them.
fn numbered(area: &Area, dots: &[Dot], colour: RGBColor, anchor: HPos) -> Drawn {
    for &(at, _) in dots {
        dot(area, at, colour)?;
    }
    let touch = |((x, y), _): &Dot, ((next, up), _): &Dot| next - x < 12 && (up - y).abs() < 8;
    for dots in dots.chunk_by(touch) {
        let mut numbers: Vec<usize> = dots.iter().map(|(_, number)| *number).collect();
        numbers.sort_unstable();
        let numbers: Vec<String> = numbers.iter().map(usize::to_string).collect();
        let [(first, y), (last, up)] = [dots[0].0, dots[dots.len() - 1].0];
        let at = if matches!(anchor, HPos::Right) { (first - 7, y - 7) } else { (last + 7, up + 7) };
        text(area, &numbers.join(", "), at, 11, anchor)?;
    }
    Ok(())
}
