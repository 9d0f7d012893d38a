//! Jets of two beams at a stationary point over the prime field, with no number equal to zero.
//!
//! They belong to no family. The closed form uses only the jet of a curve. A jet with two control vectors and any
//! shape functions has all terms, with the fewest operations.

use crate::closest_point::Held;
use crate::contact::{BlockMatrix, Contribution, State, Values, Work, closed_form};
use crate::curve::{Geometry, Jet, Shapes};
use crate::linearization::closed_form::formulation::{Distance, System};
use crate::linearization::closed_form::kernel::{Gradient, Target};
use crate::linearization::closed_form::{Formulation, Matrices, PartialVariations, variations_in};
use crate::linearization::{Derivatives, Linearization};
use crate::number::{Bits, Faulty, PrimeField, Traced};
use crate::pair::{Contact, DofVector};
use crate::prove::Situation;
use crate::test_beam::{Padded, PaddedBeam, map_padded, normal_to_free};
use crate::variant::{CONTACT, Kind, Second, kernel};
use nalgebra::{SMatrix, SVector, Vector3};
use num_traits::Zero;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// The dofs of a beam: two control vectors.
const D: usize = 6;
type Scalar = Faulty<Traced>;
type Beam = PaddedBeam<Scalar, D>;
type Memory = Second<Scalar, D, D, { 2 * D }, { D * (2 * D + 1) }>;

/// Two beams in a formulation, with the values that can replace theirs.
pub(super) struct Place {
    pub(super) name: &'static str,
    form: Formulation,
    /// Whether the kernel is run in all layouts.
    everywhere: bool,
    /// Linear in their dofs, and not.
    linear: [Runs; 2],
}

/// Two beams, and the same beams at other parameters.
struct Runs {
    now: [Beam; 2],
    before: [Beam; 2],
    at: (PrimeField, PrimeField),
    at_before: (PrimeField, PrimeField),
}

/// The name of a code, the possible replacements of its operands, and the code.
type Named<'a> = (&'static str, &'static [Kind], Box<dyn Fn(Option<Kind>) -> Vec<u64> + Sync + 'a>);

