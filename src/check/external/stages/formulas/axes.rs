//! The components of a vector as programs confuse them.

use std::sync::LazyLock;

/// The place of each component, and a factor.
pub(super) type Axes = [(usize, f64); 3];

/// The components of a vector as programs confuse them.
pub(super) static AXES: LazyLock<Vec<(Axes, String)>> = LazyLock::new(axes);

fn axes() -> Vec<(Axes, String)> {
    const NAMES: [&str; 3] = ["x", "y", "z"];
    let right = [0, 1, 2].map(|axis| (axis, 1.0));
    let mut found = Vec::new();
    for (axis, name) in NAMES.into_iter().enumerate() {
        let with = |component: (usize, f64)| {
            let mut axes = right;
            axes[axis] = component;
            axes
        };
        found.push((with((axis, -1.0)), format!("the sign is wrong in the component {name}")));
        found.push((with((axis, 0.0)), format!("the component {name} is left out")));
        for other in (0..3).filter(|other| *other != axis) {
            let words = format!("the component {} stands in the place of {name}", NAMES[other]);
            found.push((with((other, 1.0)), words));
        }
    }
    for order in [[1, 2, 0], [2, 0, 1], [2, 1, 0], [1, 0, 2], [0, 2, 1]] {
        let words =
            format!("the order {} is taken of the components", order.map(|axis| NAMES[axis]).join(", "));
        found.push((order.map(|axis| (axis, 1.0)), words));
    }
    found
}
