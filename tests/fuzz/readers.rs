//! The bodies of the fuzz targets for text. A test runs them on a fixed corpus: no text makes a reader panic.

use beamgap::check::external::{
    AnswerReader, Demands, Drawing, Expected, Matching, Vector, VectorReader, VectorWriter, hex, parse,
};
use beamgap::check::{Family, Regime};
use std::sync::OnceLock;

/// Two straight beams: the case of the answers.
fn vector() -> &'static Vector {
    static VECTOR: OnceLock<Vector> = OnceLock::new();
    VECTOR.get_or_init(|| {
        let (families, regimes) = (vec![Family::Segment], vec![Regime::Generic]);
        Drawing {
            seed: 7,
            regimes,
            families,
            cases: 1,
            penetrating: true,
            elements: false,
            steps: false,
            work: None,
        }
        .vector(0)
    })
}

/// Reads answers, JSON Lines or CSV, and compares the answers of case 0.
pub(crate) fn answers(text: &[u8]) {
    let Ok(mut reader) = AnswerReader::new(text, "answers") else { return };
    let demands = Demands { conventions: *reader.conventions(), digits: None };
    let (mut matching, mut vectors) = (Matching::new(demands, 4), Some(vector().clone()).into_iter());
    let mut next = || Ok::<_, beamgap::check::external::ExternalError>(vectors.next());
    while let Ok(Some(answers)) = reader.next_answers() {
        if matching.take(answers, &mut next).is_err() {
            return;
        }
    }
    let _ = matching.finish(next);
}

/// Reads cases. A valid case is written, and read again without loss of a bit.
pub(crate) fn vectors(text: &[u8]) {
    let Ok(mut reader) = VectorReader::new(text, "vectors") else { return };
    while let Ok(Some(vector)) = reader.next_vector() {
        let vector = Vector { place: None, ..vector };
        let writer = VectorWriter { hex: true, expected: Expected::None };
        let head = reader_head();
        let text = format!("{head}\n{}\n", writer.line(&vector));
        let mut again = VectorReader::new(text.as_bytes(), "vectors").expect("a head");
        let read = again.next_vector().expect("what was written is read").expect("a case");
        assert_eq!(Vector { place: None, ..read }, vector);
    }
}

fn reader_head() -> &'static str {
    "{\"schema\":\"beamgap-vectors/1\"}"
}

/// Reads a number. A valid number is written in hexadecimal, and read again without loss of a bit.
pub(crate) fn number(text: &str) {
    let Ok(number) = parse(text) else { return };
    let again = parse(&hex(number)).expect("what was written is read");
    assert!(again.to_bits() == number.to_bits() || (again.is_nan() && number.is_nan()), "{text}");
}
