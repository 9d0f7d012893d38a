//! The programs that `beamgap adapter` prints are correct, and a wrong term in them is named.
//!
//! A language without a compiler is skipped. If BEAMGAP_ADAPTERS is set, a missing compiler is an error, but for Julia and
//! Octave.

mod contact;

use crate::program::{command, run, shown_in_the_guides, stdout};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A language: the name of its file, the command of its compiler, and the line with the injected fault.
struct Adapter {
    language: &'static str,
    file: &'static str,
    compiler: &'static [&'static str],
    /// The term du,xi.d of the right-hand side of (50), or a term of a contact element.
    term: [&'static str; 2],
}

const ADAPTERS: [Adapter; 5] = [
    Adapter {
        language: "fortran",
        file: "adapter.f90",
        compiler: &["gfortran", "-O2"],
        term: ["r = -Gt - A1d", "r = -Gt"],
    },
    Adapter {
        language: "c",
        file: "adapter.c",
        compiler: &["cc", "-O2"],
        term: ["r = -Gt[i] - A1d[i],", "r = -Gt[i],"],
    },
    Adapter {
        language: "cpp",
        file: "adapter.cpp",
        compiler: &["c++", "-O2", "-std=c++17"],
        term: ["r = -Gt[i] - A1d[i],", "r = -Gt[i],"],
    },
    Adapter {
        language: "python",
        file: "adapter.py",
        compiler: &["python3"],
        term: ["for x, y in zip(along(shapes, t), A1d)]", "for x, y in zip(along(shapes, t), 12 * [0.0])]"],
    },
    Adapter {
        language: "julia",
        file: "adapter.jl",
        compiler: &["julia"],
        term: ["r, r_bar = -Gt - A1d,", "r, r_bar = -Gt,"],
    },
];

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("adapter-{name}"));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Writes and compiles a program. Returns the command that runs it, or nothing if there is no compiler.
fn made(adapter: &Adapter, folder: &Path, text: &str) -> Option<String> {
    let source = folder.join(adapter.file);
    std::fs::write(&source, text).unwrap();
    let is_there = Command::new(adapter.compiler[0]).arg("--version").output().is_ok();
    let is_required = std::env::var_os("BEAMGAP_ADAPTERS").is_some() && adapter.language != "julia";
    assert!(is_there || !is_required, "{} is missing", adapter.compiler[0]);
    if !is_there {
        return None;
    }
    if let "python" | "julia" = adapter.language {
        return Some(format!("{} '{}'", adapter.compiler[0], source.display()));
    }
    let program = folder.join(adapter.language);
    let output = Command::new(adapter.compiler[0])
        .args(&adapter.compiler[1..])
        // Fortran writes its module there.
        .current_dir(folder)
        .arg(&source)
        .arg("-o")
        .arg(&program)
        .arg("-lm")
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(format!("'{}'", program.display()))
}

fn verified(adapter: &Adapter) {
    let folder = folder(adapter.language);
    let vectors = folder.join("vectors.jsonl");
    let vectors = vectors.to_str().unwrap();
    let families = ["--family", "segment", "--cases", "6", "--expected", "none", "-o", vectors];
    assert!(run(&[&["export"][..], &families].concat()).status.success());
    let text = stdout(&run(&["adapter", adapter.language]));
    let Some(program) = made(adapter, &folder, &text) else { return };
    let told = stdout(&run(&["verify", vectors, "--run", &program]));
    assert!(told.contains("\nAGREE: at "), "{told}");
    other_family(&folder, &program, adapter.file);
    let [right, wrong] = adapter.term;
    assert_eq!(text.matches(right).count(), 1, "{right}");
    let program = made(adapter, &folder, &text.replace(right, wrong)).unwrap();
    let output = run(&["verify", vectors, "--run", &program]);
    let told = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(told.lines().all(|line| line.contains(&*program) || line.chars().count() <= 80), "{told}");
    assert!(told.contains("\nCause: in dp, eq. (50), the term d.du,xi is missing.\n"), "{told}");
    assert!(!told.contains("Fewer numbers are wrong"), "the conventions are right: {told}");
    if adapter.language == "cpp" {
        named_in_every_format(vectors, &program, &folder);
    }
}

/// A program that is given another family says which one it is for.
fn other_family(folder: &Path, program: &str, file: &str) {
    let vectors = folder.join("hermite.jsonl");
    let vectors = vectors.to_str().unwrap();
    assert!(run(&["export", "--family", "hermite", "--cases", "1", "-o", vectors]).status.success());
    let output = run(&["verify", vectors, "--run", program]);
    // What the program itself writes is shown as it is.
    let told = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(3), "{told}");
    assert!(told.contains(&format!("{file} is for the family segment; a case ")), "{told}");
}

