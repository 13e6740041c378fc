//! Contact of a follower with its cam.

use super::plane::{direction, length, relative};
use super::{Cam, Follower};
use linkage_core::Scalar;
use linkage_core::numeric::complex::{Complex, I};

/// The contact between follower and cam at one angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The angle of the cam.
    pub angle: f64,
    /// The roller's centre, in the cam's coordinates; of a flat face the foot of the way of its
    /// middle.
    pub pitch: [f64; 2],
    /// The point of the profile.
    pub profile: [f64; 2],
    /// The angle between the follower's direction and the contact normal, counter-clockwise; 0 for
    /// a flat face.
    pub pressure_angle: f64,
    /// One over the radius of curvature of the pitch curve, positive where it is convex; of a flat
    /// face that of the profile.
    pub pitch_curvature: f64,
    /// Radius of curvature of the profile, positive where it is convex. Where the pitch curve is
    /// convex and this is negative, the profile is undercut.
    pub radius: f64,
    /// The sliding speed of the follower along the cam, for an angular speed of 1, if its roller
    /// does not turn; one that rolls turns on its pin at this speed over its radius.
    pub sliding: f64,
}

/// A number with its derivative by the angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rate {
    pub(super) value: f64,
    pub(super) slope: f64,
}

/// The figures for a search over the turn.
pub(super) struct Figures {
    pub(super) pressure: Rate,
    /// The curvature of the pitch curve; of a flat face the radius of the profile.
    pub(super) bend: Rate,
}

impl<F: Fn(f64) -> [f64; 4]> Cam<F> {
    /// The contact at an angle of the cam.
    pub fn contact(&self, angle: f64) -> Contact {
        let jet = self.jet(angle);
        let back = direction(-angle);
        let radius = self.follower.radius();
        let Figures { pressure, bend } = self.figures(angle);
        let Some(centre) = self.follower.centre(jet) else {
            let [s, first, ..] = jet;
            let height = self.face() + s;
            return Contact {
                angle,
                pitch: (back * Complex::new(0.0, height)).into(),
                profile: (back * Complex::new(first, height)).into(),
                pressure_angle: 0.0,
                pitch_curvature: 1.0 / bend.value,
                radius: bend.value,
                sliding: height,
            };
        };
        let [z, speed, ..] = centre.jet;
        let along = speed - I * z;
        let length = length(along);
        let normal = (1.0 / length) * (I * along);
        Contact {
            angle,
            pitch: (back * z).into(),
            profile: (back * (z - radius * normal)).into(),
            pressure_angle: pressure.value,
            pitch_curvature: bend.value,
            radius: 1.0 / bend.value - radius,
            sliding: length - radius * (1.0 - centre.turning),
        }
    }

    /// Returns the distance of a flat face from the centre at the base.
    fn face(&self) -> f64 {
        match self.follower {
            Follower::Flat { base } => base,
            Follower::Roller { .. } | Follower::Swinging { .. } => 0.0,
        }
    }

    pub(super) fn figures(&self, angle: f64) -> Figures {
        let jet = self.jet(angle);
        let Some(centre) = self.follower.centre(jet) else {
            let [s, first, second, third] = jet;
            return Figures {
                pressure: Rate {
                    value: 0.0,
                    slope: 0.0,
                },
                bend: Rate {
                    value: self.face() + s + second,
                    slope: first + third,
                },
            };
        };
        let [z, speed, acceleration, jerk] = centre.jet;
        // The derivatives of the pitch curve, turned into the frame.
        let first = speed - I * z;
        let second = acceleration - 2.0 * (I * speed) - z;
        let third = jerk - 3.0 * (I * acceleration) - 3.0 * speed + I * z;
        let square = relative(first, first).re;
        let length = length(first);
        let cube = square * length;
        let [stretch, bend] = relative(first, second).into();
        let normal = relative(centre.way, I * first);
        // The normal turns in the frame by one less than on the cam.
        let turning = 1.0 + bend / square;
        Figures {
            pressure: Rate {
                value: Scalar::atan2(normal.im, normal.re),
                slope: turning - centre.turning,
            },
            bend: Rate {
                value: -bend / cube,
                slope: (3.0 * bend * stretch / square - relative(first, third).im) / cube,
            },
        }
    }
}
