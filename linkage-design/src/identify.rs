//! Dimensions from measured positions: estimates, their errors, and combinations that the readings
//! do not determine.

mod check;
mod determined;
mod directions;
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
mod undetermined;

pub use identified::{Identified, Residual, Unknown};
pub use reading::{Measured, Readings};
pub use setup::Identification;
pub use undetermined::{Remedy, Undetermined};
