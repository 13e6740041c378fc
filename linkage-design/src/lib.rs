//! Dimensions for requirements: the dimensions that meet the objectives best, by least squares on
//! exact derivatives from many starts.
//!
//! A [`Design`] has the parameters that may vary with their bounds, the goals ([`Targets`]), and
//! the conditions ([`Relation`]s, and always: assembled over the whole range on one circuit). Its
//! [`run`](Design::run) descends from quasi-random starts in all assembly modes, in lanes over
//! mechanisms and with feature `rayon` on all threads, and lists all distinct local optima.
//!
//! A [`CycleDesign`] makes the largest or smallest value over a whole cycle best, from a mechanism
//! that is there: a longest
//! [`Dwell`], a least [`Peak`] of a torque, with limits for other [`Figure`]s.
//!
//! Users reach all items through the facade crate `linkage`, in its module `design`.
//!
//! Feature: `rayon` (searches on all threads).
#![cfg_attr(docsrs, feature(doc_cfg))]

mod builder;
mod catalogue;
mod certificate;
mod check;
mod columns;
mod condition;
mod contradiction;
mod cycle;
mod declared;
mod designs;
mod error;
mod identify;
#[doc(hidden)]
pub mod internals;
mod least_squares;
mod limits;
mod minimax;
mod normal;
mod numbered;
mod objective;
mod optimum;
mod parallel;
mod part;
mod problem;
mod proof;
mod quadratic;
mod quasi_random;
mod refusals;
mod relation;
mod results;
mod rounds;
mod run;
mod sampled;
mod search;
mod settings;
mod targets;
mod varied;
mod violation;

pub use builder::Design;
pub use certificate::{Interrupted, Interruption};
pub use cycle::{
    AuxiliaryVariable, BestCycle, Candidate, Check, Chosen, Compromise, Conditions, Curve,
    CycleDesign, CycleObjective, CyclePart, Dwell, ErrorOf, Figure, Fit, Highest, Lowest, Motion,
    Peak, Piece, PieceKey, Pieces, Requirement, RootMeanSquare, Stroke, TimeRatio, Verdict,
};
pub use designs::{DesignSearch, FoundDesign};
pub use error::{DesignError, Refusals};
pub use identify::{
    Identification, Identified, Measured, Readings, Remedy, Residual, Undetermined, Unknown,
};
pub use objective::{Candidates, Evaluate, Free, Objective, Rows};
pub use part::DesignPart;
pub use relation::Relation;
pub use sampled::Sampled;
pub use settings::Progress;
pub use targets::{Targets, Timing};
