//! The outputs of a group's programs, brought into the form in which they are used.

use super::group::CoupledGroup;
use alloc::vec::Vec;
use linkage_core::Scalar;
use linkage_core::numeric::continuation::Step;

/// The outputs of a correction: the state, the square of its change, the determinant.
pub(in crate::support) fn stepped(state: &mut [f64], outputs: &[f64]) -> Step {
    let (next, rest) = outputs.split_at(state.len());
    state.copy_from_slice(next);
    Step {
        size: Scalar::sqrt(rest[0]),
        determinant: rest[1],
    }
}

/// Complex numbers.
pub fn pairs(outputs: &[f64]) -> Vec<[f64; 2]> {
    outputs.chunks_exact(2).map(|c| [c[0], c[1]]).collect()
}

/// The result of [`CoupledPrograms::placed`](super::CoupledPrograms::placed), from outputs in this
/// order and the reach of the links.
pub(in crate::support) fn placed(group: &CoupledGroup, outputs: &[f64]) -> Vec<[f64; 2]> {
    let now = outputs.last().copied().unwrap_or(f64::NAN);
    let size = if now > 0.0 { group.reach / now } else { 1.0 };
    let mut next = outputs.iter().copied();
    let mut number = || next.next().unwrap_or(f64::NAN);
    let unknowns = group.unknowns.iter();
    let placed = unknowns.map(|unknown| match unknown.angle {
        true => [number(), number()],
        false => [number(), size],
    });
    placed.collect()
}
