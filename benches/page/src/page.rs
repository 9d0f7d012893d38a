//! The benchmarks as a page, from the record alone.

use crate::benchmark::{Benchmark, CLOSED_FORM, Measured, Ratio};
use crate::methods::{GIVEN, LAYOUTS, method_name};
use crate::{Instructions, Peers, Task};
use beamgap::report::number::{count, error, number, plain, time};
use beamgap::report::page::{Block, Page};

/// The family that represents all families where only one is shown.
const STANDARD: &str = "hermite";

impl Benchmark {
    /// The pages and the pictures by file name. The same record always gives the same pages.
    pub fn pages(&self) -> Vec<(String, String)> {
        let page = self.page();
        let pages = [("benchmark.md", self.short_page().to_markdown()), ("benchmark.html", page.to_html())];
        pages.map(|(name, text)| (name.to_owned(), text)).into_iter().chain(page.pictures()).collect()
    }

    /// The page without its folded tables.
    fn short_page(&self) -> Page {
        let Page { title, mut blocks } = self.page();
        blocks.retain(|block| !matches!(block, Block::Details { .. }));
        blocks.insert(
            1,
            Block::text("The tables are in [benchmark.html](benchmark.html), a file for a browser, and all samples in `benchmark.json`."),
        );
        Page { title, blocks }
    }

    /// The page.
    pub fn page(&self) -> Page {
        let mut blocks = vec![Block::text(&self.answer())];
        blocks.extend(picture("benchmark.svg", METHODS, self.methods_to_svg()));
        blocks.push(Block::List(self.findings()));
        blocks.extend([
            Block::text("The methods differ in what they were given:"),
            Block::List(GIVEN.map(str::to_owned).to_vec()),
        ]);
        let trade = picture("benchmark-accuracy.svg", TRADE, self.trade_to_svg());
        blocks.extend(trade.into_iter().flat_map(|picture| [Block::heading("Accuracy over time"), picture]));
        blocks.extend(self.closest_points());
        blocks.extend(self.sizes());
        blocks.extend(self.roofline());
        blocks.extend(self.many());
        blocks.extend([Block::heading("All measurements"), Block::text(&self.times_of_closed_form())]);
        for task in [Task::Distance, Task::All, Task::Directions] {
            let tables = [
                Block::text(task.description()),
                self.standard(task),
                Block::text("The time for every family:"),
                self.by_family(task, |of| Some(time(of.median))),
                Block::text("The ratio to the closed form of the same family, in interleaved rounds:"),
                self.by_family(task, |of| of.ratio_to_closed_form.map(|ratio| plain(ratio.value))),
            ];
            blocks.push(Block::details(&format!("Every method: {}", task.name()), tables.to_vec()));
        }
        let task = Task::ContactElement;
        let of_element = vec![Block::text(task.description()), self.standard(task)];
        blocks.push(Block::details(&format!("Every method: {}", task.name()), of_element));
        for task in [Task::WithSlips, Task::GradientOfDistance, Task::Gradients] {
            let table = self.by_family(task, |of| Some(time(of.median)));
            let tables = vec![Block::text(task.description()), table];
            blocks.push(Block::details(&format!("Closed form: {}", task.name()), tables));
        }
        blocks.extend(self.peers.iter().flat_map(Peers::blocks));
        blocks.extend(self.instructions.as_ref().map(instructions));
        blocks.extend(self.method());
        Page::new("Benchmark", blocks)
    }

