//! Numbers as programs print them: read leniently and exactly, and written without loss of a bit.
//!
//! In addition to decimal numbers with an exponent E, it reads Fortran's exponents D and Q, its three-digit exponents
//! without a letter (`1.0-101`), hexadecimal numbers of C99 (`0x1.8p+1`), and what languages print for infinity and
//! for NaN. A decimal number is rounded correctly.

/// The reason why a word is not a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NotANumber {
    /// It is empty.
    Empty,
    /// It is a row of asterisks, which Fortran prints if the field is too narrow.
    Overflow,
    /// It is something else.
    Other,
}

impl NotANumber {
    /// The reason in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Empty => "a number expected, found nothing",
            Self::Overflow => {
                "a number expected, found asterisks: the field of the Fortran format is too narrow"
            }
            Self::Other => "a number expected",
        }
    }
}

/// Reads a number.
///
/// # Errors
/// [`NotANumber`] if the word is not a number.
pub fn parse(word: &str) -> Result<f64, NotANumber> {
    let word = word.trim_matches([' ', '\t']);
    match word.parse() {
        Ok(number) => Ok(number),
        Err(_) if word.is_empty() => Err(NotANumber::Empty),
        Err(_) if word.bytes().all(|byte| byte == b'*') => Err(NotANumber::Overflow),
        Err(_) => {
            hexadecimal(word).or_else(|| fortran(word)).or_else(|| no_number(word)).ok_or(NotANumber::Other)
        }
    }
}

/// The number in hexadecimal, as C's `%a` prints it; all bits of a finite number.
pub fn hex(number: f64) -> String {
    const FRACTION: u64 = (1 << 52) - 1;
    let sign = if number.is_sign_negative() { "-" } else { "" };
    if number.is_nan() {
        return "nan".into();
    }
    if number.is_infinite() {
        return format!("{sign}inf");
    }
    if number == 0.0 {
        return format!("{sign}0x0p+0");
    }
    let bits = number.to_bits();
    let (biased, fraction) = ((bits >> 52) & 0x7ff, bits & FRACTION);
    // A subnormal number has no leading one, and the smallest exponent.
    let (lead, exponent) =
        if biased == 0 { (0, -1022) } else { (1, i64::try_from(biased).unwrap_or(0) - 1023) };
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{lead}{point}{digits}p{exponent:+}")
}

/// Exponents of Fortran: D or Q for E, or none before the sign.
fn fortran(word: &str) -> Option<f64> {
    if !word.is_ascii() || word.bytes().any(|byte| matches!(byte, b'e' | b'E')) {
        return None;
    }
    let number = if let Some(at) = word.find(['d', 'D', 'q', 'Q']) {
        format!("{}e{}", &word[..at], &word[at + 1..])
    } else {
        let at = word.rfind(['+', '-']).filter(|&at| at > 0)?;
        format!("{}e{}", &word[..at], &word[at..])
    };
    // Words such as `inf` and `nan` have no mantissa.
    number
        .trim_start_matches(['+', '-'])
        .starts_with(|c: char| c.is_ascii_digit() || c == '.')
        .then_some(())?;
    number.parse().ok()
}

/// The notations of languages for results that are not finite.
fn no_number(word: &str) -> Option<f64> {
    let lower = word.to_ascii_lowercase();
    let (is_negative, size) = match lower.as_bytes().first()? {
        b'-' => (true, &lower[1..]),
        b'+' => (false, &lower[1..]),
        _ => (false, &lower[..]),
    };
    let is_nan = matches!(size, "nanq" | "nans" | "snan" | "1.#ind" | "1.#qnan" | "1.#snan")
        || (size.starts_with("nan(") && size.ends_with(')'));
    match size {
        _ if is_nan => Some(f64::NAN),
        "1.#inf" if is_negative => Some(f64::NEG_INFINITY),
        "1.#inf" => Some(f64::INFINITY),
        _ => None,
    }
}

