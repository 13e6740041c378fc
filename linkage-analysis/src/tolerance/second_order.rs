//! The uncertainty of a quantity that is not nearly linear.

use core::array;
use core::fmt;

use super::budget::Budget;
use super::correlation::Square;
use super::uncertainties::Uncertainties;
use crate::components::Components;
use linkage_core::format::rounded;

/// Mean and uncertainty of a quantity by its Taylor polynomial of second order, and of third order
/// where that is required.
///
/// With second derivatives the figures are those that the polynomial has, exactly: for normally
/// distributed dimensions, correlated or not, and for independent ones of any distribution. The
/// guide's formula for independent quantities (JCGM 100:2008, note in 5.1.2) has the products of
/// first and third derivatives, too, which are of the same order in the uncertainties:
/// [`with_third`](Self::with_third) adds them.
///
/// All figures are NaN where a derivative is NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecondOrder<const N: usize, const K: usize> {
    uncertainties: Uncertainties<N>,
    sensitivities: [[f64; K]; N],
    /// The mean minus the value at the best estimates.
    pub shift: [f64; K],
    /// Variances and covariances by first derivatives alone.
    pub linear: [[f64; K]; K],
    /// The part of second derivatives.
    pub quadratic: [[f64; K]; K],
    /// The part of products of first and third derivatives: 0 unless they were given.
    pub cubic: [[f64; K]; K],
}

impl<const N: usize> Uncertainties<N> {
    /// The uncertainty of a quantity to second order: `first` are its sensitivities, `second` their
    /// sensitivities, which a function gives as `sensitivity(q)` and `sensitivity(sensitivity(q))`.
    #[must_use]
    pub fn second_order<V: Components<K>, const K: usize>(
        &self,
        first: &[V; N],
        second: &[[V; N]; N],
    ) -> SecondOrder<N, K> {
        let second = second.map(|row| row.map(V::components));
        SecondOrder::new(*self, first.map(V::components), &second)
    }
}

impl<const N: usize, const K: usize> SecondOrder<N, K> {
    fn new(
        uncertainties: Uncertainties<N>,
        first: [[f64; K]; N],
        second: &[[[f64; K]; N]; N],
    ) -> Self {
        let covariance = uncertainties.covariance_matrix();
        let component =
            |k: usize| -> Square<N> { array::from_fn(|i| array::from_fn(|j| second[i][j][k])) };
        // Half of the second derivatives times the covariances.
        let halves: [Square<N>; K] = array::from_fn(|k| half_product(&component(k), &covariance));
        let trace = |k: usize| (0..N).map(|i| halves[k][i][i]).sum();
        let excess = excess(&uncertainties);
        let quadratic = |k: usize, l: usize| -> f64 {
            let pairs = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
            let normal: f64 = pairs.map(|(i, j)| halves[k][i][j] * halves[l][j][i]).sum();
            let rest = |i: usize| 0.25 * excess[i] * second[i][i][k] * second[i][i][l];
            2.0 * normal + (0..N).map(rest).sum::<f64>()
        };
        Self {
            uncertainties,
            sensitivities: first,
            shift: array::from_fn(trace),
            linear: Budget::new(uncertainties, first).covariance(),
            quadratic: array::from_fn(|k| array::from_fn(|l| quadratic(k, l))),
            cubic: [[0.0; K]; K],
        }
    }

    /// With third derivatives, `sensitivity(sensitivity(sensitivity(q)))`: the products of first
    /// and third ones.
    #[must_use]
    pub fn with_third<V: Components<K>>(mut self, third: &[[[V; N]; N]; N]) -> Self {
        let covariance = self.uncertainties.covariance_matrix();
        let excess = excess(&self.uncertainties);
        let third = third.map(|plane| plane.map(|row| row.map(V::components)));
        // The gradient of the quantity's mean, times two.
        let slope = |b: usize, l: usize| -> f64 {
            let pairs = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
            pairs
                .map(|(i, j)| third[b][i][j][l] * covariance[i][j])
                .sum()
        };
        let slopes: [[f64; K]; N] = array::from_fn(|b| array::from_fn(|l| slope(b, l)));
        let one_way = |k: usize, l: usize| -> f64 {
            let pairs = (0..N).flat_map(|a| (0..N).map(move |b| (a, b)));
            let first = &self.sensitivities;
            let normal: f64 = pairs
                .map(|(a, b)| first[a][k] * covariance[a][b] * slopes[b][l])
                .sum();
            let rest = |i: usize| excess[i] * first[i][k] * third[i][i][i][l] / 3.0;
            0.5 * (normal + (0..N).map(rest).sum::<f64>())
        };
        self.cubic = array::from_fn(|k| array::from_fn(|l| one_way(k, l) + one_way(l, k)));
        self
    }

    /// Variances and covariances, all terms together.
    #[must_use]
    pub fn covariance(&self) -> [[f64; K]; K] {
        let sum = |k: usize, l: usize| self.linear[k][l] + self.quadratic[k][l] + self.cubic[k][l];
        array::from_fn(|k| array::from_fn(|l| sum(k, l)))
    }

    /// The standard uncertainty of each component about the mean, all terms together; NaN where
    /// third derivatives make the variance negative: the uncertainties are too large for a
    /// polynomial of this order then.
    #[must_use]
    pub fn standard(&self) -> [f64; K] {
        let covariance = self.covariance();
        array::from_fn(|k| covariance[k][k].sqrt())
    }

    /// The root mean square deviation of each component from the value at the best estimates: the
    /// standard uncertainty of that value, if the mean is not corrected by the
    /// [`shift`](Self::shift).
    #[must_use]
    pub fn standard_uncorrected(&self) -> [f64; K] {
        let covariance = self.covariance();
        array::from_fn(|k| (covariance[k][k] + self.shift[k] * self.shift[k]).sqrt())
    }
}

/// Shift and uncertainties by component.
impl<const N: usize, const K: usize> fmt::Display for SecondOrder<N, K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let root = |matrix: &[[f64; K]; K]| -> [f64; K] { array::from_fn(|k| matrix[k][k].sqrt()) };
        let rows = [
            ("mean minus value", self.shift),
            ("standard uncertainty, first order", root(&self.linear)),
            ("standard uncertainty, all terms", self.standard()),
        ];
        for (name, components) in rows {
            write!(f, "{name:<34}")?;
            for component in components {
                write!(f, " {:>12}", alloc::format!("{}", rounded(component)))?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

fn half_product<const N: usize>(second: &Square<N>, covariance: &Square<N>) -> Square<N> {
    let product = |i: usize, j: usize| (0..N).map(|m| second[i][m] * covariance[m][j]).sum::<f64>();
    array::from_fn(|i| array::from_fn(|j| 0.5 * product(i, j)))
}

/// The excess of the mean fourth power of each deviation over that of a normal distribution.
fn excess<const N: usize>(uncertainties: &Uncertainties<N>) -> [f64; N] {
    let standard = uncertainties.standard_uncertainties();
    let distributions = uncertainties.distributions();
    array::from_fn(|i| (distributions[i].kurtosis() - 3.0) * standard[i].powi(4))
}
