//! The laws of motion: `s(x)` from 0 to 1, with their derivatives.
//!
//! A law consists of zones. In each it is a polynomial in `y = x - origin` less `amplitude *
//! sin(frequency * y)`. Origins lie so that `y` is small where terms would cancel each other: all
//! derivatives are then right to a few roundings of their largest value, and at 0 a law is exactly
//! 0. Sources of the definitions: VDI 2143 part 1; R. L. Norton, Cam Design and Manufacturing
//! Handbook.

use std::f64::consts::PI;

use crate::model::Law;

/// A zone in which a law is one formula: from `from` to the next zone.
pub(crate) struct Zone {
    pub(crate) from: f64,
    pub(crate) origin: f64,
    /// Coefficients of the powers of `y`.
    pub(crate) polynomial: &'static [f64],
    pub(crate) wave: Option<Wave>,
}

/// The subtracted term: `amplitudes[0] * sin(frequency * y)`.
pub(crate) struct Wave {
    pub(crate) frequency: f64,
    /// The amplitudes of the sine and of its derivatives, without their signs.
    pub(crate) amplitudes: [f64; ORDERS],
}

/// The law itself and three derivatives have formulas of their own; higher derivatives follow by
/// the rules.
pub(crate) const ORDERS: usize = 4;

const fn zone(from: f64, origin: f64, polynomial: &'static [f64], wave: Option<Wave>) -> Zone {
    Zone {
        from,
        origin,
        polynomial,
        wave,
    }
}

const fn wave(amplitude: f64, frequency: f64) -> Option<Wave> {
    let first = amplitude * frequency;
    let second = first * frequency;
    let amplitudes = [amplitude, first, second, second * frequency];
    Some(Wave {
        frequency,
        amplitudes,
    })
}

/// `1 / (4 + pi)`, the scale of the modified sine.
const SINE: f64 = 1.0 / (4.0 + PI);

/// `8 pi / (2 + pi)`, the largest acceleration of the modified trapezoid.
const TRAPEZOID: f64 = 8.0 * PI / (2.0 + PI);

/// Its speed where the first quarter of a sine ends, `2 / (2 + pi)`; as much is missing to 2 at the
/// other end of the constant.
const SPEED: f64 = 2.0 / (2.0 + PI);

/// Its way by a quarter of a sine: `A / (16 pi^2)`.
const QUARTER: f64 = 0.5 / (PI * (2.0 + PI));

/// In the middle of a constant acceleration: the way there, and the speed.
const MIDDLE_SPEED: f64 = SPEED + TRAPEZOID / 8.0;

const MIDDLE: f64 = SPEED / 8.0 - QUARTER + SPEED / 8.0 + TRAPEZOID / 128.0;

/// A law from zone to zone.
pub(crate) fn zones(law: Law) -> &'static [Zone] {
    match law {
        Law::Line => const { &[zone(0.0, 0.5, &[0.5, 1.0], None)] },
        Law::Cubic => const { &[zone(0.0, 0.5, &[0.5, 1.5, 0.0, -2.0], None)] },
        Law::Poly345 => const { &[zone(0.0, 0.5, &[0.5, 1.875, 0.0, -5.0, 0.0, 6.0], None)] },
        Law::Poly4567 => {
            const {
                &[zone(
                    0.0,
                    0.5,
                    &[0.5, 2.1875, 0.0, -8.75, 0.0, 21.0, 0.0, -20.0],
                    None,
                )]
            }
        }
        Law::Harmonic => const { &[zone(0.0, 0.5, &[0.5], wave(-0.5, PI))] },
        Law::Cycloidal => {
            const {
                &[
                    zone(0.0, 0.0, &[0.0, 1.0], wave(0.5 / PI, 2.0 * PI)),
                    zone(0.5, 1.0, &[1.0, 1.0], wave(0.5 / PI, 2.0 * PI)),
                ]
            }
        }
        Law::ModifiedSine => {
            const {
                &[
                    zone(0.0, 0.0, &[0.0, SINE * PI], wave(SINE / 4.0, 4.0 * PI)),
                    zone(
                        0.125,
                        0.5,
                        &[0.5, SINE * PI],
                        wave(SINE * -2.25, 4.0 * PI / 3.0),
                    ),
                    zone(0.875, 1.0, &[1.0, SINE * PI], wave(SINE / 4.0, 4.0 * PI)),
                ]
            }
        }
        Law::ModifiedTrapezoid => {
            const {
                &[
                    zone(0.0, 0.0, &[0.0, SPEED], wave(QUARTER, 4.0 * PI)),
                    zone(0.125, 0.25, &[MIDDLE, MIDDLE_SPEED, TRAPEZOID / 2.0], None),
                    zone(0.375, 0.5, &[0.5, 2.0 - SPEED], wave(-QUARTER, 4.0 * PI)),
                    zone(
                        0.625,
                        0.75,
                        &[1.0 - MIDDLE, MIDDLE_SPEED, TRAPEZOID / -2.0],
                        None,
                    ),
                    zone(0.875, 1.0, &[1.0, SPEED], wave(QUARTER, 4.0 * PI)),
                ]
            }
        }
    }
}

