//! How well explanations are as Markdown, from the record alone.

use super::explain::{Explain, ExplainProgram};
use super::number::{count, error};
use crate::check::external::Naming;
use std::fmt::Write;

impl Explain {
    /// The page; the same record always makes the same page.
    pub fn to_markdown(&self) -> String {
        let mut page = String::from("# Explanations\n\n");
        page += "`beamgap verify` and `beamgap explain` name the term that is wrong in the answers of a program. This report \
                 measures how often they are right. Every fault of the catalogue is planted in the closed form. The faulty \
                 program answers 24 cases, its answers are written as text, read again and explained.\n\n";
        for program in &self.programs {
            let _ = write!(page, "## Programs that answer {}\n\n{}", program.answers, program.to_markdown());
        }
        let _ = write!(
            page,
            "## How it was made\n\n{}| seed | {:#x} |\n\nAll numbers are in `explain.json`, from which alone this page is made.\n",
            self.environment.rows(),
            self.seed
        );
        page
    }
}

impl ExplainProgram {
    fn to_markdown(&self) -> String {
        let mut page = String::from("| explanation | faults |\n|---|---:|\n");
        for naming in Naming::ALL {
            let _ = writeln!(page, "| {} | {} |", words(naming), count(self.count(naming) as u64));
        }
        let _ = writeln!(
            page,
            "\nThe largest deviation that is left where the fault alone is named is {} of its scale.\n",
            error(self.largest_left)
        );
        let listed = [Naming::Among, Naming::Other, Naming::None].map(Naming::name);
        let mut others =
            self.others.iter().filter(|other| listed.contains(&other.naming.as_str())).peekable();
        if others.peek().is_some() {
            page += "| fault | explanation | named | before | after |\n|---|---|---|---:|---:|\n";
            for other in others {
                let named: Vec<_> = other
                    .named
                    .iter()
                    .take(4)
                    .map(|name| format!("`{}`", name.replace('|', "\\|")))
                    .collect();
                let more = other.named.len().saturating_sub(4);
                let more = if more > 0 { format!(" and {more} more") } else { String::new() };
                let [before, after] = other.deviation.map(error);
                let (fault, naming) = (other.fault.replace('|', "\\|"), &other.naming);
                let _ = writeln!(
                    page,
                    "| `{fault}` | {naming} | {}{more} | {before} | {after} |",
                    named.join(", ")
                );
            }
            page.push('\n');
        }
        page
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
