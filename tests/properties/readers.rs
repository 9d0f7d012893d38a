//! The fuzz targets run on a fixed corpus: no text makes a reader panic, and a valid text is written to the last bit.

#[path = "../fuzz/case.rs"]
mod case;
#[path = "../../src/cli/case_file.rs"]
#[expect(dead_code, reason = "the command line uses the rest")]
mod case_file;
#[path = "../fuzz/readers.rs"]
mod fuzz;

/// The items of the command line that the module uses.
mod arguments {
    pub(crate) fn program() -> &'static str {
        "beamgap"
    }
}

/// The texts of a target, and parts of them: truncated at any place, and with a byte changed.
fn corpus(target: &str) -> Vec<Vec<u8>> {
    let folder = format!("{}/tests/fuzz/seeds/{target}", env!("CARGO_MANIFEST_DIR"));
    let mut files: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|file| file.unwrap().path()).collect();
    files.sort();
    assert!(!files.is_empty(), "{folder} is empty");
    let mut texts = Vec::new();
    for text in files.iter().map(|file| std::fs::read(file).unwrap()) {
        for k in 1..24 {
            let at = text.len() * k / 24;
            texts.push(text[..at].to_vec());
            let mut changed = text.clone();
            if let Some(byte) = changed.get_mut(at) {
                *byte ^= 1 << (k % 8);
            }
            texts.push(changed);
        }
        texts.push(text);
    }
    texts
}

fn texts(target: &str) -> Vec<String> {
    corpus(target).into_iter().filter_map(|text| String::from_utf8(text).ok()).collect()
}

#[test]
fn answers_of_the_corpus_are_read_or_rejected() {
    corpus("answers_jsonl").iter().chain(&corpus("answers_csv")).for_each(|text| fuzz::answers(text));
}

#[test]
fn cases_of_the_corpus_are_read_and_written_to_the_last_bit() {
    for text in &corpus("vectors_jsonl") {
        fuzz::vectors(text);
    }
}

#[test]
fn numbers_of_the_corpus_are_read_and_written_to_the_last_bit() {
    for text in &texts("numbers") {
        fuzz::number(text);
    }
}

#[test]
fn case_files_of_the_corpus_are_read_and_written_to_the_last_bit() {
    for text in &texts("case_file") {
        case::case(text);
    }
}