/// Acceleration and speed of a law where it begins and where it ends.
pub(crate) fn ends(law: Law) -> [[f64; 2]; 2] {
    let zones = zones(law);
    [(&zones[0], 0.0), (&zones[zones.len() - 1], 1.0)].map(|(zone, x)| {
        let y = x - zone.origin;
        let mut rates = [1, 2].map(|order| {
            let powers = (order..zone.polynomial.len()).rev();
            powers.fold(0.0, |sum, k| {
                sum * y + falling(k, order) * zone.polynomial[k]
            })
        });
        if let Some(wave) = &zone.wave {
            let (sin, cos) = (wave.frequency * y).sin_cos();
            rates[0] -= wave.amplitudes[1] * cos;
            rates[1] += wave.amplitudes[2] * sin;
        }
        rates
    })
}

/// `k (k - 1) ...`, so many factors.
pub(crate) fn falling(k: usize, factors: usize) -> f64 {
    (0..factors).map(|less| (k - less) as f64).product()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::Word;

    /// A zone's value and two derivatives.
    fn value_and_rates(zone: &Zone, x: f64) -> [f64; 3] {
        let y = x - zone.origin;
        let mut all = [0, 1, 2].map(|order| {
            let powers = (order..zone.polynomial.len()).rev();
            powers.fold(0.0, |sum, k| {
                sum * y + falling(k, order) * zone.polynomial[k]
            })
        });
        if let Some(wave) = &zone.wave {
            let (sin, cos) = (wave.frequency * y).sin_cos();
            let signed = [-sin, -cos, sin];
            (0..3).for_each(|order| all[order] += wave.amplitudes[order] * signed[order]);
        }
        all
    }

    #[test]
    fn laws_go_from_exactly_zero_to_one_and_are_smooth_between_zones() {
        for law in Law::all() {
            let zones = zones(law);
            assert_eq!(value_and_rates(&zones[0], 0.0)[0], 0.0, "{}", law.word());
            let end = value_and_rates(&zones[zones.len() - 1], 1.0)[0];
            assert!((end - 1.0).abs() <= f64::EPSILON, "{}: {end}", law.word());
            for pair in zones.windows(2) {
                let [before, behind] =
                    [&pair[0], &pair[1]].map(|zone| value_and_rates(zone, pair[1].from));
                for order in 0..3 {
                    let gap = (before[order] - behind[order]).abs();
                    assert!(
                        gap < 1e-14,
                        "{} {order} at {}: {gap:e}",
                        law.word(),
                        pair[1].from
                    );
                }
            }
        }
    }

    #[test]
    fn ends_are_those_that_the_names_promise() {
        for law in Law::all() {
            let [[begins, starts], [ends, stops]] =
                ends(law).map(|end| end.map(|x| (1e9 * x).round() / 1e9));
            let expected = match law {
                Law::Line => [1.0, 0.0],
                Law::Cubic => [0.0, 6.0],
                Law::Harmonic => [0.0, 4.934_802_201],
                Law::Poly345
                | Law::Poly4567
                | Law::Cycloidal
                | Law::ModifiedSine
                | Law::ModifiedTrapezoid => [0.0, 0.0],
            };
            assert_eq!([begins, starts], expected, "{}", law.word());
            assert_eq!([ends.abs(), -stops + 0.0], expected, "{}", law.word());
        }
    }
}
