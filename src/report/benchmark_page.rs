//! The benchmarks as pages, from the record alone.

use super::benchmark::{Benchmark, CLOSED_FORM, Measured, Ratio};
use super::number::{count, error, number, plain, time};
use super::page::{Block, html, markdown};
use super::{Instructions, ReportError, Task};

/// The title of the page.
const TITLE: &str = "Benchmark";
/// The family that stands for all where there is room for one only.
const STANDARD: &str = "hermite";

impl Benchmark {
    /// The pages and the pictures by the names of their files; the same record always makes the same.
    ///
    /// # Errors
    /// [`ReportError::Draw`].
    pub fn pages(&self) -> Result<Vec<(String, String)>, ReportError> {
        let blocks = self.blocks()?;
        let mut pages = vec![
            ("benchmark.md".to_owned(), markdown(TITLE, &blocks)),
            ("benchmark.html".to_owned(), html(TITLE, &blocks)),
        ];
        for block in blocks {
            if let Block::Picture { file, svg, .. } = block {
                pages.push((file, svg));
            }
        }
        Ok(pages)
    }

    fn blocks(&self) -> Result<Vec<Block>, ReportError> {
        let mut blocks = vec![
            Block::text(&self.conclusion()),
            picture("benchmark.svg", "Ratios to the closed form", self.ratios_to_svg()?),
        ];
        for task in [Task::Distance, Task::All, Task::Directions] {
            blocks.extend([
                Block::heading(task.name()),
                Block::text(task.description()),
                self.standard(task),
            ]);
            blocks.push(Block::text("All families, with the ratio to the closed form of the same family:"));
            blocks.push(self.by_family(task));
        }
        for task in [Task::WithSlips, Task::GradientOfDistance, Task::Gradients, Task::ClosestPoint] {
            blocks.extend([
                Block::heading(task.name()),
                Block::text(task.description()),
                self.by_family(task),
            ]);
        }
        blocks.extend(self.sizes()?);
        blocks.extend(self.many());
        blocks.push(Block::heading("Accuracy"));
        blocks.push(Block::text(
            "Each method with the pair of Hermite beams: the largest error against double-double, over the time.",
        ));
        blocks.push(picture("benchmark-accuracy.svg", "Error over time", self.accuracy_to_svg()?));
        blocks.extend(self.roofline()?);
        blocks.extend(self.instructions.iter().flat_map(instructions));
        blocks.extend(self.peers.iter().flat_map(super::Peers::blocks));
        blocks.extend(self.method());
        Ok(blocks)
    }

    /// All methods of a task for the standard pair.
    fn standard(&self, task: Task) -> Block {
        let rows = self.of(task).filter(|measured| measured.family == STANDARD).map(|measured| {
            let [low, high] = measured.interval.map(time);
            let times = measured.ratio_to_closed_form.map_or_else(String::new, Ratio::in_words);
            let times = if measured.method == CLOSED_FORM { "1".to_owned() } else { times };
            vec![
                measured.method.clone(),
                time(measured.median),
                format!("{low} to {high}"),
                times,
                error(Some(measured.error)),
                verdict(measured.share),
            ]
        });
        let methods = format!("{STANDARD}, 24 dofs");
        let head =
            [&methods, "#median", "#95 % interval", "#times the closed form", "#largest error", VERDICT];
        Block::table(&head.map(|name: &str| name), rows.collect())
    }

