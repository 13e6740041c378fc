//! The coupled groups of a mechanism that is followed.

use alloc::vec::Vec;

/// A coupled group that is followed.
#[derive(Clone, Copy)]
pub(in super::super) struct FollowedGroup {
    pub(in super::super) number: usize,
    /// Of its state in a row; the floor stands behind that.
    pub(in super::super) first: usize,
    pub(in super::super) size: usize,
}

impl FollowedGroup {
    pub(in super::super) fn floor(self) -> usize {
        self.first + self.size
    }

    pub(in super::super) fn state(self) -> core::ops::Range<usize> {
        self.first..self.floor()
    }
}

/// The coupled groups that are followed, in order.
pub(in super::super) struct Groups {
    pub(in super::super) places: Vec<FollowedGroup>,
    /// Where all numbers of their states stand, and these with the floors.
    pub(in super::super) states: Vec<usize>,
    pub(in super::super) numbers: Vec<usize>,
}

impl Groups {
    pub(in super::super) fn new(places: Vec<FollowedGroup>) -> Self {
        let states = places.iter().flat_map(|place| place.state()).collect();
        let numbers = places.iter().flat_map(|place| place.first..=place.floor());
        let numbers = numbers.collect();
        Self {
            places,
            states,
            numbers,
        }
    }

    /// Whether a row has all their states.
    pub(in super::super) fn have<const R: usize>(&self, row: &[f64; R]) -> bool {
        self.numbers.iter().all(|&number| row[number].is_finite())
    }
}
