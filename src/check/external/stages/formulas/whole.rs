//! Changes of inputs as a whole: the vectors of the curves, numbers, what is held.

use super::axes::AXES;
use super::change::{Change, New};
use super::changes::{FACTORS, scaled};
use super::list::{CURVES, Formulas};
use super::tree::{Name, Op, Tree};

impl Formulas {
    /// All changes of inputs.
    pub(super) fn of_inputs(&self) -> Vec<Change> {
        let all = [
            self.of_curves(),
            self.of_numbers(),
            self.in_single_precision(),
            self.of_vectors(),
            self.of_conditions(),
            self.exchanges(),
        ];
        all.concat()
    }

    /// Numbers that are given, and vectors of the last step, in single precision: one, both of two beams, or the whole history.
    fn in_single_precision(&self) -> Vec<Change> {
        let is_of_last_step = |name: Name| self.names.0[name].ends_with("_n");
        let is_given = |name: &Name| {
            let kind = self.kinds[*name];
            !kind.is_condition && (!kind.is_vector || is_of_last_step(*name))
        };
        let given: Vec<Name> = (0..self.inputs).filter(is_given).collect();
        let both = given.iter().map(|name| vec![*name, self.twin(*name)]).filter(|both| both[0] < both[1]);
        let history = given.iter().copied().filter(|name| is_of_last_step(*name)).collect();
        let all = given.iter().map(|name| vec![*name]).chain(both).chain([history]);
        let of = |names: Vec<Name>| {
            let told: Vec<&str> = names.iter().map(|name| self.names.0[*name].as_str()).collect();
            let verb = if names.len() > 1 { "have" } else { "has" };
            let single = |name: &Name| New::of(*name, Tree::new(Op::Single, [Tree::name(*name)]));
            let cost = 3 + u32::from(names.len() > 1);
            let words = format!("{} {verb} single precision", told.join(", "));
            Change { new: names.iter().map(single).collect(), cost, ..Change::of(words) }
        };
        all.map(of).collect()
    }

    /// Factors on the vectors of one or both curves, or on their variations, and other components of them.
    fn of_curves(&self) -> Vec<Change> {
        let mut found = Vec::new();
        for (vector, variations) in CURVES {
            for ends in [&[""][..], &["_bar"], &["", "_bar"]] {
                let named = |name: &&str, end: &&str| {
                    let (letters, derivative) = name.split_once(',').unwrap_or((name, ""));
                    let comma = if derivative.is_empty() { "" } else { "," };
                    self.name(&format!("{letters}{end}{comma}{derivative}"))
                };
                let of = |names: &[&str]| -> Vec<Name> {
                    names.iter().flat_map(|name| ends.iter().map(move |end| named(name, end))).collect()
                };
                let (curve, varied) = (of(&[vector]), of(variations));
                let all = [&curve[..], &varied].concat();
                let is_both = u32::from(ends.len() > 1);
                for (names, cost) in [(&all, 3), (&varied, 4), (&curve, 4)] {
                    let told: Vec<_> = names.iter().map(|name| self.names.0[*name].as_str()).collect();
                    let told = match told[..] {
                        [] => continue,
                        [name] => name.to_owned(),
                        _ => format!("each of {}", told.join(", ")),
                    };
                    let mut add = |new: &dyn Fn(Name) -> Tree, words: String, cost: u32| {
                        let new = names.iter().map(|name| New::of(*name, new(*name))).collect();
                        let words = format!("the curves are wrong: {words}");
                        found.push(Change { new, cost: cost + is_both, ..Change::of(words) });
                    };
                    for (by, words, _) in FACTORS {
                        add(&|name| scaled(name, by), format!("{told} {words}"), cost);
                    }
                    for (k, (_, words)) in AXES.iter().enumerate() {
                        let new = |name| Tree::new(Op::Axes(k), [Tree::name(name)]);
                        add(&new, format!("in {told} {words}"), cost + 1);
                    }
                }
            }
        }
        found
    }

    /// Factors on numbers. The penalty is stated by the program, so another one is told as such.
    fn of_numbers(&self) -> Vec<Change> {
        let is_number = |name: &Name| {
            let kind = self.kinds[*name];
            !kind.is_vector && !kind.is_condition && self.names.0[*name] != "penalty"
        };
        let of = |name: Name| {
            FACTORS.map(|(by, words, cost)| Change {
                new: vec![New::of(name, scaled(name, by))],
                cost,
                ..Change::of(format!("{} {words}", self.names.0[name]))
            })
        };
        (0..self.inputs).filter(is_number).flat_map(of).collect()
    }

    /// Parameters that are taken as free where they are held, or the reverse.
    fn of_conditions(&self) -> Vec<Change> {
        let [xi, xi_bar, both] = ["free_xi", "free_xi_bar", "both_free"].map(|name| self.name(name));
        let of = |words: &str, [free_xi, free_xi_bar]: [Tree; 2]| {
            let both_free = Tree::product(vec![(false, free_xi.clone()), (false, free_xi_bar.clone())]);
            let new = [(xi, free_xi), (xi_bar, free_xi_bar), (both, both_free)];
            let new = new.map(|(name, tree)| New::of(name, tree)).into();
            Change { new, cost: 3, ..Change::of(words.to_owned()) }
        };
        let (free, own, other) = (|| Tree::number(1.0), || Tree::name(xi), || Tree::name(xi_bar));
        vec![
            of("xi is varied where it is held at an end", [free(), other()]),
            of("xi_bar is varied where it is held at an end", [own(), free()]),
            of("parameters are varied where they are held at an end", [free(), free()]),
            of("xi_bar is taken as held where xi is, and not where it is itself", [own(), own()]),
            of("xi is taken as held where xi_bar is, and not where it is itself", [other(), other()]),
            of("xi is taken as held where xi_bar is, and xi_bar where xi is", [other(), own()]),
        ]
    }

    /// Vectors of the curves in the place of others.
    fn of_vectors(&self) -> Vec<Change> {
        let is_vector = |name: &Name| self.kinds[*name].is_vector && !self.names.0[*name].contains("_n");
        let vectors: Vec<Name> = (0..self.inputs).filter(is_vector).collect();
        let of = |(name, other): (Name, Name)| {
            let [old, new] = [name, other].map(|name| &self.names.0[name]);
            let words = format!("the curves are wrong: {new} stands in the place of {old}");
            Change { new: self.in_place_of(name, other), cost: 4, ..Change::of(words) }
        };
        self.alike(&vectors).into_iter().map(of).collect()
    }

    /// A number of the beam and that of the bar beam in each other's place.
    fn exchanges(&self) -> Vec<Change> {
        let exchanged = |(name, text): (Name, &String)| {
            let twin = Some(self.twin(name)).filter(|twin| *twin > name)?;
            let words = format!("{text} and {} are exchanged", self.names.0[twin]);
            let new = vec![New::of(name, Tree::name(twin)), New::of(twin, Tree::name(name))];
            Some(Change { new, cost: 4, ..Change::of(words) })
        };
        self.names.0.iter().enumerate().take(self.inputs).filter_map(exchanged).collect()
    }
}
