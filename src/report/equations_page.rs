//! The table of the equations as a page, from the record alone.

mod readings;

use super::Equations;
use super::number::{count, error};
use super::page::{Block, Page};
use crate::equations::{Claim, EquationRow, EquationTable, Reading, Run, Symmetry, Verdict};
use readings::{numbers, readings, refuted};

impl Equations {
    /// The page. The same record always gives the same page.
    pub fn page(&self) -> Page {
        let table = &self.table;
        let of = |verdict| table.equations.iter().filter(|entry| entry.verdict == verdict).count();
        let (evaluated, others): (Vec<&EquationRow>, Vec<&EquationRow>) =
            table.equations.iter().partition(|entry| !entry.parts.is_empty());
        let conclusion = format!(
            "Which equations of the paper are right? **Of the {} equations of the paper {} are misprinted in the scan, and {} more are incomplete for curves that are not \
             linear in their dofs; as corrected and completed {}.** This report evaluates {} of the equations, as printed and \
             as corrected, and compares them with automatic differentiation by hyper-dual numbers. The others, {}, define, assume or \
             list something; they are judged by their words.",
            table.equations.len(),
            of(Verdict::Misprint),
            of(Verdict::ExactIfLinear),
            match of(Verdict::Refuted) {
                0 => "none is refuted".to_owned(),
                n => format!("{n} are refuted"),
            },
            evaluated.len(),
            numbers(&others),
        );
        let verdicts = VERDICTS.iter().filter_map(|(verdict, meaning)| {
            let with_it: Vec<&EquationRow> =
                table.equations.iter().filter(|entry| entry.verdict == *verdict).collect();
            let names = [format!("**{}**", verdict.words()), (*meaning).to_owned(), numbers(&with_it)];
            (!with_it.is_empty()).then(|| names.to_vec())
        });
        let [linear, nonlinear] = table.pairs.map(|pairs| count(pairs * table.draws));
        let mut blocks = vec![
            Block::text(&conclusion),
            Block::table(&["equation", "what is wrong in it"], table.in_short()),
            Block::table(&["verdict", "meaning", "equations"], verdicts.collect()),
            Block::heading("How an equation is tested"),
            Block::list(&[
                &format!(
                    "Exactly: over the field of 2^61 - 1 elements, where nothing is rounded, two sides are equal or they are not. A \
                     draw is a random pair of curves at a stationary point. {linear} draws have curves that are linear in their \
                     dofs; {nonlinear} draws have one that is not, such as a helix with its pitch as a dof."
                ),
                &format!(
                    "In `f64`: at {} closest points. The error is the difference of both sides over the larger sum of the absolute \
                     values of their terms.",
                    count(table.points.iter().sum())
                ),
                "A misprint may have several readings. An equation is refuted as printed if every reading of the print is refuted in \
                 some draw.",
                "A row *read otherwise* is evaluated, but it is no reading of the print and does not count for the verdict. It gives a \
                 letter another meaning than the paper does: by (37) û_C stands for u_C − ū_C̄, so Δû_C is not Δd, which \
                 contains the points before the deformation too. In (43), (45) and (46) such a row has variations in place of \
                 finite increments.",
                "As corrected, an equation is valid for curves that are linear in their dofs. As completed, with the terms Δᵤδᵤ, it is valid \
                 for all curves.",
            ]),
        ];
        blocks.extend(table.misprints());
        blocks.extend(table.dropped());
        blocks.extend(table.slip());
        blocks.extend(table.symmetry());
        blocks.push(table.all());
        blocks.extend([
            Block::heading("What this does not say"),
            Block::list(&SILENCE),
            Block::heading("How it was made"),
            Block::text(
                "All numbers are in `equations.json`, from which alone this page is made. `beamgap equations --equation N` shows \
                 one equation whole. [Symbols](symbols.md).",
            ),
            self.environment.table(table.made()),
        ]);
        Page::new("Equations", blocks)
    }
}

/// What is wrong, in a few words.
const MISPRINTS: [(u8, &str); 9] = [
    (16, "δḡ_T is missing from the list"),
    (32, "a stray −δξ̄ in δt̄, and t̄,ξ̄ for t̄,ξ̄ξ̄ in Δδt̄"),
    (39, "Δû_C for Δᵤû_C in the last term"),
    (40, "Δû_C for Δᵤû_C in the last two terms"),
    (42, "a plus sign and a factor t are missing"),
    (49, "bars are missing in the last sum of the second row"),
    (56, "R_Δδ for R̄_Δδ in both second terms"),
    (57, "Δû_C for Δᵤû_C in the last two terms"),
    (58, "1/t³ for 1/t, and a factor t is missing"),
];

