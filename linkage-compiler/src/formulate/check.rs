//! The range check: can the declared ranges be run through in the chosen assembly?

use linkage_runtime::numeric::range::first_failure;
use linkage_runtime::numeric::winding::{Winding, follow};

use crate::algebra::{Algebra, Atom, Nominal};
use crate::diagnostic::{Diagnostics, Origins};
use crate::lower::ContinuousAngle;
use crate::model::{Dimension, Input};
use crate::structure::report::loop_list;
use crate::syntax::SourceSpan;

use super::words::Words;
use super::{Formulation, Reference};

/// Samples for each turn of an input angle (or for a whole range of lengths); what lies between is found by searching for
/// dips.
const SAMPLES: f64 = 180.0;

/// A slack this small inside a range is a dead point: beyond it the mechanism may run on in its mirror image, even where
/// the slack only touches zero (a parallelogram stretched out). The search takes -1e-12 for rounding.
const DEAD: f64 = 2e-12;

/// The share of a range at its ends where a dead point is allowed: a range may end at one.
const END: f64 = 1e-9;

/// Positions of a grid over several inputs.
const GRID: usize = 2000;

/// Checks the ranges; reports where the mechanism comes apart, and an angle whose value is used but cannot be followed.
/// `asked` are the angles whose values functions use.
pub(crate) fn check_ranges(
    (algebra, formulation, nominal): (&Algebra, &Formulation, &Nominal),
    reference: &mut Reference,
    asked: &[ContinuousAngle],
    origins: &Origins,
    diagnostics: &mut Diagnostics,
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
            diagnostics.error(
                range_span(input, origins),
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
    let needed = ranges.reference.machine.valued.clone();
    if let Some((angle, input)) = ranges.follow_angles(algebra, &needed) {
        return report_unfollowed(algebra, angle, input, origins, diagnostics);
    }
    let declared: Vec<usize> = (0..nominal.ranges.len())
        .filter(|&k| nominal.ranges[k].is_some())
        .collect();
    let failure = match declared[..] {
        [] => None,
        [input] => ranges.first_failure(input, algebra.mechanism.inputs[input].dimension),
        _ => ranges.grid_failure(&declared),
    };
    if let Some((inputs, group)) = failure {
        let solved = &formulation.groups[group];
        let concerned = algebra.inputs_of_nodes(&[solved.closed.slack]);
        let input = *declared
            .iter()
            .find(|k| concerned.contains(k))
            .unwrap_or(&declared[0]);
        let how = match declared.len() {
            1 => String::new(),
            _ => format!(" (found on a grid of at most {GRID} positions)"),
        };
        diagnostics.error(
            range_span(&algebra.mechanism.inputs[input], origins),
            format!(
                "the mechanism comes apart in this range: {} ({}) reaches a dead point at {}{how}\n\
                 help: restrict the range, or change the lengths so that the links reach each other all the way",
                loop_list(&solved.group.loops),
                words.unknowns(&solved.group.unknowns),
                words.inputs(&inputs, &concerned),
            ),
        );
        return;
    }
    let asked = ranges.reference.machine.outputs_of(algebra, asked);
    if let Some((angle, input)) = ranges.follow_angles(algebra, &asked) {
        report_unfollowed(algebra, angle, input, origins, diagnostics);
    }
}

fn report_unfollowed(
    algebra: &Algebra,
    angle: usize,
    input: usize,
    origins: &Origins,
    diagnostics: &mut Diagnostics,
) {
    let Some(unknown) = algebra.angles[angle].meant() else {
        return;
    };
    let unknown = &algebra.mechanism.unknowns[unknown];
    let (name, input) = (&unknown.name, &algebra.mechanism.inputs[input].name);
    diagnostics.error(
        origins.span(unknown.origin),
        format!(
            "the value of `{name}` cannot be followed over the range of `{input}`: it strays by more than half a turn \
             from every uniform rotation\n\
             help: use whole multiples of `{name}` in directions, or a shorter range"
        ),
    );
}

/// The words of the range, or the input's name.
fn range_span(input: &Input, origins: &Origins) -> SourceSpan {
    match &input.range {
        Some((low, high)) => origins.span(low.origin).to(origins.span(high.origin)),
        None => origins.span(input.origin),
    }
}

struct Ranges<'a> {
    formulation: &'a Formulation,
    nominal: &'a Nominal,
    reference: &'a mut Reference,
    values: Vec<f64>,
}

