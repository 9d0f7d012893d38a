//! The benchmarks as Markdown, from the record alone.

use super::benchmark::{Benchmark, DENOMINATOR, Measured, Ratio};
use super::number::{count, error, plain, time};
use std::fmt::Write;

impl Benchmark {
    /// The page; the same record always makes the same page.
    pub fn to_markdown(&self) -> String {
        let mut page = String::from(
            "# Benchmark\n\n\
             How long does it take to linearize the contact geometry of one pair of beams, in closed form and by automatic \
             differentiation, as far as this crate does both?\n\n\
             ![Ratios to the closed form](benchmark.svg)\n",
        );
        for task in self.tasks() {
            let _ = write!(page, "\n## {}\n\n{}\n\n", task[0].task, question(&task[0].task));
            page.push_str(&table(task));
        }
        let samples = self.scenarios.iter().map(|measured| measured.samples.len()).min().unwrap_or(0);
        let _ = write!(
            page,
            "\n## How it was measured\n\n{}\n\
             - Each scenario takes one thread and one pair, the same each time; the closest point is given, unless it is what \
             is timed. Dofs in, all results out, in memory that is not reused by the caller.\n\
             - A time is the median of at least {} samples, none left out. Its 95 % interval lies between two of the samples \
             (order statistics) and assumes no distribution.\n\
             - A ratio is the time of the way over the time of the **{DENOMINATOR}** of the same task and size. Its interval \
             comes from the 97.5 % intervals of both medians. Where it holds 1 the table says *no difference*.\n\
             - The error is the largest difference from another way's result ({DENOMINATOR} against hyper-dual numbers, all \
             others against the {DENOMINATOR}), relative to the largest entry of that value, gradient or Hessian. It is \
             computed by the program that is then timed, and that program does not time what is wrong.\n\
             - The chord routes take one step for d alone, which is enough there, and two for all quantities.\n\
             - All samples are in `benchmark.json`, from which alone this page and the picture are made.\n",
            self.environment.rows(),
            count(samples as u64),
        );
        page.push_str(SILENCE);
        page
    }
}

const SILENCE: &str = "
## What these numbers do not say

- Nothing about other processors, compilers or flags.
- Nothing about other programs: a speed-up over the automatic differentiation *of this crate* is none over another's.
  How far apart honest ways of automatic differentiation are among themselves, the tables above show.
- The ways are not equally tuned. The sweeps evaluate one pair of dofs at a time, and a Hessian of n dofs takes
  n (n + 1) / 2 of them, each of all quantities; a tape, or a reverse sweep, would share work that these do not.
- The samples of one scenario follow each other, so whatever else the machine did meanwhile is in some rows and not in
  others. The intervals say how much the samples scatter, not how far a busy machine shifts them all.
- One pair of each size stands for all; its numbers are in the cache. An assembly that writes every Hessian to memory
  waits for memory.
- The errors are those of one well-conditioned pair. How errors grow is the business of the crosscheck.
";

fn question(task: &str) -> &'static str {
    match task {
        "d only" => "The distance d with gradient and Hessian: what normal contact without friction needs.",
        "all quantities" => {
            "d, t, t_bar, xi, xi_bar, g_T and g_T_bar, each with gradient and Hessian in all dofs of both beams."
        }
        "two directions" => {
            "All quantities, points and vectors included, with delta, Delta and Delta-delta along two given directions."
        }
        "closest point" => {
            "What all the rest takes as given: the search for all closest points, and Newton's method from nearby."
        }
        _ => "",
    }
}

fn table(task: &[Measured]) -> String {
    let ratios = task.iter().any(|measured| measured.ratio_to_closed_form.is_some());
    let mut rows = String::from("| size | way | median | 95 % interval |");
    rows.push_str(if ratios { " times the closed form | largest error |\n" } else { " largest error |\n" });
    rows.push_str(if ratios { "|---|---|---:|---:|---:|---:|\n" } else { "|---|---|---:|---:|---:|\n" });
    for measured in task {
        let [low, high] = measured.interval;
        let Measured { dofs, way, .. } = measured;
        let _ =
            write!(rows, "| {dofs} | {way} | {} | {} to {} |", time(measured.median), time(low), time(high));
        if ratios {
            let ratio = measured.ratio_to_closed_form.as_ref();
            let text =
                if way == DENOMINATOR { "1".to_owned() } else { ratio.map_or_else(String::new, in_words) };
            let _ = write!(rows, " {text} |");
        }
        let _ = writeln!(rows, " {} |", error(Some(measured.error)));
    }
    rows
}

/// The ratio with its interval.
fn in_words(ratio: &Ratio) -> String {
    let [low, high] = ratio.interval.map(plain);
    if ratio.is_different() {
        format!("**{}** ({low} to {high})", plain(ratio.value))
    } else {
        format!("no difference ({low} to {high})")
    }
}
