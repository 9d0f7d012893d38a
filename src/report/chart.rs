//! Charts as SVG, in light and dark, with text that is readable at a width of 400 pixels.

mod axis;

pub use axis::{Axis, errors};

use super::page::escaped;
use std::fmt::Write;

/// The width of every chart. It is displayed at the width of the page, at most 640 pixels.
pub const WIDTH: f64 = 420.0;

/// A place in a chart, from the left and from the top.
pub type Place = [f64; 2];

/// The alignment of a text relative to its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// The shape of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    Dot,
    Diamond,
}

/// A chart. Colours are numbers from 0 to 3, and [`INK`] is the colour of text.
#[derive(Clone, Debug)]
pub struct Chart {
    height: f64,
    title: String,
    body: String,
}

/// The colour of text and axes.
pub const INK: usize = 4;

/// The colours of Okabe and Ito, darker on white and lighter on black, so that the contrast of text is at least 4.5.
const STYLE: &str = "<style>\
.chart{--page:#fff;--c4:#1a1a1a;--grid:#dcdcdc;--c0:#005a9c;--c1:#b04500;--c2:#00694f;--c3:#8a3a7c}\
@media(prefers-color-scheme:dark){\
.chart{--page:#161616;--c4:#e8e8e8;--grid:#3d3d3d;--c0:#6cb6ff;--c1:#ff9e57;--c2:#4fd1a5;--c3:#e39bd6}}\
.chart text{font:12px sans-serif;fill:var(--c4);stroke:var(--page);stroke-width:3px;paint-order:stroke}\
.chart text.strong{font-weight:bold;font-size:13px}\
.chart path,.chart line{fill:none;stroke:var(--c4)}\
.chart .grid{stroke:var(--grid)}.chart .thick{stroke-width:2.5}.chart .dashed{stroke-dasharray:4 4}\
.chart .page{fill:var(--page)}\
.chart .f0{fill:var(--c0)}.chart .f1{fill:var(--c1)}.chart .f2{fill:var(--c2)}.chart .f3{fill:var(--c3)}.chart .f4{fill:var(--c4)}\
.chart .s0{stroke:var(--c0)}.chart .s1{stroke:var(--c1)}.chart .s2{stroke:var(--c2)}.chart .s3{stroke:var(--c3)}.chart .s4{stroke:var(--c4)}\
</style>";

impl Chart {
    /// A chart with its title at the top.
    pub fn new(title: &str, height: f64) -> Self {
        let mut chart = Self { height, title: escaped(title), body: String::new() };
        chart.strong([8.0, 20.0], title);
        chart
    }

    fn add(&mut self, element: std::fmt::Arguments) {
        // Writing to a String never fails.
        let _ = writeln!(self.body, "{element}");
    }

    /// Text in a colour.
    pub fn text(&mut self, [x, y]: Place, anchor: Anchor, colour: usize, words: &str) {
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let words = escaped(words);
        self.add(format_args!("<text x=\"{x:.1}\" y=\"{y:.1}\" class=\"f{colour}\"{anchor}>{words}</text>"));
    }

    /// Emphasized text.
    pub fn strong(&mut self, [x, y]: Place, words: &str) {
        let words = escaped(words);
        self.add(format_args!("<text x=\"{x:.1}\" y=\"{y:.1}\" class=\"strong\">{words}</text>"));
    }

    /// A line with additional classes: `grid`, `thick`, `dashed`, `s0` to `s4` for colours.
    pub fn line(&mut self, [x, y]: Place, [u, v]: Place, class: &str) {
        self.add(format_args!(
            "<line x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{u:.1}\" y2=\"{v:.1}\" class=\"{class}\"/>"
        ));
    }

    /// A line through places.
    pub fn curve(&mut self, places: &[Place], class: &str) {
        let places: Vec<_> = places.iter().map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
        self.add(format_args!("<path d=\"M{}\" class=\"{class}\"/>", places.join("L")));
    }

