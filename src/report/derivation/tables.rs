//! The tables of the page, and the self-checks, which have their own tables.

use super::equation::number;
use super::inline::{escaped, inline};
use super::math::mathml;
use super::record::Derivation;
use super::symbols;
use std::fmt::Write;

impl Derivation {
    /// A table by its name.
    pub(super) fn table(&self, name: &str) -> Result<String, String> {
        match name {
            "symbols" => symbols::table(),
            "letters" => symbols::others(),
            "newton" => Ok(self.newton_table()),
            "by-hand" => self.by_hand_table(),
            _ => Err(format!("no table is called {name:?}")),
        }
    }

    fn newton_table(&self) -> String {
        let mut head = String::new();
        for run in &self.newton {
            let _ = write!(head, "<th scope=\"col\">{}</th>", escaped(tangent(&run.tangent)));
        }
        let mut rows = String::new();
        for i in 0..=8 {
            let cell = |residuals: &[f64]| residuals.get(i).map_or_else(String::new, |r| format!("{r:.1e}"));
            let mut cells = String::new();
            for run in &self.newton {
                let _ = write!(cells, "<td>{}</td>", cell(&run.residuals).replace('-', "−"));
            }
            let _ = writeln!(rows, "<tr><th scope=\"row\">{i}</th>{cells}</tr>");
        }
        wide("residuals", &format!("<th scope=\"col\">iteration</th>{head}"), &rows)
    }

    fn by_hand_table(&self) -> Result<String, String> {
        let of = &self.by_hand;
        let [a, b, a_bar, det] = of.system;
        let rows = [
            (r"\xi_C", of.at[0], "1/2"),
            (r"\xb_{\bar C}", of.at[1], "0"),
            ("d", of.d, "1/4"),
            ("a", a, "1"),
            ("b", b, "3/5"),
            (r"\bar a", a_bar, "−1"),
            ("D", det, "−16/25"),
            (r"\xi_{,z}", of.gradients[0], "25/128"),
            (r"\xb_{,z}", of.gradients[1], "15/128"),
            ("d_{,z}", of.derivatives[0], "−3/4"),
            ("d_{,zz}", of.derivatives[1], "−25/256"),
        ];
        let mut lines = String::new();
        let mut add = |quantity: &str, value, by_hand| {
            let value = number(value);
            let _ = writeln!(lines, "<tr><td>{quantity}</td><td>{by_hand}</td><td>{value}</td></tr>");
        };
        for (latex, value, by_hand) in rows {
            add(&mathml(latex, false)?, value, by_hand);
        }
        let by_ad = mathml("d_{,zz}", false)? + " by hyper-dual numbers";
        add(&by_ad, of.by_ad[1], "−25/256");
        let head = "<th scope=\"col\">quantity</th><th scope=\"col\">by hand</th><th scope=\"col\">by the program</th>";
        Ok(wide("numbers of the pair that is worked by hand", head, &lines))
    }

    /// A self-check: the number of the effect, then the question, and the answer after a bar.
    pub(super) fn check(&self, argument: &str) -> Result<String, String> {
        let parts: Vec<&str> = argument.splitn(3, " | ").collect();
        let [index, question, answer] = parts[..] else {
            return Err(format!("{argument:?} has not three parts"));
        };
        let effect = index.parse().ok().and_then(|index: usize| self.effects.get(index));
        let effect = effect.ok_or_else(|| format!("there is no effect {index}"))?;
        let names = ["Δδd", "Δδξ", "Δδt", "Δδg_T"];
        let mut rows = String::new();
        for (name, deviation) in names.iter().zip(effect.deviations) {
            let deviation =
                if deviation < 1e-12 { "none".to_owned() } else { format!("{:.1} %", 100.0 * deviation) };
            let _ = writeln!(rows, "<tr><th scope=\"row\">{name}</th><td>{deviation}</td></tr>");
        }
        let symmetry =
            if effect.is_symmetric { "passes, and does not detect it" } else { "fails, and detects it" };
        let exact = self.newton.first().map_or(0, |run| run.residuals.len().saturating_sub(1));
        let newton = match (effect.in_hessian, effect.iterations) {
            (false, _) => "this term has no counterpart in the matrix form of the example".to_owned(),
            (true, Some(n)) => format!("{n} iterations instead of {exact}"),
            (true, None) => format!("does not converge: {}", effect.stopped.as_deref().unwrap_or_default()),
        };
        let table = wide(
            "deviations",
            "<th scope=\"col\">quantity</th><th scope=\"col\">relative deviation</th>",
            &rows,
        );
        let checks = [
            ("comparison with automatic differentiation", "fails, and detects it".to_owned()),
            ("test of symmetry, with the paper's formulas", symmetry.to_owned()),
            ("Newton's method in the example", newton),
        ];
        let checks = checks.iter().fold(String::new(), |rows, (check, result)| {
            rows + &format!("<tr><th scope=\"row\">{check}</th><td>{result}</td></tr>\n")
        });
        let checks =
            wide("three checks", "<th scope=\"col\">check</th><th scope=\"col\">result</th>", &checks);
        Ok(format!(
            "<details class=\"check\">\n<summary>{}</summary>\n<p>{}</p>\n<p>Injected fault: <code>{}</code>, equation {}. In the \
             standard case:</p>\n{table}{checks}</details>\n",
            inline(question)?,
            inline(answer)?,
            escaped(&effect.fault),
            inline(&format!("({})", effect.equation))?,
        ))
    }
}

/// The name of a tangent on the page: that of the record, or the missing term in full.
pub(super) fn tangent(record: &str) -> &str {
    if record == "without d.t,xi" { "without d.t,xi and d.t_bar,xi_bar" } else { record }
}

/// A table that scrolls if it is too wide.
fn wide(name: &str, head: &str, rows: &str) -> String {
    format!(
        "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"{name}\"><table><thead><tr>{head}</tr></thead><tbody>\n\
         {rows}</tbody></table></div>\n"
    )
}
