//! Parallel maps. The results are in the order of the items.
//!
//! All run through one loop that has no type parameter: a loop of rayon for each type of item and result made a twelfth of
//! the code to compile.

use rayon::prelude::*;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The results of the numbers below `count`.
pub(crate) fn indices<T: Send>(count: usize, of: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let slots: Vec<Mutex<Option<T>>> = (0..count).map(|_| Mutex::new(None)).collect();
    each(count, &|i| {
        let result = of(i);
        if let Ok(mut slot) = slots[i].lock() {
            *slot = Some(result);
        }
    });
    slots.into_iter().filter_map(|slot| slot.into_inner().ok().flatten()).collect()
}

/// The result of each item.
pub(crate) fn map<'a, I: Sync, T: Send>(items: &'a [I], of: impl Fn(&'a I) -> T + Sync) -> Vec<T> {
    indices(items.len(), |i| of(&items[i]))
}

/// The results of the items that have one.
pub(crate) fn filter_map<'a, I: Sync, T: Send>(
    items: &'a [I],
    of: impl Fn(&'a I) -> Option<T> + Sync,
) -> Vec<T> {
    map(items, of).into_iter().flatten().collect()
}

/// The results of all items, one after the other.
pub(crate) fn flat_map<'a, I: Sync, T: Send>(items: &'a [I], of: impl Fn(&'a I) -> Vec<T> + Sync) -> Vec<T> {
    map(items, of).into_iter().flatten().collect()
}

/// The result of the first of the numbers below `count` that has one. Numbers after it may be left out.
pub(crate) fn first<T: Send>(count: usize, of: impl Fn(usize) -> Option<T> + Sync) -> Option<T> {
    let first = AtomicUsize::new(count);
    let found = indices(count, |i| {
        let result = (i < first.load(Ordering::Relaxed)).then(|| of(i)).flatten();
        if result.is_some() {
            first.fetch_min(i, Ordering::Relaxed);
        }
        result
    });
    found.into_iter().flatten().next()
}

fn each(count: usize, of: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(of);
}

#[cfg(test)]
mod tests {
    use super::{filter_map, first, flat_map, indices};

    #[test]
    fn results_are_in_the_order_of_the_items() {
        let items: Vec<usize> = (0..1000).collect();
        assert_eq!(indices(1000, |i| i), items);
        assert_eq!(filter_map(&items, |i| (i % 7 == 0).then_some(i / 7)), (0..143).collect::<Vec<_>>());
        assert_eq!(flat_map(&[2, 0, 1], |n| vec![*n; *n]), [2, 2, 1]);
    }

    #[test]
    fn the_first_result_is_that_of_the_smallest_number() {
        // It is known after others.
        let slow = |i: usize| {
            if i == 37 {
                std::thread::sleep(std::time::Duration::from_millis(20));
            }
            (i % 100 == 37).then_some(i)
        };
        assert_eq!(first(1000, slow), Some(37));
        assert_eq!(first(37, |i| (i % 100 == 37).then_some(i)), None);
    }
}