impl EquationTable {
    fn made(&self) -> Vec<(&'static str, String)> {
        let two = |[linear, other]: [u64; 2]| format!("{}, {}", count(linear), count(other));
        vec![
            ("seed", format!("{:#x}", self.seed)),
            ("draws for each ordered pair of families", count(self.draws)),
            ("pairs linear in their dofs, and others", two(self.pairs)),
            ("closest points in `f64`, likewise", two(self.points)),
        ]
    }

    /// One row for each equation.
    fn all(&self) -> Block {
        let row = |entry: &EquationRow| {
            let latex =
                if entry.printed.is_empty() { "not there".to_owned() } else { inline(&entry.printed) };
            let place = entry.places.first();
            let place = place.map(|place| format!("`{}`, {}:{}", place.item, place.file, place.line));
            let run = entry.as_printed.linear.total() + entry.as_printed.nonlinear.total() > 0;
            vec![
                entry.number.to_string(),
                entry.says.clone(),
                latex,
                entry.verdict.words().to_owned(),
                refuted([entry.as_printed.linear, entry.as_printed.nonlinear]),
                refuted([entry.as_corrected.linear, entry.as_corrected.nonlinear]),
                if run { error(entry.error()) } else { String::new() },
                place.unwrap_or_default(),
            ]
        };
        let head = [
            "#eq",
            "what",
            "as printed",
            "verdict",
            "#refuted as printed",
            "#as corrected and completed",
            "#error of the print",
            "code",
        ];
        let words = "*Refuted*: draws in which a part of the equation is not equal in any reading, for pairs linear in their dofs \
                     and for others. *Error*: in `f64`; that of (14) is relative to the arc length. *Code*: the item and the line \
                     below `src` that computes it, when this was made.";
        Block::details(
            "All equations",
            vec![Block::text(words), Block::table(&head, self.equations.iter().map(row).collect())],
        )
    }

    /// A row for each misprint.
    fn in_short(&self) -> Vec<Vec<String>> {
        let misprints = self.equations.iter().filter(|entry| entry.verdict == Verdict::Misprint);
        let row = |entry: &EquationRow| {
            let found = MISPRINTS.iter().find(|(number, _)| *number == entry.number);
            let words = found.map_or("see below", |(_, words)| words);
            vec![format!("({}) {}", entry.number, entry.says), words.to_owned()]
        };
        misprints.map(row).collect()
    }

    fn misprints(&self) -> Vec<Block> {
        let mut blocks = vec![Block::heading("Misprints in the scan")];
        for entry in self.equations.iter().filter(|entry| entry.verdict >= Verdict::Misprint) {
            blocks.push(Block::Subheading(format!("({}) {}", entry.number, entry.says)));
            blocks.extend([Block::text("As printed:"), Block::Formula(entry.printed.clone())]);
            if let Some(corrected) = &entry.corrected {
                blocks.extend([
                    Block::text(&format!("{}:", entry.correction())),
                    Block::Formula(corrected.clone()),
                ]);
            }
            if !entry.remark.is_empty() {
                blocks.push(Block::text(&entry.remark));
            }
            if !entry.omitted.is_empty() {
                let left_out: Vec<String> = entry.omitted.iter().map(|term| inline(term)).collect();
                blocks.push(Block::text(&format!("The printed list lacks {}.", left_out.join(", "))));
            }
            if !entry.parts.is_empty() {
                blocks.push(Block::details("Every reading, tested", vec![readings(entry, |_| true)]));
            }
        }
        blocks
    }

    /// The equations that are exact only for curves that are linear in their dofs.
    fn dropped(&self) -> Vec<Block> {
        let mut blocks = vec![
            Block::heading("Terms dropped"),
            Block::text(&format!(
                "The paper drops {} as of higher order. It is of the order of what is kept. It is zero for curves that are \
                 linear in their dofs: segment, Lagrange, Hermite, Bezier, B-spline, and NURBS with fixed weights. It is \
                 missing for all others: NURBS with weights as dofs, arc, helix, and every curve with rotations as dofs.",
                inline(r"\Delta_u\delta_u\mathbf{u}")
            )),
        ];
        for entry in self.equations.iter().filter(|entry| entry.verdict == Verdict::ExactIfLinear) {
            let remark = (!entry.remark.is_empty()).then(|| Block::text(&entry.remark));
            let readings = readings(entry, |run| run.reading != Reading::Other);
            let name = format!("({}) {}", entry.number, entry.says);
            blocks.push(Block::details(&name, remark.into_iter().chain([readings]).collect()));
        }
        blocks
    }

