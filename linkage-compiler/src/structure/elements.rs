//! Elements that forms of groups consist of: vectors that turn, spheres, planes, links in space.

use linkage_symbolic::{Ex, V2, V3};

/// A vector that turns with an unknown angle: `z (cos + i sense sin)` in complex numbers.
#[derive(Clone, Debug)]
pub(crate) struct Rotor<'m> {
    pub(crate) angle: usize,
    /// The sense: -1 if the vector turns against the angle.
    pub(crate) sense: f64,
    pub(crate) z: V2<'m>,
}

/// `|known + factor * point| = radius`
#[derive(Clone, Debug)]
pub(crate) struct Sphere<'m> {
    pub(crate) known: V3<'m>,
    pub(crate) factor: Ex<'m>,
    pub(crate) radius: Ex<'m>,
}

/// `normal . point + offset = 0`
#[derive(Clone, Debug)]
pub(crate) struct Plane<'m> {
    pub(crate) normal: V3<'m>,
    pub(crate) offset: Ex<'m>,
}

/// A link in space, whose distance was squared.
#[derive(Clone, Debug)]
pub(crate) struct SpaceLink<'m> {
    pub(crate) vector: V3<'m>,
    pub(crate) length: Ex<'m>,
    /// The link whose square was subtracted.
    pub(crate) less: Option<Box<SpaceLink<'m>>>,
}
