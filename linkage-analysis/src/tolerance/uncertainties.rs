//! Knowledge of dimensions: distributions, standard uncertainties and correlations.

use core::array;

use super::correlation::{self, Square};
use super::distribution::Distribution;
use super::error::ToleranceError;
use super::given::{Tolerances, exactly};
use linkage_runtime::Parameter;

/// Standard uncertainties of `N` parameters with their correlations, as in the Guide to the
/// Expression of Uncertainty in Measurement (JCGM 100:2008), in the units of the parameters.
///
/// They come from tolerances and how dimensions are distributed within them (type B of the Guide),
/// or from measurements: a standard deviation with its degrees of freedom, a matrix of covariances
/// (type A).
///
/// ```
/// use linkage_runtime::Parameter;
/// use linkage_analysis::tolerance::{Distribution, Tolerances, Uncertainties};
///
/// let (nominal, tolerance) = (40.0, 0.03);
/// let rods = ["a", "b"].map(|name| Parameter { name, unit: "mm", nominal, tolerance });
/// let tolerances = Tolerances::<2>::complete(&rods)?;
/// let alone = Uncertainties::new(&tolerances, Distribution::Normal);
/// // Cut on one stop: both are too long by the same amount.
/// let together = alone.correlations(&[(0, 1, 0.8)])?;
///
/// let by_the_sum = [1.0, 1.0];
/// let [u] = alone.budget(&by_the_sum).standard();
/// assert!((u - 0.01 * 2.0_f64.sqrt()).abs() < 1e-15);
/// let [u] = together.budget(&by_the_sum).standard();
/// assert!((u - 0.01 * 3.6_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), linkage_analysis::tolerance::ToleranceError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncertainties<const N: usize> {
    tolerances: Tolerances<N>,
    distributions: [Distribution; N],
    degrees: [f64; N],
    correlations: Square<N>,
    root: Square<N>,
}

impl<const N: usize> Uncertainties<N> {
    /// Dimensions that are distributed in this way within their tolerances, independently, with
    /// infinite degrees of freedom: the distributions are known.
    #[must_use]
    pub fn new(tolerances: &Tolerances<N>, distribution: Distribution) -> Self {
        Self {
            tolerances: *tolerances,
            distributions: [distribution; N],
            degrees: [f64::INFINITY; N],
            correlations: correlation::identity(),
            root: correlation::identity(),
        }
    }

    /// Dimensions with these nominal values, normally distributed about them with these
    /// covariances; a dimension whose variance is 0 is exact.
    ///
    /// # Errors
    ///
    /// `Count` if there are not `N` parameters; `Uncertainty` for a variance that is negative,
    /// infinite or NaN, `NotSymmetric`, `Correlation` or `Contradiction` for covariances that no
    /// quantities have.
    pub fn covariance(
        parameters: &[Parameter],
        covariance: &[[f64; N]; N],
    ) -> Result<Self, ToleranceError> {
        let listed: [Parameter; N] = exactly("parameters", parameters)?;
        let mut uncertain = Self::new(&Tolerances::new(&listed, &[0.0; N])?, Distribution::Normal);
        for (i, row) in covariance.iter().enumerate() {
            uncertain = uncertain.standard(i, row[i].sqrt())?;
        }
        let standard = uncertain.standard_uncertainties();
        for i in 0..N {
            for j in 0..i {
                let names = [j, i].map(|k| listed[k].name);
                let found = [covariance[j][i], covariance[i][j]];
                let size = standard[i] * standard[j];
                // The difference between two ways of computing one product.
                let is_symmetric = (found[0] - found[1]).abs() <= 1e-12 * size.max(found[0].abs());
                if !is_symmetric {
                    return Err(ToleranceError::NotSymmetric { names, found });
                }
                // An exact dimension is correlated with nothing.
                let coefficient = if covariance[i][j] == 0.0 {
                    0.0
                } else {
                    covariance[i][j] / size
                };
                uncertain = uncertain.pair(i, j, coefficient)?;
            }
        }
        uncertain.rooted()
    }

    /// Another distribution of the parameter with this index within its tolerance.
    ///
    /// # Errors
    ///
    /// `NoSuchParameter` for an index that is not below `N`.
    pub fn distribution_of(
        mut self,
        index: usize,
        distribution: Distribution,
    ) -> Result<Self, ToleranceError> {
        self.parameter(index)?;
        self.distributions[index] = distribution;
        Ok(self)
    }

    /// The standard uncertainty of the parameter with this index, which is then normally
    /// distributed, about the middle of its zone.
    ///
    /// # Errors
    ///
    /// `NoSuchParameter` for an index that is not below `N`, `Uncertainty` if it is negative,
    /// infinite or NaN.
    pub fn standard(mut self, index: usize, standard: f64) -> Result<Self, ToleranceError> {
        let name = self.parameter(index)?.name;
        if !(standard >= 0.0 && standard.is_finite()) {
            return Err(ToleranceError::Uncertainty { name, standard });
        }
        let half = standard / Distribution::Normal.deviation();
        let middle = self.tolerances.middles()[index];
        self.distributions[index] = Distribution::Normal;
        self.tolerances = self
            .tolerances
            .limits(index, middle - half, middle + half)?;
        Ok(self)
    }

