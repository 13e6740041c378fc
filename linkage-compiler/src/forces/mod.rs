//! Forces: reactions of joints, driving torques, energies, as nodes of the same graph as the motion.
//!
//! By virtual work, on the bodies and joints that the user declares and not on the loops, which may be written in any way. Every body
//! hangs on another by its own joint: that is a tree, and what all bodies beyond a joint carry is what the joint carries. Joints
//! that close loops are cut; their reactions are found from the motions of the tree's joints, in which no work may be done
//! (see `system`). These are as many equations, in small groups, as an adjoint of the loops has, and the other reactions are sums.
//!
//! | file | what |
//! |---|---|
//! | `tree` | who hangs on whom |
//! | `geometry` | origins, angles, axes, centres of mass as nodes |
//! | `motion` | velocities and accelerations of points and bodies |
//! | `inertia` | moments of inertia and what they do when a body turns |
//! | `loads` | what acts on each body: inertia, weight, loads, springs, dampers |
//! | `freedom` | motions of the tree's joints that nothing drives |
//! | `drives` | what is driven where the unknowns do not tell |
//! | `system` | equations for the reactions of the cut joints |
//! | `rank` | do equations that are solved together tell their unknowns? |
//! | `links` | links that leave one number of a reaction open |
//! | `reactions` | the equations solved, group by group |
//! | `wrench` | what bodies beyond a joint carry together |
//! | `quantities` | what functions ask for |
//! | `check` | can forces be found with what is declared? |
//! | `fit` | do bodies and joints fit the motion? |
//! | `ends` | do springs and dampers have a direction? |
//! | `steady` | what only numbers tell of the motion |
//! | `print` | how reactions are found, for golden files |

mod check;
mod drives;
mod ends;
mod fit;
mod freedom;
mod geometry;
mod inertia;
mod links;
mod loads;
mod motion;
mod print;
mod quantities;
mod rank;
mod reactions;
mod steady;
mod system;
mod tree;
mod vector;
mod wrench;

use std::collections::HashMap;
use std::rc::Rc;

use linkage_symbolic::NodeId;

use crate::algebra::Algebra;

use geometry::Geometry;
use loads::Loads;
use motion::{Motion, Speeds};
use system::System;
use tree::Tree;
use wrench::Wrench;

pub(crate) use check::check;
pub(crate) use print::describe;

/// All that is known of the mechanics, made when it is asked for.
#[derive(Debug)]
pub(crate) struct Forces {
    tree: Tree,
    geometry: Geometry,
    motion: Motion,
    /// Ways of bodies (which, and whether they slide) whose rates by the inputs are the same at all positions.
    steady: Vec<(usize, bool)>,
    /// Ways of pins, slides and cylinders in which nothing moves.
    still: Vec<(usize, bool)>,
    /// Bodies that turn with a vector whose length does not change.
    rigid_rods: Vec<usize>,
    system: Option<Rc<System>>,
    /// By the speeds and accelerations that functions list.
    cases: HashMap<Speeds, Case>,
}

/// The forces at some speeds.
#[derive(Clone, Debug, Default)]
struct Case {
    loads: Loads,
    wrenches: HashMap<(usize, Vec<usize>, Vec<usize>), Wrench>,
    /// Unknowns of the system that are known already.
    solved: HashMap<usize, NodeId>,
}

/// The mechanics of one mechanism together with its algebra, for the time of one question.
pub(crate) struct Mechanics<'a, 'm> {
    algebra: &'a mut Algebra<'m>,
    forces: &'a mut Forces,
    speeds: Speeds,
    /// Whether reactions are asked for.
    with_reactions: bool,
}

impl Forces {
    /// Nothing is computed yet but the geometry.
    pub(crate) fn new(algebra: &mut Algebra) -> Self {
        let tree = Tree::new(algebra.mechanism);
        let geometry = Geometry::new(algebra, &tree);
        Self {
            tree,
            geometry,
            motion: Motion::default(),
            steady: Vec::new(),
            still: Vec::new(),
            rigid_rods: Vec::new(),
            system: None,
            cases: HashMap::new(),
        }
    }

    /// For a function that lists these inputs and arguments: speeds that it does not list are zero. Drives are found from the joints if
    /// reactions are asked for, too.
    pub(crate) fn at<'a, 'm>(
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

impl Mechanics<'_, '_> {
    fn case(&mut self) -> &mut Case {
        let case = self.forces.cases.get_mut(&self.speeds);
        case.expect("made with the first load")
    }

    /// The vector from a body's origin to a point.
    fn arm(&mut self, body: usize, point: &[NodeId]) -> Vec<NodeId> {
        let origin = self.forces.geometry.origins[body].clone();
        self.algebra.difference(point, &origin)
    }
}
