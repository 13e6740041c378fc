//! Angles that can be set in steps only.

/// A setting of a gear that is put on its shaft in steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slot {
    /// The number of steps.
    pub step: i64,
    /// The angle that they are.
    pub angle: f64,
    /// The excess over the wanted angle, at most half a step either way.
    pub off: f64,
}

/// The setting nearest to a wanted angle, where only whole steps can be set: one of 48 slots,
/// `TAU / 48.0`.
///
/// ```
/// use linkage_analysis::cyclogram::nearest_slot;
///
/// let slot = nearest_slot(20f64.to_radians(), std::f64::consts::TAU / 48.0);
/// assert_eq!((slot.step, slot.angle.to_degrees().round()), (3, 23.0));
/// assert!((slot.off.to_degrees() - 2.5).abs() < 1e-12);
/// ```
#[must_use]
pub fn nearest_slot(wanted: f64, step: f64) -> Slot {
    let steps = wanted / step;
    let steps = (steps + 0.5f64.copysign(steps)) as i64;
    let angle = steps as f64 * step;
    Slot {
        step: steps,
        angle,
        off: angle - wanted,
    }
}
