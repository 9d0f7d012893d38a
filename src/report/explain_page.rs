//! How well explanations are as a page, from the record alone.

use super::explain::{Explain, ExplainProgram};
use super::number::{count, error};
use super::page::{Block, Page};
use crate::check::external::Naming;

impl Explain {
    /// The page; the same record always makes the same page.
    pub fn page(&self) -> Page {
        let taken = match self.every {
            1 => "Every fault of the catalogue is planted in the closed form".to_owned(),
            every => format!("One of every {every} faults of the catalogue is planted in the closed form"),
        };
        let mut blocks = vec![Block::text(&format!(
            "`beamgap verify` and `beamgap explain` name the term that is wrong in the answers of a program. This report \
             measures how often they are right. {taken}, and pairs of faults: of every other pair both terms belong to the \
             same formula. The faulty program answers 24 cases, its answers are written as text, read again and explained.",
        ))];
        blocks.extend(self.programs.iter().flat_map(ExplainProgram::blocks));
        blocks.extend([
            Block::heading("How it was made"),
            Block::text("All numbers are in `explain.json`, from which alone this page is made."),
            self.environment.table(vec![("seed", format!("{:#x}", self.seed))]),
        ]);
        Page::new("Explanations", blocks)
    }
}

impl ExplainProgram {
    fn blocks(&self) -> Vec<Block> {
        let of_naming = |naming| vec![words(naming).to_owned(), count(self.count(naming) as u64)];
        let mut blocks = vec![
            Block::heading(&format!(
                "Programs with {} that answer {}",
                if self.faults == 1 { "one fault" } else { "two faults" },
                self.answers
            )),
            Block::table(&["explanation", "#programs"], Naming::ALL.into_iter().map(of_naming).collect()),
            Block::text(&format!(
                "At most {} explanations are named together. The largest deviation that is left where the faults alone are \
                 named is {} of its scale.",
                count(self.largest_set as u64),
                error(self.largest_left)
            )),
        ];
        let listed = [Naming::Among, Naming::Fewer, Naming::Other, Naming::None].map(Naming::name);
        let row = |other: &super::NotFirst| {
            let named: Vec<_> = other.named.iter().map(|name| format!("`{name}`")).collect();
            let more = other.count - other.named.len();
            let more = if more > 0 { format!(" and {more} more") } else { String::new() };
            let [before, after] = other.deviation.map(error);
            vec![
                format!("`{}`", other.fault),
                other.naming.clone(),
                format!("{}{more}", named.join(", ")),
                before,
                after,
            ]
        };
        let others = self.others.iter().filter(|other| listed.contains(&other.naming.as_str()));
        let rows: Vec<_> = others.map(row).collect();
        if !rows.is_empty() {
            let head = ["faults", "explanation", "named", "#before", "#after"];
            blocks.push(Block::details(
                "The programs whose faults are not named alone",
                vec![Block::table(&head, rows)],
            ));
        }
        blocks
    }
}

fn words(naming: Naming) -> &'static str {
    match naming {
        Naming::First => "first: the faults alone are named",
        Naming::Equivalent => {
            "equivalent: they are named with faults that have the same results for all beams"
        }
        Naming::Among => "among: they are named with faults that these answers cannot tell from them",
        Naming::Fewer => "fewer: one fault alone is named, which these answers cannot tell from the two",
        Naming::Other => "other: another fault is named",
        Naming::None => "none: nothing is named",
        Naming::Undetected => "undetected: the faults change none of these answers",
    }
}