    /// Methods and families, whichever there are more of down and the others across.
    fn by_family(&self, task: Task) -> Block {
        let (mut methods, mut families): (Vec<&str>, Vec<(&str, usize)>) = (Vec::new(), Vec::new());
        for Measured { method, family, dofs, .. } in self.of(task) {
            if !methods.contains(&method.as_str()) {
                methods.push(method);
            }
            if !families.contains(&(family, *dofs)) {
                families.push((family, *dofs));
            }
        }
        let find = |method: &str, (family, dofs): (&str, usize)| {
            self.of(task).find(|of| of.method == method && of.family == family && of.dofs == dofs)
        };
        let of_method = |method: &&str| families.iter().map(|&family| find(method, family)).collect();
        let mut cells: Vec<Vec<Option<&Measured>>> = methods.iter().map(of_method).collect();
        let mut down: Vec<String> = methods.iter().map(|&method| method.to_owned()).collect();
        let mut across: Vec<String> =
            families.iter().map(|(family, dofs)| format!("{family}, {dofs}")).collect();
        if across.len() > down.len() {
            cells = (0..across.len()).map(|i| cells.iter().map(|row| row[i]).collect()).collect();
            std::mem::swap(&mut down, &mut across);
        }
        let rows =
            down.into_iter().zip(cells).map(|(name, of)| std::iter::once(name).chain(row(of)).collect());
        let head = across.iter().map(|name| format!("#{name}")).chain([format!("{VERDICT} at most")]);
        let head: Vec<String> = std::iter::once("beams, dofs".to_owned()).chain(head).collect();
        Block::table(&head.iter().map(String::as_str).collect::<Vec<_>>(), rows.collect())
    }

    fn sizes(&self) -> Result<Vec<Block>, ReportError> {
        let by_size = [(Task::DistanceBySize, 1), (Task::AllBySize, 5)];
        let rows = by_size.into_iter().flat_map(|(task, hessians)| {
            self.of(task).map(move |of| {
                let entries = number(hessians * of.stored());
                vec![
                    of.task.replace(" by size", ""),
                    of.family.clone(),
                    count(of.dofs as u64),
                    of.method.clone(),
                    time(of.median),
                    format!("{} ns", plain(of.median / entries)),
                    verdict(of.share),
                ]
            })
        });
        let head = ["task", "family", "#dofs", "method", "#median", "#an entry of a Hessian", VERDICT];
        Ok(vec![
            Block::heading("Cost over the number of dofs"),
            Block::text(
                "A cost proportional to the size of the result is a constant time for each entry of a Hessian that is stored. What is \
                 spent on the shape functions and on the gradients is spread over few entries when there are few dofs, and \
                 Hessians that overflow the first cache cost more again.",
            ),
            picture("benchmark-sizes.svg", "Time over the number of dofs", self.sizes_to_svg()?),
            Block::table(&head, rows.collect()),
        ])
    }

    fn many(&self) -> Vec<Block> {
        let pairs = |task| self.of(task).map(|of| of.pairs as u64);
        let numbers = |of_d: Option<u64>, of_all: Option<u64>| {
            format!("{} for d and {} for all", count(of_d.unwrap_or(0)), count(of_all.unwrap_or(0)))
        };
        let in_cache = numbers(pairs(Task::DistanceOfMany).max(), pairs(Task::AllOfMany).max());
        let to_memory = numbers(pairs(Task::DistanceOfMany).min(), pairs(Task::AllOfMany).min());
        let rows =
            [Task::DistanceOfMany, Task::AllOfMany].into_iter().flat_map(|task| self.of(task)).map(|of| {
                let [low, high] = of.interval.map(time);
                let (interval, rate) = (format!("{low} to {high}"), plain(1e9 / of.median));
                let [speed_up, of_arithmetic] = [of.speed_up(), of.speed_up_of_arithmetic()]
                    .map(|ratio| ratio.map_or_else(String::new, Ratio::in_words));
                let task = of.task.replace(" of many pairs", "");
                let method = of.method.replace("closed form, ", "");
                let median = time(of.median);
                vec![task, method, median, interval, rate, speed_up, of_arithmetic, verdict(of.share)]
            });
        let head = [
            "task",
            "method",
            "#time of a pair",
            "#95 % interval",
            "#pairs in a second",
            "#times one thread",
            "#multiply-adds alone",
            VERDICT,
        ];
        vec![
            Block::heading("Many pairs"),
            Block::text(&format!(
                "Pairs of Hermite beams, {in_cache}, one by one or four in the lanes of a vector, each result written where \
                 the last one was, as an assembly does that takes it from there; or by one call, {to_memory}, each result in \
                 memory of its own, which then waits for memory. How many times as many pairs two threads do as one was \
                 measured with both in interleaved rounds, on {} cores; and in the same rounds how many times as many multiply-adds in \
                 registers, with no memory and nothing else to do, each thread for a whole round.",
                self.environment.cores
            )),
            Block::table(&head, rows.collect()),
        ]
    }

