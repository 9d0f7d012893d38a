//! The limits of the machine: many pairs on several threads, and the roofline.

use crate::Task;
use crate::benchmark::{Benchmark, Measured, Ratio};
use crate::page::{VERDICT, picture, verdict};
use beamgap::report::number::{count, plain, time};
use beamgap::report::page::Block;

impl Benchmark {
    pub(crate) fn many(&self) -> Vec<Block> {
        let tasks = [Task::DistanceOfMany, Task::AllOfMany];
        let pairs = |task| self.of(task).map(|of| of.pairs as u64);
        let numbers = |[of_d, of_all]: [Option<u64>; 2]| {
            format!("{} pairs for d and {} for all", count(of_d.unwrap_or(0)), count(of_all.unwrap_or(0)))
        };
        let in_cache = numbers(tasks.map(|task| pairs(task).max()));
        let to_memory = numbers(tasks.map(|task| pairs(task).min()));
        let all = || tasks.into_iter().flat_map(|task| self.of(task));
        let name = |of: &Measured| {
            let method =
                of.method.replace("closed form, ", "").replace(", 2 threads", "").replace(", 1 thread", "");
            vec![of.task.replace(" of many pairs", ""), method]
        };
        let one = all().filter(|of| of.speed_up().is_none()).map(|of| {
            let [low, high] = of.interval.map(time);
            let ratio = of.ratio_to_closed_form.map_or_else(String::new, Ratio::in_words);
            let times = [time(of.median), format!("{low} to {high}"), plain(1e9 / of.median)];
            name(of).into_iter().chain(times).chain([ratio, verdict(of.share)]).collect()
        });
        let two = all().filter_map(|of| {
            let [by_all, by_one] = of.times_of_threads()?.map(time);
            let [speed_up, of_arithmetic] =
                [of.speed_up()?, of.speed_up_of_arithmetic()?].map(Ratio::in_words);
            let ratio = of.ratio_to_closed_form.map_or_else(String::new, Ratio::in_words);
            Some(name(of).into_iter().chain([by_one, by_all, speed_up, of_arithmetic, ratio]).collect())
        });
        let head = [
            "task",
            "method",
            "#time of a pair",
            "#95 % interval",
            "#pairs in a second",
            "#ratio to one by one",
            VERDICT,
        ];
        let heads = [
            "task",
            "method",
            "#one thread",
            "#two threads",
            "#times as many pairs",
            "#multiply-adds alone",
            "#ratio to one by one",
        ];
        vec![
            Block::heading("Many pairs"),
            Block::text(
                "Pairs of Hermite beams on one thread: one by one, or d of four pairs in the lanes of a vector. The ratio to one \
                 by one is that of interleaved rounds.",
            ),
            Block::table(&head, one.collect()),
            Block::text(&format!(
                "Two threads against one, on {} cores. Each row was measured with both in interleaved rounds; its times are \
                 those of these rounds. The column \
                 *multiply-adds alone* is the speed-up of two threads that only multiply and add in registers, which is the \
                 speed-up of the machine. In single rounds it is {}.",
                self.environment.cores,
                self.speed_ups_of_arithmetic()
            )),
            Block::table(&heads, two.collect()),
            Block::list(&[
                &format!(
                    "One by one, and four at once: each result is written where the last one was, for an assembly that takes it \
                     from there; {in_cache}."
                ),
                &format!("To memory: each result has memory of its own, and waits for memory; {to_memory}."),
            ]),
        ]
    }

    pub(crate) fn roofline(&self) -> Vec<Block> {
        let rows = self.below_the_roof().map(|below| {
            let [of_arithmetic, of_stores] = below.roofline.map(time);
            let [multiply_adds, bytes] = [below.multiply_adds, below.bytes].map(|n| count(n as u64));
            let (of_pair, times) = (time(below.time), plain(below.times));
            vec![below.name(), multiply_adds, of_arithmetic, bytes, of_stores, of_pair, times]
        });
        let head = [
            "a pair, 24 dofs",
            "#multiply-adds",
            "#they take",
            "#bytes stored",
            "#they take",
            "#a pair, in these rounds",
            "#times the roofline bound",
        ];
        let rows = Block::table(&head, rows.collect());
        let [multiply_adds, bytes] = self.roof();
        let text = format!(
            "The roofline bound is the time that the multiply-adds of a method take, or its stores, whichever is longer, if the \
             machine does nothing else. One core does {} multiply-adds in a nanosecond. It stores {} bytes in a nanosecond into \
             its first-level cache. The number at a point is its time over the bound.",
            plain(multiply_adds),
            plain(bytes)
        );
        let method = Block::list(&[
            "Two small kernels measure the bounds, in interleaved rounds with the methods, so that both meet the machine at the \
             same speed.",
            "Multiply-adds are counted by evaluating the same source over a number that counts. A product with the sum that \
             takes it, any other sum or product, a quotient and a root are one each.",
            "The bound assumes four numbers in every instruction and no waiting, which one pair at a time cannot have.",
        ]);
        let picture = picture("benchmark-roofline.svg", ROOFLINE, self.roofline_to_svg());
        let blocks = [Block::heading("Roofline"), Block::text(&text)];
        let details = Block::details("The numbers of this figure", vec![method, rows]);
        blocks.into_iter().chain(picture).chain([details]).collect()
    }
}

const ROOFLINE: &str = "Points below the line, each with its layout and its time over the roofline bound. All: all but the slips.";
