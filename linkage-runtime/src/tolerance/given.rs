//! Tolerances of parameters.

use alloc::vec::Vec;
use core::fmt;

use super::{Effects, ToleranceError};
use crate::Parameter;
use crate::components::Components;

/// The tolerances of `N` parameters: each dimension lies within its nominal value, plus or minus its
/// tolerance. In the units of the parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances<const N: usize> {
    parameters: [Parameter; N],
}

impl<const N: usize> Tolerances<N> {
    /// The tolerances of the declaration; a parameter without one is exact.
    ///
    /// # Errors
    ///
    /// `Count` if there are not `N` parameters, `Invalid` for a tolerance that is negative, infinite
    /// or NaN.
    pub fn declared(parameters: &[Parameter]) -> Result<Self, ToleranceError> {
        Self::checked(exactly("parameters", parameters)?)
    }

    /// The tolerances of the declaration, where each parameter must have one.
    ///
    /// # Errors
    ///
    /// As [`declared`](Self::declared), and `Missing` with the names of the parameters whose tolerance
    /// is 0.
    pub fn complete(parameters: &[Parameter]) -> Result<Self, ToleranceError> {
        let tolerances = Self::declared(parameters)?;
        let without = tolerances.parameters.iter().filter(|p| p.tolerance == 0.0);
        let names: Vec<_> = without.map(|p| p.name).collect();
        if names.is_empty() {
            Ok(tolerances)
        } else {
            Err(ToleranceError::Missing { names })
        }
    }

    /// These tolerances for these parameters.
    ///
    /// # Errors
    ///
    /// `Count` if there are not `N` of both, `Invalid` for a tolerance that is negative, infinite or
    /// NaN.
    pub fn new(parameters: &[Parameter], tolerances: &[f64]) -> Result<Self, ToleranceError> {
        let mut parameters: [Parameter; N] = exactly("parameters", parameters)?;
        let tolerances: [f64; N] = exactly("tolerances", tolerances)?;
        for (parameter, tolerance) in parameters.iter_mut().zip(tolerances) {
            parameter.tolerance = tolerance;
        }
        Self::checked(parameters)
    }

    /// The tolerances of the parameters with these indices, for `sensitivity(q, [..])` with a list.
    ///
    /// # Errors
    ///
    /// `NoSuchParameter` for an index that is not below `N`.
    pub fn select<const M: usize>(
        &self,
        indices: [usize; M],
    ) -> Result<Tolerances<M>, ToleranceError> {
        let count = N;
        if let Some(&index) = indices.iter().find(|&&index| index >= count) {
            return Err(ToleranceError::NoSuchParameter { index, count });
        }
        Ok(Tolerances {
            parameters: indices.map(|index| self.parameters[index]),
        })
    }

    /// The parameters with their tolerances.
    #[must_use]
    pub const fn parameters(&self) -> &[Parameter; N] {
        &self.parameters
    }

    /// The tolerances alone.
    #[must_use]
    pub fn values(&self) -> [f64; N] {
        self.parameters.map(|parameter| parameter.tolerance)
    }

    /// What each tolerance does to a quantity with these sensitivities.
    ///
    /// Where a sensitivity is NaN, because the mechanism cannot be assembled, all figures that it
    /// enters are NaN.
    #[must_use]
    pub fn effects<V: Components<K>, const K: usize>(
        &self,
        sensitivities: &[V; N],
    ) -> Effects<N, K> {
        Effects::new(*self, &sensitivities.map(V::components))
    }

    fn checked(parameters: [Parameter; N]) -> Result<Self, ToleranceError> {
        let valid = |tolerance: f64| tolerance >= 0.0 && tolerance.is_finite();
        match parameters.iter().find(|p| !valid(p.tolerance)) {
            Some(&Parameter {
                name, tolerance, ..
            }) => Err(ToleranceError::Invalid { name, tolerance }),
            None => Ok(Self { parameters }),
        }
    }
}

/// One line for each parameter, as in `crank = 50 +- 0.012 mm`.
impl<const N: usize> fmt::Display for Tolerances<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for parameter in &self.parameters {
            writeln!(f, "{parameter}")?;
        }
        Ok(())
    }
}

/// The list as an array.
pub(super) fn exactly<T: Copy, const N: usize>(
    what: &'static str,
    list: &[T],
) -> Result<[T; N], ToleranceError> {
    let count = |_| ToleranceError::Count {
        what,
        expected: N,
        found: list.len(),
    };
    list.try_into().map_err(count)
}
