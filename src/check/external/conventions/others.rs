//! The conventions that a program may have without stating them.

use super::{Conventions, Dofs, Length, Range};

impl Conventions {
    /// The other conventions that a program may have, each with its description. Fewer changes come first.
    ///
    /// Changes that concern all gradients and Hessians are combined in all ways, because one without another may correct
    /// no number. The signs of residual and tangent, and the forces, are tried if there is a contact element. The others
    /// concern different quantities, and can be found one after the other.
    pub(in super::super) fn others(&self, has_element: bool) -> Vec<(Self, String)> {
        let single = self.single_changes(has_element);
        let mut of_dofs = vec![(*self, Vec::new())];
        for (change, words) in single.iter().filter(|(change, _)| change.differs_in_dofs(self)) {
            for (known, known_words) in of_dofs.clone() {
                let both = known.with_changes_of(change, self);
                if of_dofs.iter().all(|(other, _)| *other != both) {
                    of_dofs.push((both, [known_words, vec![words.clone()]].concat()));
                }
            }
        }
        let mut all = of_dofs.clone();
        for (change, words) in single.iter().filter(|(change, _)| !change.differs_in_dofs(self)) {
            for (known, known_words) in &of_dofs {
                let both = [vec![words.clone()], known_words.clone()].concat();
                all.push((known.with_changes_of(change, self), both));
            }
        }
        if has_element {
            let of_forces = self.forces.others();
            all.extend(of_forces.map(|(forces, words)| (Self { forces, ..*self }, vec![words])));
        }
        all.sort_by_key(|(_, words)| words.len());
        let joined = |(conventions, words): (Self, Vec<String>)| (conventions, words.join(" and "));
        all.into_iter().filter(|(_, words)| !words.is_empty()).map(joined).collect()
    }

    /// Whether the dofs or the order of matrices differ.
    fn differs_in_dofs(&self, other: &Self) -> bool {
        let of = |one: &Self| (one.dofs, one.bar_first, one.column_major, one.hermite_tangent.to_bits());
        of(self) != of(other)
    }

    /// The conventions with one change, each with its description.
    fn single_changes(&self, has_element: bool) -> Vec<(Self, String)> {
        let mut single: Vec<(Self, String)> = Vec::new();
        let mut add = |other: Self, words: &str| {
            if other != *self {
                single.push((other, words.to_owned()));
            }
        };
        add(
            Self { parameter: Range::Unit, ..*self },
            "the parameters run over [0,1] (\"parameter\":\"[0,1]\")",
        );
        add(
            Self { parameter: Range::Symmetric, ..*self },
            "the parameters run over [-1,1] (\"parameter\":\"[-1,1]\")",
        );
        let d = if self.d_is_negative { "x - x_bar" } else { "x_bar - x" };
        add(
            Self { d_is_negative: !self.d_is_negative, ..*self },
            &format!("the vector d is {d} (\"d\":\"{d}\")"),
        );
        add(Self { length: Length::Distance, ..*self }, "d is the distance (\"distance\":\"d\")");
        add(Self { length: Length::Square, ..*self }, "d is the squared distance (\"distance\":\"d^2\")");
        add(
            Self { length: Length::HalfSquared, ..*self },
            "d is half the squared distance (\"distance\":\"d^2/2\")",
        );
        let gap = if self.gap_is_negative { "d - r - r_bar" } else { "r + r_bar - d" };
        add(
            Self { gap_is_negative: !self.gap_is_negative, ..*self },
            &format!("the gap is {gap} (\"gap\":\"{gap}\")"),
        );
        add(Self { dofs: Dofs::NodeMajor, ..*self }, "the dofs come node by node (\"dofs\":\"node-major\")");
        add(
            Self { dofs: Dofs::ComponentMajor, ..*self },
            "the dofs come component by component (\"dofs\":\"component-major\")",
        );
        add(
            Self { dofs: Dofs::PairComponentMajor, ..*self },
            "the dofs of both beams come component by component (\"dofs\":\"component-major over both beams\")",
        );
        let (first, value) = if self.bar_first { ("beam", "beam first") } else { ("bar beam", "bar first") };
        let words = format!("the dofs of the {first} come first (\"beams\":\"{value}\")");
        add(Self { bar_first: !self.bar_first, ..*self }, &words);
        let (order, value) = if self.column_major {
            ("row by row", "row-major")
        } else {
            ("column by column", "column-major")
        };
        let words = format!("matrices are written {order} (\"matrix\":\"{value}\")");
        add(Self { column_major: !self.column_major, ..*self }, &words);
        for (factor, words) in [(1.0, "1"), (0.5, "0.5"), (2.0, "2")] {
            let words = format!(
                "dx/dxi is {words} times the tangent dofs of a Hermite beam (\"hermite_tangent\":{words})"
            );
            add(Self { hermite_tangent: factor, ..*self }, &words);
        }
        let sign = |is_negative| if is_negative { "-" } else { "+" };
        let (residual, tangent) = (!self.residual_is_negative, !self.tangent_is_negative);
        if has_element {
            add(
                Self { residual_is_negative: residual, ..*self },
                &format!("the residual has the other sign (\"residual_sign\":\"{}\")", sign(residual)),
            );
            add(
                Self { tangent_is_negative: tangent, ..*self },
                &format!("the tangent has the other sign (\"tangent_sign\":\"{}\")", sign(tangent)),
            );
        }
        single
    }

    /// These conventions, with the changes of `other` from `base`.
    fn with_changes_of(&self, other: &Self, base: &Self) -> Self {
        let choose = |own: bool, other: bool, base: bool| if other == base { own } else { other };
        Self {
            parameter: if other.parameter == base.parameter { self.parameter } else { other.parameter },
            d_is_negative: choose(self.d_is_negative, other.d_is_negative, base.d_is_negative),
            length: if other.length == base.length { self.length } else { other.length },
            dofs: if other.dofs == base.dofs { self.dofs } else { other.dofs },
            gap_is_negative: choose(self.gap_is_negative, other.gap_is_negative, base.gap_is_negative),
            bar_first: choose(self.bar_first, other.bar_first, base.bar_first),
            column_major: choose(self.column_major, other.column_major, base.column_major),
            #[expect(clippy::float_cmp, reason = "a choice among constants")]
            hermite_tangent: if other.hermite_tangent == base.hermite_tangent {
                self.hermite_tangent
            } else {
                other.hermite_tangent
            },
            residual_is_negative: choose(
                self.residual_is_negative,
                other.residual_is_negative,
                base.residual_is_negative,
            ),
            tangent_is_negative: choose(
                self.tangent_is_negative,
                other.tangent_is_negative,
                base.tangent_is_negative,
            ),
            forces: self.forces,
            penalty: self.penalty,
            triangle: self.triangle,
            first_index: self.first_index,
            null_is_no_dof: self.null_is_no_dof,
        }
    }
}