impl Place {
    /// Inside both beams in every formulation, and at the ends.
    pub(super) fn all(rng: &mut ChaCha8Rng) -> Vec<Self> {
        let none = Held::default();
        let normal = Distance::Normal { reversed: false };
        let ends = |xi, xi_bar| Formulation::paper(Held { xi, xi_bar });
        let forms = [
            ("length, determinants", Formulation::paper(none)),
            (
                "normal, determinants",
                Formulation { held: none, distance: normal, system: System::Determinants },
            ),
            ("normal, cross", Formulation { held: none, distance: normal, system: System::CrossProducts }),
            ("xi at an end", ends(true, false)),
            ("xi_bar at an end", ends(false, true)),
            ("both at ends", ends(true, true)),
        ];
        let place = |(i, (name, form)): (usize, (&'static str, Formulation))| Self {
            name,
            form,
            everywhere: i == 1,
            linear: [true, false].map(|is_linear| Runs::new(form.held, is_linear, rng)),
        };
        forms.into_iter().enumerate().map(place).collect()
    }

    /// The equations, the matrices and the kernel.
    pub(super) fn codes(&self) -> Vec<Named<'_>> {
        const VARIATIONS: &[Kind] = &[Kind::Transposed, Kind::Swapped, Kind::BarForgotten, Kind::Stale];
        const MATRICES: &[Kind] = &[Kind::Swapped, Kind::BarForgotten, Kind::Stale];
        let [linear, nonlinear] = &self.linear;
        let partial = [None].into_iter().chain(VARIATIONS.iter().map(|&kind| Some(kind)));
        let partial: Vec<_> = partial.map(|kind| (kind, nonlinear.partial_variations(kind))).collect();
        let mut codes: Vec<Named<'_>> = vec![
            ("equations", VARIATIONS, Box::new(move |kind| self.equations(&partial, kind))),
            ("matrices, curves linear in their dofs", MATRICES, Box::new(|kind| self.matrices(linear, kind))),
            ("matrices, other curves", MATRICES, Box::new(|kind| self.matrices(nonlinear, kind))),
        ];
        let [blocks, full, packed] = Memory::ALL;
        for (name, element) in self.elements() {
            codes.push((name, MATRICES, Box::new(move |kind| self.element(nonlinear, kind, &element))));
        }
        codes.push(("kernel, full", MATRICES, Box::new(move |kind| self.kernel(linear, kind, full))));
        if self.everywhere {
            codes.push(("kernel, blocks", MATRICES, Box::new(move |kind| self.kernel(linear, kind, blocks))));
            codes.push(("kernel, packed", MATRICES, Box::new(move |kind| self.kernel(linear, kind, packed))));
            let gradient = Gradient::<Scalar, { 2 * D }>::zeros;
            codes.push((
                "kernel, gradient",
                MATRICES,
                Box::new(move |kind| self.kernel(linear, kind, gradient)),
            ));
        }
        codes
    }

    fn equations(
        &self,
        partial: &[(Option<Kind>, Mistaken<PartialVariations<Scalar>>)],
        kind: Option<Kind>,
    ) -> Vec<u64> {
        let Some((_, ([beam, bar], at, contact))) = partial.iter().find(|(of, _)| *of == kind) else {
            return Vec::new();
        };
        let components = variations_in(self.form, beam, bar, *at, contact).components();
        components.into_iter().flat_map(|varied| varied.parts().map(|part| part.0.bits())).collect()
    }

    fn matrices(&self, runs: &Runs, kind: Option<Kind>) -> Vec<u64> {
        let ([(jet, _), (jet_bar, _)], at, contact) = runs.beams(kind);
        let mut all = Linearization::zeros();
        if let (Some(jet), Some(jet_bar)) = (by_shapes(jet), by_shapes(jet_bar)) {
            Matrices::in_formulation(&jet, &jet_bar, self.form).write_all(at, &contact, &mut all);
        } else {
            Matrices::in_formulation(jet, jet_bar, self.form).write_all(at, &contact, &mut all);
        }
        let Linearization { d, t, t_bar, xi, xi_bar, g_t, g_t_bar, radii } = all;
        let quantities = [&d, &t, &t_bar, &xi, &xi_bar, &g_t, &g_t_bar];
        quantities.into_iter().flat_map(numbers).chain([radii.0.bits()]).collect()
    }

    /// The contact elements of this place: in every state with both kinds of work if all parts of the geometry are used, else in
    /// slip.
    fn elements(&self) -> Vec<(&'static str, Situation)> {
        let element = |state, work| Situation::of_state(state, work, self.form.held);
        let frictionless = ("contact element, frictionless", element(State::Frictionless, Work::Rate));
        let slip = ("contact element, the paper's work, slip", element(State::Slip, Work::Paper));
        match (self.form.held.xi, self.form.held.xi_bar) {
            (true, true) => vec![frictionless],
            (false, false) if self.form == Formulation::paper(Held::default()) => vec![
                frictionless,
                ("contact element, stick", element(State::Stick, Work::Rate)),
                ("contact element, slip", element(State::Slip, Work::Rate)),
                ("contact element, the paper's work, stick", element(State::Stick, Work::Paper)),
                slip,
            ],
            _ => vec![slip],
        }
    }

    /// Residual, tangent, and the values that are returned with them.
    fn element(&self, runs: &Runs, kind: Option<Kind>, element: &Situation) -> Vec<u64> {
        let ([(jet, _), (jet_bar, _)], at, contact) = runs.beams(kind);
        let mut to = Contribution::zeros();
        let values = closed_form::write(&element.decision(contact, self.form), (jet, jet_bar), at, &mut to);
        let Contribution { residual: DofVector { beam, bar }, tangent, .. } = &to;
        let BlockMatrix { beam: own, bar_beam, beam_bar, bar: other } = tangent;
        let blocks = own.iter().chain(bar_beam).chain(beam_bar).chain(other);
        let Values { g_n, normal, f_n, traction, f, f_bar, g_t, g_t_bar, e, e_bar, rho, yield_ratio } =
            values;
        let scalars = [g_n, f_n, f, f_bar, g_t, g_t_bar, e, e_bar, rho, yield_ratio];
        let values = normal.iter().chain(&traction).chain(&scalars);
        beam.iter().chain(bar).chain(blocks).chain(values).map(|number| number.0.bits()).collect()
    }

    fn kernel<W: Target<Scalar, D, D>>(
        &self,
        runs: &Runs,
        kind: Option<Kind>,
        memory: fn() -> W,
    ) -> Vec<u64> {
        let ([beam, bar], at, contact) = runs.beams(kind);
        let beams = [beam.clone(), bar.clone()];
        let all = kernel::<_, _, D, D, D>(&beams, at, self.form, &contact, memory);
        all.into_iter().flatten().flat_map(|mut quantity| written(&mut quantity)).collect()
    }
}

