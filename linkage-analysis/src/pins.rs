//! The diameter of a joint's pin under its largest reaction, by bending, shear and bearing
//! pressure, and the stresses of a pin that is given.
//!
//! A [`Pin`] has a load, a [`Mounting`] and the [`Limit`]s of its material. [`Pin::diameter`] gives
//! the diameter that each check requires, [`Pin::check`] the stresses at a diameter;
//! [`largest_load`] finds the load in a cycle of reactions, [`standard_diameter`] the next size
//! that can be bought.
//!
//! Any units do that fit each other: stresses are forces per square of the length. With newtons and
//! millimetres they are in MPa.
//!
//! The formulas are those of textbooks on machine elements (pinned joints in Roloff/Matek, Dubbel
//! or Shigley). Bending and shear are not combined, since shear is largest where bending stress is
//! zero. Shocks and changing loads belong into the load, or into the strength, which is then the
//! one for that kind of load.

mod check;
mod criterion;
mod error;
mod formulas;
mod load;
mod pin;
mod size;
mod standard;
mod validate;

pub use crate::components::Components;
pub use check::{Check, Stress};
pub use criterion::{BearingPart, Criterion};
pub use error::PinError;
pub use load::{Largest, largest_load};
pub use pin::{Fit, Limit, Member, Mounting, Pin, Width};
pub use size::Size;
pub use standard::{STANDARD_DIAMETERS, standard_diameter};
