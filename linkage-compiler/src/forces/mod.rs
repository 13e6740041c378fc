//! Forces: reactions of joints, driving torques, energies, as expressions of the same graph as the motion.
//!
//! By virtual work, on the bodies and joints that the user declares and not on the loops, which may be written in any way. Every body
//! hangs on another by its own joint: that is a tree, and what all bodies beyond a joint carry is what the joint carries. Joints
//! that close loops are cut; their reactions are found from the motions of the tree's joints, in which no work may be done
//! (see `system`). These are as many equations, in small groups, as an adjoint of the loops has, and the other reactions are sums.
//!
//! | file | what |
//! |---|---|
//! | `tree` | who hangs on whom |
//! | `geometry` | origins, angles, axes as expressions, what joints allow |
//! | `motion` | velocities and accelerations of points and bodies |
//! | `inertia` | moments of inertia and what they do when a body turns |
//! | `loads` | what acts on each body: inertia, weight, loads, springs, dampers |
//! | `freedom` | motions of the tree's joints that nothing drives |
//! | `drives` | what is driven where the unknowns do not tell |
//! | `system` | equations for the reactions of the cut joints |
//! | `rank` | do equations that are solved together tell their unknowns? |
//! | `closed` | what the loops' closed forms know already |
//! | `links` | links that leave one number of a reaction open |
//! | `reactions` | the equations solved, group by group |
//! | `wrench` | what bodies beyond a joint carry together |
//! | `quantities` | what functions ask for |
//! | `positions` | where things are looked at on numbers |
//! | `check` | can forces be found with what is declared? |
//! | `fit` | do bodies and joints fit the motion? |
//! | `ends` | do springs and dampers have a direction? |
//! | `steady` | what only numbers tell of the motion |
//! | `print` | how reactions are found, for golden files |

pub(crate) mod check;
pub(crate) mod closed;
pub(crate) mod drives;
pub(crate) mod ends;
pub(crate) mod fit;
pub(crate) mod freedom;
pub(crate) mod geometry;
pub(crate) mod inertia;
pub(crate) mod links;
pub(crate) mod loads;
pub(crate) mod motion;
pub(crate) mod positions;
pub(crate) mod print;
pub(crate) mod quantities;
pub(crate) mod rank;
pub(crate) mod reactions;
pub(crate) mod steady;
pub(crate) mod system;
pub(crate) mod tree;
pub(crate) mod wrench;

use linkage_symbolic::lookup::Map;
use std::rc::Rc;

use linkage_symbolic::{Ex, Graph, Vn};

use crate::algebra::Algebra;

use closed::Closed;
use geometry::Geometry;
use loads::Loads;
use motion::{Motion, Speeds};
use system::System;
use tree::Tree;
use wrench::{Carried, Wrench};

pub(crate) use check::check;
pub(crate) use print::describe;

/// All that is known of the mechanics, made when it is asked for; the default for functions that ask for nothing of it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Forces<'m> {
    tree: Tree,
    geometry: Geometry<'m>,
    motion: Motion<'m>,
    /// Ways of bodies (which, and whether they slide) whose rates by the inputs are the same at all positions.
    steady: Vec<(usize, bool)>,
    /// Ways of pins, slides and cylinders in which nothing moves.
    still: Vec<(usize, bool)>,
    /// Bodies that turn with a vector whose length does not change.
    rigid_rods: Vec<usize>,
    closed: Closed<'m>,
    system: Option<Rc<System<'m>>>,
    /// By the speeds and accelerations that functions list.
    cases: Map<Speeds, Case<'m>>,
}

/// The forces at some speeds.
#[derive(Clone, Debug)]
struct Case<'m> {
    loads: Rc<Loads<'m>>,
    wrenches: Map<Carried, Wrench<'m>>,
    /// Unknowns of the system that are known already.
    solved: Map<usize, Ex<'m>>,
}

/// The mechanics of one mechanism together with its algebra, for the time of one question.
pub(crate) struct Mechanics<'a, 'm> {
    algebra: &'a mut Algebra<'m>,
    forces: &'a mut Forces<'m>,
    speeds: Speeds,
    /// Whether reactions are asked for.
    with_reactions: bool,
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
            closed: Closed::default(),
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

    /// For a function that lists these inputs and arguments: speeds that it does not list are zero. Drives are found from the joints if
    /// reactions are asked for, too.
    pub(crate) fn at<'a>(
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
    /// What is known at the speeds that are listed, the loads at least.
    fn case(&mut self) -> &mut Case<'m> {
        if !self.forces.cases.contains_key(&self.speeds) {
            let case = Case {
                loads: Rc::new(loads::all_loads(self)),
                wrenches: Map::new(),
                solved: Map::new(),
            };
            self.forces.cases.insert(self.speeds.clone(), case);
        }
        let case = self.forces.cases.get_mut(&self.speeds);
        case.expect("just made")
    }

    fn graph(&self) -> &'m Graph {
        self.algebra.graph
    }

    /// No force, no velocity.
    fn zero_vector(&self) -> Vn<'m> {
        self.graph().zeros(self.forces.geometry.dimensions)
    }

    /// No moment, no angular velocity.
    fn zero_turn(&self) -> Vn<'m> {
        self.graph().zeros(self.forces.geometry.turns())
    }

    /// The vector from a body's origin to a point.
    fn arm(&self, body: usize, point: Vn<'m>) -> Vn<'m> {
        let known = self.forces.closed.arm(body, point);
        known.unwrap_or_else(|| point - self.forces.geometry.origins[body])
    }
}
