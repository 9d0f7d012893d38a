//! `beamgap equations`: every equation of the paper, as printed and as corrected, evaluated.

use super::arguments::seed;
use super::count::count;
use super::exit::Exit;
use super::formula;
use super::outcome::{Entry, Outcome, Source, State, Verdict as Amounts};
use super::output::OutputOptions;
use super::progress::Progress;
use super::terminal::folded;
use beamgap::equations::{
    self as record, CASES, Counts, DRAWS, EquationRow, Order, Place, Run, Score, Verdict,
};
use beamgap::report::{self, Environment, Equations, Record, Table};
use clap::{Args, value_parser};
use std::fmt::Write;
use std::path::PathBuf;

/// The first lines of the table.
const HEAD: &str = "Every equation of the paper, as printed and as corrected, against hyper-dual\n\
                    numbers: over the field of 2^61 - 1 elements, and in f64\n";

/// The first lines for one equation.
fn of_one(number: u8) -> String {
    format!("Equation ({number}) of the paper, as printed and as corrected, evaluated\n\n")
}

/// The command that writes the record and the page.
const EQUATIONS: &str = "cargo run --release -- equations --to reports";

/// The arguments.
#[derive(Args)]
#[command(after_help = Exit::help())]
pub(crate) struct ListEquations {
    /// Seed of the random residues and cases, decimal or 0x-hexadecimal
    #[arg(long, default_value = "0x5eed", value_parser = seed)]
    seed: u64,
    /// How many draws for each ordered pair of families
    #[arg(long, value_name = "N", default_value_t = DRAWS)]
    #[arg(value_parser = value_parser!(u64).range(1..=100_000))]
    draws: u64,
    /// Only this equation, and everything about it
    #[arg(long, value_name = "N")]
    #[arg(value_parser = value_parser!(u8).range(1..=59))]
    equation: Option<u8>,
    /// With --equation: print LaTeX instead of UTF-8
    #[arg(long, requires = "equation")]
    latex: bool,
    /// Also write equations.json, equations.md, derivation.json and derivation.html
    /// into this directory
    #[arg(long, value_name = "DIR", conflicts_with = "equation")]
    to: Option<PathBuf>,
    /// Write the report although the source has changes that are not committed
    #[arg(long, requires = "to")]
    allow_dirty: bool,
    #[command(flatten)]
    output: OutputOptions,
}

impl ListEquations {
    /// Evaluates the equations and writes the results.
    pub(super) fn run(self) -> anyhow::Result<Exit> {
        let mut outputs = self.output.open()?;
        if self.to.is_some() {
            Environment::is_clean(self.allow_dirty)?;
        }
        let head = self.equation.map_or_else(|| HEAD.to_owned(), of_one);
        outputs.begin(&head)?;
        let progress = Progress::of("evaluating equations");
        let found = record::equation_table(self.seed, self.draws, CASES);
        progress.end();
        let mut record = Equations::new(found, Environment::here(&self.command()));
        if let Some(directory) = &self.to {
            report::equations(directory, &record)?;
            report::derivation(directory, &record)?;
        }
        let paper = &mut record.table;
        let (mut holds, mut verdict) = (paper.holds(), words(paper));
        if let Some(number) = self.equation {
            paper.equations.retain(|entry| entry.number == number);
            paper.claims.clear();
            holds = paper.equations.iter().all(|entry| entry.verdict != Verdict::Refuted);
            verdict = paper.equations.iter().map(|entry| told(entry.number, entry.verdict)).collect();
        }
        let (exit, name) = if holds { (Exit::Agree, "holds") } else { (Exit::Disagree, "does-not-hold") };
        let entries = record.table.equations.iter().map(entry).collect();
        let mut verdict = Amounts::new(exit, name, verdict);
        // One equation that is printed wrong is to look at.
        verdict.is_warning = matches!(&*record.table.equations, [one] if one.verdict == Verdict::Misprint);
        let outcome = Outcome { command: "equations", verdict, entries };
        let human = || {
            let text = match record.table.equations.as_slice() {
                [entry] => head.clone() + &whole(entry, self.latex),
                _ => table(&record.table),
            };
            format!("{text}\n{}\n", outcome.verdict.words)
        };
        outputs.write(&outcome, human, || Ok(record.to_json()?))?;
        Ok(exit)
    }

