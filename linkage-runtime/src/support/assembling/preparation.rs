//! The numbers of an assembly that depend on its dimensions alone.

use linkage_core::Scalar;

use super::compiled::{Compiled, RevolutionsOf};
use super::list::List;
use crate::support::dispatch::{DataFunction, dispatch_function};

/// The inputs of one lane.
pub(super) fn lane_inputs<C: Compiled>(
    at: &C::Inputs,
    lane: usize,
) -> <C::Plain as Compiled>::Inputs {
    let mut inputs = <C::Plain as Compiled>::Inputs::repeat(at.as_ref().len(), 0.0);
    copy_lane(at.as_ref(), lane, inputs.as_mut());
    inputs
}

/// Copies one lane. One function for all mechanisms: their code is compiled often enough.
fn copy_lane<T: Scalar>(lanes: &[T], lane: usize, numbers: &mut [f64]) {
    for (number, lanes) in numbers.iter_mut().zip(lanes) {
        *number = lanes.lane(lane);
    }
}

/// The numbers that depend on dimensions, modes and revolutions alone, by the instructions that
/// calls choose: those that calls compute, too, are the same to the last bit.
pub(super) fn prepared<C: Compiled>(
    mechanism: &C,
    modes: &C::Modes,
    revolutions: &RevolutionsOf<C>,
) -> C::Prepared {
    let data = Unprepared {
        mechanism,
        modes,
        revolutions,
    };
    dispatch_function::<Preparation, _, C::Scalar, _, 0>(&data, [])
}

/// An assembly to prepare.
struct Unprepared<'a, C: Compiled> {
    mechanism: &'a C,
    modes: &'a C::Modes,
    revolutions: &'a RevolutionsOf<C>,
}

/// The program that prepares it.
enum Preparation {}

impl<C: Compiled> DataFunction<Unprepared<'_, C>, C::Scalar, C::Prepared, 0> for Preparation {
    #[inline(always)]
    fn value<const FUSED: bool>(data: &Unprepared<'_, C>, []: [C::Scalar; 0]) -> C::Prepared {
        let mechanism = data.mechanism;
        let zero = C::Scalar::from_f64(0.0);
        let mut slots = C::Prepared::repeat(mechanism.description().prepared, zero);
        mechanism.prepare::<FUSED>(data.modes, data.revolutions, &mut slots);
        slots
    }
}
