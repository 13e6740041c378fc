//! Undercut profiles.

use crate::summary::Interval;
use alloc::vec::Vec;

/// The undercut part of a profile.
#[derive(Clone, Debug, PartialEq)]
pub struct Undercut {
    /// All intervals of the cam's angle in which the radius of the profile is negative where it
    /// should be convex, in the order of their beginnings. One that goes across angle 0 is a single
    /// one: its end is below its beginning.
    pub intervals: Vec<Interval>,
    /// The one of them in which it is worst.
    pub worst: Interval,
    /// The worst angle of the whole turn.
    pub at: f64,
    /// The radius of curvature of the profile there.
    pub radius: f64,
    /// The limit: the largest radius of a roller, which is the radius of the pitch curve, or the
    /// least distance of a flat face at the base.
    pub limit: f64,
}
