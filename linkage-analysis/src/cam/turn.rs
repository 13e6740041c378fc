//! The angles of a turn at which figures are looked at.

use core::f64::consts::TAU;

/// The number of angles per turn: a motion does nothing within half a degree.
pub(super) const POSITIONS: usize = 720;

/// Halvings of a step: beyond them there are no numbers between its ends.
pub(super) const HALVINGS: usize = 60;

/// The angles at which it is looked, both ends of the turn among them.
pub(super) fn angles() -> impl Iterator<Item = f64> {
    (0..=POSITIONS).map(|k| k as f64 * (TAU / POSITIONS as f64))
}
