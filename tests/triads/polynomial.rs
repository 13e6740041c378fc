//! Real trigonometric polynomials and all of their zeros.

use std::f64::consts::TAU;

/// More than twice the degree of any polynomial here.
const SAMPLES: usize = 32;
/// A coefficient below this, relative to the largest one, is rounding.
const ROUNDING: f64 = 1e-11;

/// `sum a[k] cos(k t) + b[k] sin(k t)`.
#[derive(Clone, Debug)]
pub(crate) struct Trigonometric {
    coefficients: Vec<[f64; 2]>,
}

impl Trigonometric {
    /// The polynomial that a function is.
    pub(crate) fn through(function: impl Fn(f64) -> f64) -> Self {
        let angle = |i: usize| TAU * i as f64 / SAMPLES as f64;
        let values: Vec<f64> = (0..SAMPLES).map(|i| function(angle(i))).collect();
        let coefficient = |k: usize| {
            let half = if k == 0 { 1.0 } else { 2.0 };
            let mean = |wave: fn(f64) -> f64| {
                let waves = values
                    .iter()
                    .enumerate()
                    .map(|(i, y)| y * wave(angle(i * k % SAMPLES)));
                half * waves.sum::<f64>() / SAMPLES as f64
            };
            [mean(f64::cos), mean(f64::sin)]
        };
        let mut coefficients: Vec<[f64; 2]> = (0..SAMPLES / 2).map(coefficient).collect();
        let largest = coefficients.iter().map(size).fold(0.0, f64::max);
        while coefficients
            .last()
            .is_some_and(|last| size(last) <= ROUNDING * largest)
        {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// How many complex zeros there are in one turn.
    pub(crate) fn degree(&self) -> usize {
        2 * self.coefficients.len().saturating_sub(1)
    }

    /// Value and derivative.
    fn at(&self, t: f64) -> (f64, f64) {
        let mut sums = (0.0, 0.0);
        for (k, [a, b]) in self.coefficients.iter().enumerate() {
            let k = k as f64;
            let (s, c) = (k * t).sin_cos();
            sums.0 += a * c + b * s;
            sums.1 += k * (b * c - a * s);
        }
        sums
    }

    /// All real zeros in one turn; `None` if two of them nearly coincide.
    ///
    /// An interval is dropped where the value and the slope at its middle, with the largest second
    /// derivative, leave no room for a zero, and taken where they leave room for one only.
    pub(crate) fn zeros(&self) -> Option<Vec<f64>> {
        let bend = self.coefficients.iter().enumerate();
        let bend: f64 = bend.map(|(k, c)| (k * k) as f64 * size(c)).sum();
        let mut zeros = Vec::new();
        let mut open = vec![(0.0, TAU)];
        while let Some((low, high)) = open.pop() {
            let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
            let (value, slope) = self.at(middle);
            if value.abs() > half * (slope.abs() + half * bend / 2.0) {
                continue;
            }
            if slope.abs() > half * bend {
                let signs = [low, high].map(|t| self.at(t).0 > 0.0);
                if signs[0] != signs[1] {
                    zeros.push(self.between(low, high));
                }
            } else if half < 1e-8 {
                return None;
            } else {
                open.extend([(middle, high), (low, middle)]);
            }
        }
        zeros.sort_by(f64::total_cmp);
        Some(zeros)
    }

    fn between(&self, mut low: f64, mut high: f64) -> f64 {
        let sign = self.at(low).0 > 0.0;
        for _ in 0..60 {
            let middle = (low + high) / 2.0;
            if (self.at(middle).0 > 0.0) == sign {
                low = middle;
            } else {
                high = middle;
            }
        }
        (low + high) / 2.0
    }
}

fn size([a, b]: &[f64; 2]) -> f64 {
    a.hypot(*b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_zeros_are_found() {
        let p = Trigonometric::through(|t| (3.0 * t).cos() - 0.5);
        assert_eq!(p.degree(), 6);
        let zeros = p.zeros().expect("they are simple");
        let expected = [20.0, 100.0, 140.0, 220.0, 260.0, 340.0].map(f64::to_radians);
        assert_eq!(zeros.len(), 6);
        assert!(
            zeros
                .iter()
                .zip(expected)
                .all(|(x, y)| (x - y).abs() < 1e-13)
        );
        let none = Trigonometric::through(|t| (2.0 * t).sin() + 1.001);
        assert_eq!(none.zeros(), Some(Vec::new()));
        let double = Trigonometric::through(|t| (t - 1.0).sin() + 1.0);
        assert_eq!(double.zeros(), None);
    }
}
