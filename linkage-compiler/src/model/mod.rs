//! Syntax tree to model: names become ids, dimensions are checked, numbers get one unit.

mod angles;
mod argument;
mod bare;
mod call_messages;
mod calls;
mod conversion;
mod decimal;
mod derivative;
mod dimension;
mod dump;
mod evaluators;
mod expression;
mod factors;
mod frame;
mod functions;
mod generated;
mod items;
mod mechanics;
mod names;
mod operators;
mod parameter;
mod passes;
mod picture;
mod place;
mod plane_and_space;
mod presentation;
mod refused;
mod shape;
#[cfg(test)]
mod tests;
mod types;
mod unitless;
mod units;
mod usage;
mod variable;
mod walk;
mod words;
mod zeros;

pub(crate) use dump::dump;
pub(crate) use frame::PARTS as FRAME_PARTS;
pub(crate) use functions::{MechanicsWord, MotionWord, QuantityWord};
pub(crate) use generated::{ASSEMBLY, COLUMNS, Sweep, TYPE_PARAMETER};
pub use parameter::COMPONENTS;
pub(crate) use presentation::significant;
pub use shape::Shape;
pub(crate) use types::*;
pub(crate) use usage::AskedPicture;
pub(crate) use walk::Derived;

use crate::diagnostic::{Diagnostics, Origins};
use crate::syntax::MechanismDef;

/// Checks names, dimensions and argument counts. `None` if anything was wrong, here or in the syntax; as much as can
/// be found is reported, consequences of what has been reported are not. What `origins` held before is replaced.
pub(crate) fn resolve(
    definition: &MechanismDef,
    origins: &mut Origins,
    diagnostics: &mut Diagnostics,
) -> Option<Mechanism> {
    let attempt = unitless::best_attempt(definition);
    *origins = attempt.origins;
    diagnostics.append(attempt.diagnostics);
    diagnostics.is_empty().then_some(attempt.mechanism)
}
