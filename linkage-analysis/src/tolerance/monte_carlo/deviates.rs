//! Deviations of a dimension in a block of mechanisms.
//!
//! Normal deviations are made in pairs (G. E. P. Box and M. E. Muller, "A note on the generation of
//! random normal deviates", 1958): the root of a logarithm as radius, in a direction that may be
//! any. Logarithm, sine and cosine are polynomials, without a branch and without fused
//! multiply-add, so that all machines draw the same mechanisms.

use super::block::{BLOCK, HALF};
use super::origin::Source;
use super::random::Numbers;
use super::wide::{self, Loop};
use crate::tolerance::Distribution;
use linkage_core::Scalar;

/// The dimension `nominal + (middle + factor * deviation)` of each mechanism of a block.
pub(super) struct Deviates<'a> {
    pub(super) source: &'a Source,
    pub(super) numbers: Numbers,
    pub(super) block: u64,
    pub(super) nominal: f64,
    pub(super) middle: f64,
    pub(super) factor: f64,
    pub(super) column: &'a mut [f64; BLOCK],
}

/// Fills the column.
pub(super) fn fill(deviates: Deviates) {
    wide::run(deviates);
}

impl Loop for Deviates<'_> {
    type Result = ();

    #[inline(always)]
    fn run(self) {
        match self.source {
            Source::Distribution(Distribution::Normal) => self.pairs(|u, v| {
                let radius = (-2.0 * logarithm(u)).sqrt() / 3.0;
                let (sine, cosine) = (core::f64::consts::TAU * v).sin_cos_in_rows::<false, true>();
                [radius * cosine, radius * sine]
            }),
            Source::Distribution(Distribution::Uniform) => {
                self.pairs(|u, v| [u, v].map(|p| 2.0 * p - 1.0));
            }
            Source::Distribution(
                other @ (Distribution::Triangular
                | Distribution::Arcsine
                | Distribution::TruncatedNormal),
            ) => {
                self.pairs(|u, v| [u, v].map(|p| other.quantile(p)));
            }
            Source::Measured(deviations) => {
                self.pairs(|u, v| [u, v].map(|p| deviations.quantile(p)));
            }
        }
    }
}

impl Deviates<'_> {
    /// A mechanism of the first half of the block and one of the second half have the two
    /// deviations of a pair of random numbers.
    #[inline(always)]
    fn pairs(self, deviations: impl Fn(f64, f64) -> [f64; 2]) {
        let (first, second) = self.column.split_at_mut(HALF);
        let begin = self.block.wrapping_mul(BLOCK as u64);
        for (j, (first, second)) in (0..).zip(first.iter_mut().zip(second)) {
            let [u, v] = [0, 1].map(|k| self.numbers.uniform(begin + 2 * j + k));
            let dimension = |deviation: f64| self.nominal + (self.middle + self.factor * deviation);
            [*first, *second] = deviations(u, v).map(dimension);
        }
    }
}

