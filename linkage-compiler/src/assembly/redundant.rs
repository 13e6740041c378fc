//! Loops that are said to follow from the others: by how much they do not, over the ranges.

use std::f64::consts::{PI, TAU};

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::Reporter;
use crate::mobility::difference;
use crate::model::{Loop, Mechanism, Type};

use super::ranges::GRID;
use crate::machine::Reference;
use crate::machine::other_inputs;
use crate::message_format::MessageFormat;

/// Positions along the range of each input.
const ALONG: usize = 97;

/// Sides that differ by a smaller share of the mechanism's size (angles: radians) are equal.
/// Positions are exact to some 1e-13; dimensions that are written with ten digits should do.
const EQUAL: f64 = 1e-9;

/// The largest difference between the sides of a loop.
struct Miss {
    inputs: Vec<f64>,
    difference: Vec<f64>,
    size: f64,
}

/// Reports each redundant loop that does not close with the others, where it misses most.
pub(crate) fn check_redundant(
    algebra: &mut Algebra,
    reference: &Reference,
    nominal: &Nominal,
    reporter: &mut Reporter,
) {
    let mechanism = algebra.mechanism;
    let positions = match mechanism.redundant.is_empty() {
        true => return,
        false => positions(mechanism, nominal, reference.longest),
    };
    for equation in &mechanism.redundant {
        // This evaluation must not change the code of functions.
        let miss = algebra.tried(|algebra| {
            let sides = difference(&mut algebra.names, equation);
            let found = positions
                .iter()
                .map(|inputs| missed(equation, reference.machine.evaluate(&sides, inputs), inputs));
            let known = found.filter(|miss| miss.size.is_finite());
            known.max_by(|a, b| a.size.total_cmp(&b.size))
        });
        let unit = match is_length(&equation.left.ty) {
            true => reference.longest,
            false => 1.0,
        };
        let Some(miss) = miss else {
            let fact = format!(
                "it cannot be told whether this loop follows from the others: its sides have no finite value (looked at {} positions)",
                positions.len()
            );
            let help = "look for a division by zero, or a root or an arc function out of its range";
            reporter.error_with_help(equation.origin, fact, help);
            continue;
        };
        if miss.size <= EQUAL * unit {
            continue;
        }
        let words = MessageFormat::new(mechanism);
        let all: Vec<usize> = (0..miss.inputs.len()).collect();
        let position = match all.is_empty() {
            true => String::new(),
            false => format!("at {} ", words.inputs(&miss.inputs, &all)),
        };
        let by = words.value(&equation.left.ty, &miss.difference);
        let fact = format!(
            "this loop does not follow from the others: {position}its sides differ by {by} (looked at {} positions)",
            positions.len()
        );
        let help = "correct the dimensions by which it should follow, or make it a loop that holds something: without `redundant`, with an \
                    unknown of its own";
        reporter.error_with_help(equation.origin, fact, help);
    }
}

/// Angles may differ by turns.
fn missed(equation: &Loop, difference: Vec<f64>, inputs: &[f64]) -> Miss {
    let is_angle = equation
        .left
        .ty
        .dimension()
        .is_some_and(|dimension| dimension.angle);
    let difference: Vec<f64> = match is_angle {
        true => difference
            .iter()
            .map(|x| (x + PI).rem_euclid(TAU) - PI)
            .collect(),
        false => difference,
    };
    Miss {
        size: difference.iter().map(|x| x * x).sum::<f64>().sqrt(),
        difference,
        inputs: inputs.to_vec(),
    }
}

fn is_length(ty: &Type) -> bool {
    ty.dimension()
        .is_some_and(|dimension| dimension.half_lengths != 0)
}

/// Places all over the ranges: along each input alone, and where they do not move in step.
fn positions(mechanism: &Mechanism, nominal: &Nominal, longest: f64) -> Vec<Vec<f64>> {
    let mut all = other_inputs(nominal, mechanism, longest);
    for (input, range) in nominal.ranges.iter().enumerate() {
        let Some((low, high)) = range else { continue };
        for k in 0..ALONG {
            let share = k as f64 / (ALONG - 1) as f64;
            let mut inputs = nominal.inputs.clone();
            inputs[input] = low + share * (high - low);
            all.push(inputs);
            if nominal.ranges.len() > 1 && all.len() < GRID {
                let scattered = nominal.ranges.iter().enumerate().map(|(other, range)| {
                    let (low, high) =
                        range.unwrap_or((nominal.inputs[other], nominal.inputs[other]));
                    low + (share * (other + 1) as f64 * 7.31).fract() * (high - low)
                });
                all.push(scattered.collect());
            }
        }
    }
    all
}
