//! A page as Markdown.

use super::{Block, Page};

impl Page {
    /// The page as Markdown, a file of the directory `reports`.
    pub fn to_markdown(&self) -> String {
        format!("# {}\n{}\n{LINKS}\n", self.title, blocks(&self.blocks))
    }
}

/// The end of each page.
const LINKS: &str = "[README](../README.md) · [symbols, names and regimes](symbols.md)";

fn blocks(all: &[Block]) -> String {
    all.iter().flat_map(|block| ["\n".to_owned(), one(block)]).collect()
}

fn one(block: &Block) -> String {
    match block {
        Block::Heading(text) => format!("## {text}\n"),
        Block::Subheading(text) => format!("### {text}\n"),
        Block::Text(text) => format!("{text}\n"),
        Block::List(points) => points.iter().flat_map(|point| ["- ", point, "\n"]).collect(),
        Block::Table { head, rows } => {
            let names: Vec<_> = head.iter().map(|(name, _)| name.clone()).collect();
            let rule: Vec<_> = head.iter().map(|&(_, right)| if right { "---:" } else { "---" }).collect();
            let rows: String = rows.iter().map(|cells| row(cells)).collect();
            format!("{}|{}|\n{rows}", row(&names), rule.join("|"))
        }
        Block::Formula(latex) => format!("```math\n{latex}\n```\n"),
        Block::Picture { file, caption, .. } => format!("![{caption}]({file})\n\n*{caption}*\n"),
        Block::Details { summary, blocks: inner } => {
            format!("<details><summary>{summary}</summary>\n{}\n</details>\n", blocks(inner))
        }
    }
}

/// A bar in a cell would end the cell.
fn row(cells: &[String]) -> String {
    let cells: Vec<_> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
    format!("| {} |\n", cells.join(" | "))
}
