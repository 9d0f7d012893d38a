//! The contact elements with friction of `beamgap adapter --contact` are correct, and wrong terms in them are named.

use super::{ADAPTERS, Adapter, folder, other_family};
use crate::program::{run, shown_in_the_guides, stdout};
use std::path::Path;
use std::process::Command;

/// What is named if grad gamma is left out of grad rho, and if the slip vector has a plus sign.
const CAUSES: [&str; 2] =
    ["in drho the term rho dgamma/gamma is missing", "in s the term e_bar tau_bar has the wrong sign"];

/// Verifies a program, and then with the wrong line in the place of each right one. `made` writes and compiles a program; it
/// returns the command that runs it, or nothing if there is no compiler.
fn verified(language: &str, file: &str, terms: [[&str; 2]; 2], made: impl Fn(&Path, &str) -> Option<String>) {
    let folder = folder(&format!("contact-{language}"));
    let [vectors, without] = ["vectors.jsonl", "without.jsonl"].map(|name| folder.join(name));
    let [vectors, without] = [&vectors, &without].map(|path| path.to_str().unwrap());
    let segments = ["--family", "segment", "--expected", "none", "--cases"];
    assert!(run(&[&["export", "--element", "-o", vectors], &segments[..], &["6"]].concat()).status.success());
    assert!(run(&[&["export", "-o", without], &segments[..], &["1"]].concat()).status.success());
    let text = stdout(&run(&["adapter", language, "--contact"]));
    let Some(program) = made(&folder, &text) else { return };
    let told = stdout(&run(&["verify", vectors, "--run", &program]));
    assert!(told.contains("\nAGREE: at ") && told.contains("for residual, tangent, state,"), "{told}");
    other_family(&folder, &program, file);
    let output = run(&["verify", without, "--run", &program]);
    let told = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(3), "{told}");
    let words = format!("{file}: a case has no element. Write the cases with `beamgap export --element`.");
    assert!(told.contains(&words), "{told}");
    for ([right, wrong], cause) in terms.into_iter().zip(CAUSES) {
        assert_eq!(text.matches(right).count(), 1, "{right}");
        let program = made(&folder, &text.replace(right, wrong)).unwrap();
        let output = run(&["verify", vectors, "--run", &program]);
        let told = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(1), "{told}");
        let words: Vec<&str> = told.split_whitespace().collect();
        assert!(words.join(" ").contains(cause), "{told}");
    }
}

/// A program in the language of another one.
fn of_language(adapter: &Adapter, file: &'static str, terms: [[&'static str; 2]; 2]) {
    let adapter = Adapter { file, term: terms[0], ..*adapter };
    verified(adapter.language, file, terms, |folder, text| super::made(&adapter, folder, text));
}

#[test]
fn the_fortran_contact_element_agrees_until_a_term_is_wrong() {
    let terms = [
        ["*grad_gap - rho/gamma*grad_gamma", "*grad_gap"],
        ["s = e*tau - e_bar*tau_bar", "s = e*tau + e_bar*tau_bar"],
    ];
    of_language(&ADAPTERS[0], "contact.f90", terms);
}

#[test]
fn the_c_contact_element_agrees_until_a_term_is_wrong() {
    let terms = [
        ["* grad_F_N - rho / gamma * grad_gamma;", "* grad_F_N;"],
        ["s[m] = e * tau[m] - e_bar * tau_bar[m];", "s[m] = e * tau[m] + e_bar * tau_bar[m];"],
    ];
    of_language(&ADAPTERS[1], "contact.c", terms);
}

#[test]
fn the_cpp_contact_element_agrees_until_a_term_is_wrong() {
    let terms = [
        ["grad_gap, -rho / gamma, grad_gamma)", "grad_gap, 0, grad_gamma)"],
        ["s = sum(e, tau, -e_bar, tau_bar)", "s = sum(e, tau, e_bar, tau_bar)"],
    ];
    of_language(&ADAPTERS[2], "contact.cpp", terms);
}

/// A guide shows what comes of its commands.
#[test]
fn the_cpp_contact_element_is_verified_as_a_guide_shows() {
    let folder = folder("contact-guide");
    let vectors = folder.join("vectors.jsonl");
    let vectors = vectors.to_str().unwrap();
    let exported = run(&["export", "--element", "--family", "segment", "-o", vectors]);
    assert!(exported.status.success(), "{exported:?}");
    let adapter = Adapter { file: "contact.cpp", ..ADAPTERS[2] };
    let text = stdout(&run(&["adapter", "cpp", "--contact"]));
    let Some(program) = super::made(&adapter, &folder, &text) else { return };
    shown_in_the_guides(
        &stdout(&run(&["verify", vectors, "--run", &program])),
        "$ beamgap verify vectors.jsonl --run ./contact",
    );
}

#[test]
fn the_python_contact_element_agrees_until_a_term_is_wrong() {
    let terms = [
        [" - rho / gamma * grad_gamma[i]", ""],
        ["s = [e * v - e_bar * w for", "s = [e * v + e_bar * w for"],
    ];
    of_language(&ADAPTERS[3], "contact.py", terms);
}

/// Julia is not a package of every system, so its installation is not required.
#[test]
fn the_julia_contact_element_agrees_until_a_term_is_wrong() {
    assert!(stdout(&run(&["adapter", "julia", "--contact"])).starts_with("# Answers"));
    let terms = [
        ["* grad_F_N - rho / gamma * grad_gamma", "* grad_F_N"],
        ["s = e * tau - e_bar * tau_bar", "s = e * tau + e_bar * tau_bar"],
    ];
    of_language(&ADAPTERS[4], "contact.jl", terms);
}

/// Octave runs the program for MATLAB. Octave is large, so its installation is not required.
#[test]
fn the_matlab_contact_element_agrees_until_a_term_is_wrong() {
    let text = stdout(&run(&["adapter", "matlab", "--contact"]));
    assert!(text.starts_with("function contact(vectors, answers)"));
    let terms = [
        ["* grad_F_N - rho / gamma * grad_gamma;", "* grad_F_N;"],
        ["s = e * tau - e_bar * tau_bar;", "s = e * tau + e_bar * tau_bar;"],
    ];
    let is_there = Command::new("octave-cli").arg("--version").output().is_ok();
    verified("matlab", "contact.m", terms, |folder, text| {
        std::fs::write(folder.join("contact.m"), text).unwrap();
        is_there.then(|| format!("octave-cli --path '{}' --eval contact", folder.display()))
    });
}