/// The natural logarithm of a normal positive number, with an error of about one unit in the last
/// place: the power of two and `log(1 + f)` by powers of `s = f / (2 + f)`, as in K. C. Ng's
/// `e_log.c` of FDLIBM, whose coefficients these are.
#[inline(always)]
fn logarithm(x: f64) -> f64 {
    const ROOT_OF_HALF: u64 = 0x3FE6_A09E_667F_3BCD;
    const LN_2: [f64; 2] = [
        f64::from_bits(0x3FE6_2E42_FEE0_0000),
        f64::from_bits(0x3DEA_39EF_3579_3C76),
    ];
    const EVEN: [f64; 3] = [
        f64::from_bits(0x3FD9_9999_9997_FA04),
        f64::from_bits(0x3FCC_71C5_1D8E_78AF),
        f64::from_bits(0x3FC3_9A09_D078_C69F),
    ];
    const ODD: [f64; 4] = [
        f64::from_bits(0x3FE5_5555_5555_5593),
        f64::from_bits(0x3FD2_4924_9422_9359),
        f64::from_bits(0x3FC7_4664_96CB_03DE),
        f64::from_bits(0x3FC2_F112_DF3E_5244),
    ];
    /// An integer added to its low bits is added to its value.
    const INTEGERS: f64 = 6_755_399_441_055_744.0;
    // The mantissa is between the root of a half and that of two.
    let power = (x.to_bits().wrapping_sub(ROOT_OF_HALF) as i64) >> 52;
    let mantissa = f64::from_bits(x.to_bits().wrapping_sub((power as u64) << 52));
    let power = f64::from_bits(INTEGERS.to_bits().wrapping_add(power as u64)) - INTEGERS;
    let f = mantissa - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let w = z * z;
    let even = w * (EVEN[0] + w * (EVEN[1] + w * EVEN[2]));
    let odd = z * (ODD[0] + w * (ODD[1] + w * (ODD[2] + w * ODD[3])));
    let half = 0.5 * f * f;
    power * LN_2[0] - ((half - (s * (half + (even + odd)) + power * LN_2[1])) - f)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::distribution::normal;

    #[test]
    fn logarithms() {
        let mut x = 1.0 - 0.5 * f64::EPSILON;
        while x > 1e-16 {
            let (found, known) = (logarithm(x), x.ln());
            assert!((found - known).abs() <= 3e-16 * known.abs(), "{x}: {found}");
            x *= 0.987_654_321;
        }
    }

    fn block(distribution: Distribution, block: u64) -> [f64; BLOCK] {
        let mut column = [0.0; BLOCK];
        fill(Deviates {
            source: &Source::Distribution(distribution),
            numbers: Numbers::new(4, 1),
            block,
            nominal: 0.0,
            middle: 0.0,
            factor: 1.0,
            column: &mut column,
        });
        column
    }

    /// The part of deviations below some quantiles, and moments up to the fourth.
    #[test]
    fn deviations_have_their_distribution() {
        const BLOCKS: u64 = 100;
        let count = BLOCKS as f64 * BLOCK as f64;
        for distribution in Distribution::ALL {
            let parts = [1e-4, 0.01, 0.2, 0.5, 0.9, 0.999];
            let quantiles = parts.map(|part| distribution.quantile(part));
            let mut below = [0.0; 6];
            let mut powers = [0.0; 4];
            for x in (0..BLOCKS).flat_map(|index| block(distribution, index)) {
                for (below, quantile) in below.iter_mut().zip(quantiles) {
                    *below += if x < quantile { 1.0 } else { 0.0 };
                }
                for (power, exponent) in powers.iter_mut().zip(1..) {
                    *power += x.powi(exponent) / count;
                }
            }
            for (below, part) in below.iter().zip(parts) {
                let deviation = (part * (1.0 - part) / count).sqrt();
                let error = (below / count - part) / deviation;
                assert!(
                    error.abs() < 4.0,
                    "{distribution}, {part}: {error} deviations"
                );
            }
            let deviation = distribution.deviation();
            let error = 4.0 / count.sqrt();
            assert!(powers[0].abs() < error * deviation, "{distribution}");
            assert!(
                (powers[1].sqrt() / deviation - 1.0).abs() < error,
                "{distribution}"
            );
            assert!(
                powers[2].abs() < 4.0 * error * deviation.powi(3),
                "{distribution}"
            );
            let kurtosis = powers[3] / powers[1].powi(2);
            assert!(
                (kurtosis - distribution.kurtosis()).abs() < 10.0 * error,
                "{distribution}"
            );
        }
    }

    /// The pair of numbers gives the radius and the direction of two normal deviations.
    #[test]
    fn normal_deviations_are_pairs() {
        let numbers = Numbers::new(4, 1);
        let column = block(Distribution::Normal, 7);
        for j in 0..HALF {
            let [u, v] = [0, 1].map(|k| numbers.uniform(7 * 1024 + 2 * j as u64 + k));
            let radius = (-2.0 * u.ln()).sqrt() / 3.0;
            let known = [(TAU * v).cos(), (TAU * v).sin()].map(|x| radius * x);
            for (found, known) in [column[j], column[j + HALF]].into_iter().zip(known) {
                assert!(
                    (found - known).abs() < 1e-15 * radius.max(1.0),
                    "{found} {known}"
                );
            }
        }
    }
    use core::f64::consts::TAU;

    #[test]
    fn far_deviations_are_there() {
        // Of half a million, one in a million is beyond 4.9 deviations, and ten beyond 4.3.
        let far = (0..500).flat_map(|index| block(Distribution::Normal, index));
        let farthest = far.map(f64::abs).fold(0.0, f64::max);
        assert!(3.0 * farthest > normal(1.0 - 1e-5), "{farthest}");
    }
}
