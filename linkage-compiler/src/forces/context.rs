//! The mechanics of a mechanism, and the context in which one question about it is answered.

use std::rc::Rc;

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, Graph, Vn};

use crate::algebra::Algebra;
use crate::forces::body_loads::Loads;
use crate::forces::geometry::Geometry;
use crate::forces::loop_values::LoopValues;
use crate::forces::speeds::{Motion, Speeds};
use crate::forces::system::System;
use crate::forces::tree::Tree;
use crate::forces::wrench::{Carried, Wrench};

/// All that is known of the mechanics, made when it is asked for; the default for functions that
/// ask for nothing of it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Forces<'m> {
    pub(super) tree: Tree,
    pub(super) geometry: Geometry<'m>,
    pub(super) motion: Motion<'m>,
    /// Ways of bodies (which, and whether they slide) whose rates by the inputs are the same at all
    /// positions.
    pub(super) steady: Vec<(usize, bool)>,
    /// Ways of pins, slides and cylinders in which nothing moves.
    pub(super) still: Vec<(usize, bool)>,
    /// Bodies that turn with a vector whose length does not change.
    pub(super) rigid_rods: Vec<usize>,
    pub(super) loop_values: LoopValues<'m>,
    pub(super) system: Option<Rc<System<'m>>>,
    /// The forces for each set of speeds and accelerations that functions list.
    pub(super) cases: Map<Speeds, Case<'m>>,
}

/// The forces at some speeds.
#[derive(Clone, Debug)]
pub(super) struct Case<'m> {
    pub(super) loads: Rc<Loads<'m>>,
    pub(super) wrenches: Map<Carried, Wrench<'m>>,
    /// Unknowns of the system that are known already.
    pub(super) solved: Map<usize, Ex<'m>>,
}

/// The mechanics of one mechanism together with its algebra, for the time of one question.
pub(crate) struct Mechanics<'a, 'm> {
    pub(super) algebra: &'a mut Algebra<'m>,
    pub(super) forces: &'a mut Forces<'m>,
    pub(super) speeds: Speeds,
    /// True if reactions are asked for.
    pub(super) with_reactions: bool,
}

impl<'m> Forces<'m> {
    /// Nothing is computed yet but the geometry.
    pub(crate) fn new(algebra: &mut Algebra<'m>) -> Self {
        let tree = Tree::new(algebra.mechanism);
        let geometry = Geometry::new(algebra, &tree);
        Self {
            tree,
            geometry,
            motion: Motion::default(),
            steady: Vec::new(),
            still: Vec::new(),
            rigid_rods: Vec::new(),
            loop_values: LoopValues::default(),
            system: None,
            cases: Map::new(),
        }
    }

    /// Forgets all that was made of derivatives.
    pub(crate) fn forget_derivatives(&mut self) {
        self.motion = Motion::default();
        self.system = None;
        self.cases = Map::new();
    }

    /// For a function that lists these inputs and arguments: speeds that it does not list are zero.
    /// Drives are found from the joints if reactions are asked for, too.
    pub(crate) fn in_function<'a>(
        &'a mut self,
        algebra: &'a mut Algebra<'m>,
        listed: &[usize],
        with_reactions: bool,
    ) -> Mechanics<'a, 'm> {
        let speeds = Speeds::listed(algebra.mechanism, listed);
        Mechanics {
            algebra,
            forces: self,
            speeds,
            with_reactions,
        }
    }
}

impl<'m> Mechanics<'_, 'm> {
    pub(super) fn graph(&self) -> &'m Graph {
        self.algebra.graph
    }

    /// No force, no velocity.
    pub(super) fn zero_vector(&self) -> Vn<'m> {
        self.graph().zeros(self.forces.geometry.dimensions)
    }

    /// No moment, no angular velocity.
    pub(super) fn zero_turn(&self) -> Vn<'m> {
        self.graph().zeros(self.forces.geometry.turns())
    }

    /// The vector from a body's origin to a point.
    pub(super) fn arm(&self, body: usize, point: Vn<'m>) -> Vn<'m> {
        let known = self.forces.loop_values.arm(body, point);
        known.unwrap_or_else(|| point - self.forces.geometry.origins[body])
    }
}

/// Neither force nor moment.
pub(super) fn zero_wrench<'m>(mechanics: &Mechanics<'_, 'm>) -> Wrench<'m> {
    Wrench {
        force: mechanics.zero_vector(),
        moment: mechanics.zero_turn(),
    }
}
