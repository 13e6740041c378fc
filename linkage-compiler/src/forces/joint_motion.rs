//! The motions of joints and the ties of gears, as data.

use linkage_symbolic::Vn;

/// A way in which a body moves in its own joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct JointMotion<'m> {
    pub(super) body: usize,
    /// Along a guide; else a turn.
    pub(super) slides: bool,
    /// Unit vector; in the plane a turn has the component 1.
    pub(super) direction: Vn<'m>,
}

/// Turns that gears tie: their couples on bodies, in proportion, which the frame takes up.
#[derive(Clone, Debug)]
pub(super) struct Tie {
    pub(super) couples: Vec<(usize, f64)>,
}

/// All motions of the tree's joints.
#[derive(Clone, Debug, Default)]
pub(super) struct Motions<'m> {
    pub(super) free: Vec<JointMotion<'m>>,
    pub(super) driven: Vec<JointMotion<'m>>,
    pub(super) ties: Vec<Tie>,
}