    /// A point.
    pub fn mark(&mut self, [x, y]: Place, mark: Mark, colour: usize) {
        match mark {
            Mark::Dot => {
                self.add(format_args!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" class=\"f{colour}\"/>"));
            }
            Mark::Diamond => self.add(format_args!(
                "<polygon points=\"{},{y:.1} {x:.1},{} {},{y:.1} {x:.1},{}\" class=\"f{colour}\"/>",
                tenth(x - 5.0),
                tenth(y - 5.0),
                tenth(x + 5.0),
                tenth(y + 5.0)
            )),
        }
    }

    /// The lines, ticks, units and names of both axes.
    pub fn frame(&mut self, x: &Axis, y: &Axis) {
        let ([left, right], [bottom, top]) = (x.pixels, y.pixels);
        for (value, label) in x.ticks() {
            let at = x.at(value);
            self.line([at, top], [at, bottom], "grid");
            self.text([at, bottom + 16.0], Anchor::Middle, INK, &label);
        }
        for (value, label) in y.ticks() {
            let at = y.at(value);
            self.line([left, at], [right, at], "grid");
            self.text([left - 6.0, at + 4.0], Anchor::End, INK, &label);
        }
        self.line([left, bottom], [right, bottom], "");
        self.line([left, top], [left, bottom], "");
        self.text([right, bottom + 34.0], Anchor::End, INK, x.name);
        self.text([8.0, top - 10.0], Anchor::Start, INK, y.name);
    }

    /// The chart as SVG.
    pub fn svg(self) -> String {
        let Self { height, title, body } = self;
        let wide = 640.0;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" viewBox=\"0 0 {WIDTH} {height:.0}\" width=\"{wide}\" \
             height=\"{:.0}\" role=\"img\">\n<title>{title}</title>\n{STYLE}\n\
             <rect width=\"{WIDTH}\" height=\"{height:.0}\" class=\"page\"/>\n{body}</svg>\n",
            height * wide / WIDTH
        )
    }
}

fn tenth(x: f64) -> String {
    format!("{x:.1}")
}

/// Separates heights or lengths so that labels do not overlap: each at least `gap` from the next, all within the range.
///
/// They keep their order and move as little as a sweep in both directions requires.
pub fn apart(wanted: &[f64], gap: f64, [low, high]: [f64; 2]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]));
    let mut placed = wanted.to_vec();
    let mut next = low;
    for &i in &order {
        placed[i] = placed[i].max(next);
        next = placed[i] + gap;
    }
    let mut last = high;
    for &i in order.iter().rev() {
        placed[i] = placed[i].min(last);
        last = placed[i] - gap;
    }
    placed
}

#[cfg(test)]
mod tests {
    use super::{Anchor, Chart, INK, Mark, apart};

    #[test]
    fn labels_move_apart_and_stay_within_their_range() {
        let bits = |all: Vec<f64>| all.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(bits(apart(&[5.0, 1.0], 2.0, [0.0, 10.0])), bits(vec![5.0, 1.0]));
        assert_eq!(bits(apart(&[5.0, 5.0, 4.5], 2.0, [0.0, 10.0])), bits(vec![6.5, 8.5, 4.5]));
        assert_eq!(bits(apart(&[10.0, 9.5], 2.0, [0.0, 10.0])), bits(vec![10.0, 8.0]));
    }

    #[test]
    fn words_are_escaped_and_the_page_has_both_looks() {
        let mut chart = Chart::new("a < b", 100.0);
        chart.text([1.0, 2.0], Anchor::End, INK, "x & y");
        chart.mark([3.0, 4.0], Mark::Diamond, 1);
        let svg = chart.svg();
        assert!(svg.contains("<title>a &lt; b</title>") && svg.contains(">x &amp; y</text>"));
        assert!(svg.contains("prefers-color-scheme:dark") && svg.contains("viewBox=\"0 0 420 100\""));
        assert!(svg.contains("<polygon points=\"-2.0,4.0 3.0,-1.0 8.0,4.0 3.0,9.0\" class=\"f1\"/>"));
    }
}
