//! Whole cycles: extremes, strokes, dwells, torques and errors of a quantity over the range of the
//! input.

mod builder;
mod candidate;
mod corners;
mod curve;
mod demand;
mod descent;
mod descents;
mod dwell;
mod error_of;
mod extent;
mod figures;
mod fit;
mod found;
mod front;
mod interval;
mod ladder;
mod mean;
mod problem;
mod proof;
mod ratio;
mod run;
mod steady;
mod verdict;
mod verify;

pub use builder::CycleDesign;
pub use candidate::{Candidate, Chosen, Conditions, CycleWish, Motion, Own, Piece, Place};
pub use curve::Curve;
pub use demand::{Demand, Figure, Pieces};
pub use dwell::Dwell;
pub use error_of::ErrorOf;
pub use figures::{Highest, Lowest, Peak, Stroke};
pub use fit::Fit;
pub use found::BestCycle;
pub use front::Compromise;
pub use mean::RootMeanSquare;
pub use ratio::TimeRatio;
pub use verdict::{Check, Verdict};
