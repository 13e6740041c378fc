//! Stresses at a diameter, and the diameter at which a stress is the allowable one.

use core::f64::consts::PI;

use super::error::PinError;
use super::pin::{Fit, Mounting, Pin, Width};
use linkage_core::math::cube_root;
use linkage_core::math::double::sqrt;

/// A length that grows with the diameter: `fixed + ratio * diameter`.
#[derive(Clone, Copy)]
pub(super) struct Length {
    fixed: f64,
    ratio: f64,
}

impl Length {
    fn times(self, factor: f64) -> Self {
        Self {
            fixed: factor * self.fixed,
            ratio: factor * self.ratio,
        }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            fixed: self.fixed + other.fixed,
            ratio: self.ratio + other.ratio,
        }
    }

    fn length(self, diameter: f64) -> f64 {
        self.fixed + self.ratio * diameter
    }
}

impl From<Width> for Length {
    fn from(width: Width) -> Self {
        match width {
            Width::Fixed(fixed) => Self { fixed, ratio: 0.0 },
            Width::Ratio(ratio) => Self { fixed: 0.0, ratio },
        }
    }
}

/// A check: how a stress depends on the diameter. `F` is the load, `d` the diameter.
pub(super) enum Formula {
    /// `32 F arm / (pi d^3)`: `arm` is the bending moment over the load.
    Bending { arm: Length },
    /// `4/3 F / (sections pi d^2 / 4)`: the largest stress in a round section is 4/3 of its mean.
    Shear { sections: f64 },
    /// `share F / (d width)`.
    Bearing { share: f64, width: Width },
    /// `F (6 l + 4 s) / (d s^2)` at the mouth of a seat of length `s`: `F / (d s)` by the force,
    /// and by its moment `F (l + s/2)` about the seat's middle a linear pressure of
    /// `6 F (l + s/2) / (d s^2)`. `six_arms` is `6 l`.
    Seat { six_arms: Length, length: Width },
}

/// Bending, shear, and the bearing pressures in both members.
pub(super) fn formulas(pin: &Pin) -> [Formula; 4] {
    match pin.mounting {
        Mounting::Clevis { fit, rod, fork } => {
            let (t_rod, t_fork) = (Length::from(rod.width), Length::from(fork.width));
            let arm = match fit {
                // Held at the middles of the cheeks, evenly loaded by the rod.
                Fit::Loose => t_rod.plus(t_fork.times(2.0)).times(0.125),
                Fit::PressedInFork => t_rod.times(0.125),
                // Two beams held by the rod, each with half of the load in the middle of a cheek.
                Fit::PressedInRod => t_fork.times(0.25),
            };
            let bearing = |share, width| Formula::Bearing { share, width };
            [
                Formula::Bending { arm },
                Formula::Shear { sections: 2.0 },
                bearing(1.0, rod.width),
                bearing(0.5, fork.width),
            ]
        }
        Mounting::Overhung { hub, seat, gap } => {
            let gap = Length {
                fixed: gap,
                ratio: 0.0,
            };
            let arm = gap.plus(Length::from(hub.width).times(0.5));
            [
                Formula::Bending { arm },
                Formula::Shear { sections: 1.0 },
                Formula::Bearing {
                    share: 1.0,
                    width: hub.width,
                },
                Formula::Seat {
                    six_arms: arm.times(6.0),
                    length: seat.width,
                },
            ]
        }
    }
}

impl Formula {
    /// The stress at a diameter.
    pub(super) fn stress(&self, load: f64, d: f64) -> f64 {
        match self {
            Self::Bending { arm } => 32.0 / PI * (load / (d * d)) * (arm.length(d) / d),
            Self::Shear { sections } => 16.0 / (3.0 * PI * sections) * (load / (d * d)),
            Self::Bearing { share, width } => share * (load / d) / width.length(d),
            Self::Seat { six_arms, length } => {
                let s = length.length(d);
                (load / d) / s * (six_arms.length(d) / s + 4.0)
            }
        }
    }

    /// The diameter at which the stress is the allowable one. Stresses fall as the diameter grows.
    pub(super) fn diameter(&self, load: f64, allowable: f64) -> Result<f64, PinError> {
        let area = load / allowable;
        Ok(match self {
            Self::Bending { arm } => {
                let Length { fixed, ratio } = arm.times(32.0 / PI);
                root_of_cubic(area * ratio, area * fixed)
            }
            Self::Shear { sections } => sqrt(16.0 / (3.0 * PI * sections) * area),
            Self::Bearing { share, width } => match width {
                Width::Fixed(length) => share * area / length,
                Width::Ratio(ratio) => sqrt(share * area / ratio),
            },
            Self::Seat { six_arms, length } => {
                let Length { fixed, ratio } = *six_arms;
                match *length {
                    // Linear: `d (s^2 - area ratio) = area (fixed + 4 s)`.
                    Width::Fixed(s) => {
                        let least = ratio * area / s / s;
                        if least >= 1.0 {
                            let least = least * allowable;
                            return Err(PinError::SeatTooShort { least, allowable });
                        }
                        area / s * (fixed / s + 4.0) / (1.0 - least)
                    }
                    Width::Ratio(k) => {
                        let area = area / k / k;
                        root_of_cubic(area * (ratio + 4.0 * k), area * fixed)
                    }
                }
            }
        })
    }
}

/// The positive root of `x^3 = linear x + constant`, where neither is negative.
///
/// In closed form where one of them is zero. Otherwise by Newton's method from above: the cubic is
/// convex there, so that each step stays above the root. In the unit chosen, the root is between
/// 1 and 1.3248.
fn root_of_cubic(linear: f64, constant: f64) -> f64 {
    const ABOVE: f64 = 1.3248;
    const STEPS: usize = 8;

    let (by_linear, by_constant) = (sqrt(linear), cube_root(constant));
    if constant == 0.0 || linear == 0.0 {
        return by_linear + by_constant;
    }
    let unit = by_linear.max(by_constant);
    let ratio = |x: f64| x / unit;
    let p = ratio(by_linear) * ratio(by_linear);
    let q = ratio(by_constant) * ratio(by_constant) * ratio(by_constant);
    let mut x = ABOVE;
    for _ in 0..STEPS {
        x -= (x * (x * x - p) - q) / (3.0 * x * x - p);
    }
    unit * x
}

#[cfg(test)]
mod tests {
    use super::root_of_cubic;

    #[test]
    fn cubics_have_their_roots() {
        for linear in [0.0, 1e-200, 1e-9, 0.3, 1.0, 7.0, 1e9, 1e200] {
            for root in [1e-90, 1e-6, 0.5, 1.0, 3.0, 1e6, 1e90] {
                let constant = root * (root * root - linear);
                if constant < 0.0 {
                    continue;
                }
                let found = root_of_cubic(linear, constant);
                assert!(
                    (found - root).abs() <= 1e-14 * root,
                    "{linear} {root} {found}"
                );
            }
        }
    }

    #[test]
    fn the_start_is_above_the_root() {
        let plastic = root_of_cubic(1.0, 1.0);
        assert!((plastic - 1.324_717_957_244_746).abs() < 1e-15);
    }
}
