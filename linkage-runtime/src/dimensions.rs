//! Mechanisms as lists of numbers.

use crate::data::Parameter;

/// The dimensions of a mechanism as `N` numbers, in the order of `PARAMETERS`: every mechanism in
/// `f64` implements it.
///
/// Programs that work on any mechanism need it: random sampling, optimisation, reading of
/// dimensions from a file.
///
/// ```
/// use linkage_runtime::{Dimensions, Parameter};
///
/// /// The same mechanism with every dimension multiplied by `factor`.
/// fn scaled<M: Dimensions<N>, const N: usize>(mechanism: &M, factor: f64) -> M {
///     M::from_values(&mechanism.values().map(|value| factor * value))
/// }
/// ```
pub trait Dimensions<const N: usize>: Sized {
    /// The `N` scalar parameters with the defaults and tolerances of the declaration.
    const PARAMETERS: &'static [Parameter];

    /// The mechanism with these dimensions, in the units of `PARAMETERS`.
    fn from_values(values: &[f64; N]) -> Self;

    /// The dimensions in the units of `PARAMETERS`.
    fn values(&self) -> [f64; N];

    /// `PARAMETERS` with the dimensions of this mechanism as nominal values; the tolerances are
    /// those of the declaration.
    ///
    /// ```
    /// use linkage_runtime::{Dimensions, Parameter};
    ///
    /// // The code that `mechanism!` generates.
    /// struct Rod { length: f64 }
    /// impl Dimensions<1> for Rod {
    ///     const PARAMETERS: &'static [Parameter] =
    ///         &[Parameter { name: "length", unit: "mm", nominal: 40.0, tolerance: 0.03 }];
    ///     fn from_values(&[length]: &[f64; 1]) -> Self { Self { length } }
    ///     fn values(&self) -> [f64; 1] { [self.length] }
    /// }
    ///
    /// let [length] = Rod { length: 55.0 }.parameters();
    /// assert_eq!(length.to_string(), "length = 55 +- 0.03 mm");
    /// ```
    fn parameters(&self) -> [Parameter; N] {
        let values = self.values();
        core::array::from_fn(|index| Parameter {
            nominal: values[index],
            ..Self::PARAMETERS[index]
        })
    }
}

/// A mechanism as `N` numbers with names. Each mechanism with [`Dimensions`] is one. The names of a
/// mechanism that is compiled at run time are those of the object, not of its type.
pub trait DimensionSet<const N: usize>: Sized {
    /// The parameters of the declaration in the order of the numbers: `N`, or fewer if the last
    /// numbers have no meaning.
    fn declared(&self) -> &[Parameter];

    /// The dimensions in the units of [`declared`](Self::declared).
    fn numbers(&self) -> [f64; N];

    /// The same mechanism with other dimensions.
    fn with_numbers(&self, numbers: &[f64; N]) -> Self;
}

impl<M: Dimensions<N>, const N: usize> DimensionSet<N> for M {
    fn declared(&self) -> &[Parameter] {
        Self::PARAMETERS
    }

    fn numbers(&self) -> [f64; N] {
        self.values()
    }

    fn with_numbers(&self, numbers: &[f64; N]) -> Self {
        Self::from_values(numbers)
    }
}
