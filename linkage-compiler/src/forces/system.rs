//! The reactions of cut joints from the motions of the tree's joints: a linear system, in small
//! groups.
//!
//! Each free motion gives an equation: the bodies beyond the joint carry no moment about its axis,
//! no force along its guide. Which equation finds which reaction is found by matching, as for the
//! loops. Equations of one block are solved by cofactors, without a choice of pivots.

use linkage_symbolic::{Ex, Vn};

use crate::forces::joint_motion::{JointMotion, Tie};
use crate::structure::matching::{self, Matching};

/// A cut joint whose reaction is open only along a link.
#[derive(Clone, Debug)]
pub(super) struct Axial {
    pub(super) joint: usize,
    pub(super) link: usize,
}

/// A number to be found.
#[derive(Clone, Debug)]
pub(super) enum Unknown<'m> {
    Reaction(Component<'m>),
    /// The couple of a tie.
    Tie(Tie),
    /// A couple along a rod between ball joints. It is zero, and makes one equation too many three
    /// for three.
    Spin {
        rod: usize,
        along: Vn<'m>,
    },
}

/// A component of a cut joint's reaction on the joint's body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Component<'m> {
    pub(super) joint: usize,
    pub(super) is_moment: bool,
    pub(super) direction: Vn<'m>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Equation<'m> {
    /// No work in a free motion.
    Motion(JointMotion<'m>),
    /// A component that a cut joint does not transmit.
    Released(Component<'m>),
}

#[derive(Clone, Debug, Default)]
pub(super) struct System<'m> {
    pub(super) unknowns: Vec<Unknown<'m>>,
    pub(super) equations: Vec<Equation<'m>>,
    /// The motions of drives.
    pub(super) driven: Vec<JointMotion<'m>>,
    pub(super) axial: Vec<Axial>,
    pub(super) matrix: Vec<Vec<Ex<'m>>>,
    pub(super) matching: Matching,
    /// The unknowns that each equation contains.
    pub(super) incidence: Vec<Vec<usize>>,
    /// Equations that are solved together.
    pub(super) blocks: Vec<Vec<usize>>,
}

/// Up to this many equations are solved at once: cofactors double with each one more.
pub(super) const LARGEST_BLOCK: usize = 6;

/// The least size of a block from which links are taken out. A dyad, which no link makes smaller,
/// has two equations.
const LARGE: usize = 3;

impl<'m> Equation<'m> {
    /// The motion, if it is about one.
    pub(super) fn motion(&self) -> Option<&JointMotion<'m>> {
        match self {
            Equation::Motion(way) => Some(way),
            Equation::Released(_) => None,
        }
    }
}

impl Unknown<'_> {
    /// The joint whose reaction it belongs to, if it does.
    pub(super) fn joint(&self) -> Option<usize> {
        match self {
            Unknown::Reaction(component) => Some(component.joint),
            Unknown::Tie(_) | Unknown::Spin { .. } => None,
        }
    }
}

impl<'m> System<'m> {
    /// The rows of equations that are solved together, by the unknowns that they find.
    pub(super) fn matrix_of(&self, block: &[usize]) -> Vec<Vec<Ex<'m>>> {
        let unknowns = self.unknowns_of(block);
        let rows = block.iter();
        rows.map(|&equation| unknowns.iter().map(|&k| self.matrix[equation][k]).collect())
            .collect()
    }

    /// Finds the unknown of each equation, and the order of solution.
    pub(super) fn order(&mut self) {
        let rows = vec![1; self.equations.len()];
        self.matching = matching::maximum(&rows, &self.incidence, self.unknowns.len());
        self.blocks = matching::components(&self.incidence, &self.matching);
    }

    /// The number of unknowns that have an equation.
    pub(super) fn found(&self) -> usize {
        self.matching.equation_of.iter().flatten().count()
    }

    /// The unknowns that a block finds.
    pub(super) fn unknowns_of(&self, block: &[usize]) -> Vec<usize> {
        let found = block.iter().map(|&e| &self.matching.coordinates_of[e]);
        found.flatten().copied().collect()
    }

    /// True if some have none.
    pub(super) fn lacks_equations(&self) -> bool {
        self.found() < self.unknowns.len()
    }

    /// True if some equations find no unknown.
    pub(super) fn lacks_unknowns(&self) -> bool {
        self.found() < self.equations.len()
    }

    /// True if gears act on a body.
    pub(super) fn ties(&self, body: usize) -> bool {
        self.unknowns.iter().any(|unknown| match unknown {
            Unknown::Tie(tie) => tie.couples.iter().any(|(tied, _)| *tied == body),
            Unknown::Reaction(_) | Unknown::Spin { .. } => false,
        })
    }

    /// True if a reaction is found together with many others, by an equation of the body's own
    /// motion.
    pub(super) fn in_large_block(&self, joint: usize, body: usize) -> bool {
        let large = self.blocks.iter().filter(|block| block.len() >= LARGE);
        let mut equations = large.flatten().map(|&equation| &self.equations[equation]);
        let unknown =
            |equation: &Equation| matches!(equation, Equation::Motion(way) if way.body == body);
        equations.any(unknown)
            && self
                .unknowns
                .iter()
                .any(|unknown_of_joint| unknown_of_joint.joint() == Some(joint))
    }
}
