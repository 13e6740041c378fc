//! Plate cams from the motion of their follower: pitch curve and profile, pressure angle, curvature, undercut, sliding.
//!
//! A [`Cam`] takes a [`Follower`] and a function that gives its motion with three derivatives by the cam's angle, as a function of
//! `mechanism!` does. [`Cam::contact`] tells all at one angle; [`Cam::pressure_angles`] and [`Cam::curvatures`] where these stand
//! still; [`Cam::check`] whether the profile can be made; [`Cam::profile`] is the profile as a polyline, with SVG and DXF in reports.
//!
//! The cam turns counter-clockwise about the origin; points are in its own coordinates, which are the frame's at angle 0. Angles
//! are radians, lengths in any unit. For `z_f` in the frame and `w = z_f' - i z_f`, as complex numbers, the contact normal is
//! `i w / |w|`; formulas of textbooks (Norton, Cam Design and Manufacturing Handbook; VDI 2142) follow from it.

mod contact;
mod error;
mod follower;
mod outline;
mod plane;
mod search;
mod undercut;
#[cfg(feature = "report")]
mod write;

pub use contact::Contact;
pub use error::CamError;
pub use follower::Follower;
pub use outline::Outline;
pub use search::Stationary;
pub use undercut::Undercut;

use core::f64::consts::TAU;

/// A plate cam: its follower, and the follower's motion over a turn.
#[derive(Clone, Copy, Debug)]
pub struct Cam<F> {
    follower: Follower,
    motion: F,
}

impl<F: Fn(f64) -> [f64; 4]> Cam<F> {
    /// The cam of a follower. `motion` gives, at an angle of the cam, the way of a follower that is pushed or the angle of one that
    /// swings, from where the roller touches the base circle on, and its first three derivatives by the angle. It is
    /// asked from 0 to a turn.
    ///
    /// # Errors
    ///
    /// [`CamError::Invalid`] for lengths that make no follower, [`CamError::NotFinite`] and [`CamError::Open`] for a motion that is
    /// no number somewhere, or ends elsewhere than it began.
    pub fn new(follower: Follower, motion: F) -> Result<Self, CamError> {
        follower.check()?;
        let cam = Self { follower, motion };
        if let Some(angle) =
            search::angles().find(|&angle| !cam.jet(angle).iter().all(|x| x.is_finite()))
        {
            return Err(CamError::NotFinite { angle });
        }
        let [begin, end] = [0.0, TAU].map(|angle| cam.jet(angle)[0]);
        let size = search::angles().fold(0.0, |size: f64, angle| size.max(cam.jet(angle)[0].abs()));
        if (end - begin).abs() > CLOSED * size {
            return Err(CamError::Open { gap: end - begin });
        }
        Ok(cam)
    }

    /// The follower.
    pub fn follower(&self) -> &Follower {
        &self.follower
    }

    fn jet(&self, angle: f64) -> [f64; 4] {
        (self.motion)(angle)
    }
}

/// By how much of its largest way the motion's end may miss its begin: what rounding of a turn's angle does to a steep motion.
const CLOSED: f64 = 1e-9;
