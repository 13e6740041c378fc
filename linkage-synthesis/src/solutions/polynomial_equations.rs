//! Equations that a user writes.

use super::number::Number;

/// A system of as many polynomial equations as unknowns, with real coefficients.
///
/// The equations of a group of links whose assemblies are asked for, as `loop` has them: distances
/// as their squares, directions as their components, with equations for their lengths.
pub trait Equations<const N: usize>: Sync {
    /// Returns the errors of the equations at `x`: all 0 at a solution. Coefficients are exact;
    /// fractions that binary numbers do not have are avoided by multiplying an equation. Unknowns
    /// and values should be about 1.
    fn values<T: Number>(&self, x: &[T; N]) -> [T; N];
}
