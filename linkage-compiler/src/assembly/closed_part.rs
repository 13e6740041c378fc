//! Mechanisms that are assembled already, as parts of another one.

use std::f64::consts::PI;
use std::rc::Rc;

use linkage_symbolic::Ex;
use linkage_symbolic::program::Ternary;

use crate::algebra::{Algebra, Bound, Nominal};
use crate::machine::{Machine, Reference};
use crate::model::{Dimension, LengthUnit, Type};
use crate::solve::Solved;

/// The number of steps in a turn of an input: an angle turns by less than half a turn in each,
/// gears of any use included.
const STEPS_OF_A_TURN: f64 = 144.0;

/// The largest number of steps: no linkage turns hundreds of times.
const STEPS: f64 = 10_000.0;

/// A mechanism assembled at its own reference, for those that it is a part of.
#[derive(Debug)]
pub(crate) struct AssembledPart {
    machine: Machine,
    pub(super) nominal: Nominal,
    pub(super) unit: LengthUnit,
    pub(super) parameters: Vec<Dimension>,
    pub(super) inputs: Vec<Dimension>,
    /// For each unknown, the index of its numbers among the outputs, and whether they are a cosine
    /// and a sine.
    unknowns: Vec<Option<(usize, bool)>>,
    pub(super) dimensions: Vec<Dimension>,
}

/// A part of the mechanism that is closed.
pub(crate) struct InnerPart<'m> {
    pub(super) closed: Rc<AssembledPart>,
    pub(super) first_unknown: usize,
    /// Its inputs, and the unknowns that they are made of.
    pub(super) inputs: Vec<Ex<'m>>,
    pub(super) needs: Vec<usize>,
    /// Its dimensions here, in its own units.
    pub(super) parameters: Vec<f64>,
    /// The number of the part's length units in one length unit here.
    pub(super) ratio: f64,
}

impl AssembledPart {
    pub(crate) fn new(algebra: &Algebra, reference: Reference, nominal: Nominal) -> Self {
        let mechanism = algebra.mechanism;
        let mut unknowns = vec![None; mechanism.unknowns.len()];
        let outputs = reference.machine.closure.groups.iter();
        for &(unknown, output) in outputs.flat_map(|group| &group.unknowns) {
            let is_angle = matches!(algebra.names.bound[unknown], Bound::Angle(_));
            unknowns[unknown] = Some((output, is_angle));
        }
        let of_unknown = |ty: &Type| ty.dimension().unwrap_or(Dimension::NUMBER);
        let all = mechanism.unknowns.iter();
        Self {
            machine: reference.machine,
            nominal,
            unit: mechanism.unit,
            parameters: mechanism
                .scalar_parameters
                .iter()
                .map(|parameter| parameter.dimension)
                .collect(),
            inputs: mechanism
                .inputs
                .iter()
                .map(|input| input.dimension)
                .collect(),
            dimensions: all.map(|unknown| of_unknown(&unknown.ty)).collect(),
            unknowns,
        }
    }

    /// Returns the part's unknowns with these dimensions, followed from the reference to these
    /// inputs; an unknown that cannot be assembled there is not a number.
    pub(super) fn led_to(&self, parameters: Vec<f64>, inputs: &[f64]) -> Vec<Vec<f64>> {
        let machine = self.machine.with_dimensions(parameters);
        let from = &self.nominal.inputs;
        let ways = from.iter().zip(inputs).zip(&self.inputs);
        let turns = ways.map(|((from, to), dimension)| match dimension.half_lengths {
            0 => (to - from).abs() / (2.0 * PI),
            _ if from == to => 0.0,
            _ => 1.0,
        });
        let steps = turns.fold(0.0, f64::max) * STEPS_OF_A_TURN;
        let steps = steps.ceil().clamp(1.0, STEPS);
        let mut found = self.nominal.estimates.clone();
        let mut program = machine.whole();
        for step in 0..=steps as usize {
            let share = step as f64 / steps;
            let ways = from.iter().zip(inputs);
            let at: Vec<f64> = match share {
                // At share 1, interpolation may miss the end by rounding.
                1.0 => inputs.to_vec(),
                _ => ways.map(|(from, to)| from + share * (to - from)).collect(),
            };
            machine.run_staged(&mut program, &at);
            for (numbers, unknown) in found.iter_mut().zip(&self.unknowns) {
                let Some((output, is_angle)) = *unknown else {
                    continue;
                };
                let number = |k: usize| program.output(output + k);
                let next: Vec<f64> = match is_angle {
                    true => vec![Ternary::AngleNear.apply([number(1), number(0), numbers[0]])],
                    false => (0..numbers.len()).map(number).collect(),
                };
                // On the way it may come apart; where it arrives counts.
                if share == 1.0 || next.iter().all(|x| x.is_finite()) {
                    *numbers = next;
                }
            }
        }
        found
    }
}

impl InnerPart<'_> {
    pub(super) fn has(&self, unknown: usize) -> bool {
        let index = unknown.checked_sub(self.first_unknown);
        index.is_some_and(|index| index < self.closed.unknowns.len())
    }

    pub(super) fn is_in(&self, solved: &Solved) -> bool {
        solved
            .group
            .unknowns
            .iter()
            .any(|&unknown| self.has(unknown))
    }
}
