//! Plate cams.

use alloc::vec::Vec;
use core::f64::consts::TAU;

use super::check::{check, sharpness};
use super::contact::{Contact, Figures, contact, figures};
use super::error::CamError;
use super::follower::Follower;
use super::outline::{Outline, check_chord_error, profile};
use super::search::{Stationary, peak, stationary};
use super::turn::angles;

/// A plate cam: its follower, and the follower's motion over a turn.
#[derive(Clone, Copy, Debug)]
pub struct Cam<F> {
    follower: Follower,
    motion: F,
}

impl<F: Fn(f64) -> [f64; 4]> Cam<F> {
    /// The cam of a follower. `motion` gives, at an angle of the cam, the way of a follower that is
    /// pushed or the angle of one that swings, from where the roller touches the base circle on,
    /// and its first three derivatives by the angle. It is evaluated from 0 to a turn.
    ///
    /// # Errors
    ///
    /// [`CamError::Invalid`] for lengths that make no follower, [`CamError::NotFinite`] and
    /// [`CamError::Open`] for a motion that is no number somewhere, or ends elsewhere than it
    /// began.
    pub fn new(follower: Follower, motion: F) -> Result<Self, CamError> {
        check_lengths(&follower)?;
        let cam = Self { follower, motion };
        if let Some(angle) = angles().find(|&angle| !cam.jet(angle).iter().all(|x| x.is_finite())) {
            return Err(CamError::NotFinite { angle });
        }
        let [begin, end] = [0.0, TAU].map(|angle| cam.jet(angle)[0]);
        let size = angles().fold(0.0, |size: f64, angle| size.max(cam.jet(angle)[0].abs()));
        if (end - begin).abs() > CLOSED * size {
            return Err(CamError::Open { gap: end - begin });
        }
        Ok(cam)
    }

    /// The follower.
    pub fn follower(&self) -> &Follower {
        &self.follower
    }

    /// The contact at an angle of the cam.
    pub fn contact(&self, angle: f64) -> Contact {
        contact(&self.follower, self.jet(angle), angle)
    }

    /// The places where the pressure angle is highest or lowest beside its neighbours, in order;
    /// none where the follower rests, none for a flat face. Roots of its exact derivative.
    pub fn pressure_angles(&self) -> Vec<Stationary> {
        stationary(&|angle| self.figures(angle), |figures| figures.pressure)
    }

    /// The same for the curvature of the pitch curve; for a flat face it is the radius of curvature
    /// of the profile.
    pub fn curvatures(&self) -> Vec<Stationary> {
        stationary(&|angle| self.figures(angle), |figures| figures.bend)
    }

    /// The pressure angle that is farthest from 0.
    pub fn largest_pressure_angle(&self) -> Stationary {
        peak(
            &|angle| self.figures(angle),
            |figures| figures.pressure,
            f64::abs,
        )
    }

    /// The place where the profile is most sharply bent, and its radius of curvature there: the
    /// least one of those where it is convex, negative if it is undercut.
    pub fn least_radius(&self) -> Stationary {
        let sharpness = |bend| sharpness(&self.follower, bend);
        let peak = peak(
            &|angle| self.figures(angle),
            |figures| figures.bend,
            sharpness,
        );
        let value = match self.follower {
            Follower::Flat { .. } => peak.value,
            Follower::Roller { radius, .. } | Follower::Swinging { radius, .. } => {
                1.0 / peak.value - radius
            }
        };
        Stationary { value, ..peak }
    }

    /// Checks whether the profile can be made.
    ///
    /// # Errors
    ///
    /// [`CamError::Undercut`] with the angles, and the radius of a roller or the distance of a flat
    /// face that would do.
    pub fn check(&self) -> Result<(), CamError> {
        check(&self.follower, &|angle| self.figures(angle))
    }

    /// The profile as a line whose chords stray from it by no more than `chord_error`. Points lie
    /// on the profile, and where it is bent they are denser.
    ///
    /// # Errors
    ///
    /// [`CamError::Invalid`] for an error that is not positive, [`CamError::Undercut`] as for
    /// [`Cam::check`].
    pub fn profile(&self, chord_error: f64) -> Result<Outline, CamError> {
        check_chord_error(chord_error)?;
        self.check()?;
        Ok(profile(|angle| self.contact(angle), chord_error))
    }

    fn figures(&self, angle: f64) -> Figures {
        figures(&self.follower, self.jet(angle))
    }

    fn jet(&self, angle: f64) -> [f64; 4] {
        (self.motion)(angle)
    }
}

/// The gap between the ends of the motion that rounding of a turn's angle can cause, as a part of
/// the largest way.
const CLOSED: f64 = 1e-9;

/// Checks that the lengths make a follower.
fn check_lengths(follower: &Follower) -> Result<(), CamError> {
    let positive = |what, value: f64| {
        if value > 0.0 && value.is_finite() {
            Ok(())
        } else {
            Err(CamError::Invalid {
                what,
                value,
                expected: "positive and finite",
            })
        }
    };
    let roller = |radius: f64, base: f64| {
        if radius >= 0.0 && radius < base {
            Ok(())
        } else {
            Err(CamError::Invalid {
                what: "radius of the roller",
                value: radius,
                expected: "0 for a point, and less than that of the pitch circle",
            })
        }
    };
    match *follower {
        Follower::Roller {
            base,
            offset,
            radius,
        } => {
            positive("radius of the pitch circle", base)?;
            if offset.abs() < base {
                return roller(radius, base);
            }
            let expected = "less than the radius of the pitch circle, which the guide meets";
            Err(CamError::Invalid {
                what: "offset",
                value: offset,
                expected,
            })
        }
        Follower::Swinging {
            base,
            pivot,
            arm,
            radius,
        } => {
            positive("radius of the pitch circle", base)?;
            positive("distance of the pivot", pivot)?;
            positive("length of the arm", arm)?;
            if base + arm > pivot && (pivot - arm).abs() < base {
                return roller(radius, base);
            }
            let expected =
                "the third side of a triangle with the distance of the pivot and the arm";
            Err(CamError::Invalid {
                what: "radius of the pitch circle",
                value: base,
                expected,
            })
        }
        Follower::Flat { base } => positive("distance of the face", base),
    }
}
