//! The values of all formulas, right and with a change.

use super::changes::Change;
use super::list::{FORMULAS, Formulas, Step};
use super::point::Point;
use super::tree::{Name, Tree};
use super::values::{Value, value};

impl Formulas {
    /// The values of all names that follow from the inputs, and from values that are `given`. `known` are the values of
    /// conditions that are open within rounding.
    pub(super) fn values(
        &self,
        way: usize,
        inputs: &[Value],
        known: &[(Name, Value)],
        given: &[(Name, Value)],
    ) -> Vec<Value> {
        let mut values = inputs.to_vec();
        values.resize(self.names.0.len(), Value::from(0.0));
        for Step { name, tree, .. } in &self.ways[way] {
            let fixed = given.iter().find(|(of, _)| of == name).map(|(_, value)| *value);
            values[*name] = fixed.unwrap_or_else(|| evaluated(*name, tree, &values, known));
        }
        values
    }

    /// Whether it is a derivative, or made of derivatives; the residual is not.
    fn is_differentiated(&self, name: Name) -> bool {
        self.kinds[name].varies != [false; 2] && !self.residual.contains(&name)
    }
}

impl Point<'_> {
    /// The values in a way of writing with other formulas in the place of some. Values that are given stay as they are, and
    /// those that are not `needed`.
    pub(super) fn changed(&self, way: usize, change: &Change, needed: &[bool]) -> Vec<Value> {
        let list = &*FORMULAS;
        let known = &self.sample.inputs.known;
        let right = &self.values[way];
        if change.is_stored {
            let mut values = right.clone();
            for (name, tree) in &change.new {
                values[*name] = value(tree, right);
            }
            for (of, name) in change.entries.iter().flat_map(|of| of.names().map(move |name| (of, name))) {
                values[name] = of.put(name, right[name], self.parts());
            }
            return values;
        }
        let mut is_other = vec![false; right.len()];
        let mut values = right.clone();
        for (name, tree) in change.new.iter().filter(|(name, _)| *name < list.inputs) {
            values[*name] = value(tree, right);
            is_other[*name] = true;
        }
        for Step { name, tree, uses } in &list.ways[way] {
            let other = change.new.iter().find(|(of, _)| of == name).map(|(_, tree)| tree);
            let entries = change.entries.filter(|of| of.names().any(|of| of == *name));
            let is_given = self.given.iter().any(|(of, _)| of == name);
            let is_same = other.is_none() && entries.is_none() && !uses.iter().any(|name| is_other[*name]);
            let is_kept = change.is_of_derivatives && other.is_none() && !list.is_differentiated(*name);
            if is_given || is_same || is_kept || !needed[*name] {
                continue;
            }
            let value = evaluated(*name, other.unwrap_or(tree), &values, known);
            let value = entries.map_or(value, |of| of.put(*name, value, self.parts()));
            if value != values[*name] {
                values[*name] = value;
                is_other[*name] = true;
            }
        }
        if change.is_of_derivatives {
            for (name, _) in &change.new {
                values[*name] = right[*name];
            }
        }
        values
    }
}

fn evaluated(name: Name, tree: &Tree, values: &[Value], known: &[(Name, Value)]) -> Value {
    let found = value(tree, values);
    let open = || known.iter().find(|(of, _)| *of == name).map(|(_, value)| *value);
    if found.is_nan() { open().unwrap_or(found) } else { found }
}
