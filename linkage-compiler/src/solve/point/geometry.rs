//! Spheres, planes and a point on them, scaled.

use linkage_symbolic::{Ex, V3};

/// A sphere `|f (p - centre)| = radius`, with its own numbers.
pub(super) struct Ball<'m> {
    pub(super) centre: V3<'m>,
    /// As a distance from the centre, and scaled.
    pub(super) radius: Ex<'m>,
    pub(super) scaled: Ex<'m>,
    /// From the first sphere's centre, scaled.
    pub(super) apart: V3<'m>,
}

/// A plane `normal . (p - centre of the first sphere) = offset`, scaled; the normal is that of the user of length 1, or the
/// distance of two centres.
pub(super) struct Level<'m> {
    pub(super) normal: V3<'m>,
    pub(super) offset: Ex<'m>,
    /// What the offset's rounding is measured by.
    pub(super) size: Ex<'m>,
    /// What the normal's length is measured by in the margin.
    pub(super) largest: Ex<'m>,
}

/// Where a point lies.
pub(super) struct PointOnSpheres<'m> {
    /// From the first sphere's centre, scaled.
    pub(super) arm: V3<'m>,
    /// What lengths are multiplied by.
    pub(super) scale: Ex<'m>,
    /// Scaled, 0 at the dead point.
    pub(super) h: Ex<'m>,
}