impl Ranges<'_> {
    /// Finds centres and windings of angles whose values are used; each comes with the output of its cosine. Returns an
    /// angle and an input over whose range it cannot be followed.
    fn follow_angles(
        &mut self,
        algebra: &Algebra,
        angles: &[(usize, usize)],
    ) -> Option<(usize, usize)> {
        for &(angle, output) in angles {
            let estimate = self.reference.machine.centres[&angle];
            let mut centre = estimate;
            for input in 0..self.nominal.inputs.len() {
                let at = self.nominal.inputs[input];
                let dimension = algebra.mechanism.inputs[input].dimension;
                let Some((low, high)) = winding_range(self.nominal.ranges[input], at, dimension)
                else {
                    continue;
                };
                let rates = candidate_rates(algebra, input);
                let machine = &self.reference.machine;
                let values = &mut self.values;
                let mut inputs = self.nominal.inputs.clone();
                let found = follow(low, high, at, estimate, &rates, |x| {
                    inputs[input] = x;
                    machine.run(values, &inputs);
                    [
                        machine.output(values, output),
                        machine.output(values, output + 1),
                    ]
                });
                let Some(Winding { centre: own, turns }) = found else {
                    return Some((angle, input));
                };
                centre += own - estimate;
                self.reference
                    .machine
                    .windings
                    .insert((angle, input), turns);
            }
            self.reference.machine.centres.insert(angle, centre);
        }
        None
    }

    /// The smallest slack of all groups at given inputs, and its group; positive where the mechanism works.
    fn slack(&mut self, inputs: &[f64]) -> (f64, usize) {
        let machine = &self.reference.machine;
        machine.run(&mut self.values, inputs);
        let mut worst = (f64::INFINITY, 0);
        for (group, stage) in machine.stages.iter().enumerate() {
            let slack = self.reference.signs[group] * machine.output(&self.values, stage.slack);
            if slack.is_nan() {
                // A group before this one has come apart; that one counts.
                return if worst.0 <= 0.0 {
                    worst
                } else {
                    (f64::NAN, group)
                };
            }
            if slack < worst.0 {
                worst = (slack, group);
            }
        }
        worst
    }

    fn first_failure(&mut self, input: usize, dimension: Dimension) -> Option<(Vec<f64>, usize)> {
        let (low, high) = self.nominal.ranges[input]?;
        let turns = (high - low) / std::f64::consts::TAU;
        let samples = match dimension.half_lengths {
            0 => (SAMPLES * turns).clamp(64.0, 4000.0),
            _ => SAMPLES,
        };
        let mut inputs = self.nominal.inputs.clone();
        let start = inputs[input];
        let failure = first_failure(low, high, start, samples as usize, |x| {
            inputs[input] = x;
            let inside = (x - low).min(high - x) > END * (high - low);
            self.slack(&inputs).0 - if inside { DEAD } else { 0.0 }
        })?;
        let step = (high - low) * END;
        inputs[input] = failure.at + if failure.above { step } else { -step };
        let (_, group) = self.slack(&inputs);
        // Where the slack rises slowly from a dead point at an end of the range, that end is meant.
        let near = |end: f64| (failure.at - end).abs() < 1e-6 * (high - low);
        inputs[input] = [low, high]
            .into_iter()
            .find(|&end| near(end))
            .unwrap_or(failure.at);
        Some((inputs, group.min(self.formulation.groups.len() - 1)))
    }

    /// The first position of a grid over several inputs that cannot be assembled.
    fn grid_failure(&mut self, declared: &[usize]) -> Option<(Vec<f64>, usize)> {
        let side = (GRID as f64)
            .powf(1.0 / declared.len() as f64)
            .floor()
            .max(2.0) as usize;
        let count = side
            .checked_pow(declared.len() as u32)
            .unwrap_or(GRID)
            .min(GRID);
        for position in 0..count {
            let mut inputs = self.nominal.inputs.clone();
            let mut rest = position;
            for &input in declared {
                let (low, high) = self.nominal.ranges[input]?;
                let share = (rest % side) as f64 / (side - 1) as f64;
                inputs[input] = low + share * (high - low);
                rest /= side;
            }
            let (slack, group) = self.slack(&inputs);
            if slack.is_nan() || slack < -1e-12 {
                return Some((inputs, group));
            }
        }
        None
    }
}

/// The range over which an angle is followed: the declared one, or a turn about the reference.
pub(crate) fn winding_range(
    range: Option<(f64, f64)>,
    reference: f64,
    dimension: Dimension,
) -> Option<(f64, f64)> {
    let turn = (
        reference - std::f64::consts::PI,
        reference + std::f64::consts::PI,
    );
    range.or((dimension.half_lengths == 0).then_some(turn))
}

/// Turns that an unknown angle may make for each turn of an input: the rates at which vectors turn with it, and simple
/// multiples.
pub(crate) fn candidate_rates(algebra: &Algebra, input: usize) -> Vec<f64> {
    let mut rates = vec![0.0];
    if algebra.mechanism.inputs[input].dimension.half_lengths != 0 {
        return rates;
    }
    for base in [1.0]
        .into_iter()
        .chain(algebra.input_rates(Atom::Input(input)))
    {
        for factor in [1.0, -1.0, 2.0, -2.0, 0.5, -0.5] {
            let rate = base * factor;
            if rate != 0.0 && !rates.contains(&rate) {
                rates.push(rate);
            }
        }
    }
    rates
}
