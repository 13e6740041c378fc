//! The loads whose forces are found, and the motion that they act in.

use crate::forces::speeds::Speeds;

/// A set of loads at some speeds.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Loading {
    pub(super) speeds: Speeds,
    pub(super) loads: LoadSet,
}

impl Loading {
    pub(super) fn new(speeds: &Speeds, loads: LoadSet) -> Self {
        let speeds = speeds.clone();
        Self { speeds, loads }
    }
}

/// The loads that act.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum LoadSet {
    /// Inertia, weights, forces, torques, springs and dampers.
    Frictionless,
    /// All these, and friction.
    WithFriction,
    /// Inertia alone.
    Inertia,
    /// The friction of one joint alone, by its number among those with friction: for contact forces
    /// of size 1, against a positive speed.
    UnitFriction(usize),
}
