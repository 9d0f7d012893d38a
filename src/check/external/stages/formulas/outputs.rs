//! The results of the formulas, by their names.

use super::list::FORMULAS;
use super::tree::Name;
use super::values::{Number, Values};
use crate::linearization::{COMPONENTS, Quantity};
use std::sync::LazyLock;

/// A result of the formulas: a number, or a component of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Output {
    pub(super) name: Name,
    pub(super) axis: Option<usize>,
}

impl Output {
    #[inline]
    pub(super) fn of<S: Number>(self, values: &(impl Values<S> + ?Sized)) -> S {
        values.at(self.name).component(self.axis)
    }
}

/// The names of a quantity: value, delta, Delta, Delta-delta. The parameters are inputs.
pub(super) fn names(quantity: Quantity) -> [Option<&'static str>; 4] {
    let [value, rest @ ..] = match quantity {
        Quantity::X => ["x", "dx", "Dx", "H_x"],
        Quantity::XBar => ["x_bar", "dx_bar", "Dx_bar", "H_x_bar"],
        Quantity::DVector => ["d", "dd", "Dd", "H_d"],
        Quantity::TVector => ["t", "dt", "Dt", "H_t"],
        Quantity::TBarVector => ["t_bar", "dt_bar", "Dt_bar", "H_t_bar"],
        Quantity::D => ["|d|", "d|d|", "D|d|", "Dd|d|"],
        Quantity::T => ["|t|", "d|t|", "D|t|", "Dd|t|"],
        Quantity::TBar => ["|t_bar|", "d|t_bar|", "D|t_bar|", "Dd|t_bar|"],
        Quantity::Xi => ["", "dxi", "Dxi", "Ddxi"],
        Quantity::XiBar => ["", "dxi_bar", "Dxi_bar", "Ddxi_bar"],
        Quantity::GN => ["g_N", "dg_N", "Dg_N", "Ddg_N"],
        Quantity::GT => ["g_T", "dg_T", "Dg_T", "Ddg_T"],
        Quantity::GTBar => ["g_T_bar", "dg_T_bar", "Dg_T_bar", "Ddg_T_bar"],
    };
    let [delta, linear, second] = rest.map(Some);
    [Some(value).filter(|name| !name.is_empty()), delta, linear, second]
}

/// The outputs of each component: value, delta, Delta, Delta-delta.
pub(super) static OF_COMPONENTS: LazyLock<Vec<[Option<Output>; 4]>> = LazyLock::new(|| {
    let of = |component: usize| {
        let axis = Quantity::axis_of_component(component).map(|axis| axis as usize - 'x' as usize);
        let output = |name: &str| Output { name: FORMULAS.name(name), axis };
        names(Quantity::of_component(component)).map(|name| name.map(output))
    };
    (0..COMPONENTS).map(of).collect()
});

/// The names of all results of the geometry.
pub(super) static RESULTS: LazyLock<Vec<Name>> = LazyLock::new(|| {
    let of = |quantity: Quantity| names(quantity).into_iter().flatten().map(|name| FORMULAS.name(name));
    Quantity::ALL.into_iter().flat_map(of).collect()
});