/// Two beams, their parameters and their contact, original or with replacements.
type Mistaken<B> = ([B; 2], (Scalar, Scalar), Contact);

impl Runs {
    fn new(held: Held, is_linear: bool, rng: &mut ChaCha8Rng) -> Self {
        let mut residue = || PrimeField::new(rng.random());
        let (at, at_before) = ((residue(), residue()), (residue(), residue()));
        let [now, before] =
            [(); 2].map(|()| stationary(held, rng).map(|geometry| beam(geometry, is_linear, rng)));
        Self { now, before, at, at_before }
    }

    fn beams(&self, kind: Option<Kind>) -> Mistaken<&Beam> {
        let [beam, bar] = &self.now;
        let faulty = |(xi, xi_bar)| (traced(xi), traced(xi_bar));
        let Contact { radius, radius_bar, xi_0, xi_bar_0 } = CONTACT;
        match kind {
            Some(Kind::Swapped) => {
                let contact =
                    Contact { radius: radius_bar, radius_bar: radius, xi_0: xi_bar_0, xi_bar_0: xi_0 };
                ([bar, beam], faulty((self.at.1, self.at.0)), contact)
            }
            Some(Kind::BarForgotten) => (
                [beam, beam],
                faulty((self.at.0, self.at.0)),
                Contact { radius_bar: radius, xi_bar_0: xi_0, ..CONTACT },
            ),
            Some(Kind::Stale) => (self.before.each_ref(), faulty(self.at_before), CONTACT),
            _ => ([beam, bar], faulty(self.at), CONTACT),
        }
    }

    fn partial_variations(&self, kind: Option<Kind>) -> Mistaken<PartialVariations<Scalar>> {
        let (beams, at, contact) = self.beams(kind);
        let partial = beams.map(|(jet, [_, dq, linear_dq])| {
            let (first, second) =
                if kind == Some(Kind::Transposed) { (linear_dq, dq) } else { (dq, linear_dq) };
            PartialVariations::new(jet, first, second)
        });
        (partial, at, contact)
    }
}

/// Points and tangents of both beams, with d normal to the tangents of the free parameters, and with square roots.
fn stationary(held: Held, rng: &mut ChaCha8Rng) -> [Geometry<PrimeField>; 2] {
    loop {
        let mut vector = || Vector3::from_fn(|_, _| PrimeField::new(rng.random()));
        let [t, t_bar, w, x_bar] = [(); 4].map(|()| vector());
        let d = normal_to_free(held, &t, &t_bar, &w);
        if [d, t, t_bar, t.cross(&t_bar)].iter().all(|v| v.dot(v).is_square() && !v.dot(v).is_zero()) {
            return [(x_bar + d, t), (x_bar, t_bar)].map(|(x, t)| Geometry {
                x,
                t,
                t_xi: vector(),
                t_xixi: vector(),
            });
        }
    }
}