/// The wrong term stands in what a CI job shows.
fn named_in_every_format(vectors: &str, program: &str, folder: &Path) {
    let files = ["junit", "sarif", "markdown"].map(|format| (format, folder.join(format)));
    let outputs = files
        .iter()
        .flat_map(|(format, path)| ["--output".to_owned(), format!("{format}={}", path.display())]);
    let options: Vec<String> =
        ["verify", vectors, "--run", program, "--format", "github"].map(str::to_owned).into();
    let arguments: Vec<String> = options.into_iter().chain(outputs).collect();
    let output = run(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let texts = files.iter().map(|(_, path)| std::fs::read_to_string(path).unwrap());
    for text in texts.chain([String::from_utf8(output.stdout).unwrap()]) {
        assert!(text.contains("Cause: in dp, eq. (50), the term d.du,xi is missing."), "{text}");
    }
}

#[test]
fn the_fortran_program_agrees_until_a_term_is_wrong() {
    verified(&ADAPTERS[0]);
}

#[test]
fn the_c_program_agrees_until_a_term_is_wrong() {
    verified(&ADAPTERS[1]);
}

#[test]
fn the_cpp_program_agrees_until_a_term_is_wrong() {
    verified(&ADAPTERS[2]);
}

/// A guide shows what comes of its commands.
#[test]
fn the_cpp_program_is_verified_as_a_guide_shows() {
    let folder = folder("guide");
    let vectors = folder.join("vectors.jsonl");
    let vectors = vectors.to_str().unwrap();
    assert!(run(&["export", "--family", "segment", "-o", vectors]).status.success());
    let Some(program) = made(&ADAPTERS[2], &folder, &stdout(&run(&["adapter", "cpp"]))) else { return };
    shown_in_the_guides(
        &stdout(&run(&["verify", vectors, "--run", &program])),
        "$ beamgap verify vectors.jsonl --run ./adapter",
    );
}

#[test]
fn a_wrong_term_of_the_cpp_program_is_named_as_the_readme_shows() {
    let (adapter, folder) = (&ADAPTERS[2], folder("readme"));
    let vectors = folder.join("vectors.jsonl");
    assert!(run(&["export", "--family", "segment", "-o", vectors.to_str().unwrap()]).status.success());
    let [right, wrong] = adapter.term;
    let text = stdout(&run(&["adapter", "cpp"])).replace(right, wrong);
    if made(adapter, &folder, &text).is_none() {
        return;
    }
    std::fs::copy(folder.join(adapter.language), folder.join("my_element")).unwrap();
    let mut verify = command(&["verify", "vectors.jsonl", "--run", "./my_element"]);
    let output = verify.current_dir(&folder).output().unwrap();
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let told = String::from_utf8(output.stdout).unwrap();
    shown_in_the_guides(&told, "$ beamgap verify vectors.jsonl --run ./my_element");
}

#[test]
fn the_python_program_agrees_until_a_term_is_wrong() {
    verified(&ADAPTERS[3]);
}

/// Octave runs the program for MATLAB. Octave is large, so its installation is not required.
#[test]
fn the_matlab_program_agrees_until_a_term_is_wrong() {
    let text = stdout(&run(&["adapter", "matlab"]));
    assert!(text.starts_with("function adapter(vectors, answers)"));
    if Command::new("octave-cli").arg("--version").output().is_err() {
        return;
    }
    let folder = folder("matlab");
    let [vectors, answers] =
        ["vectors.jsonl", "answers.jsonl"].map(|name| folder.join(name).display().to_string());
    let families = ["--family", "segment", "--cases", "6", "--expected", "none", "-o", &vectors];
    assert!(run(&[&["export"][..], &families].concat()).status.success());
    let program = format!("octave-cli --path '{}' --eval adapter", folder.display());
    let told = |text: &str| {
        std::fs::write(folder.join("adapter.m"), text).unwrap();
        let call = format!("adapter('{vectors}', '{answers}')");
        let output =
            Command::new("octave-cli").args(["--eval", &call]).current_dir(&folder).output().unwrap();
        assert!(output.status.success(), "{output:?}");
        let output = run(&["verify", &vectors, &answers]);
        (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let (code, right) = told(&text);
    assert!(code == Some(0) && right.contains("AGREE: at "), "{right}");
    let output = run(&["verify", &vectors, "--run", &program]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    other_family(&folder, &program, "adapter.m");
    assert_eq!(text.matches("r = -Gt - A1d;").count(), 1);
    let (code, wrong) = told(&text.replace("r = -Gt - A1d;", "r = -Gt;"));
    assert!(code == Some(1) && wrong.contains("In the catalogue: `R: du,xi.d = dropped`\n"), "{wrong}");
}

/// Julia is not a package of every system, so its installation is not required.
#[test]
fn the_julia_program_agrees_until_a_term_is_wrong() {
    assert!(stdout(&run(&["adapter", "julia"])).starts_with("# Answers"));
    verified(&ADAPTERS[4]);
}
