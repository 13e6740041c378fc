//! The uncertainty of a quantity and where it comes from.

mod print;

use core::array;

use super::distribution::Distribution;
use super::student;
use super::uncertainties::Uncertainties;
use crate::components::Components;

/// The uncertainty of a quantity of `K` components by those of `N` parameters, to first order: the
/// law of propagation of uncertainty (JCGM 100:2008, 5.2.2), for several components its matrix form
/// (JCGM 102:2011, 6.2.1.3).
///
/// All figures are in the unit of the quantity. They are NaN where a sensitivity is NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget<const N: usize, const K: usize> {
    uncertainties: Uncertainties<N>,
    sensitivities: [[f64; K]; N],
}

/// A line of a budget: one parameter and one component of the quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BudgetLine {
    /// Name of the parameter.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Its best estimate: the middle of its zone.
    pub value: f64,
    /// Its standard uncertainty.
    pub standard: f64,
    /// Its distribution.
    pub distribution: Distribution,
    /// The degrees of freedom of its standard uncertainty.
    pub degrees_of_freedom: f64,
    /// The sensitivity coefficient, with its sign.
    pub sensitivity: f64,
    /// Sensitivity coefficient times standard uncertainty, with its sign: the uncertainty caused by
    /// this parameter alone.
    pub contribution: f64,
    /// Its part of the variance, that of its correlations included, half of each pair's. Parts sum
    /// up to 1; one may be negative, where a correlation makes the uncertainty smaller.
    pub share: f64,
}

impl<const N: usize> Uncertainties<N> {
    /// The uncertainty of a quantity with these sensitivities, to first order, and the contribution
    /// of each parameter. The correlations are taken into account.
    ///
    /// All figures are NaN where a sensitivity is, because the mechanism cannot be assembled.
    #[must_use]
    pub fn budget<V: Components<K>, const K: usize>(&self, sensitivities: &[V; N]) -> Budget<N, K> {
        Budget::new(*self, sensitivities.map(V::components))
    }
}

impl<const N: usize, const K: usize> Budget<N, K> {
    pub(super) const fn new(uncertainties: Uncertainties<N>, sensitivities: [[f64; K]; N]) -> Self {
        Self {
            uncertainties,
            sensitivities,
        }
    }

    /// The combined standard uncertainty of each component.
    #[must_use]
    pub fn standard(&self) -> [f64; K] {
        let covariance = self.covariance();
        array::from_fn(|k| covariance[k][k].sqrt())
    }

    /// Variances and covariances of the components.
    #[must_use]
    pub fn covariance(&self) -> [[f64; K]; K] {
        // A sum of products of independent parts: no variance is negative by roundoffs.
        let root = self.uncertainties.root();
        let contributions = self.contributions();
        let part =
            |j: usize, k: usize| -> f64 { (j..N).map(|i| root[i][j] * contributions[i][k]).sum() };
        let parts: [[f64; K]; N] = array::from_fn(|j| array::from_fn(|k| part(j, k)));
        let product = |k: usize, l: usize| parts.iter().map(|part| part[k] * part[l]).sum();
        array::from_fn(|k| array::from_fn(|l| product(k, l)))
    }

    /// Correlation coefficients of the components.
    #[must_use]
    pub fn correlation(&self) -> [[f64; K]; K] {
        let covariance = self.covariance();
        let size = |k: usize, l: usize| (covariance[k][k] * covariance[l][l]).sqrt();
        array::from_fn(|k| array::from_fn(|l| covariance[k][l] / size(k, l)))
    }

    /// The budget of component `k`, one line for each parameter.
    ///
    /// # Panics
    ///
    /// Panics, as all methods that take `k`, if it is not below `K`.
    #[must_use]
    pub fn lines(&self, k: usize) -> [BudgetLine; N] {
        let uncertain = &self.uncertainties;
        let (tolerances, correlations) = (uncertain.tolerances(), uncertain.correlation_matrix());
        let contributions = self.contributions().map(|contribution| contribution[k]);
        let variance = self.covariance()[k][k];
        let standard = uncertain.standard_uncertainties();
        array::from_fn(|i| {
            let parameter = &tolerances.parameters()[i];
            let with_all = |j: usize| correlations[i][j] * contributions[j];
            let part = contributions[i] * (0..N).map(with_all).sum::<f64>();
            BudgetLine {
                name: parameter.name,
                unit: parameter.unit,
                value: parameter.nominal + tolerances.middles()[i],
                standard: standard[i],
                distribution: uncertain.distributions()[i],
                degrees_of_freedom: uncertain.degrees()[i],
                sensitivity: self.sensitivities[i][k],
                contribution: contributions[i],
                share: if variance == 0.0 {
                    0.0
                } else {
                    part / variance
                },
            }
        })
    }

    /// The effective degrees of freedom of component `k` by the formula of Welch and Satterthwaite
    /// (JCGM 100:2008, G.4.1); infinite if all parameters' are.
    ///
    /// The formula is for independent contributions: NaN if a parameter with finite degrees of
    /// freedom contributes and is correlated with another one.
    #[must_use]
    pub fn degrees_of_freedom(&self, k: usize) -> f64 {
        let lines = self.lines(k);
        let finite =
            |i: &usize| lines[*i].degrees_of_freedom.is_finite() && lines[*i].contribution != 0.0;
        if (0..N)
            .filter(finite)
            .any(|i| self.uncertainties.is_correlated(i))
        {
            return f64::NAN;
        }
        let standard = self.standard()[k];
        let part =
            |i: usize| (lines[i].contribution / standard).powi(4) / lines[i].degrees_of_freedom;
        1.0 / (0..N).filter(finite).map(part).sum::<f64>().abs()
    }

    /// The factor by which the standard uncertainty of component `k` is multiplied for an interval
    /// of this confidence, 0.95 for 95 %: the quantile of Student's distribution with the effective
    /// degrees of freedom (JCGM 100:2008, G.3.2), that of the normal distribution if they are
    /// infinite.
    ///
    /// It supposes that the quantity is distributed so, as many contributions of similar size make
    /// it. NaN if the confidence is not between 0 and 1, or the degrees of freedom are NaN.
    #[must_use]
    pub fn coverage_factor(&self, k: usize, confidence: f64) -> f64 {
        student::two_sided(confidence, self.degrees_of_freedom(k))
    }

    /// The expanded uncertainty of component `k`: standard uncertainty times coverage factor.
    #[must_use]
    pub fn expanded(&self, k: usize, confidence: f64) -> f64 {
        self.standard()[k] * self.coverage_factor(k, confidence)
    }

    /// Sensitivity times standard uncertainty.
    fn contributions(&self) -> [[f64; K]; N] {
        let standard = self.uncertainties.standard_uncertainties();
        array::from_fn(|i| self.sensitivities[i].map(|component| component * standard[i]))
    }
}
