//! The result of an identification.

use std::vec::Vec;

use super::determined::Determined;
use super::named::Named;
use super::reading::ReadingRow;
use super::undetermined::Undetermined;
use linkage_analysis::internals::student_outside;
use linkage_runtime::{Dimensions, Parameter};

/// Readings are marked as outliers if one as far off is among as many good ones with this
/// probability.
const OUTLIER: f64 = 0.05;

/// A mechanism as readings say that it is.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Identified<M, const N: usize> {
    /// The mechanism with estimated dimensions.
    pub mechanism: M,
    /// The parameters that were to be found.
    pub parameters: Vec<Unknown>,
    /// The combinations that the readings do not determine; empty if they determine everything.
    pub undetermined: Vec<Undetermined>,
    /// All readings, in the order in which they were given, missing ones left out.
    pub residuals: Vec<Residual>,
    /// The sum of squares of differences over standard deviations.
    pub sum_of_squares: f64,
    /// The number of readings less the number of determined combinations.
    pub degrees_of_freedom: usize,
    /// The standard deviation of readings: 1 if they were given; otherwise that of all, from their
    /// scatter, NaN if there are no more readings than unknowns.
    pub deviation: f64,
    /// True if the sum of squares is least here: a step that would make it smaller is shorter than
    /// a thousandth of its standard error. Otherwise, as where the mechanism falls apart beyond the
    /// estimate, there are no standard errors: they are NaN.
    pub converged: bool,
    covariance: [[f64; N]; N],
}

/// A parameter that was to be found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unknown {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The value at the start of the fit.
    pub start: f64,
    /// The estimate.
    pub value: f64,
    /// Its standard error; infinite if it is not determined, NaN if the fit has not converged.
    pub standard_error: f64,
    /// Its place in `PARAMETERS`.
    pub index: usize,
    /// True at one of its bounds: then the readings would have it beyond, and errors of all
    /// estimates are those of a fit without the bound.
    pub is_at_bound: bool,
}

/// A reading with the value of the estimated mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// The number that was read.
    pub number: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The input; NaN for a parameter that was measured itself.
    pub input: f64,
    /// The reading.
    pub reading: f64,
    /// The value of the mechanism minus the reading.
    pub difference: f64,
    /// The difference over its own standard deviation, which is smaller than that of the reading,
    /// since the estimate follows each reading a little; NaN if nothing but this reading determines
    /// something, or the fit has not converged.
    pub standardised: f64,
    /// True if it is farther off than the farthest of as many good readings is in 95 of 100 cases.
    pub is_outlier: bool,
}

impl<M, const N: usize> Identified<M, N> {
    /// The covariances of all parameters, those that were not to be found with zeros. For
    /// [`Uncertainties::covariance`](linkage_analysis::tolerance::Uncertainties::covariance), if everything is
    /// determined.
    ///
    /// Combinations that are not determined are left out: their covariances are infinite. They are
    /// NaN where [`converged`](Self::converged) is false.
    #[must_use]
    pub const fn covariance(&self) -> &[[f64; N]; N] {
        &self.covariance
    }

    /// The correlation coefficient of two parameters by their indices; NaN if one is exact or not
    /// determined.
    ///
    /// # Panics
    ///
    /// Panics if an index is not below `N`.
    #[must_use]
    pub fn correlation(&self, i: usize, j: usize) -> f64 {
        let covariance = &self.covariance;
        covariance[i][j] / (covariance[i][i] * covariance[j][j]).sqrt()
    }

    /// The readings that are farther off than errors explain.
    pub fn outliers(&self) -> impl Iterator<Item = &Residual> {
        self.residuals.iter().filter(|residual| residual.is_outlier)
    }
}

pub(super) fn identified<M, const N: usize>(
    mechanism: M,
    named: &Named,
    rows: &[ReadingRow],
    found: &Determined,
    undetermined: Vec<Undetermined>,
    converged: bool,
) -> Identified<M, N>
where
    M: Dimensions<N>,
{
    let (places, limits) = (&named.places, &named.limits);
    let mut covariance = [[0.0; N]; N];
    let is_known: Vec<bool> = (0..places.len()).map(|j| found.is_determined(j)).collect();
    for (a, &i) in places.iter().enumerate() {
        for (b, &j) in places.iter().enumerate() {
            covariance[i][j] = match is_known[a] && is_known[b] {
                true if !converged => f64::NAN,
                true => named.ranges[a] * found.covariance(a, b) * named.ranges[b],
                false => f64::INFINITY,
            };
        }
    }
    let unknown = |j: usize| {
        let Parameter { name, unit, .. } = named.parameters[j];
        Unknown {
            name,
            unit,
            start: named.starts[j],
            value: named.values[j],
            standard_error: covariance[places[j]][places[j]].sqrt(),
            index: places[j],
            is_at_bound: [limits.lower[j], limits.upper[j]].contains(&named.values[j]),
        }
    };
    Identified {
        mechanism,
        parameters: (0..places.len()).map(unknown).collect(),
        undetermined,
        residuals: residuals(rows, found, converged),
        converged,
        sum_of_squares: found.sum,
        degrees_of_freedom: found.degrees_of_freedom(),
        deviation: found.deviation(),
        covariance,
    }
}

fn residuals(rows: &[ReadingRow], found: &Determined, converged: bool) -> Vec<Residual> {
    /// A reading that keeps less of its own error than this determines something alone.
    const ALONE: f64 = 1e-9;
    let deviation = found.deviation();
    let freedom = found.degrees_of_freedom() as f64;
    // Bonferroni's bound: the probability of one divided among all.
    let outside = OUTLIER / rows.len() as f64;
    let is_estimated = found.is_estimated();
    let limit = match is_estimated {
        // With a scatter from all other readings, the distribution is Student's.
        true => student_outside(outside, freedom - 1.0),
        false => student_outside(outside, f64::INFINITY),
    };
    let residual = |(i, row): (usize, &ReadingRow)| {
        let kept = 1.0 - found.leverage(i);
        let standardised = match converged && kept > ALONE {
            true => row.difference / (row.deviation * deviation * kept.sqrt()),
            false => f64::NAN,
        };
        let beside_others = match is_estimated {
            true => {
                standardised * ((freedom - 1.0) / (freedom - standardised * standardised)).sqrt()
            }
            false => standardised,
        };
        Residual {
            number: row.number,
            unit: row.unit,
            input: row.input,
            reading: row.reading,
            difference: row.difference,
            standardised,
            is_outlier: beside_others.abs() > limit,
        }
    };
    rows.iter().enumerate().map(residual).collect()
}

/// All pairs of unknown parameters with their correlation coefficients.
pub(super) fn pairs<M, const N: usize>(
    identified: &Identified<M, N>,
) -> impl Iterator<Item = (&Unknown, &Unknown, f64)> {
    let all = &identified.parameters;
    let pairs =
        (0..all.len()).flat_map(move |i| (i + 1..all.len()).map(move |j| (&all[i], &all[j])));
    pairs.map(|(a, b)| (a, b, identified.correlation(a.index, b.index)))
}
