//! What each form keeps as pictures: errors over the gap and over the angle, both axes logarithmic.

use super::ReportError;
use super::accuracy::{Accuracy, AccuracyRow, Losses};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn std::error::Error>>;

const SIZE: (u32, u32) = (860, 480);
const LEFT: i32 = 80;
const RIGHT: i32 = 640;
const TOP: i32 = 50;
const BOTTOM: i32 = 420;
/// The powers of ten at the ends of the axis of errors.
const POWERS: (i32, i32) = (-17, 3);
const FONT: &str = "sans-serif";
const GREY: RGBColor = RGBColor(205, 205, 205);
/// Of the palette of Okabe and Ito.
const COLOURS: [RGBColor; 3] = [RGBColor(213, 94, 0), RGBColor(86, 180, 233), BLACK];

impl Accuracy {
    /// The errors of Delta-delta d over the gap; the same record always makes the same picture.
    ///
    /// # Errors
    /// [`ReportError::Draw`].
    pub fn gap_to_svg(&self) -> Result<String, ReportError> {
        let names = ["paper: divided by d", "along the normal", "chosen"];
        picture("Median error of Delta-delta d over the gap", names, &self.gaps, |row| row.d)
    }

    /// The errors of Delta-delta xi over the angle; the same record always makes the same picture.
    ///
    /// # Errors
    /// [`ReportError::Draw`].
    pub fn angle_to_svg(&self) -> Result<String, ReportError> {
        let names = ["paper: determinants", "by cross products", "chosen"];
        picture("Median error of Delta-delta xi over the angle", names, &self.angles, |row| row.xi)
    }
}

fn picture(
    title: &str,
    names: [&str; 3],
    rows: &[AccuracyRow],
    of: fn(&AccuracyRow) -> Losses,
) -> Result<String, ReportError> {
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        draw(&root, title, names, rows, of).map_err(|error| ReportError::Draw(error.to_string()))?;
    }
    if !svg.ends_with('\n') {
        svg.push('\n');
    }
    Ok(svg)
}

fn draw(
    root: &Area,
    title: &str,
    names: [&str; 3],
    rows: &[AccuracyRow],
    of: fn(&AccuracyRow) -> Losses,
) -> Drawn {
    root.fill(&WHITE)?;
    text(root, title, (LEFT, 22), 17, HPos::Left)?;
    // From wide to narrow.
    let decades = i32::try_from(rows.len())?.saturating_sub(1).max(1);
    let x = |at: f64| pixel(-at.log10() / f64::from(decades), (LEFT, RIGHT));
    let y = |error: f64| {
        let share = (error.log10() - f64::from(POWERS.0)) / f64::from(POWERS.1 - POWERS.0);
        pixel(share, (BOTTOM, TOP))
    };
    for power in (POWERS.0..=POWERS.1).filter(|power| power % 4 == 0) {
        let at = y(10_f64.powi(power));
        root.draw(&PathElement::new([(LEFT, at), (RIGHT, at)], GREY))?;
        text(root, &format!("1e{power}"), (LEFT - 8, at), 12, HPos::Right)?;
    }
    for row in rows {
        let at = x(row.at);
        root.draw(&PathElement::new([(at, TOP), (at, BOTTOM)], GREY))?;
        text(root, &format!("{:e}", row.at), (at, BOTTOM + 14), 11, HPos::Center)?;
    }
    for (k, name) in names.into_iter().enumerate() {
        let told = |row: &AccuracyRow| {
            let Losses { paper, robust, chosen } = of(row);
            [paper, robust, chosen][k].filter(|error| *error > 0.0).map(|error| (x(row.at), y(error)))
        };
        let points: Vec<_> = rows.iter().filter_map(told).collect();
        let (colour, width) = (COLOURS[k], if k == 2 { 1 } else { 4 });
        root.draw(&PathElement::new(points.clone(), colour.stroke_width(width)))?;
        for point in points {
            root.draw(&Circle::new(point, if k == 2 { 3 } else { 4 }, colour.filled()))?;
        }
        let legend = TOP + 12 + 22 * i32::try_from(k)?;
        root.draw(&PathElement::new(
            [(RIGHT + 16, legend), (RIGHT + 40, legend)],
            colour.stroke_width(width),
        ))?;
        text(root, name, (RIGHT + 48, legend), 13, HPos::Left)?;
    }
    Ok(root.present()?)
}

/// Where a share of the method between two pixels is.
fn pixel(share: f64, (from, to): (i32, i32)) -> i32 {
    #[expect(clippy::cast_possible_truncation, reason = "a pixel within the picture")]
    let offset = (share.clamp(0.0, 1.0) * f64::from(to - from)).round() as i32;
    from + offset
}

fn text(area: &Area, words: &str, at: (i32, i32), size: i32, anchor: HPos) -> Drawn {
    let style = (FONT, size).into_font().color(&BLACK).pos(Pos::new(anchor, VPos::Center));
    Ok(area.draw(&Text::new(words.to_owned(), at, style))?)
}
