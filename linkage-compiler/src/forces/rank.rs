//! The numeric test that equations which are solved together determine their unknowns: matching
//! sees only the unknowns of an equation.

use linkage_core::numeric::rank::is_singular;
use linkage_symbolic::Ex;

use super::positions::Positions;
use super::system::System;

/// Equations that differ by a smaller share repeat each other: far above what rounding leaves, far
/// below what is left near a dead point.
const INDEPENDENT: f64 = 1e-9;

impl System<'_> {
    /// True if the equations of a block repeat each other at all positions where the mechanism
    /// closes.
    pub(super) fn repeats(&self, block: &[usize], positions: &Positions) -> bool {
        let unknowns = self.unknowns_of(block);
        let entries = block
            .iter()
            .flat_map(|&e| unknowns.iter().map(move |&k| self.matrix[e][k]));
        let entries: Vec<Ex> = entries.collect();
        let numbers = positions.numbers(&entries);
        !numbers.is_empty()
            && numbers.into_iter().all(|numbers| {
                let rows = numbers.chunks(unknowns.len()).map(<[f64]>::to_vec);
                is_singular(rows.collect(), INDEPENDENT)
            })
    }
}
