//! The followers, and where they are.

use core::f64::consts::PI;

use linkage_core::math::double::sqrt;

use super::plane::direction;
use linkage_core::Scalar;
use linkage_core::numeric::complex::{Complex, I};

/// A follower of a cam. A roller of radius 0 is a point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Follower {
    /// A roller that is pushed along a guide, upwards, to the right of the cam's centre by
    /// `offset`.
    Roller {
        /// Radius of the pitch circle: how far the roller's centre is from that of the cam where
        /// the motion is 0.
        base: f64,
        /// Distance of the guide from the cam's centre, to the right.
        offset: f64,
        /// Radius of the roller.
        radius: f64,
    },
    /// A roller on an arm about a pivot to the right of the cam's centre, above the line between
    /// them. The motion is the arm's angle from where the motion is 0, away from the cam.
    Swinging {
        /// Radius of the pitch circle.
        base: f64,
        /// Distance of the pivot from the cam's centre.
        pivot: f64,
        /// Length of the arm.
        arm: f64,
        /// Radius of the roller.
        radius: f64,
    },
    /// A flat face that is pushed upwards, perpendicular to its way.
    Flat {
        /// Distance of the face from the cam's centre where the motion is 0.
        base: f64,
    },
}

/// The centre of a roller in the frame, with three derivatives, and the direction in which it is
/// pushed, with the rate at which that turns.
pub(super) struct Centre {
    pub(super) jet: [Complex; 4],
    pub(super) way: Complex,
    pub(super) turning: f64,
}

impl Follower {
    /// The radius of its roller; 0 for a flat face.
    pub fn radius(&self) -> f64 {
        match *self {
            Self::Roller { radius, .. } | Self::Swinging { radius, .. } => radius,
            Self::Flat { .. } => 0.0,
        }
    }

    /// The centre of a roller; `None` for a flat face.
    pub(super) fn centre(&self, [s, first, second, third]: [f64; 4]) -> Option<Centre> {
        match *self {
            Self::Roller { base, offset, .. } => {
                let height = sqrt((base - offset) * (base + offset)) + s;
                let jet = [
                    Complex::new(offset, height),
                    first * I,
                    second * I,
                    third * I,
                ];
                Some(Centre {
                    jet,
                    way: I,
                    turning: 0.0,
                })
            }
            Self::Swinging {
                base, pivot, arm, ..
            } => {
                let cosine = (pivot * pivot + arm * arm - base * base) / (2.0 * pivot * arm);
                let begin = Scalar::acos(cosine);
                let direction = direction(PI - (begin + s));
                let arm = arm * direction;
                // Each derivative of the arm is a factor times it; the arm turns against the angle.
                let factors = [
                    Complex::new(0.0, -first),
                    Complex::new(-first * first, -second),
                    Complex::new(-3.0 * first * second, first * first * first - third),
                ];
                let [speed, acceleration, jerk] = factors.map(|factor| factor * arm);
                let jet = [Complex::new(pivot, 0.0) + arm, speed, acceleration, jerk];
                Some(Centre {
                    jet,
                    way: -(I * direction),
                    turning: -first,
                })
            }
            Self::Flat { .. } => None,
        }
    }
}
