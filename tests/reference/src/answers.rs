//! What one program gives at one position, as plain numbers.

use nalgebra::Vector2;

/// Everything that a test program is asked for at one position.
#[derive(Clone, Debug, Default)]
pub struct Answers {
    /// The outputs.
    pub values: Vec<f64>,
    /// `margin()`.
    pub margin: f64,
    /// `velocity(q)` of every output.
    pub first: Vec<f64>,
    /// `acceleration(q)` of every output.
    pub second: Vec<f64>,
    /// `jerk(q)` of every output.
    pub third: Vec<f64>,
    /// `sensitivity(q)`: for every parameter the derivatives of all outputs.
    pub sensitivity: Vec<Vec<f64>>,
    /// `sensitivity(velocity(q))` likewise.
    pub mixed: Vec<Vec<f64>>,
    /// `sensitivity(acceleration(q))` likewise.
    pub mixed_second: Vec<Vec<f64>>,
    /// Second derivatives by the pairs of data that the system names: for every pair those of all
    /// outputs.
    pub pairs: Vec<Vec<f64>>,
}

/// The numbers in a result of a program: one, or the components of a vector.
pub trait Components {
    /// The numbers in order.
    fn components(&self) -> Vec<f64>;
}

impl Components for f64 {
    fn components(&self) -> Vec<f64> {
        vec![*self]
    }
}

impl<T: Components> Components for Vector2<T> {
    fn components(&self) -> Vec<f64> {
        self.iter().flat_map(Components::components).collect()
    }
}

/// The numbers of several results one after the other.
pub fn concatenate(results: &[&dyn Components]) -> Vec<f64> {
    results
        .iter()
        .flat_map(|result| result.components())
        .collect()
}
