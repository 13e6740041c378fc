//! The range check: can the declared ranges be run through in the chosen assembly?

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::{OriginId, Reporter};
use crate::formulate::Formulation;
use crate::model::Input;
use crate::structure::report::loop_list;
use crate::unit::ContinuousAngle;

use super::Reference;
use super::follow::{Unfollowed, follow_angles};
use super::ranges::{Broken, GRID, Ranges};
use super::words::Words;

/// Checks the ranges; reports where the mechanism comes apart, and an angle whose value is used but cannot be followed.
/// `asked` are the angles whose values functions use.
pub(crate) fn check_ranges<'m>(
    algebra: &mut Algebra<'m>,
    formulation: &Formulation<'m>,
    nominal: &Nominal,
    reference: &mut Reference,
    asked: &[ContinuousAngle],
    reporter: &mut Reporter,
) {
    let words = Words::new(algebra.mechanism);
    let mut sound = true;
    for (index, input) in algebra.mechanism.inputs.iter().enumerate() {
        let Some((low, high)) = nominal.ranges[index] else {
            continue;
        };
        let value = nominal.inputs[index];
        if !(low < high && low <= value && value <= high) {
            let show = |x| words.scalar(input.dimension, x);
            sound = false;
            reporter.error_between(
                range_of(input),
                format!(
                    "the range of `{}` from {} to {} does not contain its reference value {}\n\
                     help: write the lower end first, and a reference value inside the range",
                    input.name,
                    show(low),
                    show(high),
                    show(value)
                ),
            );
        }
    }
    if !sound {
        return;
    }
    let mut ranges = Ranges {
        formulation,
        nominal,
        reference,
        values: Vec::new(),
    };
    let machine = &mut ranges.reference.machine;
    let needed = machine.closing.valued.clone();
    if let Some(unfollowed) = follow_angles(algebra, nominal, machine, &needed) {
        return report_unfollowed(algebra, unfollowed, reporter);
    }
    let declared: Vec<usize> = (0..nominal.ranges.len())
        .filter(|&k| nominal.ranges[k].is_some())
        .collect();
    let failure = match declared[..] {
        [] => None,
        [input] => ranges.first_failure(input, algebra.mechanism.inputs[input].dimension),
        _ => ranges.grid_failure(&declared),
    };
    if let Some(Broken {
        inputs,
        group,
        finite,
    }) = failure
    {
        let solved = &formulation.groups[group];
        let concerned = algebra.inputs_below(&[solved.closed.slack]);
        let input = *declared
            .iter()
            .find(|k| concerned.contains(k))
            .unwrap_or(&declared[0]);
        let how = match declared.len() {
            1 => String::new(),
            _ => format!(" (found on a grid of at most {GRID} positions)"),
        };
        let reach = match solved.group.loops.len() {
            1 => "reaches",
            _ => "reach",
        };
        let loops = loop_list(&solved.group.loops);
        let unknowns = words.unknowns(&solved.group.unknowns);
        let place = words.inputs(&inputs, &concerned);
        let message = match finite {
            true => format!(
                "the mechanism comes apart in this range: {loops} ({unknowns}) {reach} a dead point at {place}{how}\n\
                 help: restrict the range, or change the lengths so that the links reach each other all the way"
            ),
            false => format!(
                "the mechanism comes apart in this range: {loops} ({unknowns}) {reach} a division by zero, or a root or an \
                 arc function out of its range at {place}{how}\n\
                 help: restrict the range, or change what is not a finite number beyond it"
            ),
        };
        reporter.error_between(range_of(&algebra.mechanism.inputs[input]), message);
        return;
    }
    let machine = &mut ranges.reference.machine;
    let asked = machine.outputs_of(algebra, asked);
    if let Some(unfollowed) = follow_angles(algebra, nominal, machine, &asked) {
        report_unfollowed(algebra, unfollowed, reporter);
    }
}

/// Says that an angle cannot be followed over the range of an input.
pub(super) fn report_unfollowed(
    algebra: &Algebra,
    Unfollowed { angle, input }: Unfollowed,
    reporter: &mut Reporter,
) {
    let Some(unknown) = algebra.names.angles[angle].meant() else {
        return;
    };
    let unknown = &algebra.mechanism.unknowns[unknown];
    let (name, input) = (&unknown.name, &algebra.mechanism.inputs[input].name);
    reporter.error(
        unknown.origin,
        format!(
            "the value of `{name}` cannot be followed over the range of `{input}`: it strays by more than half a turn \
             from every uniform rotation\n\
             help: use whole multiples of `{name}` in directions, or a shorter range"
        ),
    );
}

/// Where the range is written, or the input's name.
pub(super) fn range_of(input: &Input) -> [OriginId; 2] {
    match &input.range {
        Some((low, high)) => [low.origin, high.origin],
        None => [input.origin; 2],
    }
}
