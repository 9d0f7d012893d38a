//! How well explanations are as a page, from the record alone.

use super::explain::{Explain, ExplainProgram};
use super::number::{count, error};
use super::page::{Block, Page};
use crate::check::external::Naming;

impl Explain {
    /// The page; the same record always makes the same page.
    pub fn page(&self) -> Page {
        let mut blocks = vec![Block::text(
            "`beamgap verify` and `beamgap explain` name the term that is wrong in the answers of a program. This report \
             measures how often they are right. Every fault of the catalogue is planted in the closed form. The faulty \
             program answers 24 cases, its answers are written as text, read again and explained.",
        )];
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
            Block::heading(&format!("Programs that answer {}", self.answers)),
            Block::table(&["explanation", "#faults"], Naming::ALL.into_iter().map(of_naming).collect()),
            Block::text(&format!(
                "The largest deviation that is left where the fault alone is named is {} of its scale.",
                error(self.largest_left)
            )),
        ];
        let listed = [Naming::Among, Naming::Other, Naming::None].map(Naming::name);
        let row = |other: &super::NotFirst| {
            let named: Vec<_> = other.named.iter().take(4).map(|name| format!("`{name}`")).collect();
            let more = other.named.len().saturating_sub(4);
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
            let head = ["fault", "explanation", "named", "#before", "#after"];
            blocks
                .push(Block::details("The faults that are not named alone", vec![Block::table(&head, rows)]));
        }
        blocks
    }
}

fn words(naming: Naming) -> &'static str {
    match naming {
        Naming::First => "first: the fault alone is named",
        Naming::Equivalent => "equivalent: it is named with faults that have the same results for all beams",
        Naming::Among => "among: it is named with faults that have the same results at these cases",
        Naming::Other => "other: another fault is named",
        Naming::None => "none: nothing is named",
        Naming::Undetected => "undetected: the fault changes none of these answers",
    }
}
