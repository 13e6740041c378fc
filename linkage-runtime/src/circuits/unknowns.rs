//! The unknowns of an assembly: their numbers, and whether two assemblies are in one place.

use super::branch::Estimate;
use super::levels::Levels;
use crate::support::SurveyedUnknown;
use alloc::vec::Vec;
use linkage_core::Scalar;

/// The numbers of the unknowns.
pub(super) fn numbers<M: Levels>(mechanism: &M, assembly: &M::Assembly, x: f64) -> Vec<f64> {
    let before = 1 + mechanism.searched().levels.len();
    mechanism.survey(assembly, x).as_ref()[before..].to_vec()
}

pub(super) fn estimates<M: Levels>(mechanism: &M, assembly: &M::Assembly, x: f64) -> Vec<Estimate> {
    let numbers = numbers(mechanism, assembly, x);
    let mut next = numbers.iter().copied();
    let estimate = |unknown: &SurveyedUnknown| {
        let components: Vec<f64> = next.by_ref().take(unknown.numbers).collect();
        Estimate {
            name: unknown.name,
            unit: unknown.unit,
            angle: unknown.angle,
            numbers: match components[..] {
                [cosine, sine] if unknown.angle => Vec::from([Scalar::atan2(sine, cosine)]),
                _ => components,
            },
        }
    };
    let unknowns = mechanism.searched().unknowns;
    unknowns.iter().map(estimate).collect()
}

/// Returns true if two lists of numbers are equal, within a share of this size.
pub(super) fn near(a: &[f64], b: &[f64], size: f64, share: f64) -> bool {
    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= share * size;
    a.iter().zip(b).all(close)
}

/// The largest of some numbers.
pub(super) fn size(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |size: f64, x| size.max(x.abs()))
}
