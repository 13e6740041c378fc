//! UniqueNames that are given once.

use linkage_symbolic::lookup::{Map, Set};

/// UniqueNames of which each is given once.
#[derive(Default)]
pub(super) struct UniqueNames {
    taken: Set<String>,
    /// For each name as it was asked for: the last number behind it.
    last: Map<String, usize>,
}

impl UniqueNames {
    /// The name, with a number behind it if it is taken.
    pub(super) fn unique(&mut self, name: String) -> String {
        if self.taken.insert(name.clone()) {
            return name;
        }
        let last = self.last.entry(name.clone()).or_insert(1);
        loop {
            *last += 1;
            let numbered = format!("{name} {last}");
            if self.taken.insert(numbered.clone()) {
                return numbered;
            }
        }
    }
}