    /// The reason why the closed form for d has several times.
    fn times_of_closed_form(&self) -> String {
        let find = |task: Task, method: &str| {
            let of = self.of(task).find(|of| of.family == STANDARD && of.method == method);
            of.map_or_else(|| "no time".to_owned(), |of| time(of.median))
        };
        let of_peers = self.peers.as_ref().map(|peers| {
            let times =
                peers.times_of_ours("A").into_iter().map(|(layout, ns)| format!("{} {layout}", time(ns)));
            let times: Vec<_> = times.collect();
            format!(" In the run with other programs, on {} pairs: {}.", count(peers.pairs), times.join(", "))
        });
        format!(
            "The closed form for d, 24 dofs, has several times, since layouts and pairs differ. One pair, the same each time: {} \
             blocks, {} full, {} packed. Many pairs, one by one: {} blocks. In interleaved rounds each time is that of these \
             rounds.{} {LAYOUTS} Where no layout is named, it is blocks.",
            find(Task::Distance, CLOSED_FORM),
            find(Task::Distance, "closed form, in full"),
            find(Task::Distance, "closed form, packed"),
            find(Task::DistanceOfMany, "closed form, one by one, 1 thread"),
            of_peers.unwrap_or_default()
        )
    }

    /// All methods of a task for the standard pair.
    fn standard(&self, task: Task) -> Block {
        let rows = self.of(task).filter(|measured| measured.family == STANDARD).map(|measured| {
            let [low, high] = measured.interval.map(time);
            let [own, of_closed_form] =
                measured.times_of_rounds().map_or_else(Default::default, |of| of.map(time));
            vec![
                method_name(&measured.task, &measured.method),
                time(measured.median),
                format!("{low} to {high}"),
                own,
                of_closed_form,
                measured.ratio_to_closed_form.map_or_else(String::new, Ratio::in_words),
                error(Some(measured.error)),
                verdict(measured.share),
            ]
        });
        let methods = format!("{STANDARD}, 24 dofs");
        let head = [
            &methods,
            "#median, alone",
            "#95 % interval",
            "#in rounds",
            "#closed form in these rounds",
            "#ratio in rounds",
            "#largest error",
            VERDICT,
        ];
        Block::table(&head, rows.collect())
    }

    /// A table of methods and families. The larger number of them are the rows, the others are the columns.
    fn by_family(&self, task: Task, cell: impl Fn(&Measured) -> Option<String>) -> Block {
        let (mut methods, mut families): (Vec<&str>, Vec<(&str, usize)>) = (Vec::new(), Vec::new());
        for of in self.of(task).filter(|of| cell(of).is_some()) {
            if !methods.contains(&of.method.as_str()) {
                methods.push(&of.method);
            }
            if !families.contains(&(&of.family, of.dofs)) {
                families.push((&of.family, of.dofs));
            }
        }
        let find = |method: &str, (family, dofs): (&str, usize)| {
            let is_it = |of: &&Measured| of.method == method && of.family == family && of.dofs == dofs;
            self.of(task).find(is_it).and_then(&cell).unwrap_or_default()
        };
        let name = |(family, dofs): (&str, usize)| format!("{family}, {dofs}");
        let (mut across, rows): (Vec<String>, Vec<Vec<String>>) = if families.len() > methods.len() {
            let row = |&family: &(&str, usize)| {
                let cells = methods.iter().map(|method| find(method, family));
                std::iter::once(name(family)).chain(cells).collect()
            };
            let names = methods.iter().map(|method| method_name(task.name(), method));
            (names.collect(), families.iter().map(row).collect())
        } else {
            let row = |method: &&str| {
                let cells = families.iter().map(|&family| find(method, family));
                std::iter::once(method_name(task.name(), method)).chain(cells).collect()
            };
            (families.iter().map(|&family| name(family)).collect(), methods.iter().map(row).collect())
        };
        for name in &mut across {
            name.insert(0, '#');
        }
        across.insert(0, "beams, dofs".to_owned());
        Block::table(&across, rows)
    }

