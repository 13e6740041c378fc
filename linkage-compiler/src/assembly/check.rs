//! The range check: can the declared ranges be run through in the chosen assembly?

use linkage_core::range_check::{Comes, PASSES_HELP, passes};

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::Reporter;
use crate::ir::ContinuousAngle;
use crate::model::{Input, Mechanism};
use crate::solve::Formulation;

use super::follow::{Unfollowed, follow_angles};
use super::ranges::{Broken, Ranges};
use super::refused_range::{RefusedRange, range_of};
use crate::machine::Reference;
use crate::message_format::MessageFormat;

/// A mechanism that closes at the reference inputs.
pub(super) struct ClosedMechanism<'a, 'm> {
    pub(super) formulation: &'a Formulation<'m>,
    /// The dimensions, with the ranges over which coupled groups are prepared.
    pub(super) nominal: &'a Nominal,
    /// The dimensions with ranges as they are declared.
    pub(super) written: &'a Nominal,
    pub(super) reference: &'a mut Reference,
    /// The refusal of the declared ranges, if those of `nominal` are narrower.
    pub(super) refused: Option<RefusedRange>,
}

/// Checks the ranges; reports where the mechanism comes apart, and an angle whose value is used but
/// cannot be followed. `asked` are the angles whose values functions use.
pub(super) fn check_ranges<'m>(
    algebra: &mut Algebra<'m>,
    closed: ClosedMechanism<'_, 'm>,
    asked: &[ContinuousAngle],
    reporter: &mut Reporter,
) {
    let ClosedMechanism {
        formulation,
        nominal,
        written,
        reference,
        refused,
    } = closed;
    if has_wrong_range(algebra.mechanism, written, reporter) {
        return;
    }
    let mut ranges = Ranges {
        formulation,
        nominal,
        program: reference.machine.whole(),
        reference,
    };
    let machine = &mut ranges.reference.machine;
    let needed = machine.closure.valued.clone();
    if let Some(unfollowed) = follow_angles(algebra, nominal, machine, &needed) {
        if let Some(refused) = refused {
            refused.report(algebra.mechanism, None, reporter);
        }
        return report_unfollowed(algebra, unfollowed, reporter);
    }
    let declared: Vec<usize> = (0..nominal.ranges.len())
        .filter(|&k| nominal.ranges[k].is_some())
        .collect();
    match (&declared[..], refused) {
        ([input], Some(refused)) => {
            let dimension = algebra.mechanism.inputs[*input].dimension;
            let is_range = nominal.ranges[*input].is_some_and(|(low, high)| low < high);
            let works = is_range && ranges.first_failure(*input, dimension).is_none();
            let nominal = works.then_some(nominal);
            return refused.report(algebra.mechanism, nominal, reporter);
        }
        ([input], None) => {
            let dimension = algebra.mechanism.inputs[*input].dimension;
            if let Some(at) = ranges.first_failure(*input, dimension) {
                let apart = ranges.apart(algebra, at);
                let span = reporter.span_between(apart.origins);
                let message = reporter.error_between(apart.origins, apart.message);
                if let Some(range) = apart.range {
                    message.suggest(format!("write `in {range}`, which works"), span, range);
                }
                return;
            }
        }
        ([], _) => warn_of_change_point(algebra, &mut ranges, reporter),
        (declared, refused) => {
            if let Some(broken) = ranges.grid_failure(declared) {
                let refused =
                    refused.unwrap_or_else(|| ranges.apart_on_grid(algebra, declared, &broken));
                let works = ranges.largest_box(algebra.mechanism, declared);
                return refused.report(algebra.mechanism, works.as_ref(), reporter);
            }
            if let Some(refused) = refused {
                return refused.report(algebra.mechanism, Some(nominal), reporter);
            }
        }
    }
    let machine = &mut ranges.reference.machine;
    let asked = machine.outputs_of(algebra, asked);
    if let Some(unfollowed) = follow_angles(algebra, nominal, machine, &asked) {
        report_unfollowed(algebra, unfollowed, reporter);
    }
}

/// Reports ranges with errors in their ends or in the reference value; true if there are any.
fn has_wrong_range(mechanism: &Mechanism, nominal: &Nominal, reporter: &mut Reporter) -> bool {
    let words = MessageFormat::new(mechanism);
    let mut wrong = false;
    for (index, input) in mechanism.inputs.iter().enumerate() {
        let Some((low, high)) = nominal.ranges[index] else {
            continue;
        };
        let value = nominal.inputs[index];
        if let Some(message) = wrong_range(&words, input, [low, high], value) {
            wrong = true;
            reporter.error_between(range_of(input), message);
        }
    }
    wrong
}

/// Returns the error in the ends of a range or in the reference value, if there is one.
fn wrong_range(
    words: &MessageFormat,
    input: &Input,
    [low, high]: [f64; 2],
    value: f64,
) -> Option<String> {
    let name = &input.name;
    let show = |x, other| words.distinguished(input.dimension, x, other);
    let [from, to] = [show(low, high), show(high, low)];
    let of_angle = input.dimension.half_lengths == 0;
    if low == high {
        return Some(format!(
            "the range of `{name}` from {from} to {to} is a single position\n\
             help: write a lower and a higher end, or no range for an input that stays where it is"
        ));
    }
    if low > high {
        let turn = match of_angle {
            true => "; an angle may go on beyond a turn, as in `350deg..370deg`",
            false => "",
        };
        return Some(format!(
            "the range of `{name}` begins at {from}, above its end at {to}\n\
             help: write the lower end first{turn}"
        ));
    }
    let outside = |end: f64| {
        let [value, from, to] = [show(value, end), show(low, value), show(high, value)];
        format!(
            "the range of `{name}` from {from} to {to} does not contain its reference value {value}\n\
             help: write a reference value inside the range, or a wider range"
        )
    };
    match value {
        _ if value < low => Some(outside(low)),
        _ if value > high => Some(outside(high)),
        _ => None,
    }
}

/// Warns of a change point: a mechanism driven by one angle without a range may be meant to turn
/// fully, and only seem to do so.
fn warn_of_change_point(algebra: &mut Algebra, ranges: &mut Ranges, reporter: &mut Reporter) {
    let formulation = ranges.formulation;
    let [input] = &algebra.mechanism.inputs[..] else {
        return;
    };
    if input.dimension.half_lengths != 0 || formulation.prepared().next().is_some() {
        return;
    }
    let Some(Broken { inputs, group, .. }) = ranges.first_change_point(0) else {
        return;
    };
    let words = MessageFormat::new(algebra.mechanism);
    let group = &formulation.groups[group].group;
    let position = words.inputs(&inputs, &[0]);
    let loops = words.loops(&group.loops);
    let unknowns = words.unknowns(&group.unknowns);
    let group = Comes {
        loops: &loops,
        several: group.loops.len() != 1,
        unknowns: &unknowns,
    };
    reporter.warning_with_help(input.origin, passes(group, &position), PASSES_HELP);
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
