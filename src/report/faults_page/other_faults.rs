//! Faults of the search, faults on one side only, and faults of the gate itself.

use crate::closest_point::SearchFault;
use crate::faults::{Compared, Gate, SearchDetection};
use crate::report::faults::Faults;
use crate::report::number::{count, error};
use crate::report::page::Block;

impl Faults {
    /// The faults of the search for closest points, each with the number of cases after which it is detected.
    pub(super) fn faults_of_search(&self) -> Vec<Block> {
        if self.search.is_empty() {
            return Vec::new();
        }
        let row = |fault: SearchFault| {
            let after = self.search.iter().map(|of| match of.detected.get(&fault) {
                Some(SearchDetection { after, .. }) => (*after, of.regime, count(*after)),
                None => (u64::MAX, of.regime, "NOT DETECTED".to_owned()),
            });
            let (_, regime, most) = after.max_by_key(|(after, ..)| *after)?;
            Some([fault.name(), fault.what(), &most, regime.name()].map(str::to_owned).to_vec())
        };
        let head = ["fault", "the search", "#cases until it is detected", "in the regime"];
        let rows = SearchFault::ALL.into_iter().filter_map(row).collect();
        let (missed, rejected) = self
            .search
            .iter()
            .fold((0, 0), |(missed, rejected), of| (missed + of.missed.len(), rejected + of.rejected));
        vec![
            Block::heading("Faults of the search"),
            Block::text(&format!(
                "{} faults are injected into the search for closest points, one at a time. The search is compared with an independent \
                 search. {} faults are missed in some regime, and the unmodified search is rejected at {} pairs of beams.",
                count(SearchFault::ALL.len() as u64),
                count(missed as u64),
                count(rejected)
            )),
            Block::details(
                "Each fault of the search, in the regime that needs the most cases to detect it",
                vec![Block::table(&head, rows)],
            ),
        ]
    }

    /// The faults of the contact element.
    pub(super) fn of_elements(&self) -> Vec<Block> {
        let Some(first) = self.elements.first() else { return Vec::new() };
        let missed: Vec<_> =
            self.elements.iter().filter(|of| !of.holds()).map(|of| of.regime.name()).collect();
        let most = self.elements.iter().map(|of| of.cases).max().unwrap_or_default();
        let found = if missed.is_empty() {
            format!("All are detected within {} cases of each regime.", count(most))
        } else {
            format!("NOT ALL ARE DETECTED in {}.", missed.join(", "))
        };
        vec![
            Block::heading("Faults of the contact element"),
            Block::text(&format!(
                "{} faults in the terms of R and K are injected, one at a time. {found}",
                count(first.planted as u64)
            )),
        ]
    }

    /// The faults that act on one side of a symmetry only.
    pub(super) fn one_sided(&self) -> Vec<Block> {
        let Some(of) = &self.one_sided else { return Vec::new() };
        let missed = of.missed.iter().map(|(fault, side)| vec![fault.clone(), side.clone()]);
        let mut blocks = vec![
            Block::heading("Faults on one side only"),
            Block::text(&format!(
                "Each fault acts on one side of one symmetry only: at an obtuse crossing, or where the bar beam lies on one side of \
                 the beam. These are {} faults. The cases of `beamgap check` detect {} of them within {} cases, and miss {}. The other \
                 {} act on neither side of the symmetry, such as a term that is used only inside the beams, at their ends.",
                count(of.planted as u64),
                count(of.detected as u64),
                count(of.cases),
                count(of.missed.len() as u64),
                count(of.neither as u64)
            )),
        ];
        if !of.missed.is_empty() {
            blocks.push(Block::table(&["fault", "side"], missed.collect()));
        }
        blocks
    }

    /// What the gate itself compares.
    pub(super) fn of_gate(&self) -> Vec<Block> {
        if self.gate.is_empty() {
            return Vec::new();
        }
        let row = |gate: &Gate| {
            let counts = Compared::ALL.map(|of| match gate.counts.get(&of) {
                Some([found, wanted]) if found == wanted => count(*found as u64),
                Some([found, wanted]) => format!("{found} OF {wanted}"),
                None => "NONE".to_owned(),
            });
            let terms = if gate.rejected == gate.terms {
                count(gate.terms as u64)
            } else {
                format!("{} OF {}", gate.rejected, gate.terms)
            };
            let limits = [terms, error(Some(gate.median.0))];
            std::iter::once(gate.regime.name().to_owned()).chain(counts).chain(limits).collect()
        };
        let head = Compared::ALL.map(|of| format!("#{}", of.name()));
        let head: Vec<String> = std::iter::once("regime".to_owned())
            .chain(head)
            .chain(["#small changes rejected", "#median of the smallest"].map(str::to_owned))
            .collect();
        vec![
            Block::heading("The gate itself"),
            Block::text(
                "The comparisons of the first case of each pair of families, by kind; *a OF b* if something is not compared. Each \
                 term is changed by four times the smallest relative error that exceeds a tolerance. The check has to reject \
                 each of these changes. The median of these smallest errors shows how narrow the tolerances are.",
            ),
            Block::details(
                "Comparisons by regime",
                vec![Block::table(&head, self.gate.iter().map(row).collect())],
            ),
        ]
    }
}
