//! Which form is taken at a point.

use crate::closest_point::Active;
use crate::linearization::closed_form::form::{Distance, Elimination, Squares};
use crate::linearization::closed_form::{Form, Points};
use crate::number::{Lanes, Real};

/// A form for a point.
#[derive(Clone, Copy)]
pub(super) struct Chosen<T> {
    pub(super) form: Form,
    /// The sign of its normal to t × t_bar: that of the form but where lanes differ.
    pub(super) sign: T,
    /// The lanes, by bits, for which the form does not hold.
    pub(super) exceptions: u8,
}

impl<T: Real> Chosen<T> {
    #[inline(always)]
    fn new(form: Form) -> Self {
        Self { form, sign: T::from(form.sign().unwrap_or(1.0)), exceptions: 0 }
    }

    /// Along the normal with this sign, inside both beams.
    #[inline(always)]
    fn along_normal(sign: T, exceptions: u8) -> Self {
        let form = Form {
            active: Active { xi: false, xi_bar: false },
            distance: Distance::Normal { reversed: false },
            system: Elimination::Products,
        };
        Self { form, sign, exceptions }
    }
}

/// A choice between the forms.
pub(super) trait Choice<T> {
    /// The form at a point with these products; nothing if it is not among the choices.
    fn choose(
        self,
        squares: impl FnOnce() -> Squares<T>,
        points: impl FnOnce() -> Points<T>,
    ) -> Option<Chosen<T>>;
}

/// The common normal and the paper's system, inside both beams, where no other form keeps more digits.
#[derive(Clone, Copy)]
pub(super) struct Regular;

impl Choice<f64> for Regular {
    #[inline(always)]
    fn choose(
        self,
        squares: impl FnOnce() -> Squares<f64>,
        _: impl FnOnce() -> Points<f64>,
    ) -> Option<Chosen<f64>> {
        let squares = squares();
        squares.is_regular().then(
            #[inline(always)]
            || Chosen::along_normal(1.0_f64.copysign(squares.c_d), 0),
        )
    }
}

impl Choice<Lanes> for Regular {
    #[inline(always)]
    fn choose(
        self,
        squares: impl FnOnce() -> Squares<Lanes>,
        _: impl FnOnce() -> Points<Lanes>,
    ) -> Option<Chosen<Lanes>> {
        let squares = squares();
        let mut exceptions = 0;
        let mut sign = Lanes([1.0; 4]);
        for lane in 0..4 {
            let regular = squares.map(
                #[inline(always)]
                |x| x.0[lane],
            );
            exceptions |= u8::from(!regular.is_regular()) << lane;
            sign.0[lane] = sign.0[lane].copysign(squares.c_d.0[lane]);
        }
        (exceptions != ALL).then(
            #[inline(always)]
            || Chosen::along_normal(sign, exceptions),
        )
    }
}

/// All four lanes.
pub(super) const ALL: u8 = 0b1111;

/// The form that loses the fewest digits.
#[derive(Clone, Copy)]
pub(super) struct Best(pub(super) Active);

impl Choice<f64> for Best {
    #[inline]
    fn choose(
        self,
        _: impl FnOnce() -> Squares<f64>,
        points: impl FnOnce() -> Points<f64>,
    ) -> Option<Chosen<f64>> {
        Some(Chosen::new(Form::at(&points(), self.0)))
    }
}

/// The form given.
#[derive(Clone, Copy)]
pub(super) struct Given(pub(super) Form);

impl<T: Real> Choice<T> for Given {
    #[inline]
    fn choose(self, _: impl FnOnce() -> Squares<T>, _: impl FnOnce() -> Points<T>) -> Option<Chosen<T>> {
        Some(Chosen::new(self.0))
    }
}
