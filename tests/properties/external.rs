//! Answers of other programs are read in every notation and compared with the same tolerances.

mod broken;
mod complete;
mod conventions;
mod digits;
mod explanations;
mod hand_written;
mod hidden;
mod parameters;
mod programs;
mod recognized;

use beamgap::check::external::{
    AnswerReader, Demands, Drawing, Evaluator, Expected, Formulas, Matching, Report, Vector, VectorReader,
    VectorWriter,
};
use beamgap::check::{Family, Regime};
use proptest::prelude::*;
use std::fmt::Write as _;

pub(crate) fn drawing(families: &[Family], regimes: &[Regime], cases: u64) -> Drawing {
    Drawing {
        seed: 7,
        regimes: regimes.to_vec(),
        families: families.to_vec(),
        cases,
        penetrating: false,
        elements: false,
        steps: false,
        work: None,
    }
}

fn vectors(drawing: &Drawing) -> Vec<Vector> {
    (0..drawing.count()).map(|number| drawing.vector(number)).collect()
}

/// The answers of the library, as text.
fn answers(evaluator: &Evaluator, vectors: &[Vector]) -> String {
    let lines = vectors.iter().map(|vector| evaluator.line(vector) + "\n");
    format!("{}\n{}", evaluator.head(), lines.collect::<String>())
}

/// The result of the comparison of a text of answers.
fn verified(vectors: &[Vector], text: &str, digits: Option<u8>) -> Result<Report, String> {
    let mut reader = AnswerReader::new(text.as_bytes(), "answers").map_err(|error| error.to_string())?;
    let demands = Demands { conventions: *reader.conventions(), digits };
    let matching = Matching::new(demands, 64).of_program(reader.program(), reader.only());
    let (mut matching, mut vectors) = (matching, vectors.iter().cloned());
    let mut next = || Ok::<_, beamgap::check::external::ExternalError>(vectors.next());
    while let Some(answers) = reader.next_answers().map_err(|error| error.to_string())? {
        matching.take(answers, &mut next).map_err(|error| error.to_string())?;
    }
    matching.finish(next).map_err(|error| error.to_string())
}

/// The text with additional entries in its head.
fn with_head(text: &str, entries: &str) -> String {
    text.replacen('}', &format!(",{entries}}}"), 1)
}

#[test]
fn cases_are_read_back_to_the_last_bit() {
    let drawing = drawing(&Family::ALL, &Regime::ALL, 7);
    let all = vectors(&drawing);
    for hex in [false, true] {
        for expected in [Expected::None, Expected::All] {
            let writer = VectorWriter { hex, expected };
            let lines = all.iter().map(|vector| writer.line(vector) + "\n");
            let text = format!("{}\n{}", writer.head(&drawing), lines.collect::<String>());
            let mut reader = VectorReader::new(text.as_bytes(), "vectors").unwrap();
            for vector in &all {
                let read = reader.next_vector().unwrap().unwrap();
                assert_eq!(Vector { place: None, ..read }, *vector);
            }
            assert_eq!(reader.next_vector().unwrap(), None);
        }
    }
}

#[test]
fn the_library_agrees_with_itself_in_all_formulations_and_notations() {
    let all = vectors(&drawing(&Family::ALL, &Regime::ALL, 6));
    for formulas in [Formulas::Chosen, Formulas::Paper] {
        for hex in [false, true] {
            let writer = VectorWriter { hex, expected: Expected::None };
            let evaluator = Evaluator { formulas, writer, ..Evaluator::default() };
            let report = verified(&all, &answers(&evaluator, &all), None).unwrap();
            assert!(report.agrees() && report.missing == 0, "{report:?}");
            assert!(report.compared >= 50 && report.never_answered().is_empty());
        }
    }
}

#[test]
fn a_loss_of_digits_is_told_and_fails_only_if_digits_are_asked_for() {
    let all = vectors(&drawing(&[Family::Hermite], &[Regime::NearlyCrossing], 20));
    let paper = Evaluator { formulas: Formulas::Paper, ..Evaluator::default() };
    let text = answers(&paper, &all);
    let report = verified(&all, &text, None).unwrap();
    let loss = report.regimes["nearly-crossing"].loss.clone().unwrap();
    assert!(report.agrees() && loss.digits() > 2.0, "{loss:?}");
    assert!(!verified(&all, &text, Some(12)).unwrap().agrees());
    let best = answers(&Evaluator::default(), &all);
    assert!(verified(&all, &best, Some(12)).unwrap().agrees());
}

