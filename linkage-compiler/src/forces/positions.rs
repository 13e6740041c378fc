//! The positions at which bodies and joints are looked at on numbers.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::Nominal;
use crate::machine::{ALTERATIONS, Reference, altered, other_inputs};
use crate::message_format::MessageFormat;
use crate::model::Mechanism;

/// Velocities that differ by a smaller share are equal: derivatives are rounded far less than this, and what is
/// written wrongly is wrong by far more.
pub(super) const EQUAL: f64 = 1e-7;

/// Where velocities are compared, smaller ones count as so large: per unit of an input a turn in radians, a shift in
/// lengths of the mechanism.
pub(super) const SLOW: f64 = 1e-3;

/// The reference position and a few others.
pub(super) struct Positions<'a> {
    reference: &'a Reference,
    inputs: Vec<Vec<f64>>,
}

/// One of them.
#[derive(Clone, Copy)]
pub(super) struct Position<'a> {
    reference: &'a Reference,
    inputs: &'a [f64],
}

impl<'a> Positions<'a> {
    /// Those at which other phases look at numbers, too.
    pub(super) fn new(mechanism: &Mechanism, reference: &'a Reference, nominal: &Nominal) -> Self {
        Self {
            reference,
            inputs: other_inputs(nominal, mechanism, reference.longest),
        }
    }

    /// Each of them, the reference first.
    pub(super) fn iter(&self) -> impl Iterator<Item = Position<'_>> {
        self.inputs.iter().map(|inputs| Position {
            reference: self.reference,
            inputs,
        })
    }

    /// Numbers where the mechanism closes, also with other dimensions and in other assemblies, each group in its other
    /// mode once: what they have in common there is no chance.
    pub(super) fn numbers_anyhow(
        &self,
        mechanism: &Mechanism,
        nominal: &Nominal,
        all: &[Ex],
    ) -> Vec<Vec<f64>> {
        let machine = &self.reference.machine;
        let modes = std::iter::once(None).chain((0..machine.modes.len()).map(Some));
        let machines = modes.flat_map(|flipped| {
            (0..ALTERATIONS).map(move |number| {
                let dimensions = altered(mechanism, nominal, self.reference.longest, number);
                let mut machine = machine.with_dimensions(dimensions);
                if let Some(mode) = flipped {
                    machine.modes[mode] *= -1.0;
                }
                machine
            })
        });
        let numbers = machines.flat_map(|machine| {
            let places = self.inputs.iter();
            places
                .map(|inputs| machine.evaluate(all, inputs))
                .collect::<Vec<_>>()
        });
        numbers
            .filter(|numbers| numbers.iter().all(|x| x.is_finite()))
            .collect()
    }

    /// Numbers at the positions where the mechanism closes.
    pub(super) fn numbers(&self, all: &[Ex]) -> Vec<Vec<f64>> {
        let numbers = self.iter().map(|position| numbers(position, all));
        numbers
            .filter(|numbers| numbers.iter().all(|x| x.is_finite()))
            .collect()
    }
}

/// Values of expressions; NaN where the mechanism does not close.
pub(super) fn numbers(position: Position<'_>, all: &[Ex]) -> Vec<f64> {
    position.reference.machine.evaluate(all, position.inputs)
}

/// The components of a vector.
pub(super) fn vector(position: Position<'_>, v: Vn) -> Vec<f64> {
    numbers(position, &v.iter().collect::<Vec<_>>())
}

/// The length that lengths of the mechanism are compared with.
pub(super) fn longest(position: Position<'_>) -> f64 {
    position.reference.longest
}

/// `at phi = 30deg `; nothing without inputs.
pub(super) fn words(position: Position<'_>, mechanism: &Mechanism) -> String {
    let all: Vec<usize> = (0..position.inputs.len()).collect();
    match all.is_empty() {
        true => String::new(),
        false => format!(
            "at {} ",
            MessageFormat::new(mechanism).inputs(position.inputs, &all)
        ),
    }
}

/// The length of a vector.
pub(super) fn size(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
