//! A solution of a coupled group, and its distance from the estimates.

use super::group::{CoupledGroup, CoupledUnknown};
use super::programs::CoupledPrograms;
use crate::error::{Placed, Value};
use alloc::vec::Vec;
use core::f64::consts::TAU;
use linkage_core::{Scalar, math};

/// A real solution of a group.
#[derive(Clone, Debug, PartialEq)]
pub struct CoupledSolution {
    /// Its state.
    pub state: Vec<f64>,
    /// The unknowns with start estimates: angles from -pi to pi, lengths.
    pub values: Vec<f64>,
    /// The distance from the estimates.
    pub distance: f64,
}

pub(super) fn solution(
    group: &CoupledGroup,
    programs: &mut dyn CoupledPrograms,
    x: &[f64],
    state: Vec<f64>,
) -> CoupledSolution {
    let placed = programs.placed(x, &state);
    let value = |(unknown, &[a, b]): (&CoupledUnknown, &[f64; 2])| {
        if unknown.angle {
            Scalar::atan2(b, a)
        } else {
            a
        }
    };
    let values: Vec<f64> = group.unknowns.iter().zip(&placed).map(value).collect();
    CoupledSolution {
        state,
        distance: distance(group, &values, &placed),
        values,
    }
}

fn distance(group: &CoupledGroup, values: &[f64], placed: &[[f64; 2]]) -> f64 {
    let square = |((unknown, value), [_, size]): ((&CoupledUnknown, &f64), &[f64; 2])| {
        let off = if unknown.angle {
            // Adding and subtracting 1.5 * 2^52 rounds to an integer.
            const ROUND: f64 = 6_755_399_441_055_744.0;
            let off = value - unknown.estimate;
            off - TAU * ((off / TAU + ROUND) - ROUND)
        } else {
            value * size - unknown.estimate
        };
        let off = off / unknown.scale;
        off * off
    };
    math::double::sqrt(
        group
            .unknowns
            .iter()
            .zip(values)
            .zip(placed)
            .map(square)
            .sum(),
    )
}

pub(super) fn placed(group: &CoupledGroup, values: &[f64]) -> Placed {
    let value = |(unknown, &value): (&CoupledUnknown, &f64)| Value {
        name: unknown.name,
        value,
        unit: unknown.unit,
        angle: unknown.angle,
    };
    Placed(group.unknowns.iter().zip(values).map(value).collect())
}
