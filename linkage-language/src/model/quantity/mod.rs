//! Quantities of functions: derivatives, screws, pictures, reactions.

pub(super) mod derivative;
pub(super) mod dynamics;
pub(super) mod force_arguments;
pub(super) mod forces;
pub(super) mod input_derivative;
pub(super) mod moving_frame;
pub(super) mod picture_links;
pub(super) mod quantity_call;
pub(super) mod screw;
pub(super) mod variable;