/// A beam with any dofs and directions that has this jet. If it is linear in its dofs, t,xi and t,xixi are different.
fn beam(mut geometry: Geometry<PrimeField>, is_linear: bool, rng: &mut ChaCha8Rng) -> Beam {
    let mut residue = || PrimeField::new(rng.random());
    let mut q = SVector::<PrimeField, D>::from_fn(|_, _| residue());
    let dofs = if is_linear {
        // The two control vectors from x = n₁q₁ + n₂q₂ and t = n₁′q₁ + n₂′q₂.
        let shapes: [[PrimeField; 2]; 4] = std::array::from_fn(|_| [residue(), residue()]);
        let [[n, m], [n_xi, m_xi], ..] = shapes;
        let over = PrimeField::new(1) / (n * m_xi - m * n_xi);
        let (first, second) =
            ((geometry.x * m_xi - geometry.t * m) * over, (geometry.t * n - geometry.x * n_xi) * over);
        q.fixed_rows_mut::<3>(0).copy_from(&first);
        q.fixed_rows_mut::<3>(3).copy_from(&second);
        let [_, _, t_xi, t_xixi] = shapes.map(|[n, m]| first * n + second * m);
        (geometry.t_xi, geometry.t_xixi) = (t_xi, t_xixi);
        let filled = |[n, m]: [PrimeField; 2]| {
            SVector::from_fn(|i, _| [n, m].get(i).copied().unwrap_or(PrimeField::zero()))
        };
        Padded::Linear(shapes.map(filled))
    } else {
        let jacobians = (0..3).map(|_| SMatrix::from_fn(|_, _| residue())).collect();
        let mut symmetric = || {
            let half = SMatrix::<PrimeField, D, D>::from_fn(|_, _| residue());
            half + half.transpose()
        };
        Padded::Nonlinear(jacobians, (0..6).map(|_| symmetric()).collect())
    };
    let mut vector = || SVector::from_fn(|_, _| residue());
    map_padded(&(Jet { geometry, dofs }, [q, vector(), vector()]), traced)
}

fn traced(value: PrimeField) -> Scalar {
    Faulty(value.into())
}

/// The jet as shape functions, if it has any.
fn by_shapes(jet: &Jet<Scalar, Padded<Scalar, D>>) -> Option<Jet<Scalar, Shapes<Scalar, { D / 3 }>>> {
    let derivatives = jet.dofs.all_shapes()?.map(|shapes| std::array::from_fn(|i| shapes[i]));
    Some(Jet { geometry: jet.geometry, dofs: Shapes { derivatives } })
}

/// All numbers of a quantity.
fn numbers(of: &Derivatives<Scalar, D, D>) -> Vec<u64> {
    let Derivatives { value, gradient, hessian } = of;
    let all = [*value].into_iter().chain(gradient.beam.iter().chain(&gradient.bar).copied());
    let second = hessian.beam.iter().chain(&hessian.mixed).chain(&hessian.bar).copied();
    all.chain(second).map(|number| number.0.bits()).collect()
}

/// All numbers that the kernel wrote. For a packed row, these are the row and a few more numbers.
fn written(of: &mut impl Target<Scalar, D, D>) -> Vec<u64> {
    let mut all = vec![of.value().0.bits()];
    let mut write = |(beam, bar): (&mut [Scalar], &mut [Scalar])| {
        all.extend(beam.iter().chain(&*bar).map(|number| number.0.bits()));
    };
    write(of.gradient());
    for i in 0..D {
        write(of.row(i / 3, i % 3));
        write(of.row_bar(i / 3, i % 3));
    }
    all
}
