//! Whole cycles: extremes, strokes, dwells, torques and errors of a quantity over the range of the
//! input.

mod builder;
mod candidate;
mod conditions;
mod corners;
mod curve;
mod descent;
mod descents;
mod dwell;
mod ended;
mod error_of;
mod extent;
mod figures;
mod fit;
mod found;
mod front;
mod interval;
mod ladder;
mod mean;
mod part;
mod problem;
mod proof;
mod ratio;
mod requirement;
mod run;
mod searches;
mod spread;
mod verdict;
mod verify;

pub use builder::CycleDesign;
pub use candidate::{AuxiliaryVariable, Candidate, Chosen, CycleObjective, Motion};
pub use conditions::{Conditions, Piece, PieceKey};
pub use curve::Curve;
pub use dwell::Dwell;
pub use error_of::ErrorOf;
pub use figures::{Highest, Lowest, Peak, Stroke};
pub use fit::Fit;
pub use found::BestCycle;
pub use front::Compromise;
pub use mean::RootMeanSquare;
pub use part::CyclePart;
pub use ratio::TimeRatio;
pub use requirement::{Figure, Pieces, Requirement};
pub use verdict::{Check, Verdict};
