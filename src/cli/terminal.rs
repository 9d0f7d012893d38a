//! Pages on a terminal.

use beamgap::report::Page;
use std::io::IsTerminal;

/// The page with the verdict below it, as wide as the terminal (80 to 120 columns); 80 columns if there is no terminal.
pub(super) fn page(page: &Page, verdict: &str) -> String {
    format!("{}\n{verdict}\n", page.to_text(columns()))
}

fn columns() -> usize {
    let stdout = std::io::stdout();
    let width = if stdout.is_terminal() { terminal_size::terminal_size_of(stdout) } else { None };
    width.map_or(80, |(terminal_size::Width(width), _)| usize::from(width).clamp(80, 120))
}
