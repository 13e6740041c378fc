//! Round numbers along an axis.

use std::format;
use std::string::String;
use std::vec::Vec;

/// The stretch of numbers that an axis shows, with the ticks in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    pub low: f64,
    pub high: f64,
    pub ticks: Vec<f64>,
    decimals: usize,
    /// Labels are in units of ten to this power.
    pub exponent: i32,
}

/// Steps between ticks of angles, in degrees.
const DEGREES: [f64; 9] = [5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0];

/// An end of the axis that misses a tick by this share of a step, by rounding, still has it.
const BESIDE: f64 = 1e-6;

/// Numbers smaller than this are zero: steps between them could not be computed.
const NOTHING: f64 = 1e-280;

/// Differences of numbers, as a share of their size, that are roundoff: shown large they would be
/// noise.
const NOISE: f64 = 1e-12;

/// A number is whole if it is off by less than this share of it, which is rounding of powers of
/// ten.
const WHOLE: f64 = 1e-6;

/// A step may be too short by this share, so that rounding does not take the next longer one.
const ENOUGH: f64 = 1e-9;

impl Scale {
    /// About `count` ticks in just these limits.
    pub fn within(low: f64, high: f64, count: usize) -> Self {
        Self::stepped(low, high, round_step((high - low) / count as f64))
    }

    /// Returns a scale as [`within`](Self::within), with steps that divide a turn.
    pub fn degrees(low: f64, high: f64, count: usize) -> Self {
        let least = (high - low) / count as f64;
        let step = DEGREES.into_iter().find(|step| *step >= least);
        match step {
            Some(step) if least > 2.0 => Self::stepped(low, high, step),
            _ => Self::within(low, high, count),
        }
    }

    /// Limits with some air about these numbers, which may be equal.
    pub fn about(low: f64, high: f64, count: usize) -> Self {
        let (low, high) = with_air(low, high);
        Self::within(low, high, count)
    }

    /// Returns a scale as [`about`](Self::about), with steps that divide a turn if the range is
    /// much of one.
    pub fn about_degrees(low: f64, high: f64, count: usize) -> Self {
        let (low, high) = with_air(low, high);
        match high - low > 120.0 {
            true => Self::degrees(low, high, count),
            false => Self::within(low, high, count),
        }
    }

    fn stepped(low: f64, high: f64, step: f64) -> Self {
        let (first, last) = ((low / step - BESIDE).ceil(), (high / step + BESIDE).floor());
        let count = (last - first).max(0.0) as usize;
        let ticks: Vec<f64> = (0..=count).map(|i| (first + i as f64) * step).collect();
        let largest = ticks.iter().fold(step, |size, tick| size.max(tick.abs()));
        let exponent = match largest.log10().floor() as i32 {
            power @ (..-3 | 5..) => 3 * power.div_euclid(3),
            _ => 0,
        };
        let decimals = (0..15).find(|digits| whole(step / 10f64.powi(exponent - digits)));
        Self {
            low,
            high,
            ticks,
            decimals: decimals.unwrap_or(15) as usize,
            exponent,
        }
    }

    /// A tick's number as it stands at the axis.
    pub fn label(&self, tick: f64) -> String {
        let number = tick / 10f64.powi(self.exponent);
        let decimals = self.decimals;
        let digits = format!("{:.decimals$}", number.abs());
        let is_zero = digits.bytes().all(|c| matches!(c, b'0' | b'.'));
        match number < 0.0 && !is_zero {
            true => format!("\u{2212}{digits}"),
            false => digits,
        }
    }

    /// Returns the position of a number between the ends, 0 to 1.
    pub fn part(&self, x: f64) -> f64 {
        (x - self.low) / (self.high - self.low)
    }
}

fn with_air(low: f64, high: f64) -> (f64, f64) {
    let size = low.abs().max(high.abs());
    let air = match high - low {
        _ if size < NOTHING => 1.0,
        width if width > NOISE * size => 0.06 * width,
        _ => 0.1 * size,
    };
    (low - air, high + air)
}

fn whole(x: f64) -> bool {
    x.round() != 0.0 && (x - x.round()).abs() < WHOLE * x.abs()
}

/// The next of 1, 2, 2.5, 5 times a power of ten.
fn round_step(least: f64) -> f64 {
    let power = 10f64.powf(least.log10().floor());
    let factors = [1.0, 2.0, 2.5, 5.0];
    let factor = factors
        .into_iter()
        .find(|f| f * power >= least * (1.0 - ENOUGH));
    factor.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: &Scale) -> Vec<String> {
        scale.ticks.iter().map(|&tick| scale.label(tick)).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(
            labels(&Scale::within(-0.3, 1.1, 6)),
            ["\u{2212}0.25", "0.00", "0.25", "0.50", "0.75", "1.00"]
        );
        assert_eq!(
            labels(&Scale::within(0.0, 10.0, 5)),
            ["0", "2", "4", "6", "8", "10"]
        );
        assert_eq!(
            labels(&Scale::within(1.0, 2.0, 4)),
            ["1.00", "1.25", "1.50", "1.75", "2.00"]
        );
    }

    #[test]
    fn turns_are_divided_evenly() {
        assert_eq!(
            labels(&Scale::degrees(0.0, 360.0, 9)),
            ["0", "45", "90", "135", "180", "225", "270", "315", "360"]
        );
        assert_eq!(
            labels(&Scale::degrees(-90.0, 630.0, 9))
                .first()
                .map(String::as_str),
            Some("\u{2212}90")
        );
        assert_eq!(
            labels(&Scale::degrees(1.0, 2.0, 4)),
            ["1.00", "1.25", "1.50", "1.75", "2.00"]
        );
    }

    #[test]
    fn large_and_small_numbers_share_a_power_of_ten() {
        let large = Scale::within(-2.0e6, 3.0e6, 5);
        assert_eq!(
            (large.exponent, labels(&large)[0].as_str()),
            (6, "\u{2212}2")
        );
        let small = Scale::within(0.0, 5e-6, 5);
        assert_eq!((small.exponent, labels(&small)[1].as_str()), (-6, "1"));
    }

    #[test]
    fn a_constant_gets_a_scale_about_it() {
        let scale = Scale::about(5.0, 5.0, 4);
        assert!(
            scale.low < 5.0 && scale.high > 5.0 && scale.ticks.len() > 2,
            "{scale:?}"
        );
        let zero = Scale::about(0.0, 0.0, 4);
        assert!(zero.low < 0.0 && zero.high > 0.0, "{zero:?}");
    }
}
