//! The format of numbers on pages.

/// A count as a number.
#[expect(clippy::cast_precision_loss, reason = "counts, far below 2^53")]
pub fn number(count: usize) -> f64 {
    count as f64
}

/// Rounds x to `digits` significant digits.
pub fn rounded(x: f64, digits: usize) -> f64 {
    format!("{x:.*e}", digits.saturating_sub(1)).parse().unwrap_or(x)
}

/// At least three significant digits, with separated thousands: 0.123, 1.23, 12.3, 123, 12,300.
pub fn plain(x: f64) -> String {
    let x = rounded(x, 3);
    let decimals = match x.abs() {
        size if size < 1.0 => 3,
        size if size < 10.0 => 2,
        size if size < 100.0 => 1,
        _ => 0,
    };
    let text = format!("{x:.decimals$}");
    if decimals > 0 { text } else { thousands(&text) }
}

/// Two significant digits, with separated thousands: 0.12, 1.2, 12, 120, 1,200.
pub fn two_digits(x: f64) -> String {
    let x = rounded(x, 2);
    match x.abs() {
        size if size < 1.0 => format!("{x:.2}"),
        size if size < 10.0 => format!("{x:.1}"),
        _ => thousands(&format!("{x:.0}")),
    }
}

/// A count with separated thousands.
pub fn count(n: u64) -> String {
    thousands(&n.to_string())
}

fn thousands(digits: &str) -> String {
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A time in nanoseconds, in a suitable unit.
pub fn time(ns: f64) -> String {
    match ns {
        _ if ns < 999.5 => format!("{} ns", plain(ns)),
        _ if ns < 999.5e3 => format!("{} µs", plain(ns * 1e-3)),
        _ => format!("{} ms", plain(ns * 1e-6)),
    }
}

/// An error, to two digits. A missing error is written as not a number.
pub fn error(error: Option<f64>) -> String {
    error.map_or_else(
        || "not a number".to_owned(),
        |error| if error == 0.0 { "0".to_owned() } else { format!("{error:.1e}") },
    )
}

/// A number that JSON can represent. JSON has no infinity.
pub fn finite(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}
