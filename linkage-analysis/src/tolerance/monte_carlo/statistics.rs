//! Statistics of numbers, from sums of powers.

use core::fmt;

use crate::tolerance::distribution::normal;
use linkage_core::format::rounded;

/// An estimate from samples with its confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

/// A number over all mechanisms that could be assembled. Intervals are of 95 % confidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistics {
    /// The number of mechanisms that could be assembled.
    pub count: usize,
    /// The number of mechanisms that could not be assembled, whose value is NaN.
    pub missing: usize,
    /// The mean.
    pub mean: Estimate,
    /// The standard deviation.
    pub deviation: Estimate,
    /// The mean third power of the distance from the mean over the third power of the deviation:
    /// 0 for symmetrical values, positive if large ones reach further from the mean.
    pub skewness: f64,
    /// The least value.
    pub min: f64,
    /// The largest value.
    pub max: f64,
}

/// Sums of powers of numbers about a value in the middle, so that nothing cancels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Moments {
    pub(super) count: u64,
    pub(super) centre: f64,
    /// Of the first power to the fourth.
    pub(super) powers: [f64; 4],
}

impl Estimate {
    /// Where there is none.
    pub(super) const NAN: Self = Self {
        value: f64::NAN,
        low: f64::NAN,
        high: f64::NAN,
    };

    /// The estimate with so many standard errors on both sides.
    fn around(value: f64, error: f64) -> Self {
        Self {
            value,
            low: value - error,
            high: value + error,
        }
    }
}

impl Moments {
    /// The statistics of numbers whose limits are known.
    pub(super) fn statistics(&self, missing: u64, [min, max]: [f64; 2]) -> Statistics {
        let n = self.count as f64;
        let [shift, second, third, fourth] = self.powers.map(|power| power / n);
        let square = shift * shift;
        let variance = second - square;
        let cube = third - shift * (3.0 * second - 2.0 * square);
        let quartic = fourth - shift * (4.0 * third - shift * (6.0 * second - 3.0 * square));
        let deviation = (variance * (n / (n - 1.0))).sqrt();
        // The variance of a variance depends on how heavy the tails are.
        let peak = if variance == 0.0 {
            1.0
        } else {
            quartic / (variance * variance)
        };
        let spread = deviation * (0.25 * (peak - 1.0).max(0.0) / n).sqrt();
        let z = normal(0.975);
        Statistics {
            count: self.count as usize,
            missing: missing as usize,
            mean: Estimate::around(self.centre + shift, z * deviation / n.sqrt()),
            deviation: Estimate::around(deviation, z * spread),
            skewness: cube / (variance * variance.sqrt()),
            min,
            max,
        }
    }
}

/// A part of `n`, with Wilson's score interval of this confidence.
pub(super) fn score_interval(within: f64, n: f64, confidence: f64) -> Estimate {
    let part = within / n;
    let z = normal(0.5 + 0.5 * confidence);
    let centre = (part + 0.5 * z * z / n) / (1.0 + z * z / n);
    let half = z / (1.0 + z * z / n) * (part * (1.0 - part) / n + 0.25 * z * z / (n * n)).sqrt();
    Estimate {
        value: part,
        low: (centre - half).max(0.0),
        high: (centre + half).min(1.0),
    }
}

/// A text such as `17.5 (17.4 to 17.6)`.
impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [value, low, high] = [self.value, self.low, self.high].map(rounded);
        write!(f, "{value} ({low} to {high})")
    }
}

impl fmt::Display for Statistics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "mean                {}", self.mean)?;
        writeln!(f, "standard deviation  {}", self.deviation)?;
        writeln!(f, "skewness            {}", rounded(self.skewness))?;
        writeln!(f, "from                {}", rounded(self.min))?;
        writeln!(f, "to                  {}", rounded(self.max))?;
        writeln!(f, "mechanisms          {}", self.count)?;
        writeln!(f, "not assembled       {}", self.missing)
    }
}
