//! Ratios to the closed form, on a logarithmic axis.

use super::{Area, COLOURS, Drawn, GREY, picture, text};
use crate::report::benchmark::{Benchmark, Measured};
use crate::report::number::{count, plain};
use crate::report::{ReportError, Task};
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

const WIDTH: u32 = 860;
/// The height of title and legend.
const HEAD: i32 = 62;
/// The height of a bar.
const BAR: i32 = 13;
/// The height between the bars of two methods.
const SPACE: i32 = 9;
/// The height of a panel's title.
const TITLE: i32 = 34;
/// The height of a panel's axis.
const AXIS: i32 = 34;
/// Where the names of the methods end.
const NAMES: i32 = 222;
/// Where the bars start.
const LEFT: i32 = 230;
/// Where the axis ends.
const RIGHT: i32 = 790;
/// The families that are shown: straight, cubic, and with dofs that enter nonlinearly.
const FAMILIES: [&str; 3] = ["segment", "hermite", "helix"];
impl Benchmark {
    /// Ratios to the closed form, method by method.
    ///
    /// # Errors
    /// [`ReportError::Draw`].
    pub fn ratios_to_svg(&self) -> Result<String, ReportError> {
        let tasks = [Task::Distance, Task::All, Task::Directions];
        let panels: Vec<Panel> = tasks.into_iter().filter_map(|task| Panel::new(self, task)).collect();
        let height = HEAD + panels.iter().map(Panel::height).sum::<i32>();
        picture((WIDTH, u32::try_from(height).unwrap_or(WIDTH)), |area| draw(area, &panels))
    }
}

/// One task: its methods, and the families of each.
struct Panel<'a> {
    task: &'a str,
    methods: Vec<(&'a str, Vec<&'a Measured>)>,
    /// The powers of ten at which the axis starts and ends.
    decades: (i32, i32),
}

impl<'a> Panel<'a> {
    /// The panel of a task that has a closed form and something to divide by it.
    fn new(record: &'a Benchmark, task: Task) -> Option<Self> {
        let mut panel = Self { task: task.name(), methods: Vec::new(), decades: (0, 1) };
        for measured in record.of(task).filter(|measured| colour(measured).is_some()) {
            let Some(ratio) = measured.ratio_to_closed_form else { continue };
            while ratio.interval[1] >= 10_f64.powi(panel.decades.1) {
                panel.decades.1 += 1;
            }
            while ratio.interval[0] <= 10_f64.powi(panel.decades.0) {
                panel.decades.0 -= 1;
            }
            match panel.methods.iter_mut().find(|(method, _)| *method == measured.method) {
                Some((_, rows)) => rows.push(measured),
                None => panel.methods.push((&measured.method, vec![measured])),
            }
        }
        (!panel.methods.is_empty()).then_some(panel)
    }

    fn height(&self) -> i32 {
        let bars: i32 = self.methods.iter().map(|(_, rows)| way_height(rows)).sum();
        TITLE + bars + AXIS
    }
}

/// The colour of a family that is shown.
fn colour(measured: &Measured) -> Option<RGBColor> {
    FAMILIES.iter().position(|&family| family == measured.family).map(|i| COLOURS[i])
}

/// The height that a method takes, the space after it included.
fn way_height(rows: &[&Measured]) -> i32 {
    BAR * i32::try_from(rows.len()).unwrap_or(0) + SPACE
}

fn draw(root: &Area, panels: &[Panel]) -> Drawn {
    text(root, "Time of each method over the time of the closed form", (LEFT, 18), 17, HPos::Left)?;
    for (i, family) in FAMILIES.iter().enumerate() {
        let x = LEFT + 90 * i32::try_from(i)?;
        root.draw(&Rectangle::new([(x, 38), (x + 12, 50)], COLOURS[i].filled()))?;
        text(root, family, (x + 18, 45), 13, HPos::Left)?;
    }
    let mut top = HEAD;
    for panel in panels {
        draw_panel(root, panel, top)?;
        top += panel.height();
    }
    Ok(())
}

fn draw_panel(root: &Area, panel: &Panel, top: i32) -> Drawn {
    let x = |ratio: f64| {
        let (low, high) = panel.decades;
        let part = ((ratio.log10() - f64::from(low)) / f64::from(high - low)).clamp(0.0, 1.0);
        #[expect(clippy::cast_possible_truncation, reason = "a pixel within the picture")]
        let offset = (part * f64::from(RIGHT - LEFT)).round() as i32;
        LEFT + offset
    };
    let bottom = top + panel.height() - AXIS;
    text(root, panel.task, (LEFT, top + 16), 15, HPos::Left)?;
    for power in panel.decades.0..=panel.decades.1 {
        let at = x(10_f64.powi(power));
        root.draw(&PathElement::new([(at, top + TITLE - 6), (at, bottom)], GREY))?;
        text(root, &label(power), (at, bottom + 11), 12, HPos::Center)?;
    }
    let mut y = top + TITLE;
    for (method, rows) in &panel.methods {
        let height = way_height(rows) - SPACE;
        text(root, method, (NAMES, y + height / 2), 13, HPos::Right)?;
        for measured in rows {
            let Some(ratio) = measured.ratio_to_closed_form else { continue };
            let colour = colour(measured).unwrap_or(BLACK);
            let [low, high] = ratio.interval.map(x);
            let middle = y + BAR / 2;
            let [from, to] = [x(ratio.value.min(1.0)), x(ratio.value.max(1.0))];
            root.draw(&Rectangle::new([(from, y + 1), (to, y + BAR - 1)], colour.filled()))?;
            // The interval: a line with two ends.
            for line in [
                [(low, middle), (high, middle)],
                [(low, middle - 3), (low, middle + 3)],
                [(high, middle - 3), (high, middle + 3)],
            ] {
                root.draw(&PathElement::new(line, BLACK))?;
            }
            text(root, &plain(ratio.value), (high.max(x(1.0)) + 6, middle), 11, HPos::Left)?;
            y += BAR;
        }
        y += SPACE;
    }
    Ok(root.draw(&PathElement::new([(x(1.0), top + TITLE - 6), (x(1.0), bottom)], BLACK))?)
}

/// A power of ten.
fn label(power: i32) -> String {
    u32::try_from(power).map_or_else(|_| format!("{}", 10_f64.powi(power)), |power| count(10_u64.pow(power)))
}
