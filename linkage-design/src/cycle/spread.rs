//! Changes over a dwell for mechanisms within tolerances.

use std::vec::Vec;

use super::{Piece, PieceKey};

/// The part of a band that is left to rounding and to the precision of the search: no limit may lie
/// outside of it in the end. A start leaves twice as much, so that it is a dwell even if nothing is
/// searched.
pub(super) const SPARE: f64 = 1e-6;

/// Returns the changes of a mechanism within tolerances beyond the band: each high position minus
/// each low one.
pub(super) fn ranges<const N: usize>(
    [highs, lows]: &[Vec<Piece<N>>; 2],
    band: f64,
) -> Vec<Piece<N>> {
    let mut ranges = Vec::new();
    for (i, high) in highs.iter().enumerate() {
        for (j, low) in lows.iter().enumerate() {
            let mut auxiliary: Vec<f64> = high
                .auxiliary
                .iter()
                .zip(&low.auxiliary)
                .map(|(a, b)| a - b)
                .collect();
            auxiliary[3] = SPARE - 1.0;
            ranges.push(Piece {
                key: PieceKey::Nth(i * lows.len() + j),
                value: high.value - low.value - (1.0 - SPARE) * band,
                parameters: core::array::from_fn(|k| high.parameters[k] - low.parameters[k]),
                auxiliary,
            });
        }
    }
    ranges
}
