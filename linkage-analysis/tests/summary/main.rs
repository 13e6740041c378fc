//! Courses against closed forms, against a dense search, with gaps and at extreme scales.
#![cfg(feature = "alloc")]

mod closed_forms;
mod crossings;
mod dwells;
mod gaps;
mod harmonics;
mod lengths;
mod printed;
mod ranges;
mod samples;

use linkage_analysis::summary::Curve;

pub(crate) const TAU: f64 = std::f64::consts::TAU;
pub(crate) const PI: f64 = std::f64::consts::PI;

/// Over a turn, from 360 positions.
pub(crate) fn turn<const N: usize, F: Fn(f64) -> [f64; N]>(function: F) -> Curve<N, F> {
    Curve::new((0.0, TAU), 360, function).expect("a course")
}

#[track_caller]
pub(crate) fn near(found: f64, known: f64, tolerance: f64) {
    assert!((found - known).abs() <= tolerance, "{found} is not {known}");
}
