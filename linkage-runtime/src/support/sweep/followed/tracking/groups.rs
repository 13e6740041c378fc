//! The coupled groups that are followed.

use alloc::vec::Vec;

/// A coupled group that is followed.
#[derive(Clone, Copy)]
pub(crate) struct StateSpan {
    pub(crate) number: usize,
    /// Position of its state in a row, before the floor.
    pub(crate) first: usize,
    pub(crate) size: usize,
}

impl StateSpan {
    pub(super) fn floor(self) -> usize {
        self.first + self.size
    }

    pub(super) fn state(self) -> core::ops::Range<usize> {
        self.first..self.floor()
    }
}

/// The coupled groups that are followed, in order.
pub(crate) struct Groups {
    pub(super) spans: Vec<StateSpan>,
    /// Positions of all numbers of their states, and of these with the floors.
    pub(super) states: Vec<usize>,
    pub(super) numbers: Vec<usize>,
}

impl Groups {
    pub(crate) fn new(spans: Vec<StateSpan>) -> Self {
        let states = spans.iter().flat_map(|span| span.state()).collect();
        let numbers = spans.iter().flat_map(|span| span.first..=span.floor());
        let numbers = numbers.collect();
        Self {
            spans,
            states,
            numbers,
        }
    }

    /// Returns true if a row has all their states.
    pub(crate) fn have<const R: usize>(&self, row: &[f64; R]) -> bool {
        self.numbers.iter().all(|&number| row[number].is_finite())
    }
}
