//! Relations and bounds that contradict each other, and the size of the contradiction.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::limits::{Limits, Linear};
use super::{DesignError, Relation};
use linkage_core::format::rounded;

/// Halvings of the amount by which a relation is missed: to some ten digits.
const HALVINGS: usize = 34;

/// `Ok` if the relations leave anything within the bounds of the variables, whose names these are;
/// else a smallest set that does not: without any of its relations and bounds the others can hold.
pub(crate) fn consistent(
    relations: &[Relation],
    limits: &Limits,
    names: &[&'static str],
) -> Result<(), DesignError> {
    let bounds = limits.lower.iter().zip(&limits.upper);
    let middle: Vec<f64> = bounds.map(|(low, high)| 0.5 * (low + high)).collect();
    if limits.nearest(&middle).is_some() {
        return Ok(());
    }
    let possible = |limits: &Limits| limits.nearest(&middle).is_some();
    let mut least = limits.clone();
    let mut needed: Vec<usize> = (0..limits.relations.len()).collect();
    for k in (0..needed.len()).rev() {
        let mut without = least.clone();
        without.relations.remove(k);
        if !possible(&without) {
            least = without;
            needed.remove(k);
        }
    }
    let mut bound_texts: Vec<String> = Vec::new();
    for (j, name) in names.iter().enumerate() {
        for upper in [false, true] {
            let none = if upper {
                f64::INFINITY
            } else {
                f64::NEG_INFINITY
            };
            let side = |limits: &mut Limits, bound: f64| {
                let side = if upper {
                    &mut limits.upper
                } else {
                    &mut limits.lower
                };
                core::mem::replace(&mut side[j], bound)
            };
            let bound = side(&mut least, none);
            if possible(&least) {
                side(&mut least, bound);
                let words = if upper { "at most" } else { "at least" };
                bound_texts.push(format!("`{name}` {words} {}", rounded(bound)));
            }
        }
    }
    Err(DesignError::Contradiction {
        missed: missed(&least, &middle),
        relations: needed
            .into_iter()
            .map(|k| relations[k].described())
            .collect(),
        bounds: bound_texts,
    })
}

/// Returns the least miss of the last relation where the others hold.
fn missed(limits: &Limits, middle: &[f64]) -> f64 {
    let mut others = limits.clone();
    let Some(last) = others.relations.pop() else {
        return 0.0;
    };
    let Some(nearest_point) = others.nearest(middle) else {
        return 0.0;
    };
    let slack = last.slack(&nearest_point);
    let (mut broken, mut held) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let share = 0.5 * (broken + held);
        let mut moved = others.clone();
        moved.relations.push(Linear {
            most: last.most - share * slack,
            ..last.clone()
        });
        match moved.nearest(&nearest_point) {
            Some(_) => held = share,
            None => broken = share,
        }
    }
    (held * slack).abs()
}