    /// The command that repeats the record.
    fn command(&self) -> String {
        let mut command = String::from(EQUATIONS);
        if self.seed != report::SEED {
            let _ = write!(command, " --seed {:#x}", self.seed);
        }
        if self.draws != DRAWS {
            let _ = write!(command, " --draws {}", self.draws);
        }
        command
    }
}

/// The result for an equation.
fn entry(row: &EquationRow) -> Entry {
    Entry {
        group: "equation".to_owned(),
        name: format!("({})", row.number),
        state: State::of(1, u64::from(row.verdict == Verdict::Refuted)),
        message: format!("{}: {}", row.says, row.verdict.words()),
        source: Source::of_equation(Some(row.number)),
    }
}

fn words(paper: &record::EquationTable) -> String {
    let of = |verdict| paper.equations.iter().filter(|entry| entry.verdict == verdict).count();
    let (all, misprints) = (paper.equations.len(), of(Verdict::Misprint));
    if paper.holds() {
        format!(
            "HOLDS: no equation is refuted as corrected; {misprints} of {all} are misprinted in the scan."
        )
    } else if of(Verdict::Refuted) == 0 {
        format!("DOES NOT HOLD: the equations, {all} in number, are not those from 1 to 59.")
    } else {
        format!("DOES NOT HOLD: of {} {} refuted as corrected.", count(all, "equation"), of(Verdict::Refuted))
    }
}

fn told(number: u8, verdict: Verdict) -> String {
    format!("Eq. ({number}): {}.", verdict.words())
}

/// One row for each equation.
fn table(paper: &record::EquationTable) -> String {
    let [linear, nonlinear] = paper.pairs.map(|pairs| pairs * paper.draws);
    let mut text = format!(
        "{HEAD}seed {:#x}, {} for each ordered pair of families\n\n\
         Refuted draws as printed: of {linear} with curves linear in their dofs (lin), and\n\
         of {nonlinear} with one that is not (non); as corrected (lin*, non*). Error: of the\n\
         print in f64, relative to its terms, the largest at {}; of\n\
         (14), relative to (12).\n\n",
        paper.seed,
        count(paper.draws, "draw"),
        count(paper.points.iter().sum::<u64>(), "closest point"),
    );
    let titles = ["eq", "verdict", "lin", "non", "lin*", "non*", "error", "where"];
    let mut table = Table::new(&titles).left(&[1, 7]);
    for entry in &paper.equations {
        let place = entry.places.first();
        let file = |file: &str| file.rsplit('/').next().unwrap_or_default().to_owned();
        let [printed, corrected] = [&entry.as_printed, &entry.as_corrected].map(refuted);
        let run = !entry.parts.is_empty() && !entry.printed.is_empty();
        table.row(vec![
            format!("{:>2}", entry.number),
            entry.verdict.words().into(),
            printed[0].clone(),
            printed[1].clone(),
            corrected[0].clone(),
            corrected[1].clone(),
            entry.error().filter(|_| run).map_or_else(|| "-".into(), |error| format!("{error:.1e}")),
            place.map_or_else(|| "-".into(), |place| format!("{}:{}", file(&place.file), place.line)),
        ]);
    }
    let _ = write!(text, "{table}");
    text.push_str("\nSymmetry when delta and Delta are exchanged, of formulas of second order: by\n");
    text.push_str("form, by relations between the operands (rel), not at all\n\n");
    let mut table = Table::new(&["claim", "made in", "form", "rel", "not"]).left(&[1]);
    for claim in &paper.claims {
        let [form, relations, not] = claim.found.map(|n| n.to_string());
        table.row(vec![claim.says.clone(), claim.made.clone(), form, relations, not]);
    }
    let _ = write!(text, "{table}");
    text
}

