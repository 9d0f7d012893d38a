//! LaTeX as MathML, with the letters of the two beams and of the distance in colour.

use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

/// Short names in the prose for long LaTeX commands.
const MACROS: [(&str, &str); 26] = [
    ("vd", r"\mathbf{d}"),
    ("vt", r"\mathbf{t}"),
    ("vtb", r"\bar{\mathbf{t}}"),
    ("vx", r"\mathbf{x}"),
    ("vxb", r"\bar{\mathbf{x}}"),
    ("vu", r"\mathbf{u}"),
    ("vub", r"\bar{\mathbf{u}}"),
    ("uh", r"\hat{\mathbf{u}}_C"),
    ("vn", r"\mathbf{n}"),
    ("vv", r"\mathbf{v}"),
    ("vw", r"\mathbf{w}"),
    ("xb", r"\bar\xi"),
    ("tx", r"\mathbf{t}_{,\xi}"),
    ("tbx", r"\bar{\mathbf{t}}_{,\bar\xi}"),
    ("txx", r"\mathbf{t}_{,\xi\xi}"),
    ("tbxx", r"\bar{\mathbf{t}}_{,\bar\xi\bar\xi}"),
    ("ux", r"\mathbf{u}_{C,\xi}"),
    ("ubx", r"\bar{\mathbf{u}}_{\bar C,\bar\xi}"),
    ("uxx", r"\mathbf{u}_{C,\xi\xi}"),
    ("ubxx", r"\bar{\mathbf{u}}_{\bar C,\bar\xi\bar\xi}"),
    ("uc", r"\mathbf{u}_C"),
    ("ubc", r"\bar{\mathbf{u}}_{\bar C}"),
    ("Rd", r"R_\delta"),
    ("Rdb", r"\bar R_\delta"),
    ("Rdd", r"R_{\Delta\delta}"),
    ("Rddb", r"\bar R_{\Delta\delta}"),
];

/// The MathML of a formula, as a block or inline.
///
/// # Errors
/// The message of the parser, with the formula.
pub(in crate::report) fn mathml(latex: &str, block: bool) -> Result<String, String> {
    let expanded = expand(latex);
    let storage = Storage::new();
    let mut out = String::new();
    let display_mode = if block { DisplayMode::Block } else { DisplayMode::Inline };
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    push_mathml(&mut out, Parser::new(&expanded, &storage), config)
        .map_err(|error| format!("{latex}: {error}"))?;
    // A formula that cannot be parsed is rendered as an error.
    if out.contains("<merror") {
        return Err(format!("{latex} cannot be parsed"));
    }
    // The renderer escapes the space of `\ ` twice.
    let out = out.replace("<mtext>&amp;nbsp;</mtext>", "<mspace width=\"0.25em\" />");
    Ok(coloured(&out.replace("\"minsize", "\" minsize")))
}

/// The LaTeX with all short names expanded.
pub(super) fn expand(latex: &str) -> String {
    let mut out = String::with_capacity(latex.len() * 2);
    let mut rest = latex;
    while let Some(at) = rest.find('\\') {
        out.push_str(&rest[..at]);
        rest = &rest[at + 1..];
        let end = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let name = &rest[..end];
        if let Some((_, long)) = MACROS.iter().find(|(short, _)| *short == name) {
            out.push('{');
            out.push_str(long);
            out.push('}');
        } else {
            out.push('\\');
            out.push_str(name);
            // An escaped backslash does not begin a name.
            if name.is_empty() && rest.starts_with('\\') {
                out.push('\\');
                rest = &rest[1..];
                continue;
            }
        }
        rest = &rest[end..];
    }
    out + rest
}

/// Letters with classes: `b` of the beam, `r` of the bar beam, `d` the distance, `h` the difference of both.
fn coloured(mathml: &str) -> String {
    let mut text = mathml.to_owned();
    for letter in ["𝐭", "𝐱", "𝐮", "𝐗", "ξ"] {
        text = text.replace(&format!("<mi>{letter}</mi>"), &format!("<mi class=\"b\">{letter}</mi>"));
    }
    for letter in ["𝐝", "d"] {
        text = text.replace(&format!("<mi>{letter}</mi>"), &format!("<mi class=\"d\">{letter}</mi>"));
    }
    let bar = ("<mi>‾</mi></mover>", "<mo stretchy=\"false\">¯</mo></mover>", "r");
    let hat = ("<mi>^</mi></mover>", "<mo stretchy=\"false\">^</mo></mover>", "h");
    for (accent, with, class) in [bar, hat] {
        while let Some(end) = text.find(accent) {
            let start = text[..end].rfind("<mover>").unwrap_or_default();
            text.replace_range(end..end + accent.len(), with);
            text.replace_range(start..start + "<mover>".len(), &format!("<mover class=\"{class}\">"));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{expand, mathml};

    #[test]
    fn short_names_are_written_out_and_others_stay() {
        assert_eq!(expand(r"\vt\cdot\vtb_1 \\ \vtx"), r"{\mathbf{t}}\cdot{\bar{\mathbf{t}}}_1 \\ \vtx");
        assert_eq!(expand(r"a \\[2pt] \{\xi\}"), r"a \\[2pt] \{\xi\}");
    }

    #[test]
    fn the_letters_of_each_beam_have_its_class() {
        let math = mathml(r"\vd\cdot\vtb + \delta_u\uh", false).unwrap();
        assert!(math.contains("<mi class=\"d\">𝐝</mi>"), "{math}");
        assert!(math.contains("<mover class=\"r\">") && math.contains("<mover class=\"h\">"), "{math}");
        let spaced = mathml(r"a\ b", true).unwrap();
        assert!(spaced.contains("<mspace") && !spaced.contains("nbsp"), "{spaced}");
        assert!(mathml(r"\frac{1}", false).is_err() && mathml(r"\nonsense", true).is_err());
    }
}
