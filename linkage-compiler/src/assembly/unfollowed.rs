//! Messages about a coupled group whose assembly cannot be followed over the range.

use linkage_core::numeric::continuation::Refusal;

use crate::solve::{Prepared, Solved};
use crate::structure::fault::OURS;

use super::assembler::Assembly;
use super::refused_range::{FoundBox, OR_LENGTHS, RefusedRange, range_of};

/// Reports a group whose solution is singular at the reference inputs.
pub(super) fn report_singular<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
) {
    let refused = refused(assembly, solved, prepared, Refusal::NotASolution);
    refused.report(assembly.algebra.mechanism, None, &mut assembly.reporter);
}

/// The refusal of a group over its ranges.
pub(super) fn refused<'m>(
    assembly: &Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
    refusal: Refusal,
) -> RefusedRange {
    let loops = assembly.words.loops(&solved.group.loops);
    let unknowns = assembly.words.unknowns(&solved.group.unknowns);
    let [reach, come, are] = match solved.group.loops.len() {
        1 => ["reaches", "comes", "is"],
        _ => ["reach", "come", "are"],
    };
    let position = assembly.words.at_reference(&assembly.nominal.inputs);
    let mechanism = assembly.algebra.mechanism;
    let at_input = |at: f64| {
        let mut inputs = assembly.nominal.inputs.clone();
        if let Some(&input) = prepared.inputs.first() {
            inputs[input] = at;
        }
        assembly.words.inputs(&inputs, &prepared.inputs)
    };
    let range = prepared.inputs.first().copied();
    let origins = range
        .filter(|&input| assembly.nominal.ranges[input].is_some())
        .map_or(
            [mechanism.loops[solved.group.loops[0]].origin; 2],
            |input| range_of(&mechanism.inputs[input]),
        );
    let (fact, narrower, otherwise) = match refusal {
        Refusal::TurningPoint { at } => (
            format!(
                "the mechanism comes apart in this range: {loops} ({unknowns}) {reach} a turning point at {}, where this \
                 assembly meets another one and both end",
                at_input(at)
            ),
            "restrict the range",
            OR_LENGTHS,
        ),
        Refusal::NotConverging { at } => (
            format!(
                "{loops} ({unknowns}) {come} too near to a turning point at {} for a table over this range; {OURS}",
                at_input(at)
            ),
            "restrict the range",
            ", or choose lengths away from the turning point",
        ),
        _ => (
            format!("{loops} ({unknowns}) {are} singular{position}, a dead point"),
            "choose a reference input or lengths away from the dead point",
            "",
        ),
    };
    RefusedRange {
        origins,
        fact,
        narrower,
        otherwise: otherwise.to_owned(),
        found: FoundBox::Largest,
    }
}
