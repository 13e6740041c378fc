//! Distributions of dimensions.

use core::fmt;

/// The distribution of a dimension within its tolerance `t`, symmetrically about the middle of its
/// zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Distribution {
    /// Normal with a standard deviation of `t / 3`: 0.27 % lie outside of the tolerance.
    Normal,
    /// Uniform between the limits.
    Uniform,
    /// Triangular between the limits, most frequent in the middle.
    Triangular,
    /// The sine of an angle that may be any: most frequent at the limits. An eccentricity or a
    /// runout of a part that is mounted at random has this distribution.
    Arcsine,
    /// Normal with a standard deviation of `t / 3`, without those outside of the tolerance: parts
    /// that are measured and sorted.
    TruncatedNormal,
}

/// Standard deviations of a normal distribution from its middle to the limits of the tolerance.
const LIMIT: f64 = 3.0;
/// The part of a normal distribution below its lower limit.
const BELOW: f64 = 0.001_349_898_031_630_094_5;
/// The density of the standard normal distribution at the limits, over the part between them.
const DENSITY: f64 = 0.004_431_848_411_938_007_5 / (1.0 - 2.0 * BELOW);

impl Distribution {
    /// All of them.
    #[cfg(all(test, feature = "monte-carlo"))]
    pub(crate) const ALL: [Self; 5] = [
        Self::Normal,
        Self::Uniform,
        Self::Triangular,
        Self::Arcsine,
        Self::TruncatedNormal,
    ];

    /// The standard deviation for a tolerance of 1: 1/3, 1/sqrt(3), 1/sqrt(6), 1/sqrt(2),
    /// and 0.3289.
    #[must_use]
    pub fn deviation(self) -> f64 {
        match self {
            Self::Normal => 1.0 / 3.0,
            Self::Uniform => 1.0 / 3.0_f64.sqrt(),
            Self::Triangular => 1.0 / 6.0_f64.sqrt(),
            Self::Arcsine => core::f64::consts::FRAC_1_SQRT_2,
            Self::TruncatedNormal => (1.0 - 2.0 * LIMIT * DENSITY).sqrt() / LIMIT,
        }
    }

    /// The mean fourth power of the deviation over the squared variance: 3, 9/5, 12/5, 3/2,
    /// and 2.829.
    #[must_use]
    pub fn kurtosis(self) -> f64 {
        match self {
            Self::Normal => 3.0,
            Self::Uniform => 1.8,
            Self::Triangular => 2.4,
            Self::Arcsine => 1.5,
            Self::TruncatedNormal => {
                let fourth = 3.0 - 2.0 * LIMIT * (LIMIT * LIMIT + 3.0) * DENSITY;
                fourth / (LIMIT * self.deviation()).powi(4)
            }
        }
    }

    /// The value, for a tolerance of 1, below which this part of all dimensions lies; by inversion,
    /// so that each dimension takes one random number.
    #[must_use]
    pub fn quantile(self, probability: f64) -> f64 {
        let p = probability;
        match self {
            Self::Normal => normal(p) / 3.0,
            Self::Uniform => 2.0 * p - 1.0,
            Self::Triangular if p <= 0.5 => (2.0 * p).sqrt() - 1.0,
            Self::Triangular => 1.0 - (2.0 * (1.0 - p)).sqrt(),
            Self::Arcsine => (core::f64::consts::PI * (p - 0.5)).sin(),
            Self::TruncatedNormal => normal(BELOW + p * (1.0 - 2.0 * BELOW)) / LIMIT,
        }
    }
}

/// Writes a name such as `uniform`.
impl fmt::Display for Distribution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Normal => "normal",
            Self::Uniform => "uniform",
            Self::Triangular => "triangular",
            Self::Arcsine => "arcsine",
            Self::TruncatedNormal => "truncated normal",
        })
    }
}

/// The quantile of the standard normal distribution by Wichura's algorithm AS 241 (PPND16), which
/// is good to about 16 digits.
pub(super) fn normal(p: f64) -> f64 {
    let q = p - 0.5;
    if q.abs() <= 0.425 {
        let r = 0.180_625 - q * q;
        return q * ratio(&CENTRE, r);
    }
    let tail = if q < 0.0 { p } else { 1.0 - p };
    let r = (-tail.ln()).sqrt();
    let size = if r <= 5.0 {
        ratio(&TAIL, r - 1.6)
    } else {
        ratio(&FAR, r - 5.0)
    };
    size.copysign(q)
}

