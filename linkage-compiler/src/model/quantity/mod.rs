//! Quantities of functions: derivatives, screws, pictures, reactions.

pub(super) mod derivative;
pub(super) mod input_derivative;
pub(super) mod mechanics;
pub(super) mod moving_frame;
pub(super) mod picture;
pub(super) mod resolve;
pub(super) mod screw;
pub(super) mod variable;