    /// On how many degrees of freedom the standard uncertainty of the parameter with this index
    /// rests: one less than there were measurements. Infinity if it is exactly known.
    ///
    /// # Errors
    ///
    /// `NoSuchParameter` for an index that is not below `N`, `DegreesOfFreedom` if there is not one
    /// at least.
    pub fn degrees_of_freedom(
        mut self,
        index: usize,
        degrees: f64,
    ) -> Result<Self, ToleranceError> {
        let name = self.parameter(index)?.name;
        if degrees < 1.0 || degrees.is_nan() {
            return Err(ToleranceError::DegreesOfFreedom { name, degrees });
        }
        self.degrees[index] = degrees;
        Ok(self)
    }

    /// Correlation coefficients of pairs of parameters, by their indices, in addition to those that
    /// were given before.
    ///
    /// # Errors
    ///
    /// `NoSuchParameter` for an index that is not below `N`, `Correlation` for one that is not
    /// between -1 and 1 or of a parameter with itself, `Contradiction` if no quantities have all of
    /// them together.
    pub fn correlations(mut self, pairs: &[(usize, usize, f64)]) -> Result<Self, ToleranceError> {
        for &(i, j, coefficient) in pairs {
            self = self.pair(i, j, coefficient)?;
        }
        self.rooted()
    }

    /// The parameters with nominal values; their tolerances are half the widths of their zones,
    /// three standard uncertainties where these were given.
    #[must_use]
    pub const fn tolerances(&self) -> &Tolerances<N> {
        &self.tolerances
    }

    /// The distribution of each parameter.
    #[must_use]
    pub const fn distributions(&self) -> &[Distribution; N] {
        &self.distributions
    }

    /// The standard uncertainty of each parameter.
    #[must_use]
    pub fn standard_uncertainties(&self) -> [f64; N] {
        let half = self.tolerances.values();
        array::from_fn(|i| half[i] * self.distributions[i].deviation())
    }

    /// The degrees of freedom of each parameter.
    #[must_use]
    pub const fn degrees(&self) -> &[f64; N] {
        &self.degrees
    }

    /// The correlation coefficients.
    #[must_use]
    pub const fn correlation_matrix(&self) -> &[[f64; N]; N] {
        &self.correlations
    }

    /// The covariances.
    #[must_use]
    pub fn covariance_matrix(&self) -> [[f64; N]; N] {
        let standard = self.standard_uncertainties();
        let covariance = |i: usize, j: usize| standard[i] * self.correlations[i][j] * standard[j];
        array::from_fn(|i| array::from_fn(|j| covariance(i, j)))
    }

    pub(super) const fn root(&self) -> &Square<N> {
        &self.root
    }

    /// Returns true if the parameter is correlated with another one.
    pub(super) fn is_correlated(&self, i: usize) -> bool {
        (0..N).any(|j| j != i && self.correlations[i][j] != 0.0)
    }

    #[cfg(feature = "monte-carlo")]
    pub(super) fn all_correlated_are_normal(&self) -> Result<(), ToleranceError> {
        let is_other =
            |&i: &usize| self.distributions[i] != Distribution::Normal && self.is_correlated(i);
        match (0..N).find(is_other) {
            Some(i) => Err(ToleranceError::NotNormal {
                name: self.tolerances.parameters()[i].name,
            }),
            None => Ok(()),
        }
    }

    fn parameter(&self, index: usize) -> Result<&Parameter, ToleranceError> {
        let parameter = self.tolerances.parameters().get(index);
        parameter.ok_or(ToleranceError::NoSuchParameter { index, count: N })
    }

    /// With this coefficient, before it is known whether it fits the others.
    fn pair(mut self, i: usize, j: usize, coefficient: f64) -> Result<Self, ToleranceError> {
        let names = [self.parameter(i)?.name, self.parameter(j)?.name];
        // Covariances that give 1 do it up to roundoffs.
        let is_possible = coefficient.abs() <= 1.0 + 1e-12;
        if i == j || !is_possible {
            return Err(ToleranceError::Correlation { names, coefficient });
        }
        let coefficient = coefficient.clamp(-1.0, 1.0);
        (self.correlations[i][j], self.correlations[j][i]) = (coefficient, coefficient);
        Ok(self)
    }

    fn rooted(mut self) -> Result<Self, ToleranceError> {
        self.root = correlation::root(&self.correlations).map_err(|(row, left)| {
            ToleranceError::Contradiction {
                name: self.tolerances.parameters()[row].name,
                left,
            }
        })?;
        Ok(self)
    }
}
