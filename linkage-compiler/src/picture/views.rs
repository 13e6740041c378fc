//! The dimensions and inputs at which a picture's points are looked at.

use std::ops::Range;

use linkage_symbolic::Ex;

use crate::algebra::{Algebra, Nominal};
use crate::machine::{ALTERATIONS, Machine, Reference, altered, other_inputs};
use crate::model::MechanismPart;

/// The mechanism with some dimensions at inputs where it closes.
pub(super) struct View {
    pub(super) machine: Machine,
    pub(super) places: Vec<Vec<f64>>,
    /// Where its coordinates are in a track.
    pub(super) own: Range<usize>,
}

/// The mechanism as it is written, then with other dimensions, as far as it closes; and those, if it closes with none of them.
pub(super) fn views(
    algebra: &Algebra,
    reference: &Reference,
    nominal: &Nominal,
) -> (Vec<View>, Vec<Machine>) {
    let mechanism = algebra.mechanism;
    let all = other_inputs(nominal, mechanism, reference.longest);
    let unknowns = 0..algebra.names.bound.len();
    let numbers: Vec<Ex> = unknowns
        .flat_map(|own| algebra.names.numbers_of(own))
        .collect();
    let look = |machine: &Machine| -> Vec<Vec<f64>> {
        let closes = |inputs: &&Vec<f64>| {
            let values = machine.evaluate(&numbers, inputs);
            values.iter().all(|x| x.is_finite())
        };
        all.iter().filter(closes).cloned().collect()
    };
    let altered = |number: usize| altered(mechanism, nominal, reference.longest, number);
    let of_part = |part: &MechanismPart| -> Vec<f64> {
        let own = mechanism.scalar_parameters.iter().zip(&nominal.parameters);
        let own = own.zip(altered(0)).map(|((scalar, &value), other)| {
            match scalar.name.split('.').next() == Some(part.name.as_str()) {
                true => other,
                false => value,
            }
        });
        own.collect()
    };
    let mut views: Vec<View> = Vec::new();
    let mut look_at = |machine: Machine| {
        let places = look(&machine);
        let start = views.last().map_or(0, |view| view.own.end);
        // Nothing is learned from one position with dimensions that nobody asked for.
        if views.is_empty() || places.len() > 1 {
            let own = start..start + places.len();
            views.push(View {
                machine,
                places,
                own,
            });
        }
        views.len()
    };
    let mut count = look_at(reference.machine.clone());
    let other = (0..ALTERATIONS).map(|number| reference.machine.with_dimensions(altered(number)));
    let mut other: Vec<Machine> = other.collect();
    for machine in &other {
        count = look_at(machine.clone());
    }
    // A group that is closed by steps from a table closes with no other dimensions: then parts without any are altered alone.
    if count > 1 {
        other.clear();
    } else {
        for part in &mechanism.parts {
            look_at(reference.machine.with_dimensions(of_part(part)));
        }
    }
    (views, other)
}