/// Numerators and denominators, lowest power first.
type Ratio = [[f64; 8]; 2];

fn ratio([above, below]: &Ratio, r: f64) -> f64 {
    let polynomial = |c: &[f64; 8]| c.iter().rev().fold(0.0, |sum, c| sum * r + c);
    polynomial(above) / polynomial(below)
}

#[allow(
    clippy::excessive_precision,
    clippy::unreadable_literal,
    reason = "as published"
)]
const CENTRE: Ratio = [
    [
        3.3871328727963666080e0,
        1.3314166789178437745e2,
        1.9715909503065514427e3,
        1.3731693765509461125e4,
        4.5921953931549871457e4,
        6.7265770927008700853e4,
        3.3430575583588128105e4,
        2.5090809287301226727e3,
    ],
    [
        1.0,
        4.2313330701600911252e1,
        6.8718700749205790830e2,
        5.3941960214247511077e3,
        2.1213794301586595867e4,
        3.9307895800092710610e4,
        2.8729085735721942674e4,
        5.2264952788528545610e3,
    ],
];

#[allow(
    clippy::excessive_precision,
    clippy::unreadable_literal,
    reason = "as published"
)]
const TAIL: Ratio = [
    [
        1.42343711074968357734e0,
        4.63033784615654529590e0,
        5.76949722146069140550e0,
        3.64784832476320460504e0,
        1.27045825245236838258e0,
        2.41780725177450611770e-1,
        2.27238449892691845833e-2,
        7.74545014278341407640e-4,
    ],
    [
        1.0,
        2.05319162663775882187e0,
        1.67638483018380384940e0,
        6.89767334985100004550e-1,
        1.48103976427480074590e-1,
        1.51986665636164571966e-2,
        5.47593808499534494600e-4,
        1.05075007164441684324e-9,
    ],
];

#[allow(
    clippy::excessive_precision,
    clippy::unreadable_literal,
    reason = "as published"
)]
const FAR: Ratio = [
    [
        6.65790464350110377720e0,
        5.46378491116411436990e0,
        1.78482653991729133580e0,
        2.96560571828504891230e-1,
        2.65321895265761230930e-2,
        1.24266094738807843860e-3,
        2.71155556874348757815e-5,
        2.01033439929228813265e-7,
    ],
    [
        1.0,
        5.99832206555887937690e-1,
        1.36929880922735805310e-1,
        1.48753612908506148525e-2,
        7.86869131145613259100e-4,
        1.84631831751005468180e-5,
        1.42151175831644588870e-7,
        2.04426310338993978564e-15,
    ],
];

#[cfg(test)]
mod tests {
    use super::{Distribution, normal};

    #[test]
    fn quantiles_of_the_normal_distribution() {
        for (p, known) in [
            (0.5, 0.0),
            (0.75, 0.674_489_750_196_081_7),
            (0.975, 1.959_963_984_540_054),
            (0.001, -3.090_232_306_167_813),
            (1e-20, -9.262_340_089_798_41),
        ] {
            assert!(
                (normal(p) - known).abs() <= 1e-14 * known.abs(),
                "{p}: {}",
                normal(p)
            );
        }
    }

    #[test]
    fn quantiles_are_antisymmetric_and_grow() {
        for distribution in [
            Distribution::Normal,
            Distribution::Uniform,
            Distribution::Triangular,
            Distribution::Arcsine,
            Distribution::TruncatedNormal,
        ] {
            let quantile = |i: i32| distribution.quantile(f64::from(i) / 4096.0);
            let (mut square, mut fourth) = (0.0, 0.0);
            for i in 1..4096 {
                assert!((quantile(i) + quantile(4096 - i)).abs() < 1e-14);
                assert!(
                    quantile(i) > quantile(i - 1) || i == 1,
                    "{distribution:?} {i}"
                );
                square += quantile(i).powi(2) / 4096.0;
                fourth += quantile(i).powi(4) / 4096.0;
            }
            assert!(
                (square.sqrt() / distribution.deviation() - 1.0).abs() < 2e-3,
                "{distribution:?}"
            );
            // Rare values of a normal distribution are a good part of its fourth power.
            let kurtosis = fourth / (square * square);
            assert!(
                (kurtosis / distribution.kurtosis() - 1.0).abs() < 5e-2,
                "{distribution:?} {kurtosis}"
            );
        }
    }
}
