//! Goal and conditions of an objective, in pieces that are smooth functions.

use std::vec::Vec;

/// The key of a piece among several, which identifies it in another mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PieceKey {
    /// The one with this number.
    Nth(usize),
    /// The one at this input.
    At(f64),
}

/// One of the smooth functions of which the largest, or the smallest, is a figure of a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece<const N: usize> {
    /// The key of the piece.
    pub key: PieceKey,
    /// Its value.
    pub value: f64,
    /// Its derivatives by the parameters.
    pub parameters: [f64; N],
    /// Its derivatives by the variables that the objective has for itself.
    pub auxiliary: Vec<f64>,
}

impl<const N: usize> Piece<N> {
    /// Returns true if all its numbers are finite.
    pub(crate) fn is_finite(&self) -> bool {
        let mut slopes = self.parameters.iter().chain(&self.auxiliary);
        self.value.is_finite() && slopes.all(|slope| slope.is_finite())
    }

    /// This piece times a factor, plus a number.
    pub(crate) fn times(&self, factor: f64, more: f64) -> Self {
        Self {
            key: self.key,
            value: factor * self.value + more,
            parameters: self.parameters.map(|slope| factor * slope),
            auxiliary: self.auxiliary.iter().map(|slope| factor * slope).collect(),
        }
    }
}

/// Goal and conditions of an objective for a candidate.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Conditions<const N: usize> {
    /// The largest of these is to be least; empty if the objective is only a condition.
    pub goal: Vec<Piece<N>>,
    /// None of these may be above zero.
    pub conditions: Vec<Vec<Piece<N>>>,
    /// The pieces of whose squares the goal is the sum, if it is one; empty otherwise. Its
    /// curvature is known from them.
    pub squares: Vec<Piece<N>>,
}
