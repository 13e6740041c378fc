//! Plate cams from the motion of their follower: pitch curve and profile, pressure angle,
//! curvature, undercut, sliding.
//!
//! A [`Cam`] takes a [`Follower`] and a function that gives its motion with three derivatives with
//! respect to the cam's angle, as a function of `mechanism!` does. [`Cam::contact`] returns all
//! figures at one angle, [`Cam::pressure_angles`] and [`Cam::curvatures`] the places where these
//! are stationary. [`Cam::check`] finds undercut, and [`Cam::profile`] returns the profile as a
//! polyline, with SVG and DXF in reports.
//!
//! The cam turns counter-clockwise about the origin; points are in its own coordinates, which are
//! the frame's at angle 0. Angles are radians, lengths in any unit. For `z_f` in the frame and
//! `w = z_f' - i z_f`, as complex numbers, the contact normal is `i w / |w|`; formulas of textbooks
//! (Norton, Cam Design and Manufacturing Handbook; VDI 2142) follow from it.

mod check;
mod contact;
mod error;
#[cfg(feature = "files")]
mod files;
mod follower;
mod outline;
mod plane;
mod plate;
mod search;
mod turn;
mod undercut;

pub use contact::Contact;
pub use error::CamError;
pub use follower::Follower;
pub use outline::Outline;
pub use plate::Cam;
pub use search::Stationary;
pub use undercut::Undercut;
