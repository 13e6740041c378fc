//! Effects of the tolerances of dimensions on a quantity, and tolerances for an allowed error.
//!
//! [`Tolerances`] times sensitivities are the [`Effects`] at a position; [`largest`] finds where in
//! a cycle a figure is largest; a [`Requirement`] divides an allowed error among the parameters;
//! [`Uncertainties`] give standard uncertainties, with correlations, as a [`Budget`] and to [second
//! order](SecondOrder); with feature `monte-carlo`, `MonteCarlo` evaluates random mechanisms.

mod allocation;
mod budget;
mod correlation;
mod cost;
mod cycle;
mod distribution;
mod effects;
mod error;
mod given;
mod grade;
pub(crate) mod modulus;
#[cfg(feature = "monte-carlo")]
mod monte_carlo;
mod requirement;
mod second_order;
mod sizes;
pub(crate) mod student;
mod uncertainties;

pub use crate::components::Components;
pub use allocation::{Allocation, AllocationRule, Costs};
pub use budget::{Budget, BudgetLine};
pub use cycle::{Extreme, largest, largest_at};
pub use distribution::Distribution;
pub use effects::{Contribution, Effects};
pub use error::ToleranceError;
pub use given::Tolerances;
pub use grade::{Grade, tolerance_factor};
#[cfg(feature = "monte-carlo")]
pub use monte_carlo::{
    Agreement, Estimate, ExtremeSample, MonteCarlo, Progress, Samples, Statistics, Stream, Study,
};
pub use requirement::{Addition, Requirement};
pub use second_order::SecondOrder;
pub use sizes::Sizes;
pub use uncertainties::Uncertainties;
