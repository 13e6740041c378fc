//! Sets of things that are one: points that pins join, and bodies that are welded.

/// A number for each thing, equal for those of one set.
pub(super) struct Groups {
    first: Vec<usize>,
}

impl Groups {
    pub(super) fn new(count: usize) -> Self {
        Self {
            first: (0..count).collect(),
        }
    }

    /// Returns the smallest index of the set of a thing.
    pub(super) fn first(&self, index: usize) -> usize {
        self.first[index]
    }

    pub(super) fn join(&mut self, one: usize, other: usize) {
        let (one, other) = (self.first[one], self.first[other]);
        let (kept, replaced) = (one.min(other), one.max(other));
        for first in &mut self.first {
            if *first == replaced {
                *first = kept;
            }
        }
    }
}
