//! Changes of results as a whole: one in the place of another, a factor, the form for straight beams.

use super::change::{Change, New, put};
use super::changes::{FACTORS, scaled};
use super::list::{Formula, Formulas, STRAIGHT};
use super::outputs::RESULTS;
use super::tree::{Name, Op, Tree};

impl Formulas {
    /// Results that are answered in the place of others, or with a factor.
    pub(super) fn of_results(&self) -> Vec<Change> {
        let results = &*RESULTS;
        let of_factor = |name: Name| {
            FACTORS.map(|(by, words, cost)| {
                let names = [Some(name), self.linear.get(name)].into_iter().flatten();
                let new = names.map(|name| New::of(name, scaled(name, by))).collect();
                let words = format!("{} {words} where it is answered", self.names.0[name]);
                Change { new, is_stored: true, cost, ..Change::of(words) }
            })
        };
        let is_result = |name: &Name| self.kinds[*name].varies != [false, true];
        let factors = results.iter().copied().filter(is_result).flat_map(of_factor);
        let of_pair = |(name, other): (Name, Name)| {
            let [old, new] = [name, other].map(|name| &self.names.0[name]);
            let words = format!("{new} is answered in the place of {old}");
            Change { new: self.in_place_of(name, other), is_stored: true, cost: 4, ..Change::of(words) }
        };
        factors.chain(self.alike(results).into_iter().map(of_pair)).collect()
    }

    /// Formulas in their form for straight beams.
    pub(super) fn of_straight_beams(&self) -> Vec<Change> {
        let of = |formula: &Formula| {
            let [tree, straight] = [0, STRAIGHT].map(|way| formula.written(way));
            let mut new = Vec::new();
            put(formula, straight, &mut new);
            let words = format!("{} is that of straight beams", self.words_of(formula));
            (tree != straight).then(|| Change { new, cost: 5, ..Change::of(words) })
        };
        self.all.iter().filter_map(of).collect()
    }

    /// The side of the normal that is that of the tangents, and not that of the last step.
    pub(super) fn of_side(&self) -> Change {
        let words = "the normal is on the side of cross(t, t_bar), and not on that of the last step or of d";
        self.instead(words.into(), &[("side", "normal.cross(t, t_bar) < 0 ? -1 : 1".into())])
    }

    /// The length of a variation in the place of the variation of a length.
    pub(super) fn of_lengths(&self) -> Vec<Change> {
        let lengths = [("d|t|", "dt"), ("d|t_bar|", "dt_bar"), ("d|d|", "dd")];
        let of = |pairs: &[(&str, &str)]| {
            let mut new = Vec::new();
            for (length, vector) in pairs {
                let [length, vector] = [length, vector].map(|name| self.name(name));
                let dot = Tree::new(Op::Dot, [Tree::name(vector), Tree::name(vector)]);
                let tree = Tree::new(Op::Root, [dot]);
                self.all
                    .iter()
                    .filter(|formula| formula.name == length)
                    .for_each(|of| put(of, &tree, &mut new));
            }
            let words: Vec<_> =
                pairs.iter().map(|(of, vector)| format!("{of} is the length of {vector}")).collect();
            Change { new, cost: 5, ..Change::of(words.join(" and ")) }
        };
        [&lengths[..1], &lengths[1..2], &lengths[..2], &lengths[2..]].map(of).into()
    }

    /// Each of two formulas in the place of the other.
    pub(super) fn exchange_of(&self, formula: &Formula, twin: &Formula) -> Change {
        let mut new = Vec::new();
        put(formula, twin.written(0), &mut new);
        put(twin, formula.written(0), &mut new);
        let [name, other] = [formula, twin].map(|of| self.words_of(of));
        let words = format!("{name} and {other} are exchanged");
        Change { new, cost: 4, ..Change::of(words) }
    }

    /// Pairs of different names of one kind, without those along Delta.
    pub(super) fn alike(&self, names: &[Name]) -> Vec<(Name, Name)> {
        let is_alike = |(name, other): &(Name, Name)| {
            name != other
                && self.kinds[*name] == self.kinds[*other]
                && self.kinds[*name].varies != [false, true]
        };
        let pairs = names.iter().flat_map(|&name| names.iter().map(move |&other| (name, other)));
        pairs.filter(is_alike).collect()
    }

    /// A name in the place of another, also along Delta.
    pub(super) fn in_place_of(&self, name: Name, other: Name) -> Vec<New> {
        let along = |name: Name| self.linear.get(name);
        let linear = along(name).zip(along(other));
        let pairs = [Some((name, other)), linear].into_iter().flatten();
        pairs.map(|(name, other)| New::of(name, Tree::name(other))).collect()
    }
}
