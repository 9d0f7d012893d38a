//! Which form is taken at a point.

use crate::closest_point::Active;
use crate::linearization::closed_form::{Form, Points};
use crate::number::{Lanes, Real};

/// A form for a point.
#[derive(Clone, Copy)]
pub(super) struct Chosen<T> {
    pub(super) form: Form,
    /// The sign of its normal to t × t_bar: that of the form but where lanes differ.
    pub(super) sign: T,
}

impl<T: Real> Chosen<T> {
    #[inline(always)]
    fn new(form: Form) -> Self {
        Self { form, sign: T::from(form.sign().unwrap_or(1.0)) }
    }

    /// The paper's, inside both beams.
    #[inline(always)]
    fn plain() -> Self {
        Self { form: Form::paper(Active { xi: false, xi_bar: false }), sign: T::one() }
    }
}

/// A choice between the forms.
pub(super) trait Choice<T> {
    /// The form at a point where t·t, t̄·t̄, t·t̄ and d·d are `squares`; nothing if it is not among the choices.
    fn choose(self, squares: [T; 4], points: impl FnOnce() -> Points<T>) -> Option<Chosen<T>>;
}

/// The paper's form inside both beams, where no other keeps more digits.
#[derive(Clone, Copy)]
pub(super) struct Plain;

impl Choice<f64> for Plain {
    #[inline(always)]
    fn choose(self, squares: [f64; 4], _: impl FnOnce() -> Points<f64>) -> Option<Chosen<f64>> {
        if Form::is_plain(squares) { Some(Chosen::plain()) } else { None }
    }
}

impl Choice<Lanes> for Plain {
    #[inline(always)]
    fn choose(self, squares: [Lanes; 4], _: impl FnOnce() -> Points<Lanes>) -> Option<Chosen<Lanes>> {
        let [t2, t_bar2, b, d2] = squares;
        let plain = (0..4).all(|i| Form::is_plain([t2.0[i], t_bar2.0[i], b.0[i], d2.0[i]]));
        if plain { Some(Chosen::plain()) } else { None }
    }
}

/// The form that loses the fewest digits.
#[derive(Clone, Copy)]
pub(super) struct Best(pub(super) Active);

impl Choice<f64> for Best {
    #[inline]
    fn choose(self, _: [f64; 4], points: impl FnOnce() -> Points<f64>) -> Option<Chosen<f64>> {
        Some(Chosen::new(Form::at(&points(), self.0)))
    }
}

impl Choice<Lanes> for Best {
    /// One for all lanes, but for the sign of the normal.
    #[inline]
    fn choose(self, _: [Lanes; 4], points: impl FnOnce() -> Points<Lanes>) -> Option<Chosen<Lanes>> {
        let points = points();
        let forms = [0, 1, 2, 3].map(|lane| Form::at(&points.map(|x: Lanes| x.0[lane]), self.0));
        let alike = forms.iter().all(|form| *form == forms[0] || *form == forms[0].reversed());
        let sign = Lanes(forms.map(|form| form.sign().unwrap_or(1.0)));
        alike.then_some(Chosen { form: forms[0], sign })
    }
}

/// The form given.
#[derive(Clone, Copy)]
pub(super) struct Given(pub(super) Form);

impl<T: Real> Choice<T> for Given {
    #[inline]
    fn choose(self, _: [T; 4], _: impl FnOnce() -> Points<T>) -> Option<Chosen<T>> {
        Some(Chosen::new(self.0))
    }
}
