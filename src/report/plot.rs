//! The benchmarks as a picture: ratios to the closed form, on a logarithmic axis.

use super::ReportError;
use super::benchmark::{Benchmark, DENOMINATOR, Measured};
use super::number::{count, plain};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

const WIDTH: u32 = 860;
/// The height of title and legend.
const HEAD: i32 = 62;
/// The height of a bar.
const BAR: i32 = 13;
/// The height between the bars of two ways.
const SPACE: i32 = 9;
/// The height of a panel's title.
const TITLE: i32 = 34;
/// The height of a panel's axis.
const AXIS: i32 = 34;
/// Where the names of the ways end.
const NAMES: i32 = 172;
/// Where the bars start.
const LEFT: i32 = 180;
/// Where the axis ends.
const RIGHT: i32 = 790;
/// The sizes' colours, of the palette of Okabe and Ito.
const COLOURS: [RGBColor; 3] = [RGBColor(86, 180, 233), RGBColor(0, 158, 115), RGBColor(204, 121, 167)];
const FONT: &str = "sans-serif";

impl Benchmark {
    /// The picture; the same record always makes the same picture.
    ///
    /// # Errors
    /// [`ReportError::Draw`].
    pub fn to_svg(&self) -> Result<String, ReportError> {
        let panels: Vec<Panel> = self.tasks().filter_map(Panel::new).collect();
        let height = HEAD + panels.iter().map(Panel::height).sum::<i32>();
        let mut svg = String::new();
        {
            let size = (WIDTH, u32::try_from(height).unwrap_or(WIDTH));
            let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            draw(&root, &panels).map_err(|error| ReportError::Draw(error.to_string()))?;
        }
        if !svg.ends_with('\n') {
            svg.push('\n');
        }
        Ok(svg)
    }
}

/// One task: its ways, and the sizes of each.
struct Panel<'a> {
    task: &'a str,
    ways: Vec<(&'a str, Vec<&'a Measured>)>,
    sizes: Vec<&'a str>,
    /// The power of ten at which the axis ends.
    decades: i32,
}

impl<'a> Panel<'a> {
    /// The panel of a task that has a closed form and something to divide by it.
    fn new(of: &'a [Measured]) -> Option<Self> {
        let mut panel = Self { task: &of.first()?.task, ways: Vec::new(), sizes: Vec::new(), decades: 1 };
        for measured in of {
            let Some(ratio) = measured.ratio_to_closed_form else { continue };
            if !panel.sizes.contains(&measured.dofs.as_str()) {
                panel.sizes.push(&measured.dofs);
            }
            if measured.way == DENOMINATOR {
                continue;
            }
            while ratio.interval[1] >= 10_f64.powi(panel.decades) {
                panel.decades += 1;
            }
            match panel.ways.iter_mut().find(|(way, _)| *way == measured.way) {
                Some((_, rows)) => rows.push(measured),
                None => panel.ways.push((&measured.way, vec![measured])),
            }
        }
        (!panel.ways.is_empty()).then_some(panel)
    }

    fn height(&self) -> i32 {
        let bars: i32 = self.ways.iter().map(|(_, rows)| way_height(rows)).sum();
        TITLE + bars + AXIS
    }
}

/// The height that a way takes, the space after it included.
fn way_height(rows: &[&Measured]) -> i32 {
    BAR * i32::try_from(rows.len()).unwrap_or(0) + SPACE
}

fn text(
    area: &Area,
    words: &str,
    at: (i32, i32),
    size: i32,
    anchor: HPos,
) -> Result<(), Box<dyn std::error::Error>> {
    let style = (FONT, size).into_font().color(&BLACK).pos(Pos::new(anchor, VPos::Center));
    Ok(area.draw(&Text::new(words.to_owned(), at, style))?)
}

fn draw(root: &Area, panels: &[Panel]) -> Result<(), Box<dyn std::error::Error>> {
    root.fill(&WHITE)?;
    text(root, "Time of each way over the time of the closed form", (LEFT, 18), 17, HPos::Left)?;
    let sizes = panels.first().map_or(&[][..], |panel| &panel.sizes);
    for (i, size) in sizes.iter().enumerate() {
        let x = LEFT + 90 * i32::try_from(i)?;
        root.draw(&Rectangle::new([(x, 38), (x + 12, 50)], COLOURS[i % 3].filled()))?;
        text(root, size, (x + 18, 45), 13, HPos::Left)?;
    }
    let mut top = HEAD;
    for panel in panels {
        draw_panel(root, panel, top)?;
        top += panel.height();
    }
    Ok(root.present()?)
}

fn draw_panel(root: &Area, panel: &Panel, top: i32) -> Result<(), Box<dyn std::error::Error>> {
    let x = |ratio: f64| {
        let part = (ratio.log10() / f64::from(panel.decades)).clamp(-0.1, 1.0);
        #[expect(clippy::cast_possible_truncation, reason = "a pixel within the picture")]
        let offset = (part * f64::from(RIGHT - LEFT)).round() as i32;
        LEFT + offset
    };
    let bottom = top + panel.height() - AXIS;
    text(root, panel.task, (LEFT, top + 16), 15, HPos::Left)?;
    for power in 0..=panel.decades {
        let at = x(10_f64.powi(power));
        let grey = RGBColor(205, 205, 205);
        root.draw(&PathElement::new([(at, top + TITLE - 6), (at, bottom)], grey))?;
        text(root, &count(10_u64.pow(u32::try_from(power)?)), (at, bottom + 11), 12, HPos::Center)?;
    }
    let mut y = top + TITLE;
    for (way, rows) in &panel.ways {
        let height = way_height(rows) - SPACE;
        text(root, way, (NAMES, y + height / 2), 13, HPos::Right)?;
        for measured in rows {
            let Some(ratio) = measured.ratio_to_closed_form else { continue };
            let colour =
                panel.sizes.iter().position(|&size| size == measured.dofs).map_or(BLACK, |i| COLOURS[i % 3]);
            let [low, high] = ratio.interval.map(x);
            let middle = y + BAR / 2;
            root.draw(&Rectangle::new([(x(1.0), y + 1), (x(ratio.value), y + BAR - 1)], colour.filled()))?;
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
