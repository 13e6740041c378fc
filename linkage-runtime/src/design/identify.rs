//! Dimensions from measured positions: estimates, how good they are, and what the readings cannot tell.

mod determined;
mod directions;
mod error;
mod fit;
mod identified;
mod named;
mod print;
mod reading;
mod rows;
mod run;
mod scale;
mod settled;
mod setup;
mod words;

pub use identified::{Identified, Residual, Unknown};
pub use reading::{Measured, Readings};
pub use setup::Identification;
pub use words::{Remedy, Undetermined};
