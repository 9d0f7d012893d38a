//! Matrices with rows and columns in another order.

use super::{Dof, Entries};

/// What the dofs are sorted by: from the vector and the component.
type Key = fn(&Dof, [usize; 2]) -> [usize; 3];

/// The orders of rows or columns that have names.
const ORDERS: [(&str, Key); 2] = [
    ("all x, all y and all z of each beam", |dof, [vector, axis]| [usize::from(dof.is_bar), axis, vector]),
    ("all x, all y and all z of both beams", |dof, [vector, axis]| [axis, usize::from(dof.is_bar), vector]),
];

/// What is in another order in the answered matrix, and for each entry the place of the expected one that stands there.
pub(in crate::check::external) fn permuted(entries: &Entries) -> Option<(String, Vec<usize>)> {
    let size = entries.dofs.len();
    let same: Vec<usize> = (0..size).collect();
    let is_right = |rows: &[usize], columns: &[usize]| {
        (0..size * size).all(|k| {
            let expected = entries.expected[rows[k / size] * size + columns[k % size]];
            entries.is_near(entries.answered[k], expected)
        })
    };
    let row = |matrix: &[f64], i: usize| matrix[i * size..(i + 1) * size].to_vec();
    let column = |matrix: &[f64], j: usize| (0..size).map(|i| matrix[i * size + j]).collect();
    // The entries of a row in an order that does not depend on that of the columns.
    let sorted = |matrix: &[f64], i: usize| {
        let mut of_row = row(matrix, i);
        of_row.sort_by(f64::total_cmp);
        [vec![matrix[i * size + i]], of_row].concat()
    };
    let found = |of: &dyn Fn(&[f64], usize) -> Vec<f64>| order(entries, of);
    let is_other = |order: &Vec<usize>| *order != same;
    let columns = || found(&column).filter(is_other).filter(|order| is_right(&same, order));
    let rows = || found(&row).filter(is_other).filter(|order| is_right(order, &same));
    let both = || found(&sorted).filter(is_other).filter(|order| is_right(order, order));
    let told = |what: &str, rows: &[usize], columns: &[usize], order: &[usize]| {
        let places = (0..size * size).map(|k| rows[k / size] * size + columns[k % size]).collect();
        (format!("{what} in another order: {}", words(entries, order)), places)
    };
    columns()
        .map(|order| told("columns", &same, &order, &order))
        .or_else(|| rows().map(|order| told("rows", &order, &same, &order)))
        .or_else(|| both().map(|order| told("rows and columns", &order, &order, &order)))
}

/// For each dof of the answered matrix the dof of the expected one with the same numbers; itself if it is one of them.
fn order(entries: &Entries, of: &dyn Fn(&[f64], usize) -> Vec<f64>) -> Option<Vec<usize>> {
    let size = entries.dofs.len();
    let all = |matrix: &[f64]| -> Vec<Vec<f64>> { (0..size).map(|i| of(matrix, i)).collect() };
    let [answered, expected] = [entries.answered, entries.expected].map(all);
    let is_same = |i: usize, p: usize| {
        answered[i].iter().zip(&expected[p]).all(|(one, other)| entries.is_near(*one, *other))
    };
    let mut order: Vec<Option<usize>> = (0..size).map(|i| is_same(i, i).then_some(i)).collect();
    for i in 0..size {
        if order[i].is_none() {
            order[i] = (0..size).find(|p| !order.contains(&Some(*p)) && is_same(i, *p));
            order[i]?;
        }
    }
    order.into_iter().collect()
}

/// An order in words: its name, or the dofs that are moved.
fn words(entries: &Entries, order: &[usize]) -> String {
    let named = ORDERS.iter().find(|(_, key)| {
        let key = |i: &usize| entries.dofs[*i].vector.map(|of| key(&entries.dofs[*i], of));
        order.is_sorted_by_key(&key) && order.iter().all(|i| entries.dofs[*i].vector.is_some())
    });
    if let Some((name, _)) = named {
        return (*name).to_owned();
    }
    let moved: Vec<usize> = (0..order.len()).filter(|i| order[*i] != *i).collect();
    let list = |of: &mut dyn Iterator<Item = usize>| {
        of.map(|i| (i + entries.first).to_string()).collect::<Vec<_>>().join(", ")
    };
    let there = list(&mut moved.iter().map(|i| order[*i]));
    format!("at the dofs {} stand those of {there}", list(&mut moved.iter().copied()))
}

#[cfg(test)]
mod tests {
    use super::super::{Dof, Entries};

    /// What is told of a matrix whose rows or columns are in these orders.
    fn told(rows: &[usize], columns: &[usize]) -> String {
        let dofs: Vec<Dof> = (0..12)
            .map(|k| Dof { is_bar: k >= 6, is_there: true, vector: Some([k % 6 / 3, k % 3]) })
            .collect();
        let at =
            |i: usize, j: usize| f64::from(u16::try_from(100 * i.min(j) + i.max(j) + 7 * i * j).unwrap());
        let expected: Vec<f64> = (0..144).map(|k| at(k / 12, k % 12)).collect();
        let answered: Vec<f64> = (0..144).map(|k| at(rows[k / 12], columns[k % 12])).collect();
        let is_wrong: Vec<bool> =
            answered.iter().zip(&expected).map(|(one, other)| (one - other).abs() > 0.5).collect();
        let entries =
            Entries { answered: &answered, expected: &expected, is_wrong: &is_wrong, dofs: &dofs, first: 1 };
        entries.words().unwrap()
    }

    #[test]
    fn other_orders_are_told() {
        let same: Vec<usize> = (0..12).collect();
        let mut turned = same.clone();
        turned[3..9].rotate_left(1);
        let of_both = "at the dofs 4, 5, 6, 7, 8, 9 stand those of 5, 6, 7, 8, 9, 4";
        assert!(
            told(&turned, &turned)
                .ends_with(&format!("with the rows and columns in another order: {of_both}"))
        );
        assert!(told(&same, &turned).ends_with(&format!("with the columns in another order: {of_both}")));
        assert!(told(&turned, &same).ends_with(&format!("with the rows in another order: {of_both}")));
        let by_component = [0, 3, 1, 4, 2, 5, 6, 9, 7, 10, 8, 11];
        assert!(told(&by_component, &by_component).ends_with("order: all x, all y and all z of each beam"));
        let of_pair = [0, 3, 6, 9, 1, 4, 7, 10, 2, 5, 8, 11];
        assert!(told(&of_pair, &of_pair).ends_with("order: all x, all y and all z of both beams"));
    }
}
