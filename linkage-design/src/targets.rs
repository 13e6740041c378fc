//! Values that a quantity should have at positions: points of a path, function values, poses,
//! velocities.

use std::string::{String, ToString};
use std::vec;
use std::vec::Vec;

/// At which inputs the positions are.
#[derive(Clone, Debug, PartialEq)]
pub enum Timing {
    /// At these, one for each position.
    Given(Vec<f64>),
    /// Anywhere, one after the other in the sense in which the input grows; within one turn of an
    /// input that turns.
    InOrder,
    /// Anywhere, as [`InOrder`](Self::InOrder), in the sense in which the input falls.
    Backwards,
    /// Anywhere, in any order.
    Free,
    /// At this distance from each other, beginning anywhere.
    Evenly(f64),
}

impl Timing {
    /// The input of a position, and the free one that it depends on, with the derivative by it.
    pub(super) fn input(&self, free: &[f64], position: usize) -> (f64, Option<(usize, f64)>) {
        match self {
            Self::Given(inputs) => (inputs[position], None),
            Self::InOrder | Self::Free => (free[position], Some((position, 1.0))),
            Self::Backwards => (-free[position], Some((position, -1.0))),
            Self::Evenly(step) => (free[0] + step * position as f64, Some((0, 1.0))),
        }
    }
}

/// Values that a quantity should have at positions: points of a path, function values, poses,
/// velocities.
///
/// The rows are the differences of the numbers of all positions from their targets, each times its
/// weight; the difference of an angle is taken without whole turns.
#[derive(Clone, Debug, PartialEq)]
pub struct Targets {
    pub(super) quantities: Vec<String>,
    pub(super) targets: Vec<Vec<f64>>,
    pub(super) weights: Vec<f64>,
    pub(super) timing: Timing,
}

impl Targets {
    /// The numbers of a quantity at each position, such as `Targets::new("tracer", [[20.0, 20.0],
    /// [20.0, 25.0]])`.
    #[must_use]
    pub fn new<const K: usize>(
        quantity: &str,
        targets: impl IntoIterator<Item = [f64; K]>,
    ) -> Self {
        Self::of_all([quantity], targets)
    }

    /// The numbers of several quantities together: a point and an angle are a pose,
    /// `of_all(["point", "angle"], [[x, y, angle]])`.
    #[must_use]
    pub fn of_all<'a, const K: usize>(
        quantities: impl IntoIterator<Item = &'a str>,
        targets: impl IntoIterator<Item = [f64; K]>,
    ) -> Self {
        Self {
            weights: vec![1.0; K],
            ..Self::of_rows(quantities, targets.into_iter().map(|row| row.to_vec()))
        }
    }

    /// The same for numbers that are read at run time: a row for each position.
    #[must_use]
    pub fn of_rows<'a>(
        quantities: impl IntoIterator<Item = &'a str>,
        rows: impl IntoIterator<Item = Vec<f64>>,
    ) -> Self {
        let targets: Vec<Vec<f64>> = rows.into_iter().collect();
        Self {
            quantities: quantities.into_iter().map(ToString::to_string).collect(),
            weights: vec![1.0; targets.first().map_or(0, Vec::len)],
            targets,
            timing: Timing::InOrder,
        }
    }

    /// At which inputs; without it `InOrder`.
    #[must_use]
    pub fn timing(mut self, timing: Timing) -> Self {
        self.timing = timing;
        self
    }

    /// At these inputs, one for each position.
    #[must_use]
    pub fn at_inputs(self, inputs: impl IntoIterator<Item = f64>) -> Self {
        self.timing(Timing::Given(inputs.into_iter().collect()))
    }

    /// Sets the weight of each number: 1 over a difference that counts as 1, in the units of the
    /// quantity. Without it 1.
    #[must_use]
    pub fn weights(mut self, weights: impl IntoIterator<Item = f64>) -> Self {
        self.weights = weights.into_iter().collect();
        self
    }
}