    fn roofline(&self) -> Result<Vec<Block>, ReportError> {
        let rows = self.below_the_roof().map(|below| {
            let [of_arithmetic, of_stores] = below.roofline.map(time);
            let [multiply_adds, bytes] = [below.multiply_adds, below.bytes].map(|n| count(n as u64));
            let (of_pair, times) = (time(below.time), plain(below.times));
            vec![below.name(), multiply_adds, of_arithmetic, bytes, of_stores, of_pair, times]
        });
        let head = [
            "a pair, 24 dofs",
            "#multiply-adds",
            "#roofline bound",
            "#bytes stored",
            "#roofline bound",
            "#a pair",
            "#times the roofline bound",
        ];
        let [multiply_adds, bytes] = self.roof();
        Ok(vec![
            Block::heading("The roofline"),
            Block::text(&format!(
                "One core of this machine does {} multiply-adds in a nanosecond at best, and stores {} bytes into its first \
                 cache: measured by two small kernels, in interleaved rounds with the methods of this table, so that both meet the machine at \
                 the same speed. The multiply-adds of a method are counted by evaluating \
                 the same source over a number that counts: a product with the sum that takes it, any other sum or product, \
                 a quotient and a root are one each. So the roofline is that of a machine that only computes, never waits, \
                 and always has four numbers to compute with, which one pair at a time has not.",
                plain(multiply_adds),
                plain(bytes)
            )),
            picture("benchmark-roofline.svg", "The roofline", self.roofline_to_svg()?),
            Block::table(&head, rows.collect()),
        ])
    }
}

/// The times of a row with their ratios, and the worst verdict of them.
fn row(of: Vec<Option<&Measured>>) -> Vec<String> {
    let cell = |of: &Measured| match &of.ratio_to_closed_form {
        Some(ratio) => format!("{} ({})", time(of.median), plain(ratio.value)),
        None => time(of.median),
    };
    let share = of.iter().flatten().map(|of| of.share).fold(0.0, f64::max);
    of.into_iter().map(|of| of.map_or_else(String::new, cell)).chain([verdict(share)]).collect()
}

/// The head of a column of verdicts.
const VERDICT: &str = "#error / tolerance";

/// The largest error over what is allowed for it.
fn verdict(share: f64) -> String {
    format!("{} ({})", error(Some(share)), if share <= 1.0 { "pass" } else { "fail" })
}

fn picture(file: &str, caption: &str, svg: String) -> Block {
    Block::Picture { file: file.to_owned(), caption: caption.to_owned(), svg }
}

fn instructions(of: &Instructions) -> [Block; 3] {
    let rows = of.rows.iter().map(|row| vec![row.scenario.clone(), count(row.instructions)]);
    [
        Block::heading("Instructions"),
        Block::text(&format!(
            "Counted by callgrind, for one run each: {}, {}. `{}`",
            of.rustc, of.target, of.command
        )),
        Block::table(&["scenario", "#instructions"], rows.collect()),
    ]
}

impl Ratio {
    /// The ratio with its interval.
    fn in_words(self) -> String {
        let [low, high] = self.interval.map(plain);
        if self.is_different() {
            format!("**{}** ({low} to {high})", plain(self.value))
        } else {
            format!("no difference ({low} to {high})")
        }
    }
}