    /// The time to find a closest point, next to the time to linearize there.
    fn closest_points(&self) -> Vec<Block> {
        let closed = |task: Task, family: &str| {
            let is_it = |of: &&Measured| of.family == family && of.method == CLOSED_FORM;
            self.of(task).find(is_it).map_or_else(String::new, |of| time(of.median))
        };
        let mut families: Vec<(&str, usize)> = Vec::new();
        for of in self.of(Task::ClosestPoint) {
            if !families.contains(&(&of.family, of.dofs)) {
                families.push((&of.family, of.dofs));
            }
        }
        let row = |&(family, dofs): &(&str, usize)| {
            let find = |method: &str| {
                let is_it = |of: &&Measured| of.family == family && of.method.starts_with(method);
                self.of(Task::ClosestPoint).find(is_it).map_or_else(String::new, |of| time(of.median))
            };
            let linearized = [closed(Task::Distance, family), closed(Task::All, family)];
            let found = [format!("{family}, {dofs}"), find("search"), find("Newton")];
            found.into_iter().chain(linearized).collect()
        };
        let head = [
            "beams, dofs",
            "#search for all closest points",
            "#Newton's method from 0.05 away",
            "#closed form, d",
            "#closed form, all but the slips",
        ];
        vec![
            Block::heading("Finding the closest point"),
            Block::text(
                "All methods above are given the closest point. This table has the time to find it beside the time to linearize \
                 there. Newton's method starts 0.05 away in both parameters, as from the last load step. The search finds all \
                 closest points, and needs no start.",
            ),
            Block::table(&head, families.iter().map(row).collect()),
        ]
    }

    fn sizes(&self) -> Vec<Block> {
        let by_size = [(Task::DistanceBySize, 1), (Task::AllBySize, 5)];
        let rows = by_size.into_iter().flat_map(|(task, hessians)| {
            self.of(task).map(move |of| {
                let entries = number(hessians * of.stored());
                vec![
                    of.task.replace(" by size", ""),
                    of.family.clone(),
                    count(of.dofs as u64),
                    time(of.median),
                    format!("{} ns", plain(of.median / entries)),
                    verdict(of.share),
                ]
            })
        });
        let head = ["task", "family", "#dofs", "#median", "#time per Hessian entry", VERDICT];
        let rows = Block::table(&head, rows.collect());
        let picture = picture("benchmark-sizes.svg", SIZES, self.sizes_to_svg());
        let text = format!(
            "{} The Hessian has the square of the dofs as entries. Few dofs share the cost of the shape functions and gradients \
             among few entries.",
            self.growth()
        );
        let blocks = [Block::heading("Cost over dofs"), Block::text(&text)];
        blocks
            .into_iter()
            .chain(picture)
            .chain([Block::details("The numbers of this figure", vec![rows])])
            .collect()
    }
}

const METHODS: &str = "The median time of a pair of cubic Hermite beams, one core, in one run. Bars reach from the lower to the \
                       upper quartile of the rounds; for the closest point they are 95 % intervals. Errors are the largest \
                       in a gradient or Hessian, relative to its largest entry, against double-double.";
const TRADE: &str =
    "d, xi, xi_bar, t and t_bar with gradients and Hessians. Lower is more accurate; left is faster.";
const SIZES: &str =
    "Gradients and Hessians in all dofs of two Lagrange or cubic B-spline beams. All: all but the slips.";

/// The head of a column of verdicts.
pub(crate) const VERDICT: &str = "#error / tolerance";

/// The largest error over its tolerance.
pub(crate) fn verdict(share: f64) -> String {
    format!("{} ({})", error(Some(share)), if share <= 1.0 { "pass" } else { "fail" })
}

pub(crate) fn picture(file: &str, caption: &str, svg: Option<String>) -> Option<Block> {
    Some(Block::Picture { file: file.to_owned(), caption: caption.to_owned(), svg: svg? })
}

fn instructions(of: &Instructions) -> Block {
    let rows = of.rows.iter().map(|row| {
        let task = row.scenario.split('/').next().unwrap_or_default();
        vec![method_name(task, &row.scenario), count(row.instructions)]
    });
    let text =
        format!("Counted by callgrind, for one run each: {}, {}. `{}`", of.rustc, of.target, of.command);
    let table = Block::table(&["scenario", "#instructions"], rows.collect());
    Block::details("Instructions", vec![Block::text(&text), table])
}

impl Ratio {
    /// The ratio with its interval.
    pub(crate) fn in_words(self) -> String {
        let [low, high] = self.interval.map(plain);
        if self.is_different() {
            format!("**{}** ({low} to {high})", plain(self.value))
        } else {
            format!("no difference ({low} to {high})")
        }
    }
}
