//! The bodies of a mechanism: their tree, their geometry, and facts about both that numbers show.

use linkage_symbolic::Vn;

use crate::algebra::Algebra;
use crate::forces::geometry::Geometry;
use crate::forces::loop_values::LoopValues;
use crate::forces::tree::Tree;
use crate::model::{Mechanism, Rotation};

/// The bodies of a mechanism. Functions only read them, and the check of the bodies adds the facts.
#[derive(Clone, Debug, Default)]
pub(super) struct Multibody<'m> {
    pub(super) tree: Tree,
    pub(super) geometry: Geometry<'m>,
    pub(super) facts: NumericFacts,
    pub(super) loop_values: LoopValues<'m>,
}

/// Facts about the motion that only numbers show.
#[derive(Clone, Debug, Default)]
pub(super) struct NumericFacts {
    /// Ways of bodies (which, and whether they slide) whose rates by the inputs are the same at all
    /// positions.
    pub(super) steady: Vec<(usize, bool)>,
    /// Ways of pins, slides and cylinders in which nothing moves.
    pub(super) still: Vec<(usize, bool)>,
    /// Bodies that turn with a vector whose length does not change.
    pub(super) rigid_rods: Vec<usize>,
}

impl<'m> Multibody<'m> {
    /// The declared bodies, without facts.
    pub(super) fn new(algebra: &mut Algebra<'m>) -> Self {
        let tree = Tree::new(algebra.mechanism);
        let geometry = Geometry::new(algebra, &tree);
        Self {
            tree,
            geometry,
            facts: NumericFacts::default(),
            loop_values: LoopValues::default(),
        }
    }

    /// True for a body of the plane with a pin on the frame that does not move.
    pub(super) fn turns_about_fixed_pin(&self, mechanism: &Mechanism, body: usize) -> bool {
        let joint = &mechanism.joints[mechanism.bodies[body].joint];
        let is_pin = joint.kind.rotation() == Rotation::AboutAxis && !joint.kind.slides();
        let origin = self.geometry.origins[body];
        let rests = joint.on.is_none() && origin.iter().all(|x| x.is_fixed());
        self.geometry.is_plane() && is_pin && rests
    }

    /// The vector from a body's origin to a point.
    pub(super) fn arm(&self, body: usize, point: Vn<'m>) -> Vn<'m> {
        let known = self.loop_values.arm(body, point);
        known.unwrap_or_else(|| point - self.geometry.origins[body])
    }
}
