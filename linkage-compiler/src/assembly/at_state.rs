//! The values of all unknowns if a coupled group has a given state, whether or not its loops close.

use linkage_symbolic::{SymbolId, lookup::Map};

use crate::algebra::Bound;
use crate::mobility::Position;
use crate::solve::Prepared;
use crate::structure::Core;

use super::assembler::Assembly;

/// Returns all unknowns for this state of a group; the unknowns of later groups are not known.
pub(super) fn standing<'a, 'm>(
    assembly: &'a Assembly<'_, 'm>,
    prepared: &Prepared<'m>,
    state: &[f64],
) -> Position<'a, 'm> {
    let names = &assembly.algebra.names;
    let mut known: Map<SymbolId, f64> = Map::new();
    let mut numbers = prepared.unscaled(assembly.nominal, state).into_iter();
    for core in prepared.core() {
        let symbols = match *core {
            Core::Angle(angle) => vec![names.angles[angle].cos, names.angles[angle].sin],
            Core::Length { symbol, .. } => vec![symbol],
        };
        known.extend(symbols.into_iter().zip(&mut numbers));
    }
    let all = (0..names.bound.len()).map(|unknown| {
        let numbers = names.numbers_of(unknown);
        let found = assembly
            .machine
            .evaluate_open(&numbers, &assembly.nominal.inputs, &known);
        match names.bound[unknown] {
            Bound::Angle(_) => vec![found[1].atan2(found[0])],
            Bound::Lengths(_) => found,
        }
    });
    Position::new(
        &assembly.words,
        assembly.nominal,
        assembly.longest,
        all.collect(),
    )
}