#[test]
fn six_digits_are_enough_if_six_are_asked_for() {
    let all = vectors(&drawing(&[Family::Hermite, Family::Arc], &[Regime::Generic], 16));
    let rounded = Evaluator { digits: Some(6), ..Evaluator::default() };
    let text = answers(&rounded, &all);
    assert!(verified(&all, &text, Some(6)).unwrap().agrees());
    assert!(!verified(&all, &text, None).unwrap().agrees());
}

#[test]
fn what_is_not_answered_is_told() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 10));
    let text = answers(&Evaluator::default(), &all);
    let some: String =
        text.lines().enumerate().filter(|(i, _)| i % 3 == 0).map(|(_, l)| l.to_owned() + "\n").collect();
    let report = verified(&all, &some, None).unwrap();
    assert_eq!((report.vectors, report.compared, report.missing), (10, 3, 7));
    assert_eq!(report.first_missing.as_deref(), Some("0"));
    // The answers are in another order, and one of them has no numbers.
    let mut lines: Vec<&str> = text.lines().collect();
    lines[1..].reverse();
    lines[5] = "{\"id\":5,\"result\":\"degenerate\"}";
    let report = verified(&all, &lines.join("\n"), None).unwrap();
    assert_eq!((report.compared, report.declined, report.missing), (9, 1, 0));
    assert!(!report.agrees());
    // Answers with values only.
    let value = "{\"schema\":\"beamgap-answers/1\"}\n{\"id\":\"0\",\"d\":1e3,\"x\":{\"value\":[0,0,0]}}\n";
    let report = verified(&all, value, None).unwrap();
    assert_eq!((report.wrong, report.parts.len()), (1, 2));
}

/// An answer without its case says why it has none.
#[test]
fn an_answer_belongs_to_one_case() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 70));
    let text = answers(&Evaluator::default(), &all);
    let first = text.lines().nth(1).unwrap();
    // 69 cases are open, and the first five of them are given up.
    let late = [text.lines().next().unwrap(), text.lines().last().unwrap(), first].join("\n");
    for (text, expected) in [
        (format!("{text}{first}\n"), "answers:72: case \"0\": one answer expected, found another in line 2"),
        (format!("{text}{{\"id\":\"70\",\"d\":1}}\n"), "answers:72: the id of a case expected, found \"70\""),
        (
            late,
            "answers:3: case \"0\": its answer expected earlier, in the order of the cases or at most 64 out of it",
        ),
    ] {
        assert_eq!(verified(&all, &text, None).map(drop), Err(expected.to_owned()));
    }
}

#[test]
fn csv_says_the_same_as_json() {
    let all = vectors(&drawing(&[Family::Quadratic], &[Regime::Generic], 4));
    let text = answers(&Evaluator::default(), &all);
    let mut csv = "# schema = beamgap-answers/1\r\n# first_index = 1\r\ncase,quantity,value\r\n".to_owned();
    for line in text.lines().skip(1) {
        let line: serde_json::Value = serde_json::from_str(line).unwrap();
        let (id, d) = (line["id"].as_str().unwrap(), &line["d"]);
        let _ = write!(csv, "{id},d,{}\r\n", d["value"]);
        // A number as Fortran prints it.
        let delta = format!("{:.16e}", line["xi"]["delta"].as_f64().unwrap()).replace('e', "D");
        let _ = write!(csv, "{id}, xi:delta, {delta}\r\n");
        for i in 0..18 {
            let _ = write!(csv, "{id},d:gradient:{},{}\r\n", i + 1, d["gradient"][i]);
            for j in 0..18 {
                let _ = write!(csv, "{id},d:hessian:{}:{},{}\r\n", i + 1, j + 1, d["hessian"][18 * i + j]);
            }
        }
    }
    let report = verified(&all, &csv, None).unwrap();
    assert!(report.agrees() && report.compared == 4 && report.parts.len() == 4, "{report:?}");
    let of_entry = csv.lines().find(|line| line.contains(",d:hessian:3:4,")).unwrap();
    let (place, _) = of_entry.rsplit_once(',').unwrap();
    let wrong = csv.replacen(of_entry, &format!("{place},1e3"), 1);
    assert_eq!(verified(&all, &wrong, None).unwrap().wrong, 1);
    let missing: String = csv
        .lines()
        .filter(|line| !line.starts_with("1,d:gradient:5,"))
        .map(|l| l.to_owned() + "\n")
        .collect();
    let told = verified(&all, &missing, None).unwrap_err();
    assert!(told.contains("case 1: d:gradient: 18 entries expected for 18 dofs, found 17"), "{told}");
}

