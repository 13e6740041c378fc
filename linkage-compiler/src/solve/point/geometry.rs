//! Spheres, planes and a point on them, scaled.

use linkage_symbolic::{Ex, V3};

/// A sphere `|f (p - centre)| = radius`, with its own numbers.
pub(super) struct Ball<'m> {
    pub(super) centre: V3<'m>,
    /// The radius as a distance from the centre, and scaled.
    pub(super) radius: Ex<'m>,
    pub(super) scaled: Ex<'m>,
    /// The vector from the first sphere's centre, scaled.
    pub(super) apart: V3<'m>,
}

/// A plane `normal . (p - centre of the first sphere) = offset`, scaled; the normal is that of the
/// user of length 1, or the distance of two centres.
pub(super) struct Level<'m> {
    pub(super) normal: V3<'m>,
    pub(super) offset: Ex<'m>,
    /// The measure of the offset's rounding.
    pub(super) size: Ex<'m>,
    /// The measure of the normal's length in the margin.
    pub(super) largest: Ex<'m>,
}

/// The position of a point.
pub(super) struct PointOnSpheres<'m> {
    /// The vector from the first sphere's centre, scaled.
    pub(super) arm: V3<'m>,
    /// The factor of lengths.
    pub(super) scale: Ex<'m>,
    /// Scaled, 0 at the dead point.
    pub(super) h: Ex<'m>,
}
