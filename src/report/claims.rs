//! What the front page claims of the benchmarks, in words made of the record alone.

use super::benchmark::{Benchmark, CLOSED_FORM, Measured, Ratio};
use super::number::{count, error, number, plain, time};
use super::{Peers, Task};

impl Benchmark {
    /// The sentences of the front page, none of them of numbers that are not in the record.
    pub fn claims(&self) -> Vec<String> {
        let mut claims = vec![self.closed_form(), self.automatic(), self.differences()];
        claims.extend([self.threads(), self.closest_point(), self.growth()]);
        claims.extend(self.peers.as_ref().map(peers));
        claims
    }

    /// The methods of a task with the standard pair.
    fn of_hermites(&self, task: Task) -> impl Iterator<Item = &Measured> {
        self.of(task).filter(|of| of.family == "hermite")
    }

    fn closed_form(&self) -> String {
        let [d, all] = [Task::Distance, Task::All].map(|task| {
            let closed =
                self.below_the_roof().find(|of| of.task == task && of.measured.method == CLOSED_FORM);
            closed.map_or_else(String::new, |of| {
                format!("{}, {} times", time(of.measured.median), plain(of.times))
            })
        });
        format!(
            "Two Hermite beams, 24 dofs, on one core, in closed form: d with gradient and Hessian in {d} what its \
             arithmetic and stores would take if this machine did nothing else; all quantities but the slips in {all}."
        )
    }

    fn threads(&self) -> String {
        let tasks = [Task::DistanceOfMany, Task::AllOfMany];
        let methods = || tasks.into_iter().flat_map(|task| self.of(task));
        let to_memory = |of: &&Measured| of.method.contains("to memory");
        let in_words = |ratios: &mut dyn Iterator<Item = Ratio>| {
            let (least, most) = range(ratios.map(|ratio| ratio.value));
            format!("{} to {}", plain(least), plain(most))
        };
        format!(
            "Two threads do {} times as many pairs as one, or {} times if each result goes to memory of its own; where \
             they only multiply and add in registers, {} times as much.",
            in_words(&mut methods().filter(|of| !to_memory(of)).filter_map(Measured::speed_up)),
            in_words(&mut methods().filter(to_memory).filter_map(Measured::speed_up)),
            in_words(&mut methods().filter_map(Measured::speed_up_of_arithmetic))
        )
    }

    fn automatic(&self) -> String {
        let [d, all] = [Task::Distance, Task::All]
            .map(|task| ratios(self.of_hermites(task).filter(|of| of.method.contains("dual"))));
        format!(
            "Automatic differentiation takes {d} times as long for d and {all} times for all, depending on what it \
             shares and how the closest point is lifted."
        )
    }

    fn differences(&self) -> String {
        let rows = || self.of_hermites(Task::All).filter(|of| of.method.contains("differences"));
        let (least, most) = range(rows().map(|of| of.error));
        let (least, most) = (error(Some(least)), error(Some(most)));
        format!(
            "Central differences take {} times as long for all, with errors of {least} to {most}.",
            ratios(rows())
        )
    }

    fn closest_point(&self) -> String {
        let times = |method: &str| {
            range(self.of(Task::ClosestPoint).filter(|of| of.method.starts_with(method)).map(|of| of.median))
        };
        let ((least, most), (first, last)) = (times("Newton"), times("search"));
        format!(
            "The closest point takes {} to {} by Newton's method from nearby, {} to {} by the search for all, \
             depending on the family.",
            time(least),
            time(most),
            time(first),
            time(last)
        )
    }

    /// From the second smallest to the largest Lagrange pair: the smallest has hardly a result to spread its cost over.
    fn growth(&self) -> String {
        let rows: Vec<_> = self.of(Task::AllBySize).filter(|of| of.family == "lagrange").collect();
        let [_, first, .., last] = &rows[..] else { return String::new() };
        format!(
            "From {} to {} dofs all quantities take {} times as long, for a result {} times as large.",
            count(first.dofs as u64),
            count(last.dofs as u64),
            plain(last.median / first.median),
            plain(number(last.stored()) / number(first.stored()))
        )
    }
}

/// What other programs take.
fn peers(of: &Peers) -> String {
    let times = |program: &&str| {
        let [d, all] = ["A", "B"].map(|task| of.over_ours(program, task).map_or("no".to_owned(), plain));
        format!("{program} {d} and {all}")
    };
    let times: Vec<_> = ["CasADi", "SymPy", "JAX", "Sacado", "Eigen"].iter().map(times).collect();
    format!(
        "Other programs on the same pairs in one run take so many times as long as the closed form, for d and for all: \
         {}.",
        times.join(", ")
    )
}

/// The ratios to the closed form, from the least to the largest.
fn ratios<'a>(rows: impl Iterator<Item = &'a Measured>) -> String {
    let (least, most) = range(rows.filter_map(|of| of.ratio_to_closed_form).map(|ratio| ratio.value));
    format!("{} to {}", plain(least), plain(most))
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, 0.0), |(least, most), value| (least.min(value), most.max(value)))
}
