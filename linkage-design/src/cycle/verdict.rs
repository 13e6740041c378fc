//! The verdict on a result: goal and conditions of an objective, computed without the search.

use std::vec::Vec;

use super::conditions::{Conditions, Piece};

/// Goal and conditions of an objective in a mechanism that a search found, computed from the
/// assembled mechanism without the search.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// The value that the search makes least; `None` if the objective is only a condition.
    pub goal: Option<f64>,
    /// The conditions of the objective.
    pub conditions: Vec<Check>,
}

/// A condition of a result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Check {
    /// The violation of the condition, in its unit; not above zero where it holds.
    pub by: f64,
    /// The size that a violation is compared with, such as the band of a dwell. Without it the
    /// search takes the change of the condition in the first step.
    pub size: Option<f64>,
}

impl Verdict {
    /// The largest piece of the goal, and of each condition.
    pub(super) fn from_conditions<const N: usize>(asked: &Conditions<N>) -> Self {
        let largest = |pieces: &Vec<Piece<N>>| {
            let values = pieces.iter().map(|piece| piece.value);
            // Unlike `f64::max` this keeps NaN.
            values.reduce(|a, b| if a.is_nan() || a > b { a } else { b })
        };
        let check = |pieces: &Vec<Piece<N>>| {
            let by = largest(pieces)?;
            Some(Check { by, size: None })
        };
        Self {
            goal: largest(&asked.goal),
            conditions: asked.conditions.iter().filter_map(check).collect(),
        }
    }
}
