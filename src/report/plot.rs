//! The benchmarks as pictures; the same record always makes the same ones.

mod accuracy;
mod ratios;
mod roofline;
mod sizes;

use super::ReportError;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn Error>>;

const FONT: &str = "sans-serif";
const GREY: RGBColor = RGBColor(205, 205, 205);
/// Of the palette of Okabe and Ito.
const COLOURS: [RGBColor; 8] = [
    RGBColor(86, 180, 233),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(213, 94, 0),
    RGBColor(0, 114, 178),
    RGBColor(230, 159, 0),
    RGBColor(128, 128, 128),
    RGBColor(150, 110, 60),
];

/// A picture of this size, as SVG.
fn picture(size: (u32, u32), draw: impl FnOnce(&Area) -> Drawn) -> Result<String, ReportError> {
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        let drawn = root.fill(&WHITE).map_err(Into::into).and_then(|()| draw(&root));
        drawn
            .and_then(|()| Ok(root.present()?))
            .map_err(|error: Box<dyn Error>| ReportError::Draw(error.to_string()))?;
    }
    if !svg.ends_with('\n') {
        svg.push('\n');
    }
    Ok(svg)
}

fn text(area: &Area, words: &str, at: (i32, i32), size: i32, anchor: HPos) -> Drawn {
    let style = (FONT, size).into_font().color(&BLACK).pos(Pos::new(anchor, VPos::Center));
    Ok(area.draw(&Text::new(words.to_owned(), at, style))?)
}

fn line(area: &Area, from: (i32, i32), to: (i32, i32), colour: RGBColor) -> Drawn {
    Ok(area.draw(&PathElement::new([from, to], colour))?)
}

/// A logarithmic axis.
struct Axis {
    /// The first and the last value.
    range: (f64, f64),
    /// The pixels where they are.
    pixels: (i32, i32),
    /// The values that are marked, with their names.
    ticks: Vec<(f64, String)>,
    /// What it measures.
    name: &'static str,
}

impl Axis {
    /// An axis from one power of ten to another, all of them marked, that holds all `values`.
    fn decades(
        values: impl Iterator<Item = f64>,
        pixels: (i32, i32),
        name: &'static str,
        label: impl Fn(f64) -> String,
    ) -> Self {
        let (least, most) = values
            .filter(|value| *value > 0.0)
            .fold((f64::INFINITY, 0.0_f64), |(least, most), x| (least.min(x), most.max(x)));
        let (low, high) =
            if least <= most { (least.log10().floor(), most.log10().ceil()) } else { (0.0, 1.0) };
        let high = high.max(low + 1.0);
        #[expect(clippy::cast_possible_truncation, reason = "exponents of f64")]
        let powers = (low as i32)..=(high as i32);
        let ticks = powers.map(|power| 10_f64.powi(power)).map(|value| (value, label(value))).collect();
        Self { range: (10_f64.powf(low), 10_f64.powf(high)), pixels, ticks, name }
    }

    /// The pixel of a value; what is beyond the ends is put there.
    fn at(&self, value: f64) -> i32 {
        let ((low, high), (from, to)) = (self.range, self.pixels);
        let part = ((value / low).ln() / (high / low).ln()).clamp(0.0, 1.0);
        #[expect(clippy::cast_possible_truncation, reason = "a pixel within the picture")]
        let offset = (part * f64::from(to - from)).round() as i32;
        from + offset
    }
}

/// Both axes, with their marks and names.
fn frame(area: &Area, x: &Axis, y: &Axis, title: &str) -> Drawn {
    let ((left, right), (bottom, top)) = (x.pixels, y.pixels);
    text(area, title, (left, top - 38), 17, HPos::Left)?;
    for (value, label) in &x.ticks {
        line(area, (x.at(*value), top), (x.at(*value), bottom), GREY)?;
        text(area, label, (x.at(*value), bottom + 12), 12, HPos::Center)?;
    }
    for (value, label) in &y.ticks {
        line(area, (left, y.at(*value)), (right, y.at(*value)), GREY)?;
        text(area, label, (left - 8, y.at(*value)), 12, HPos::Right)?;
    }
    line(area, (left, bottom), (right, bottom), BLACK)?;
    line(area, (left, top), (left, bottom), BLACK)?;
    text(area, x.name, (left.midpoint(right), bottom + 32), 13, HPos::Center)?;
    text(area, y.name, (left - 60, top - 16), 13, HPos::Left)
}

/// A dot.
fn dot(area: &Area, at: (i32, i32), colour: RGBColor) -> Drawn {
    Ok(area.draw(&Circle::new(at, 4, colour.filled()))?)
}
