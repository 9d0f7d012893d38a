//! The quality of explanations as a page, from the record alone.

use super::explain::{Explain, ExplainProgram, KindCount};
use super::number::{count, error};
use super::page::{Block, Page};
use crate::check::external::Naming;

impl Explain {
    /// The page. The same record always gives the same page.
    pub fn page(&self) -> Page {
        let taken = match self.every {
            1 => "Every fault of the catalogue is injected into the closed form".to_owned(),
            every => format!("One of every {every} faults of the catalogue is injected into the closed form"),
        };
        let mut blocks = vec![
            Block::text(&self.conclusion()),
            Block::text(&format!(
                "`beamgap check` names injected faults, and `beamgap verify` and `beamgap explain` try them for answers that \
                 the equations and the list of formulas do not explain. This report measures how often they are named. {taken}. Pairs of faults are injected, too; in every second pair both terms \
                 belong to the same formula. The faulty program answers 24 cases. Its answers are written as text, read again and \
                 explained.",
            )),
            Block::list(&[
                "If several explanations are named, each of them alone explains the answers.",
                "A deviation is the largest difference of a number from its prediction, over the scale of the number. *Before*: \
                 the prediction of the closed form. *After*: that of the closed form with the faults that are named first.",
                "An explanation leaves a deviation within the rounding of the answers.",
            ]),
        ];
        let names = Naming::ALL.map(|naming| format!("#{}", naming.name()));
        let head: Vec<String> = ["faults", "answers"]
            .map(str::to_owned)
            .into_iter()
            .chain(names)
            .chain(["#most named".to_owned(), "#left".to_owned()])
            .collect();
        blocks.extend([
            Block::table(&head, self.programs.iter().map(ExplainProgram::row).collect()),
            Block::List(Naming::ALL.map(|naming| words(naming).to_owned()).to_vec()),
            Block::text(
                "*Most named*: the most explanations that are named together. *Left*: the largest deviation that is left where \
                 the faults alone are named.",
            ),
        ]);
        blocks.extend(self.by_kind());
        blocks.extend([
            Block::heading("How it was made"),
            Block::text("All numbers are in `explain.json`, from which alone this page is made. It lists the programs whose faults are not \
                 named alone."),
            self.environment.table(vec![("seed", format!("{:#x}", self.seed))]),
        ]);
        Page::new("Explanations", blocks)
    }

    /// How often the fault is named, by its kind and by the digits of the answers.
    fn by_kind(&self) -> Vec<Block> {
        let programs: Vec<&ExplainProgram> = self.programs.iter().filter(|of| !of.kinds.is_empty()).collect();
        let Some(first) = programs.first() else { return Vec::new() };
        let of_program = |program: &&ExplainProgram| {
            let digits = program.digits.map_or_else(|| "all digits".to_owned(), |n| format!("{n} digits"));
            COLUMNS.map(|(words, _)| format!("#{words}, {digits}"))
        };
        let head: Vec<String> =
            std::iter::once("kind".to_owned()).chain(programs.iter().flat_map(of_program)).collect();
        let row = |(k, kind): (usize, &KindCount)| {
            let counts = programs.iter().flat_map(|program| {
                COLUMNS.map(|(_, namings)| count(program.kinds[k].count(namings) as u64))
            });
            std::iter::once(kind.kind.clone()).chain(counts).collect()
        };
        vec![
            Block::heading("By kind of error"),
            Block::text(
                "Programs with one fault, by its kind and by the digits of their answers. *Named*: first or equivalent.",
            ),
            Block::table(&head, first.kinds.iter().enumerate().map(row).collect()),
        ]
    }

    /// The frequency with which faults that change an answer are named.
    fn conclusion(&self) -> String {
        let of = |faults: usize| self.programs.iter().filter(move |of| of.faults == faults);
        let count_of = |faults: usize, namings: &[Naming]| -> u64 {
            of(faults).flat_map(|of| namings.iter().map(|&naming| of.count(naming) as u64)).sum()
        };
        let shows = |naming: &Naming| !matches!(naming, Naming::Faint | Naming::Undetected);
        let shown: Vec<Naming> = Naming::ALL.into_iter().filter(shows).collect();
        let [one, two] = [1, 2].map(|faults| count_of(faults, &shown));
        let together = [Naming::Equivalent, Naming::Among];
        let wrong: u64 = [1, 2].map(|faults| count_of(faults, &[Naming::Other])).iter().sum();
        let wrong = match wrong {
            0 => "No program has only other faults named.".to_owned(),
            1 => "One program has only other faults named.".to_owned(),
            wrong => format!("{} programs have only other faults named.", count(wrong)),
        };
        let of_two = if two == 0 {
            String::new()
        } else {
            format!(
                " Of {} such programs with two faults, {} have both named alone, {} have them named with such faults, {} have one of them \
                 named, and {} have none named.",
                count(two),
                count(count_of(2, &[Naming::First])),
                count(count_of(2, &together)),
                count(count_of(2, &[Naming::Fewer])),
                count(count_of(2, &[Naming::None])),
            )
        };
        format!(
            "How often is the wrong term named? **Of {} programs whose answers show one fault, {} have the fault named alone, and {} have it named with faults that the answers \
             cannot tell from it. {wrong}**{of_two}",
            count(one),
            count(count_of(1, &[Naming::First])),
            count(count_of(1, &together)),
        )
    }
}

/// The columns of the table by kind.
const COLUMNS: [(&str, &[Naming]); 3] = [
    ("named", &[Naming::First, Naming::Equivalent]),
    ("among", &[Naming::Among]),
    ("other or none", &[Naming::Other, Naming::None]),
];

impl ExplainProgram {
    fn row(&self) -> Vec<String> {
        let numbers = Naming::ALL.map(|naming| count(self.count(naming) as u64));
        let last = [count(self.largest_set as u64), error(self.largest_left)];
        [self.faults.to_string(), self.answers.clone()].into_iter().chain(numbers).chain(last).collect()
    }
}

fn words(naming: Naming) -> &'static str {
    match naming {
        Naming::First => "*first*: the faults alone are named",
        Naming::Equivalent => {
            "*equivalent*: they are named with faults that have the same results for all beams"
        }
        Naming::Among => "*among*: they are named with other faults that explain these answers as well",
        Naming::Fewer => "*fewer*: one of two faults is named; the deviation *after* remains",
        Naming::Other => "*other*: only other faults are named",
        Naming::None => "*none*: nothing is named",
        Naming::Faint => {
            "*faint*: the answers differ too little to show which term is wrong, and none is named"
        }
        Naming::Undetected => "*undetected*: the faults change none of these answers",
    }
}
