//! The conventions of another program, stated in the head of its answers, and the conversion to them.
//!
//! The references are converted and not the answers, in the arithmetic that bounds rounding. A squared
//! distance, for example, has its own tolerance. The order and the scale of dofs are those of the directions that
//! gradients and Hessians are contracted with.

mod dofs;
mod forces;
mod others;
mod triangle;

use crate::check::element::ElementAt;
use crate::linearization::Varied;
use crate::linearization::closed_form::Formulation;
use crate::number::Real;
pub use dofs::Dofs;
pub use forces::ForceConventions;
pub use triangle::Triangle;

/// The item of the work of the contact element, after the components of the quantities: the penalty energy, or the virtual
/// work. The items after it are those of [`STATE_AND_FORCES`].
pub(super) const ENERGY: usize = crate::linearization::COMPONENTS;
/// State and forces of a contact element with friction, by their names in the answers. The state is its index in
/// [`State::ALL`](crate::contact::State::ALL).
pub(super) const STATE_AND_FORCES: [&str; 4] = ["state", "F_N", "F", "F_bar"];

/// The range of the parameters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Range {
    /// [-1, 1].
    #[default]
    Symmetric,
    /// [0, 1].
    Unit,
}

/// The meaning of d.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Length {
    /// The distance.
    #[default]
    Distance,
    /// Its square.
    Square,
    /// Half its square.
    HalfSquared,
}

/// The conventions of a program.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a choice of its own")]
pub struct Conventions {
    /// The range of the parameters.
    pub parameter: Range,
    /// Whether the vector d is x_bar - x.
    pub d_is_negative: bool,
    /// The meaning of d.
    pub length: Length,
    /// Whether the gap is the penetration r + r_bar - d.
    pub gap_is_negative: bool,
    /// The order of the dofs.
    pub dofs: Dofs,
    /// Whether the dofs of the bar beam come first.
    pub bar_first: bool,
    /// Whether Hessians and tangents are written column by column.
    pub column_major: bool,
    /// The part of Hessians and tangents that is answered.
    pub triangle: Triangle,
    /// d x/d xi of a Hermite beam over its dof: 1, or half the length if the dofs are unit tangents.
    pub hermite_tangent: f64,
    /// Whether the residual of a contact element has the opposite sign.
    pub residual_is_negative: bool,
    /// Whether its tangent has the opposite sign.
    pub tangent_is_negative: bool,
    /// Its forces.
    pub forces: ForceConventions,
    /// The contact element, if there is one.
    pub penalty: Option<Penalty>,
    /// The first index of rows and columns, in answers that have indices.
    pub first_index: usize,
    /// Whether null stands for a dof that the element does not have.
    pub null_is_no_dof: bool,
}

/// A contact element with the energy stiffness g_N²/2. Its residual is the gradient and its tangent the Hessian of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalty {
    /// The penalty stiffness.
    pub stiffness: f64,
    /// Whether it is active at an open gap too.
    pub always: bool,
}

impl Default for Conventions {
    fn default() -> Self {
        Self {
            parameter: Range::default(),
            d_is_negative: false,
            length: Length::default(),
            gap_is_negative: false,
            dofs: Dofs::default(),
            bar_first: false,
            column_major: false,
            triangle: Triangle::default(),
            hermite_tangent: 1.0,
            residual_is_negative: false,
            tangent_is_negative: false,
            forces: ForceConventions::default(),
            penalty: None,
            first_index: 0,
            null_is_no_dof: false,
        }
    }
}

/// The keys of the head, each with its values. The first value is the default.
pub(super) const KEYS: [(&str, &[&str]); 19] = [
    ("parameter", &["[-1,1]", "[0,1]"]),
    ("d", &["x - x_bar", "x_bar - x"]),
    ("distance", &["d", "d^2", "d^2/2"]),
    ("gap", &["d - r - r_bar", "r + r_bar - d"]),
    ("dofs", &["node-major", "component-major", "component-major over both beams"]),
    ("beams", &["beam first", "bar first"]),
    ("matrix", &["row-major", "column-major"]),
    ("triangle", &["both", "upper", "lower"]),
    ("residual_sign", &["+", "-"]),
    ("tangent_sign", &["+", "-"]),
    ("normal_force", &["positive in compression", "negative in compression"]),
    ("friction_force", &["on the beam", "on the bar beam"]),
    ("friction_components", &["covariant", "contravariant"]),
    ("F_bar", &["along -t_bar", "along t_bar"]),
    ("first_index", &["0", "1"]),
    ("penalty_active", &["penetration", "always"]),
    ("penalty_stiffness", &[]),
    ("hermite_tangent", &[]),
    ("null", &["not a number", "no dof"]),
];

