//! Published elements as a page, from the record alone.

use super::elements::{ElementErrors, Elements, PublishedElement};
use super::newton::Iterations;
use super::number::{count, error};
use super::page::{Block, Page};

impl Elements {
    /// The page. The same record always gives the same page.
    pub fn page(&self) -> Page {
        let worst =
            |of: &PublishedElement| of.errors.iter().map(|errors| errors.tangent[0]).fold(0.0, f64::max);
        let named = |of: &PublishedElement| format!("{} {}", of.name, error(Some(worst(of))));
        let all: Vec<String> = self.elements.iter().map(named).collect();
        let conclusion = format!(
            "What do published contact elements of beams leave out of their tangents, and what does it cost? **The median relative error \
             of K, in the state with the larger one: {}.**",
            all.join("; ")
        );
        let sources =
            self.elements.iter().map(|of| vec![of.name.clone(), of.lacks.clone(), of.source.clone()]);
        let errors = self.elements.iter().flat_map(|of| of.errors.iter().map(|errors| errors.row(&of.name)));
        let newton = self.elements.iter().flat_map(|of| {
            of.newton.iter().map(|runs| {
                let all = [&runs.derivative, &runs.published];
                let cells = all.into_iter().flat_map(|run| [run.cells()[1].clone(), reached(run)]);
                [of.name.clone(), runs.problem.clone()].into_iter().chain(cells).collect()
            })
        });
        let reasons = self.elements.iter().flat_map(|of| {
            of.newton
                .iter()
                .flat_map(|runs| [&runs.derivative, &runs.published].map(|run| (&runs.problem, run)))
                .filter_map(|(problem, run)| {
                    let why = run.stopped.as_ref()?.split(':').next()?;
                    Some(format!("{}, {problem}, {}: {why}.", of.name, run.tangent))
                })
        });
        let blocks = vec![
            Block::text(&conclusion),
            Block::text(
                "**None of this runs code of others.** Their formulas were read in the files below and written anew in \
                 `src/teaching/published`, for cubic Hermite beams and the normal law -eps g_N. What they do besides, such as \
                 search, damping, other laws and other curves, is not measured. A newer version may differ.",
            ),
            Block::table(
                &["element", "what its tangent lacks", "repository, file, function, commit"],
                sources.collect(),
            ),
            Block::heading("Errors"),
            Block::table(
                &[
                    "element",
                    "state",
                    "#K: median",
                    "#K: largest",
                    "#friction in R: median",
                    "#friction in R: largest",
                ],
                errors.collect(),
            ),
            Block::list(&[
                "*K*: the tangent against the derivative of the residual of the same element, the largest difference over the largest \
                 entry. Of 4C the tangent is written anew from the geometry, with the sign of -K reversed.",
                "*Friction in R*: against the friction that does the work of the force T on the relative velocity. GIRAFFE adds the slips \
                 with a plus sign, e tau + e_bar tau_bar, uses the components along the tangents where the work needs the \
                 products T.tau, and lets them work on grad g_T of eq. (20). The components agree for beams that cross at a right angle.",
                "*Basic stiffness*: 4C uses it where the penetration exceeds its parameter `BEAMS_BASICSTIFFGAP`.",
                "The IPC Toolkit smooths the law of friction at small slips. Only its lagging is measured, with the law of this library: \
                 normal force and tangents of the last iteration. The toolkit also has the other terms, in `force_jacobian`, for the \
                 derivative of a solution.",
            ]),
            Block::heading("Newton's method"),
            Block::text(
                "The sum of the iterations over all steps with contact, or none if a step does not converge in 41 iterations, and the steps \
                 that converge. The problems are those of [beam problems](beam-problems.md), those of 4C with mu = 0. The residual \
                 is that of the element; for the lagged tangent it is the exact one, so each iteration uses the force and the \
                 tangents of the iterate before.",
            ),
            Block::table(
                &["element", "problem", "#derivative of its residual", "#steps", "#as published", "#steps"],
                newton.collect(),
            ),
            Block::List(reasons.collect()),
            Block::text(
                "Where the smallest residual is rounding, the step was solved, and the tangent then amplified rounding until the beams left \
                 the equilibrium. A test of the residual alone would have ended before.",
            ),
            Block::heading("How it was made"),
            Block::text(
                "The pairs are two bent Hermite beams of length 2 that cross at 20 to 160 degrees and penetrate by up to half a radius. Slips \
                 are up to a tenth of the length. Tests compare the sum of all terms with the tangent of the element, and the \
                 tangent with contravariant components with differences of its residual. All numbers are in `elements.json`, from \
                 which alone this page is made.",
            ),
            self.environment.table(vec![
                ("seed", format!("{:#x}", self.seed)),
                ("pairs in each state", count(self.pairs as u64)),
            ]),
        ];
        Page::new("Published contact elements", blocks)
    }
}

impl ElementErrors {
    fn row(&self, name: &str) -> Vec<String> {
        let numbers = [self.tangent, self.residual].concat().into_iter().map(|x| error(Some(x)));
        [name.to_owned(), self.state.clone()].into_iter().chain(numbers).collect()
    }
}

/// The steps that converge, of those with contact.
fn reached(run: &Iterations) -> String {
    format!("{} of {}", run.iterations.len(), run.steps)
}
