//! A numerical check that equations which are solved together determine their unknowns. Matching
//! sees only which unknowns an equation contains.

use linkage_core::numeric::rank::is_singular;
use linkage_symbolic::Ex;

use crate::forces::positions::Positions;
use crate::forces::system::System;

/// Equations that differ by a smaller share repeat each other: far above rounding, far below the
/// difference near a dead point.
const INDEPENDENT: f64 = 1e-9;

/// True if the equations of a block repeat each other at all positions where the mechanism closes.
pub(super) fn repeats(system: &System, block: &[usize], positions: &Positions) -> bool {
    let unknowns = system.unknowns_of(block);
    let entries = block
        .iter()
        .flat_map(|&e| unknowns.iter().map(move |&k| system.matrix[e][k]));
    let entries: Vec<Ex> = entries.collect();
    let numbers = positions.numbers(&entries);
    !numbers.is_empty()
        && numbers.into_iter().all(|numbers| {
            let rows = numbers.chunks(unknowns.len()).map(<[f64]>::to_vec);
            is_singular(rows.collect(), INDEPENDENT)
        })
}
