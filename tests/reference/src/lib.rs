//! The accuracy proof of `linkage`.
//!
//! A test mechanism is written twice: in the language of `linkage::mechanism!` (in several written
//! forms, which the engine compiles), and here as a [`System`]: its loop equations as residuals over unknown unit vectors, slides
//! and coordinates, with `c^2 + s^2 = 1` as further equations. The reference solves the system by Newton's
//! method in 154 digits and takes every derivative as a central difference of the *solved* quantity
//! with steps of 8e-31. No formula of the compiler is used: no closed form of a dyad, no derivative
//! of a loop.
//!
//! The numbers of the `f64` program are taken as exact. Errors are stated in three ways, each a
//! multiple of the unit roundoff: of the size of the mechanism (its longest length, slide or
//! coordinate), of that size times the condition number (one over the normalised determinant of a
//! dyad's loop, times the lever of the output), and of the *inherent uncertainty*, which is what a
//! change of one roundoff in every dimension and input does to the quantity (itself taken from the
//! reference).
//!
//! Every form is computed twice: as this build does, and with multiply-adds that are always fused.

mod answers;
mod big;
mod cases;
mod compare;
mod datum;
mod edge;
mod errors;
mod fused;
mod gap;
mod homogeneous;
mod limits;
mod matrix;
mod plane;
mod program;
mod reference;
mod report;
mod solve;
mod system;
mod uncertainty;

pub use answers::{Answers, Components, concatenate};
pub use big::{BITS, Big};
pub use cases::{
    Plan, cycle_cases, dead_point_cases, decade_cases, far_input_cases, nearby_cases,
    proportion_cases, scale_cases, tried, wide_scale_cases,
};
pub use cases::{approach, rescaled};
pub use compare::{Case, Depth, Evaluate, Form, Variant, compare};
pub use datum::{Datum, Kind, Unknown};
pub use edge::{Edge, edge};
pub use fused::Fused;
pub use gap::{circle_gap, line_gap, planes_line, reach_gap, triangle_gap};
pub use homogeneous::homogeneous;
pub use limits::Limits;
pub use linkage_random::Random;
pub use plane::Plane;
pub use plane::Space;
pub use program::{Parameters, Program, Values};
pub use reference::Reference;
pub use report::{Measure, Report};
pub use solve::{Solution, solve};
pub use system::{Output, Position, System};

use compare::default_mode;

/// Unit roundoff of `f64`: half of the distance from 1 to the next number.
pub const ROUNDOFF: f64 = f64::EPSILON / 2.0;
