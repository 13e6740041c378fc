//! How close two organs come: the least distance of points and segments over a cycle, and the phase that makes it
//! largest.
//!
//! A [`Clearance`] holds all places of a cycle where the distance is least, as roots of exact derivatives; each
//! [`Nearest`] knows what dimensions do to the distance and to its place. [`Phases`] turns one organ against the
//! other on their shaft, a [`PhaseSet`] several of them.

mod ascent;
mod boxes;
mod case;
mod error;
mod least;
mod nearest;
mod phases;
mod probe;
mod search;
mod several;
mod shape;
mod slots;

pub use error::PhaseError;
pub use least::Clearance;
#[cfg(feature = "tolerance")]
pub use least::Guaranteed;
pub use nearest::Nearest;
pub use phases::Phases;
pub use search::{BestPhase, Contact, Optimum};
pub use several::{BestPhases, BestSteps, PairContact, PhaseSet};
pub use slots::BestStep;