    fn slip(&self) -> [Block; 3] {
        let rows = self.equations.iter().flat_map(|entry| &entry.arcs).map(|arc| {
            let ratio = arc.ratio.map_or_else(|| "rounding".to_owned(), |ratio| format!("{ratio:.1}"));
            vec![arc.family.clone(), arc.slip.to_string(), error(Some(arc.error)), ratio]
        });
        let head = ["family", "#xi_C - xi_C0", "#largest difference / arc length", "#median ratio"];
        [
            Block::heading("Slip along the tangent"),
            Block::text(
                "Equation (14) defines the slip that the program varies, and approximates the arc length (12). Both are equal where \
                 the tangent has constant length along the curve. Elsewhere the leading term of the difference is quadratic in \
                 xi_C - xi_C0. Differences are absolute. *Ratio*: the difference over that for half of xi_C - xi_C0; 4 for a \
                 quadratic term.",
            ),
            Block::table(&head, rows.collect()),
        ]
    }

    fn symmetry(&self) -> Vec<Block> {
        let row = |claim: &Claim| {
            let broken: Vec<String> = claim.broken_by.iter().map(|number| format!("({number})")).collect();
            let holds = if claim.holds() { "yes".to_owned() } else { format!("no: {}", broken.join(", ")) };
            let counts = claim.found.map(|number| number.to_string());
            [claim.says.clone(), claim.made.clone()].into_iter().chain(counts).chain([holds]).collect()
        };
        let by_relations = self.equations.iter().filter(|entry| {
            let is_so = |run: &Run| run.symmetry() == Some(Symmetry::ByRelations);
            entry.parts.iter().any(|part| part.corrected().is_some_and(is_so))
        });
        let numbers: Vec<String> = by_relations.map(|entry| format!("({})", entry.number)).collect();
        let head = [
            "the paper says, or implies",
            "where",
            "#symmetric by form",
            "#by relations",
            "#not symmetric",
            "valid",
        ];
        vec![
            Block::heading("Symmetry"),
            Block::text(
                "A second variation must not change if delta and Delta are exchanged. A formula is symmetric *by form* if it is \
                 symmetric for independent random numbers in place of all operands. It is symmetric *by relations* if it is symmetric \
                 only for the operands of a stationary point, which satisfy relations between them. (25) and (29) need the chain \
                 rule for their total variations. (34) needs (33), which gives Δv. (38), (39), (40) and (57) need that d is normal to \
                 both tangents.",
            ),
            Block::text(
                "The numbers count formulas. As corrected and completed, each part of an equation is one formula. As printed, each \
                 reading of the print is one, so the two numbers differ.",
            ),
            Block::table(&head, self.claims.iter().map(row).collect()),
            Block::text(&format!("Symmetric as corrected, but by relations only: {}.", numbers.join(", "))),
        ]
    }
}

/// Every verdict with its meaning.
const VERDICTS: [(Verdict, &str); 10] = [
    (Verdict::Definition, "gives a quantity its name"),
    (Verdict::List, "names terms, and none is missing"),
    (Verdict::Assumption, "supposes something"),
    (Verdict::NotInTheScan, "missing in the scan, and reconstructed from the text"),
    (Verdict::Exact, "equal in every draw"),
    (Verdict::ExactIfFinite, "equal for finite increments, with a remainder for variations"),
    (Verdict::ExactIfLinear, "equal for curves linear in their dofs, refuted for others"),
    (Verdict::Approximation, "not equal to the quantity that it replaces"),
    (Verdict::Misprint, "refuted as printed, equal as corrected and completed; or a list that lacks a term"),
    (Verdict::Refuted, "also refuted as corrected"),
];

/// Inline LaTeX, fenced so that Markdown does not change it.
fn inline(latex: &str) -> String {
    format!("$`{}`$", latex.replace('\n', " "))
}

const SILENCE: [&str; 5] = [
    "A wrong formula can be equal in a draw, with a small probability that `beamgap prove` states. A refuted formula is certainly \
     wrong.",
    "The print is read from a scan. A misprint may be a fault of the scan.",
    "The reference is the derivative of the definitions and of the curves' positions by hyper-dual numbers. A wrong definition \
     makes both sides wrong.",
    "Closest points lie inside both beams, as in the paper. `beamgap prove` treats ends.",
    "The errors in `f64` are the largest of the errors that were measured. They are no bounds.",
];
