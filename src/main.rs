//! The command line.
use beamgap::check::*;
use beamgap::report;
fn main() {
    // beamgap report [CASES]
    if std::env::args().nth(1).is_some_and(|first| first == "report") {
        let cases = std::env::args().nth(2).and_then(|cases| cases.parse().ok()).unwrap_or(report::CASES);
        let (to, command) = (std::path::Path::new("reports"), "beamgap report");
        let crosscheck = report::crosscheck(to, report::SEED, cases, command, || ());
        let benchmark = report::benchmark(to, &report::criterion_directory());
        let errors: Vec<_> = [crosscheck.err(), benchmark.err()].into_iter().flatten().collect();
        for error in &errors {
            eprintln!("error: {error}");
        }
        std::process::exit(i32::from(!errors.is_empty()));
    }
    let cases = std::env::args().nth(1).and_then(|s| s.parse().ok()).unwrap_or(500);
    let s = run(1, &Selection { regimes: Regime::ALL.to_vec(), family: None, cases }, || ());
    for (r, t) in &s.regimes {
        println!(
            "{:16} {} int {} end {} mism {} worst {:.1e} (case {}) over {:.2} {:?}",
            r.name(),
            t.cases,
            t.interior,
            t.at_end,
            t.mismatches,
            t.worst.scaled_error,
            t.worst.case,
            t.worst.over_tolerance,
            t.inconclusive
        );
    }
    for ((q, o), c) in &s.cells {
        println!("{:12} {:9} {:.1e} {:.3} {}", q.name(), o.name(), c.scaled_error, c.over_tolerance, c.case);
    }
    if let Some(n) = std::env::args().nth(2).and_then(|s| s.parse().ok()) {
        let c = Case::draw(1, n);
        println!("{:?} {:?}", c.regime, c.families);
        for (p, v) in compare(&c) {
            println!(
                "{p:?} {:?}",
                match v {
                    Verdict::Inconclusive(r) => Some(r),
                    _ => None,
                }
            );
        }
    }
    for (n, m) in s.mismatches.iter().take(10) {
        println!("{n} {m:?}");
    }
}
