//! Clearance of two members: the least distance of points and segments over a cycle, and the phase
//! with the largest one.
//!
//! A [`Clearance`] contains all places of a cycle where the distance is least, as roots of exact
//! derivatives. Each [`Nearest`] has the sensitivities of the distance and of its place to the
//! dimensions. [`Phases`] turns one member against the other on their shaft, a [`PhaseSet`] several
//! of them.

mod ascent;
mod boxes;
mod case;
mod error;
mod minima;
mod nearest;
mod phases;
mod probe;
mod search;
mod several;
mod shape;
mod slots;

pub use error::PhaseError;
pub use minima::Clearance;
#[cfg(feature = "tolerance")]
pub use minima::Guaranteed;
pub use nearest::Nearest;
pub use phases::Phases;
pub use search::{BestPhase, Contact, Optimum};
pub use several::{BestPhases, BestSteps, PairContact, PhaseSet};
pub use slots::BestStep;