/// Refuted draws, of both kinds of pairs.
fn refuted(score: &Score) -> [String; 2] {
    [score.linear, score.nonlinear]
        .map(|counts: Counts| if counts.total() == 0 { "-".to_owned() } else { counts.refuted.to_string() })
}

/// One equation with all its variants.
fn whole(entry: &EquationRow, latex: bool) -> String {
    let mut text = format!("({}) {}: {}\n", entry.number, entry.says, entry.verdict.words());
    let mut section = |title: &str, body: String| {
        if !body.is_empty() {
            let _ = write!(text, "\n{title}\n{body}");
        }
    };
    let formula = |source: &str| if latex { wrapped(source) } else { readable(source) };
    section("As printed", formula(&entry.printed));
    section(entry.correction(), formula(entry.corrected.as_deref().unwrap_or_default()));
    section("Remark", wrapped(&entry.remark));
    section("Left out", formula(&entry.omitted.join(", ")));
    for part in &entry.parts {
        let order = match part.order {
            Order::Value => "value",
            Order::First => "first order",
            Order::Second => "second order",
            Order::Finite => "finite increments",
        };
        let _ = writeln!(
            text,
            "\nRun{} ({order}, {})",
            if part.name.is_empty() { String::new() } else { format!(": {}", part.name) },
            part.verdict().words()
        );
        for run in &part.runs {
            let _ = write!(text, "{}", shown(run));
        }
    }
    if !entry.arcs.is_empty() {
        let _ = writeln!(text, "\nAgainst the arc length (12)");
    }
    for arc in &entry.arcs {
        let ratio = arc
            .ratio
            .map_or_else(|| "rounding".to_owned(), |r| format!("{r:.1} times less for half the slip"));
        let _ = writeln!(text, "  {:<14}  slip {}: {:.1e}, {ratio}", arc.family, arc.slip, arc.error);
    }
    text.push_str("\nWhere\n");
    let definition = record::definition(entry.number);
    if let Some(record::Definition { file, item, from, to, .. }) = definition {
        let _ = writeln!(text, "  src/{file}:{from}-{to}  {item}");
    }
    // The definition includes its attributes.
    let is_attribute = |place: &&Place| {
        definition.is_some_and(|of| place.file == of.file && (of.from..of.line).contains(&place.line))
    };
    for place in entry.places.iter().filter(|place| !is_attribute(place)) {
        let _ = writeln!(text, "  src/{}:{}  {}", place.file, place.line, place.item);
    }
    text
}

fn shown(run: &Run) -> String {
    let mut text = format!("  {}\n", run.name());
    let kinds = [("dofs linear", run.score.linear), ("nonlinear", run.score.nonlinear)];
    for ((kind, counts), error) in kinds.into_iter().zip(run.score.errors) {
        let error = error.map_or_else(|| "not finite".to_owned(), |error| format!("{error:.1e}"));
        let _ = writeln!(
            text,
            "    {kind:<11}  {:>6} equal, {:>6} refuted; error in f64 {error}",
            counts.equal, counts.refuted
        );
    }
    if let Some(symmetry) = run.symmetry() {
        let _ = writeln!(text, "    symmetric    {}", symmetry.words());
    }
    text
}

/// A formula as text, or its LaTeX if a part of it has no text form.
fn readable(latex: &str) -> String {
    let Ok(lines) = formula::lines(latex) else { return wrapped(latex) };
    lines.iter().fold(String::new(), |text, line| text + "  " + line + "\n")
}

/// The words in indented lines; nothing for none.
fn wrapped(text: &str) -> String {
    if text.is_empty() { String::new() } else { folded(text, "  ", "  ") + "\n" }
}
