//! LaTeX as MathML, with the letters of the two beams and of the distance in colour.

use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::event::Event;
use pulldown_latex::{Parser, Storage, push_mathml};

/// Short names in the prose for long LaTeX commands.
const MACROS: &str = r"
    \def\vd{{\mathbf{d}}}
    \def\vt{{\mathbf{t}}}
    \def\vtb{{\bar{\mathbf{t}}}}
    \def\vx{{\mathbf{x}}}
    \def\vxb{{\bar{\mathbf{x}}}}
    \def\vu{{\mathbf{u}}}
    \def\vub{{\bar{\mathbf{u}}}}
    \def\uh{{\hat{\mathbf{u}}_C}}
    \def\vn{{\mathbf{n}}}
    \def\vv{{\mathbf{v}}}
    \def\vw{{\mathbf{w}}}
    \def\xb{{\bar\xi}}
    \def\tx{{\mathbf{t}_{,\xi}}}
    \def\tbx{{\bar{\mathbf{t}}_{,\bar\xi}}}
    \def\txx{{\mathbf{t}_{,\xi\xi}}}
    \def\tbxx{{\bar{\mathbf{t}}_{,\bar\xi\bar\xi}}}
    \def\ux{{\mathbf{u}_{C,\xi}}}
    \def\ubx{{\bar{\mathbf{u}}_{\bar C,\bar\xi}}}
    \def\uxx{{\mathbf{u}_{C,\xi\xi}}}
    \def\ubxx{{\bar{\mathbf{u}}_{\bar C,\bar\xi\bar\xi}}}
    \def\uc{{\mathbf{u}_C}}
    \def\ubc{{\bar{\mathbf{u}}_{\bar C}}}
    \def\Rd{{R_\delta}}
    \def\Rdb{{\bar R_\delta}}
    \def\Rdd{{R_{\Delta\delta}}}
    \def\Rddb{{\bar R_{\Delta\delta}}}
";

/// The LaTeX with the definitions of the short names before it.
pub(super) fn with_macros(latex: &str) -> String {
    MACROS.to_owned() + latex
}

/// The events of LaTeX with macros.
///
/// # Errors
/// The message of the parser.
pub(super) fn parsed<'a>(source: &'a str, storage: &'a Storage) -> Result<Vec<Event<'a>>, String> {
    Parser::new(source, storage).collect::<Result<_, _>>().map_err(|error| error.to_string())
}

/// The MathML of a formula, as a block or inline.
///
/// # Errors
/// The message of the parser, with the formula.
pub(crate) fn mathml(latex: &str, block: bool) -> Result<String, String> {
    let (source, storage) = (with_macros(latex), Storage::new());
    let events = parsed(&source, &storage)?;
    let display_mode = if block { DisplayMode::Block } else { DisplayMode::Inline };
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let mut out = String::new();
    push_mathml(&mut out, events.into_iter().map(Ok::<_, std::io::Error>), config)
        .map_err(|error| format!("{latex}: {error}"))?;
    // The renderer escapes the space of `\ ` twice.
    let out = out.replace("<mtext>&amp;nbsp;</mtext>", "<mspace width=\"0.25em\" />");
    Ok(coloured(&out.replace("\"minsize", "\" minsize")))
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
    use super::mathml;

    #[test]
    fn the_letters_of_each_beam_have_its_class() {
        let math = mathml(r"\vd\cdot\vtb + \delta_u\uh", false).unwrap();
        assert!(math.contains("<mi class=\"d\">𝐝</mi>"), "{math}");
        assert!(math.contains("<mover class=\"r\">") && math.contains("<mover class=\"h\">"), "{math}");
        assert!(mathml(r"\vtx", false).unwrap_err().contains(r"\vtx"));
        let spaced = mathml(r"a\ b", true).unwrap();
        assert!(spaced.contains("<mspace") && !spaced.contains("nbsp"), "{spaced}");
        assert!(mathml(r"\frac{1}", false).is_err() && mathml(r"\nonsense", true).is_err());
    }
}
