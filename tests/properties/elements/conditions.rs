//! What a case must have to show an error, computed from the case as it is written.

use serde_json::Value;

/// A conjunction of conditions.
pub(super) struct Condition(Vec<String>);

impl Condition {
    pub(super) fn new(text: &str) -> Self {
        Self(text.split(" and ").filter(|one| !one.is_empty()).map(str::to_owned).collect())
    }

    /// Whether every case has it.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether a case has it.
    pub(super) fn holds(&self, line: &Value) -> bool {
        line["result"] == "valid" && self.0.iter().all(|one| holds(one, line))
    }
}

fn holds(condition: &str, line: &Value) -> bool {
    let number = |value: &Value| value.as_f64().unwrap();
    let vector = |beam: &str, name: &str| [0, 1, 2].map(|c| number(&line["jets"][beam][name][c]));
    let dot = |u: [f64; 3], v: [f64; 3]| (0..3).map(|c| u[c] * v[c]).sum::<f64>();
    let (x, x_bar) = (vector("beam", "x"), vector("bar", "x"));
    let d = [0, 1, 2].map(|c| x[c] - x_bar[c]);
    let (t, t_bar) = (vector("beam", "t"), vector("bar", "t"));
    let cross = [0, 1, 2].map(|c| t[(c + 1) % 3] * t_bar[(c + 2) % 3] - t[(c + 2) % 3] * t_bar[(c + 1) % 3]);
    let xi = number(&line["point"]["xi"]);
    let xi_bar = number(&line["point"]["xi_bar"]);
    // An angle of at most 0.1 rad.
    let is_parallel = dot(cross, cross) <= 0.01 * dot(t, t) * dot(t_bar, t_bar);
    match condition {
        "free" => line["held"] == "none",
        "not free" => line["held"] != "none",
        "held = xi" => line["held"] == "xi",
        "held = xi_bar" => line["held"] == "xi_bar",
        "parallel" => is_parallel,
        "not parallel" => !is_parallel,
        "xi < 0" => xi < 0.0,
        "xi > 0" => xi > 0.0,
        "xi_bar < 0" => xi_bar < 0.0,
        "xi_bar > 0" => xi_bar > 0.0,
        "xi < xi_0" => xi < number(&line["contact"]["xi_0"]),
        "d.x < 0" => d[0] < 0.0,
        "d.z < 0" => d[2] < 0.0,
        "t.t_bar < 0" => dot(t, t_bar) < 0.0,
        "d.t_xi < 0" => dot(d, vector("beam", "t_xi")) < 0.0,
        "d.t_bar_xi > 0" => dot(d, vector("bar", "t_xi")) > 0.0,
        "d.(t x t_bar) < 0" => dot(d, cross) < 0.0,
        _ => panic!("no condition: {condition}"),
    }
}
