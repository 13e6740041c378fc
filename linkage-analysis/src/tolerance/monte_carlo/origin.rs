//! Where the deviations of a dimension come from.

use alloc::vec::Vec;

use crate::tolerance::{Distribution, ToleranceError};

/// Where the deviations of a dimension come from.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Source {
    /// A distribution, for a tolerance of 1.
    Distribution(Distribution),
    /// Measured deviations, in the unit of the parameter.
    Measured(Measured),
}

/// Measured deviations from the nominal value, in order.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Measured {
    sorted: Vec<f64>,
}

impl Measured {
    /// The deviations that were measured of the parameter with this index.
    ///
    /// # Errors
    ///
    /// `Nothing` for an empty list, `Measurement` for a deviation that is not finite.
    pub(super) fn new(index: usize, deviations: &[f64]) -> Result<Self, ToleranceError> {
        if deviations.is_empty() {
            return Err(ToleranceError::Nothing {
                what: "no measured deviations",
            });
        }
        if let Some(number) = deviations.iter().position(|x| !x.is_finite()) {
            return Err(ToleranceError::Measurement {
                index,
                number,
                deviation: deviations[number],
            });
        }
        let mut sorted = deviations.to_vec();
        sorted.sort_unstable_by(f64::total_cmp);
        Ok(Self { sorted })
    }

    /// The deviation below which this part of all lies; linear between neighbours.
    #[inline]
    pub(super) fn quantile(&self, part: f64) -> f64 {
        let last = self.sorted.len() - 1;
        let rank = part * last as f64;
        let below = (rank as usize).min(last);
        let above = (below + 1).min(last);
        let [low, high] = [below, above].map(|rank| self.sorted[rank]);
        low + (rank - below as f64) * (high - low)
    }

    /// The standard deviation of what is drawn, about the mean of it: between two neighbours it is
    /// even.
    pub(super) fn deviation(&self) -> f64 {
        let pairs = || self.sorted.windows(2).map(|pair| [pair[0], pair[1]]);
        let count = (self.sorted.len() - 1) as f64;
        if count == 0.0 {
            return 0.0;
        }
        let mean = pairs().map(|[a, b]| 0.5 * (a + b)).sum::<f64>() / count;
        let square = |[a, b]: [f64; 2]| {
            let [a, b] = [a - mean, b - mean];
            (a * a + a * b + b * b) / 3.0
        };
        (pairs().map(square).sum::<f64>() / count).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_and_deviation() {
        let measured = Measured::new(0, &[3.0, -1.0, 1.0]).expect("they are finite");
        for (part, known) in [
            (0.0, -1.0),
            (0.25, 0.0),
            (0.5, 1.0),
            (0.75, 2.0),
            (1.0, 3.0),
        ] {
            assert_eq!(measured.quantile(part), known);
        }
        // Even from -1 to 3.
        assert!((measured.deviation() - 4.0 / 12.0_f64.sqrt()).abs() < 1e-15);
        let one = Measured::new(0, &[0.5]).expect("it is finite");
        assert_eq!((one.quantile(0.3), one.deviation()), (0.5, 0.0));
    }

    #[test]
    fn refused() {
        assert!(matches!(
            Measured::new(0, &[]),
            Err(ToleranceError::Nothing { .. })
        ));
        let error = Measured::new(2, &[0.0, f64::INFINITY]).expect_err("not finite");
        let infinite = ToleranceError::Measurement {
            index: 2,
            number: 1,
            deviation: f64::INFINITY,
        };
        assert_eq!(error, infinite);
    }
}
