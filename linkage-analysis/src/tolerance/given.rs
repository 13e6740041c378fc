//! Tolerances of parameters.

use alloc::vec::Vec;
use core::fmt;

use super::error::ToleranceError;
use linkage_core::format::rounded;
use linkage_runtime::Parameter;

/// The tolerances of `N` parameters: each dimension is within its nominal value, plus or minus
/// its tolerance, or between [other limits](Self::limits). In the units of the parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances<const N: usize> {
    parameters: [Parameter; N],
    /// The middle of each zone, from the nominal value.
    middles: [f64; N],
}

impl<const N: usize> Tolerances<N> {
    /// The tolerances of the declaration; a parameter without one is exact.
    ///
    /// # Errors
    ///
    /// `Count` if there are not `N` parameters, `Invalid` for a tolerance that is negative,
    /// infinite or NaN.
    pub fn declared(parameters: &[Parameter]) -> Result<Self, ToleranceError> {
        Self::checked(exactly("parameters", parameters)?)
    }

    /// The tolerances of the declaration, where each parameter must have one.
    ///
    /// # Errors
    ///
    /// As [`declared`](Self::declared), and `Missing` with the names of the parameters whose
    /// tolerance is 0.
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
    /// `Count` if there are not `N` of both, `Invalid` for a tolerance that is negative, infinite
    /// or NaN.
    pub fn new(parameters: &[Parameter], tolerances: &[f64]) -> Result<Self, ToleranceError> {
        let mut parameters: [Parameter; N] = exactly("parameters", parameters)?;
        let tolerances: [f64; N] = exactly("tolerances", tolerances)?;
        for (parameter, tolerance) in parameters.iter_mut().zip(tolerances) {
            parameter.tolerance = tolerance;
        }
        Self::checked(parameters)
    }

    /// Other limits for the parameter with this index, as deviations from its nominal value:
    /// `-0.01` and `0.02` for 50 +0.02 -0.01 mm, `-0.03` and `-0.01` for a fit. Half the width of
    /// the zone is its tolerance then, and its middle is where the dimension is on average.
    ///
    /// # Errors
    ///
    /// `NoSuchParameter` for an index that is not below `N`, `Limits` if the lower one is above the
    /// upper one, or one is infinite or NaN.
    ///
    /// ```
    /// use linkage_runtime::Parameter;
    /// use linkage_analysis::tolerance::Tolerances;
    ///
    /// let shaft = [Parameter { name: "shaft", unit: "mm", nominal: 20.0, tolerance: 0.0 }];
    /// let tolerances = Tolerances::<1>::declared(&shaft)?.limits(0, -0.041, -0.020)?;
    /// assert_eq!(tolerances.to_string(), "shaft = 20 -0.02 -0.041 mm\n");
    /// # Ok::<(), linkage_analysis::tolerance::ToleranceError>(())
    /// ```
    pub fn limits(mut self, index: usize, lower: f64, upper: f64) -> Result<Self, ToleranceError> {
        let parameter = self.parameters.get_mut(index);
        let parameter = parameter.ok_or(ToleranceError::NoSuchParameter { index, count: N })?;
        let half = 0.5 * (upper - lower);
        if !(half >= 0.0 && half.is_finite() && lower.is_finite()) {
            return Err(ToleranceError::Limits {
                name: parameter.name,
                lower,
                upper,
            });
        }
        parameter.tolerance = half;
        self.middles[index] = 0.5 * (lower + upper);
        Ok(self)
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
            middles: indices.map(|index| self.middles[index]),
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

    /// The middle of each zone, from the nominal value: 0 where the limits are as far from it.
    #[must_use]
    pub const fn middles(&self) -> &[f64; N] {
        &self.middles
    }

    fn checked(parameters: [Parameter; N]) -> Result<Self, ToleranceError> {
        let valid = |tolerance: f64| tolerance >= 0.0 && tolerance.is_finite();
        match parameters.iter().find(|p| !valid(p.tolerance)) {
            Some(&Parameter {
                name, tolerance, ..
            }) => Err(ToleranceError::Invalid { name, tolerance }),
            None => Ok(Self {
                parameters,
                middles: [0.0; N],
            }),
        }
    }
}

/// One line for each parameter, as in `crank = 50 +- 0.012 mm` or `crank = 50 +0.02 -0.01 mm`.
impl<const N: usize> fmt::Display for Tolerances<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (parameter, &middle) in self.parameters.iter().zip(&self.middles) {
            if middle == 0.0 {
                writeln!(f, "{parameter}")?;
                continue;
            }
            // Sums of a middle and half a width have roundoffs that nobody wrote.
            let [upper, lower] = [1.0, -1.0].map(|sign| middle + sign * parameter.tolerance);
            let limit = |x: f64| alloc::format!("{}{}", if x > 0.0 { "+" } else { "" }, rounded(x));
            let (name, nominal) = (parameter.name, parameter.nominal);
            write!(f, "{name} = {nominal} {} {}", limit(upper), limit(lower))?;
            let space = if parameter.unit.is_empty() { "" } else { " " };
            writeln!(f, "{space}{}", parameter.unit)?;
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
