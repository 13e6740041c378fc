//! The contact of a follower with its cam.

use super::follower::Follower;
use super::plane::{direction, length, relative};
use linkage_core::Scalar;
use linkage_core::numeric::complex::{Complex, I};

/// The contact of the follower with the cam at one angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The angle of the cam.
    pub angle: f64,
    /// The roller's centre, in the cam's coordinates; of a flat face the foot of the way of its
    /// middle.
    pub pitch: [f64; 2],
    /// The point of the profile.
    pub profile: [f64; 2],
    /// The angle from the follower's way to the contact normal, counter-clockwise; 0 for a flat
    /// face.
    pub pressure_angle: f64,
    /// One over the radius of curvature of the pitch curve, positive where it is convex; of a flat
    /// face that of the profile.
    pub pitch_curvature: f64,
    /// Radius of curvature of the profile, positive where it is convex. Where the pitch curve is
    /// convex and this is negative, the profile is undercut.
    pub radius: f64,
    /// The sliding speed of the follower along the cam, for an angular speed of 1, if its roller
    /// does not turn. A roller that rolls turns on its pin at this speed divided by its radius.
    pub sliding: f64,
}

/// A number with its derivative by the angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rate {
    pub(super) value: f64,
    pub(super) slope: f64,
}

/// The figures that are searched over the turn.
pub(super) struct Figures {
    pub(super) pressure: Rate,
    /// Curvature of the pitch curve; for a flat face the radius of the profile.
    pub(super) bend: Rate,
}

/// The contact at an angle of the cam, with the follower's motion `jet` there.
pub(super) fn contact(follower: &Follower, jet: [f64; 4], angle: f64) -> Contact {
    let back = direction(-angle);
    let radius = follower.radius();
    let Figures { pressure, bend } = figures(follower, jet);
    let Some(centre) = follower.centre(jet) else {
        let [s, first, ..] = jet;
        let height = face(follower) + s;
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

/// Distance of a flat face from the centre at the base.
fn face(follower: &Follower) -> f64 {
    match *follower {
        Follower::Flat { base } => base,
        Follower::Roller { .. } | Follower::Swinging { .. } => 0.0,
    }
}

/// The pressure angle and the curvature where the follower's motion is `jet`.
pub(super) fn figures(follower: &Follower, jet: [f64; 4]) -> Figures {
    let Some(centre) = follower.centre(jet) else {
        let [s, first, second, third] = jet;
        return Figures {
            pressure: Rate {
                value: 0.0,
                slope: 0.0,
            },
            bend: Rate {
                value: face(follower) + s + second,
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