impl Conventions {
    /// The values of a key; none if it is unknown.
    fn values(key: &str) -> &'static [&'static str] {
        KEYS.iter().find(|(known, _)| *known == key).map_or(&[], |(_, values)| values)
    }

    /// Sets an entry of the head.
    ///
    /// # Errors
    /// What was expected, if the key or the value is unknown.
    pub(super) fn set(&mut self, key: &str, value: &str) -> Result<(), String> {
        let Some((_, values)) = KEYS.iter().find(|(known, _)| *known == key) else {
            let known: Vec<_> = KEYS.iter().map(|(key, _)| *key).collect();
            return Err(format!("{key}: no such entry, expected {}", known.join(", ")));
        };
        let positive = || {
            let number = super::number::parse(value).ok().filter(|x| x.is_finite() && *x > 0.0);
            number.ok_or_else(|| format!("{key}: a positive number expected, found {value:?}"))
        };
        let plain = |text: &str| text.replace([' ', '\''], "");
        let choice = || {
            let chosen = values.iter().position(|known| plain(known) == plain(value));
            chosen.ok_or_else(|| format!("{key}: one of {values:?} expected, found {value:?}"))
        };
        let penalty = self.penalty.unwrap_or(Penalty { stiffness: 1.0, always: false });
        match key {
            "parameter" => self.parameter = [Range::Symmetric, Range::Unit][choice()?],
            "d" => self.d_is_negative = choice()? == 1,
            "distance" => self.length = [Length::Distance, Length::Square, Length::HalfSquared][choice()?],
            "gap" => self.gap_is_negative = choice()? == 1,
            "dofs" => {
                let orders = [Dofs::NodeMajor, Dofs::ComponentMajor, Dofs::PairComponentMajor];
                self.dofs = orders[choice()?];
            }
            "beams" => self.bar_first = choice()? == 1,
            "matrix" => self.column_major = choice()? == 1,
            "triangle" => self.triangle = [Triangle::Both, Triangle::Upper, Triangle::Lower][choice()?],
            "residual_sign" => self.residual_is_negative = choice()? == 1,
            "tangent_sign" => self.tangent_is_negative = choice()? == 1,
            "normal_force" => self.forces.compression_is_negative = choice()? == 1,
            "friction_force" => self.forces.on_bar = choice()? == 1,
            "friction_components" => self.forces.contravariant = choice()? == 1,
            "F_bar" => self.forces.along_bar_tangent = choice()? == 1,
            "first_index" => self.first_index = choice()?,
            "null" => self.null_is_no_dof = choice()? == 1,
            "penalty_active" => self.penalty = Some(Penalty { always: choice()? == 1, ..penalty }),
            "penalty_stiffness" => self.penalty = Some(Penalty { stiffness: positive()?, ..penalty }),
            _ => self.hermite_tangent = positive()?,
        }
        Ok(())
    }

    /// All components of the quantities, the work and the forces of the contact element, in the conventions of the program.
    ///
    /// The work is that of the element of the case, if it has one, with the quantities in the formulas `form`.
    pub(super) fn of<T: Real>(
        &self,
        all: &[Varied<T>],
        is_closed: bool,
        element: Option<&ElementAt>,
        form: Formulation,
    ) -> Vec<Varied<T>> {
        let (half, two) = (T::from(0.5), T::from(2.0));
        let times = |v: Varied<T>, f: T| Varied {
            value: v.value * f,
            delta: v.delta * f,
            linear: v.linear * f,
            second: v.second * f,
        };
        let square = |v: Varied<T>, f: T| Varied {
            value: v.value * v.value * f,
            delta: v.value * v.delta * two * f,
            linear: v.value * v.linear * two * f,
            second: (v.delta * v.linear + v.value * v.second) * two * f,
        };
        let mut converted = all.to_vec();
        if self.d_is_negative {
            converted[6..9].iter_mut().for_each(|v| *v = times(*v, -T::one()));
        }
        if self.gap_is_negative {
            converted[20] = times(converted[20], -T::one());
        }
        if self.parameter == Range::Unit {
            // η = (ξ + 1)/2, so that dx/dη = 2 dx/dξ. The slips do not change.
            for i in (9..15).chain([16, 17]) {
                converted[i] = times(converted[i], two);
            }
            for i in [18, 19] {
                converted[i] = times(Varied { value: converted[i].value + T::one(), ..converted[i] }, half);
            }
        }
        match self.length {
            Length::Distance => {}
            Length::Square => converted[15] = square(converted[15], T::one()),
            Length::HalfSquared => converted[15] = square(converted[15], half),
        }
        let nothing = Varied::constant(T::zero());
        let penalty = || {
            let active = self.penalty.filter(|penalty| penalty.always || is_closed);
            active.map_or(nothing, |penalty| square(all[20], half * T::from(penalty.stiffness)))
        };
        let of_element = element.and_then(|element| element.numbers(all, form));
        let (energy, forces) = of_element
            .map_or_else(|| (penalty(), [nothing; 4]), |(work, forces)| (work, self.forces.of(&forces)));
        let sign = |is_negative| if is_negative { -T::one() } else { T::one() };
        let (residual, tangent) = (sign(self.residual_is_negative), sign(self.tangent_is_negative));
        converted.push(Varied {
            value: energy.value,
            delta: energy.delta * residual,
            linear: energy.linear * residual,
            second: energy.second * tangent,
        });
        converted.extend(forces);
        converted
    }
}
