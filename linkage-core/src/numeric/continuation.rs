//! Groups of equations without a closed form: their solution is prepared as a table over the input,
//! followed from one known solution, and corrected by Newton steps where it is used.
//!
//! The *state* of a group is a few numbers, all about 1: cosine and sine of its angles, its lengths
//! scaled. A table gives the state at any input with an error of 1e-9 or less, so that a single
//! Newton step brings it to rounding. It also gives the *floor*, half of the smallest determinant
//! near that input: a step that is small while the determinant is not below the floor cannot have
//! ended on another solution.
//!
//! With several inputs, or none, the states are prepared on a [`Grid`]. Over two inputs it has
//! polynomials and one step is made, as from a table; over others it has slopes, and four steps are
//! made.

mod cell;
mod estimate;
mod follow;
mod grid;
mod isolation;
mod layout;
mod lookup;
mod polynomial;
mod scale;
mod shared;
mod states;
mod straight;
mod table;
mod turning_point;
mod walk;

pub use crate::certificate::{ALLOWED_CONTRACTION, FIRST_CORRECTION, STEPS_BESIDE};
pub use estimate::{Astray, from_estimate, turned};
pub use grid::{Grid, GridLookup, LeftOut, Terms, reached};
pub use layout::{Axis, CellLayout, GridLayout, NodeLayout, TableLayout};
pub use lookup::Lookup;
pub use states::{meeting_states, states};
pub use straight::dead_point;
pub use table::Table;

use crate::scalar::Enclosure;
use alloc::vec::Vec;

/// A group of equations with a correction that brings a state nearer to the solution.
pub trait Correction {
    /// One Newton step at the inputs `x`, in place. Where there is none the step's size is NaN.
    fn correct(&mut self, x: &[f64], state: &mut [f64]) -> Step;
}

impl<F: FnMut(&[f64], &mut [f64]) -> Step> Correction for F {
    fn correct(&mut self, x: &[f64], state: &mut [f64]) -> Step {
        self(x, state)
    }
}

/// A group of which a solution can be proven.
pub trait Residuals: Correction {
    /// Returns the errors of the equations over a box of states, at the inputs `x`: as many as the
    /// unknowns have numbers, less one for each unit vector. Returns none for a group without a
    /// proof.
    fn residuals(&mut self, _x: &[f64], _state: &[Enclosure]) -> Vec<Enclosure> {
        Vec::new()
    }
}

/// A Newton step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The largest change: radians, or lengths on the scale of the state.
    pub size: f64,
    /// The determinant of the equations, with its sign, where the step began.
    pub determinant: f64,
}

/// The range of an input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// One end.
    pub low: f64,
    /// The other end; below the first one it is the lower.
    pub high: f64,
    /// True if the input is an angle in radians of which everything repeats after a turn.
    pub turn: bool,
}

/// The end of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// It does not: the state repeats after a turn.
    Closed,
    /// With the range.
    Range(f64),
    /// At a turning point, where this solution meets another one and both end.
    TurningPoint(f64),
    /// A place beyond which the solution cannot be followed: another one is too near.
    Lost(f64),
}

/// Why there is no table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refusal {
    /// The solution ends inside the range, where it meets another one.
    TurningPoint {
        /// The input there.
        at: f64,
    },
    /// The solution cannot be followed beyond a place, or needs too large a table.
    NotConverging {
        /// The input there.
        at: f64,
    },
    /// The state to start from is no solution, or a singular one.
    NotASolution,
    /// The range or the place to start from is not finite.
    NotFinite,
}
