//! Letters, indices and brackets in UTF-8.

/// Puts the part in brackets if it is more than one factor.
pub(super) fn bracketed(part: &str) -> String {
    let part = part.trim();
    if part.contains([' ', '·']) { format!("({part})") } else { part.to_owned() }
}

/// The bold form of a letter.
pub(super) fn bold(letter: char) -> char {
    let from = |base: u32, first: u8| char::from_u32(base + u32::from(letter) - u32::from(first));
    match letter {
        'a'..='z' => from(0x1d41a, b'a'),
        'A'..='Z' => from(0x1d400, b'A'),
        _ => None,
    }
    .unwrap_or(letter)
}

/// A letter or a derivative as a subscript.
pub(super) fn subscript(index: &str) -> String {
    match index {
        "" => String::new(),
        "u" => "ᵤ".to_owned(),
        "0" => "₀".to_owned(),
        _ if index.starts_with(',') => index.to_owned(),
        _ => format!("_{index}"),
    }
}

/// An exponent as a superscript.
pub(super) fn superscript(index: &str) -> Result<String, String> {
    match index {
        "" => Ok(String::new()),
        "2" => Ok("²".to_owned()),
        "3" => Ok("³".to_owned()),
        _ => Err(format!("the exponent {index} is not known")),
    }
}