fn hexadecimal(word: &str) -> Option<f64> {
    let (sign, size) = match word.strip_prefix('-') {
        Some(size) => (-1.0, size),
        None => (1.0, word.strip_prefix('+').unwrap_or(word)),
    };
    let digits = size.strip_prefix("0x").or_else(|| size.strip_prefix("0X"))?;
    let (mantissa, exponent) = digits.split_once(['p', 'P']).unwrap_or((digits, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent: i32 = exponent.parse().ok().filter(|exponent: &i32| exponent.abs() < 100_000)?;
    let (mut bits, mut scale) = (0_u64, exponent);
    if whole.len() + fraction.len() == 0 || fraction.len() > 1000 {
        return None;
    }
    let digits = whole.bytes().map(|byte| (byte, 0)).chain(fraction.bytes().map(|byte| (byte, -4)));
    for (byte, shift) in digits {
        let digit = char::from(byte).to_digit(16)?;
        if bits >> 59 == 0 {
            bits = 16 * bits + u64::from(digit);
            scale += shift;
        } else {
            // Digits beyond 60 bits only decide about rounding.
            bits |= u64::from(digit != 0);
            scale += 4 + shift;
        }
    }
    #[expect(clippy::cast_precision_loss, reason = "rounds to the nearest number")]
    let mut value = bits as f64;
    // In steps that neither overflow nor lose bits before the last one.
    while scale != 0 && value != 0.0 && value.is_finite() {
        let step = scale.clamp(-960, 960);
        value *= 2.0_f64.powi(step);
        scale -= step;
    }
    Some(sign * value)
}

#[cfg(test)]
mod tests {
    use super::{NotANumber, hex, parse};
    use proptest::prelude::*;

    #[test]
    fn what_languages_print_is_read() {
        for (word, number) in [
            ("1.2345678901234567-101", 1.234_567_890_123_456_7e-101),
            ("-1.5+300", -1.5e300),
            ("0.1D+00", 0.1),
            ("-.25d-3", -0.25e-3),
            ("1.5Q2", 150.0),
            ("+2.5E+03", 2500.0),
            (" 7. ", 7.0),
            ("0x1.8p+1", 3.0),
            ("-0X.8P-1", -0.25),
            ("0x10", 16.0),
            ("Infinity", f64::INFINITY),
            ("-inf", f64::NEG_INFINITY),
            ("-1.#INF", f64::NEG_INFINITY),
        ] {
            assert_eq!(parse(word).map(f64::to_bits), Ok(number.to_bits()), "{word}");
        }
        for word in ["NaN", "-nan", "nan(0x8)", "NaNQ", "-nan(ind)", "1.#QNAN", "nan"] {
            assert!(parse(word).is_ok_and(f64::is_nan), "{word}");
        }
    }

    #[test]
    fn other_words_are_no_numbers() {
        for word in
            ["abc", "1.0.0", "1e", "--1", "1-", "-", "0x", "0xg", "0x1p", "d5", "1 2", "1,5", "1e5e5", "ω"]
        {
            assert_eq!(parse(word), Err(NotANumber::Other), "{word}");
        }
        assert_eq!((parse("  "), parse("*****")), (Err(NotANumber::Empty), Err(NotANumber::Overflow)));
    }

    #[test]
    fn hexadecimal_numbers_are_those_of_c() {
        for (number, word) in [(1.0, "0x1p+0"), (-0.0, "-0x0p+0"), (0.1, "0x1.999999999999ap-4")] {
            assert_eq!(hex(number), word);
        }
        assert_eq!(hex(f64::from_bits(1)), "0x0.0000000000001p-1022");
        // More digits than a double has are rounded.
        assert_eq!(parse("0x1.00000000000008p0"), Ok(1.0));
        assert_eq!(parse("0x1.000000000000080001p0"), Ok(1.0 + f64::EPSILON));
    }

    proptest! {
        #[test]
        fn no_bit_is_lost(bits in any::<u64>()) {
            let number = f64::from_bits(bits);
            prop_assume!(!number.is_nan());
            prop_assert_eq!(parse(&hex(number)).map(f64::to_bits), Ok(bits));
            prop_assert_eq!(parse(&format!("{number:e}")).map(f64::to_bits), Ok(bits));
            let fortran = format!("{number:.16e}").replace('e', "D");
            prop_assert_eq!(parse(&fortran).map(f64::to_bits), Ok(bits));
        }
    }
}
