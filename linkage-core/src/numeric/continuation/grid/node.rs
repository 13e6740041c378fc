//! What is known of a cell.

use super::super::scale::guard;
use super::lookup::OUTSIDE;
use alloc::vec::Vec;

/// The state in a cell.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Node {
    /// At its centre.
    pub(in super::super) state: Vec<f64>,
    /// How the state changes along the cell, input by input.
    pub(in super::super) slopes: Vec<f64>,
    /// Half of the smallest determinant, with its sign.
    pub(in super::super) floor: f64,
}

impl Node {
    /// The state at these offsets from the centre, in cells; the floor.
    pub(super) fn state(&self, offsets: &[f64], state: &mut [f64]) -> f64 {
        state.copy_from_slice(&self.state);
        let mut outside = 0.0;
        for (slopes, &offset) in self.slopes.chunks_exact(state.len()).zip(offsets) {
            outside += guard(offset, OUTSIDE);
            for (number, slope) in state.iter_mut().zip(slopes) {
                *number += slope * offset;
            }
        }
        state.iter_mut().for_each(|number| *number += outside);
        self.floor + outside
    }
}
