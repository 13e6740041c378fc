//! Messages about a coupled group whose assembly cannot be followed over the range.

use linkage_core::numeric::continuation::Refusal;

use crate::message_format::loop_list;
use crate::solve::{Prepared, Solved};
use crate::structure::unsolved::OURS;

use super::assembler::Assembly;
use super::check::range_of;

pub(super) fn refused<'m>(
    assembly: &mut Assembly<'_, 'm>,
    solved: &Solved<'m>,
    prepared: &Prepared<'m>,
    refusal: Refusal,
) {
    let loops = loop_list(&solved.group.loops);
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
    let message = match refusal {
        Refusal::TurningPoint { at } => format!(
            "the mechanism comes apart in this range: {loops} ({unknowns}) {reach} a turning point at {}, where this \
                 assembly meets another one and both end\n\
                 help: restrict the range, or change the lengths so that the links reach each other all the way",
            at_input(at)
        ),
        Refusal::NotConverging { at } => format!(
            "{loops} ({unknowns}) {come} too near to a turning point at {} for a table over this range; {OURS}\n\
                 help: restrict the range, or choose lengths away from the turning point",
            at_input(at)
        ),
        _ => format!(
            "{loops} ({unknowns}) {are} singular{position}, a dead point\n\
                 help: choose a reference input or lengths away from the dead point"
        ),
    };
    assembly.reporter.error_between(origins, message);
}
