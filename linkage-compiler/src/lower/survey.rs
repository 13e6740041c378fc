//! The survey of a mechanism: margins, slacks and the numbers that distinguish assemblies.

use linkage_symbolic::Ex;

use crate::algebra::{Algebra, Bound};
use crate::ir::Surveyed;
use crate::solve::Formulation;

/// See [`CompiledMechanism::survey`](crate::ir::CompiledMechanism::survey).
pub(super) fn survey<'m>(algebra: &Algebra<'m>, formulation: &Formulation<'m>) -> Vec<Ex<'m>> {
    let margins = formulation.groups.iter().map(|group| group.closed.margin);
    let least = margins.fold(algebra.one(), |least, margin| least.min(margin));
    // The curves of coupled groups are followed; their slack is not used.
    let slacks = formulation.groups.iter().map(|group| match group.prepared {
        Some(_) => algebra.one(),
        None => group.closed.slack,
    });
    let unknowns = found_by_groups(algebra, formulation);
    let numbers = unknowns.flat_map(|unknown| algebra.names.numbers_of(unknown));
    let first = std::iter::once(least).chain(slacks);
    first.chain(numbers).collect()
}

/// See [`CompiledMechanism::surveyed`](crate::ir::CompiledMechanism::surveyed).
pub(super) fn surveyed(algebra: &Algebra, formulation: &Formulation) -> Vec<Surveyed> {
    let surveyed = |unknown: usize| Surveyed {
        unknown,
        angle: matches!(algebra.names.bound[unknown], Bound::Angle(_)),
        numbers: algebra.names.numbers_of(unknown).len(),
    };
    found_by_groups(algebra, formulation)
        .map(surveyed)
        .collect()
}

/// The unknowns that groups find.
fn found_by_groups(algebra: &Algebra, formulation: &Formulation) -> impl Iterator<Item = usize> {
    let unknowns = 0..algebra.names.bound.len();
    unknowns.filter(|&k| formulation.last_group_with(k).is_some())
}
