//! The beam problems as a page, from the record alone.

use super::beam_pictures::file_name;
use super::beam_problems::{BeamProblem, BeamProblems, NOTHING};
use super::newton::Iterations;
use super::number::{count, error, plain};
use super::page::{Block, Page};

impl BeamProblems {
    /// The page. The same record always gives the same page.
    pub fn page(&self) -> Page {
        let steps: usize = self.problems.iter().map(|problem| problem.steps.len()).sum();
        let exact = || self.problems.iter().filter_map(BeamProblem::exact);
        let most = exact().map(Iterations::most).max().unwrap_or(0);
        let least = self.problems.iter().filter_map(|problem| problem.order).min_by(f64::total_cmp);
        let (mut slower, mut failed, mut all) = (0, 0, 0);
        for problem in &self.problems {
            let sum = problem.exact().map_or(0, Iterations::sum);
            for run in problem.runs.iter().filter(|run| run.tangent != NOTHING) {
                all += 1;
                failed += u64::from(run.stopped.is_some());
                slower += u64::from(run.stopped.is_none() && run.sum() > sum);
            }
        }
        let conclusion = format!(
            "Does Newton's method converge with the contact element, and does it need every term? **With the exact tangent it converges \
             in all {} steps of {} problems, in at most {most} iterations and with an order of at least {}. Of {} runs without a term of the tangent, {} do not reach the \
             end, and {} need more iterations.**",
            count(steps as u64),
            self.problems.len(),
            least.map_or_else(|| "-".to_owned(), |order| format!("{order:.2}")),
            count(all),
            count(failed),
            count(slower),
        );
        let mut blocks = vec![
            Block::text(&conclusion),
            Block::text(
                "The beams are chains of cubic Hermite elements without shear and torsion. The residual is always exact; only the tangent \
                 of the contact lacks a term. A step has converged when the residual and the displacement of every node are small. \
                 `cargo run --release --example beam_problems` prints the same.",
            ),
        ];
        for problem in &self.problems {
            blocks.extend(problem.blocks());
        }
        blocks.extend([
            Block::heading("What the numbers do not say"),
            Block::list(&[
                "*Order*: ln(e4/e2)/ln(e3/e1) of the last four energy norms sqrt(|R.du|) above rounding. Newton's method runs once more in \
                 double-double arithmetic for it. In straight thin beams the norms alternate by a constant factor: bending by b \
                 strains the axis by its square, and a strain s changes the next bending by b s. This factor has no effect on the order.",
                "*Factor*: the largest increment over the square of the one before it, of increments below 1e-2 and above rounding. If \
                 convergence is quadratic in every step, it is a constant of the problem, of the size of EA/EI: bending by an \
                 increment strains the beam by its square. If convergence is linear, it grows without limit.",
                "A residual that is small once need not stay small. The crossed beams are symmetric, and without some terms each iteration \
                 amplifies what is not: rounding grows until the beams leave the equilibrium. A test of the residual alone would \
                 have ended before.",
                "A run that fails may succeed with smaller steps.",
            ]),
            Block::heading("How it was made"),
            Block::text(
                "All numbers, and why a run ended, are in `beam-problems.json`, from which alone this page and its pictures are made. The problems are in \
                 `src/teaching/chains`.",
            ),
            self.environment.table(Vec::new()),
        ]);
        Page::new("Beam problems", blocks)
    }
}

impl BeamProblem {
    /// The run with the exact tangent.
    fn exact(&self) -> Option<&Iterations> {
        self.runs.iter().find(|run| run.tangent == NOTHING)
    }

    fn blocks(&self) -> Vec<Block> {
        let steps: Vec<Vec<String>> = self
            .steps
            .iter()
            .enumerate()
            .map(|(i, step)| {
                let order = step.order.map_or_else(|| "-".to_owned(), |order| format!("{order:.2}"));
                let residuals: Vec<String> = step.residuals.iter().map(|&r| error(Some(r))).collect();
                let owner = step.owner.map(|element| (element + 1).to_string()).join(", ");
                let force = if step.f_n > 0.0 { format!("{:.7e}", step.f_n) } else { "0".to_owned() };
                vec![
                    (i + 1).to_string(),
                    step.state.clone(),
                    owner,
                    force,
                    plain(step.friction),
                    order,
                    residuals.join(" "),
                ]
            })
            .collect();
        let head = ["#step", "state", "elements", "#F_N", "#|T|/F_N", "#order", "residuals"];
        let runs = self.runs.iter().map(|run| {
            let [iterations, sum] = run.cells();
            let factor = run.quadratic_factor.map_or_else(|| "-".to_owned(), |factor| error(Some(factor)));
            vec![format!("`{}`", run.tangent), iterations, sum, factor]
        });
        let mut blocks = vec![Block::heading(&self.name)];
        let order =
            self.order.map(|order| format!(" The order of convergence is at least {order:.2} in each step."));
        blocks.push(Block::text(&format!(
            "mu = {}, EA/EI = {}. The exact tangent needs {} iterations.{}",
            self.mu,
            plain(self.stiffness),
            self.exact().map_or(0, Iterations::sum),
            order.unwrap_or_default(),
        )));
        let picture = |what: &str, caption: &str, svg: String| Block::Picture {
            file: format!("beam-problems-{}-{what}.svg", file_name(&self.name)),
            caption: caption.to_owned(),
            svg,
        };
        if !self.convergence.is_empty() {
            blocks.push(picture(
                "beams",
                "Both beams, to scale, from the side and above. Dashed: earlier steps.",
                self.beams_to_svg(),
            ));
            blocks.push(picture(
                "newton",
                "One step that begins at the exact equilibrium. A tangent with which it ends with an error is not drawn.",
                self.newton_to_svg(),
            ));
        }
        blocks.push(Block::table(
            &["left out of the tangent", "iterations in each step with contact", "#sum", "#factor"],
            runs.collect(),
        ));
        let mut details = vec![Block::table(&head, steps)];
        if let Some(tip) = self.tip {
            let tip = tip.map(|x| format!("{x:.10e}")).join(", ");
            details.push(Block::text(&format!("The tip of the beam moves by ({tip}).")));
        }
        blocks.push(Block::details("The steps with the exact tangent", details));
        blocks
    }
}
