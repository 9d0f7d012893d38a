//! The names of the last cases of a stream, with their lines. Their number is limited, so that memory stays flat.

use std::collections::{HashMap, VecDeque};
use std::sync::Arc;

/// The number of names that are known.
const KNOWN: usize = 1 << 16;

/// The last names, each with its line.
#[derive(Debug, Default)]
pub(super) struct Recent {
    lines: HashMap<Arc<str>, usize>,
    order: VecDeque<Arc<str>>,
}

impl Recent {
    /// Adds a name. Returns its line if it is known already.
    pub(super) fn insert(&mut self, name: &str, line: usize) -> Option<usize> {
        if let Some(known) = self.line(name) {
            return Some(known);
        }
        let name: Arc<str> = name.into();
        self.lines.insert(Arc::clone(&name), line);
        self.order.push_back(name);
        if self.order.len() > KNOWN
            && let Some(oldest) = self.order.pop_front()
        {
            self.lines.remove(&oldest);
        }
        None
    }

    /// The line of a name, if it is known.
    pub(super) fn line(&self, name: &str) -> Option<usize> {
        self.lines.get(name).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::{KNOWN, Recent};

    #[test]
    fn the_last_names_are_known() {
        let mut names = Recent::default();
        for k in 0..=KNOWN {
            assert_eq!(names.insert(&k.to_string(), k + 2), None);
        }
        assert_eq!((names.line("0"), names.line("1")), (None, Some(3)));
        assert_eq!((names.insert("1", 9), names.line("1")), (Some(3), Some(3)));
        assert_eq!((names.lines.len(), names.order.len()), (KNOWN, KNOWN));
    }
}
