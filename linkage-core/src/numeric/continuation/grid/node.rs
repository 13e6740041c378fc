//! The state in a cell.

use super::super::scale::guard;
use super::terms::{OUTSIDE, Terms, index, values};
use alloc::vec;
use alloc::vec::Vec;

/// The state in a cell.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Node {
    /// The numbers of the state side by side, term by term; first those at the centre.
    pub(in super::super) coefficients: Vec<f64>,
    /// Half of the smallest determinant, with its sign.
    pub(in super::super) floor: f64,
    width: usize,
    terms: Terms,
}

impl Node {
    /// With nothing but a state at the centre and slopes, input by input.
    pub(super) fn with_slopes(state: &[f64], slopes: &[f64], floor: f64, terms: Terms) -> Self {
        let width = state.len();
        let inputs = slopes.len() / width;
        let mut coefficients = vec![0.0; terms.count(inputs) * width];
        coefficients[..width].copy_from_slice(state);
        for (input, slopes) in slopes.chunks_exact(width).enumerate() {
            let first = match (terms, input) {
                (Terms::Slopes, _) => 1 + input,
                (_, 0) => index(1, 0),
                _ => index(0, 1),
            };
            coefficients[first * width..][..width].copy_from_slice(slopes);
        }
        Self {
            coefficients,
            floor,
            width,
            terms,
        }
    }

    /// The state at its centre.
    pub(super) fn centre(&self) -> &[f64] {
        &self.coefficients[..self.width]
    }

    /// The state by the slopes alone, at these offsets of two inputs.
    pub(super) fn along_slopes(&self, [x, y]: &[f64; 2], state: &mut [f64]) {
        let row = |number: usize| &self.coefficients[number * self.width..][..self.width];
        let slopes = row(index(1, 0)).iter().zip(row(index(0, 1)));
        for ((number, centre), (along, across)) in state.iter_mut().zip(row(0)).zip(slopes) {
            *number = centre + x * along + y * across;
        }
    }

    /// The state at these offsets from the centre, in cells; the floor.
    pub(super) fn state<const FUSED: bool>(&self, offsets: &[f64], state: &mut [f64]) -> f64 {
        let guards = offsets.iter().map(|&offset| guard(offset, OUTSIDE));
        let outside: f64 = guards.sum();
        for (index, number) in state.iter_mut().enumerate() {
            let coefficient = |term: usize| [self.coefficients[term * self.width + index]];
            *number = values::<FUSED, 1>(self.terms, coefficient, offsets)[0] + outside;
        }
        self.floor + outside
    }
}