#[test]
fn errors_say_where_and_what_was_expected() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 2));
    let head = "{\"schema\":\"beamgap-answers/1\"}\n";
    for (text, expected) in [
        (String::new(), "answers:1:1: a head {\"schema\":\"beamgap-answers/1\", ..} expected"),
        (
            "{\"schema\":\"other\"}".into(),
            "answers:1:11: schema: \"beamgap-answers/1\" expected, found \"other\"",
        ),
        (
            "{\"schema\":\"beamgap-answers/1\",\"paramter\":\"x\"}".into(),
            "answers:1:42: paramter: no such entry",
        ),
        (
            "{\"schema\":\"beamgap-answers/1\",\"parameter\":\"[0,2]\"}".into(),
            "parameter: one of [\"[-1,1]\", \"[0,1]\"] expected",
        ),
        (
            format!("{head}{{\"id\":\"0\",\"d\":{{\"value\":abc}}}}\n"),
            "answers:2:24: a number expected, found \"abc\"",
        ),
        (
            format!("{head}{{\"id\":\"0\",\"d\":{{\"gradient\":[1,2]}}}}\n"),
            "answers:2: case 0: gradient of d: 12 numbers expected, found 2",
        ),
        (format!("{head}{{\"id\":\"0\",\"e\":1}}\n"), "answers:2:15: one of x, x_bar,"),
        (
            format!("{head}{{\"id\":\"0\",\"d\":{{\"values\":1}}}}\n"),
            "one of value, gradient, hessian, delta, Delta, Delta-delta expected",
        ),
        (format!("{head}{{\"d\":1}}\n"), "answers:2:1: id expected, found none"),
        (
            format!("{head}{{\"id\":\"0\",\"d\":1"),
            "answers:2:16: a comma or a closing brace expected, found the end of the line",
        ),
        (format!("{head}{{\"id\":\"0\",\"residual\":[1]}}"), "penalty_stiffness expected in the head"),
        (
            "# schema = beamgap-answers/1\nquantity,value\n".into(),
            "answers:2:1: the titles `case,quantity,value`",
        ),
        ("# schema = beamgap-answers/1\ncase,quantity,value\n0,d,1,2\n".into(), "answers:3:1: three cells"),
        (
            "# schema = beamgap-answers/1\ncase,quantity,value\n0,d,*****\n".into(),
            "answers:3:5: a number expected, found asterisks",
        ),
        (
            "# schema = beamgap-answers/1\ncase,quantity,value\n0,d:hessian:1,1\n".into(),
            "2 indices expected, found 1",
        ),
        (
            "# schema = beamgap-answers/1\ncase,quantity,value\n0,d,1\n1,d,1\n0,d,1\n".into(),
            "answers:5:1: the rows of case \"0\" expected one after another",
        ),
        (
            "case,quantity,value\n".into(),
            "a comment `# schema = beamgap-answers/1` expected before the titles",
        ),
    ] {
        let told = verified(&all, &text, None).unwrap_err();
        assert!(told.contains(expected), "{told}\n{expected}");
    }
}

#[test]
fn numbers_that_are_none_are_wrong() {
    let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 3));
    for word in ["NaN", "null", "\"-inf\"", "Infinity"] {
        let text = format!(
            "{{\"schema\":\"beamgap-answers/1\"}}\n{{\"id\":\"0\",\"d\":{{\"gradient\":[{word},0,0,0,0,0,0,0,0,0,0,0]}}}}\n"
        );
        assert_eq!(verified(&all, &text, None).unwrap().wrong, 1, "{word}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn no_bytes_make_the_readers_panic(bytes in prop::collection::vec(any::<u8>(), 0..200), at in 0.0..1.0, is_csv in any::<bool>()) {
        let all = vectors(&drawing(&[Family::Segment], &[Regime::Generic], 1));
        let json = answers(&Evaluator::default(), &all);
        let csv = "# schema = beamgap-answers/1\ncase,quantity,value\n0,d,1\n0,d:gradient:0,1\n".to_owned();
        let mut text = if is_csv { csv } else { json }.into_bytes();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "a place in a text")]
        let start = (at * text.len() as f64) as usize;
        let end = (start + bytes.len() / 2).min(text.len());
        text.splice(start..end, bytes.iter().copied());
        if let Ok(mut reader) = AnswerReader::new(&text[..], "answers") {
            while let Ok(Some(_)) = reader.next_answers() {}
        }
        let writer = VectorWriter::default();
        let mut text = format!("{}\n{}\n", writer.head(&drawing(&[Family::Segment], &[Regime::Generic], 1)), writer.line(&all[0])).into_bytes();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "a place in a text")]
        let start = (at * text.len() as f64) as usize;
        let end = (start + bytes.len() / 2).min(text.len());
        text.splice(start..end, bytes);
        if let Ok(mut reader) = VectorReader::new(&text[..], "vectors") {
            while let Ok(Some(vector)) = reader.next_vector() {
                let _ = vector.outcome();
            }
        }
    }
}
