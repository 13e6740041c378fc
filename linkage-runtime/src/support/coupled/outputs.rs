//! The outputs of a group's programs, brought into the form in which they are used.

use alloc::vec::Vec;
use linkage_core::Scalar;
use linkage_core::numeric::continuation::Step;

/// Puts a state in its place among arguments.
pub fn put_state<T: Copy>(arguments: &mut [T], first: usize, state: &[T]) {
    arguments[first..first + state.len()].copy_from_slice(state);
}

/// The outputs of a correction: the state, the square of its change, the determinant.
pub fn stepped(state: &mut [f64], outputs: &[f64]) -> Step {
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
/// order and the reach of the links, which is `reach` by default.
pub fn placed(angles: &[bool], reach: f64, outputs: &[f64]) -> Vec<[f64; 2]> {
    let now = outputs.last().copied().unwrap_or(f64::NAN);
    let size = if now > 0.0 { reach / now } else { 1.0 };
    let mut next = outputs.iter().copied();
    let mut number = || next.next().unwrap_or(f64::NAN);
    let one = |angle: &bool| {
        if *angle {
            [number(), number()]
        } else {
            [number(), size]
        }
    };
    angles.iter().map(one).collect()
}
