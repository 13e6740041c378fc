//! The reactions of cut joints from the motions of the tree's joints: a linear system, in small groups.
//!
//! Each free motion gives an equation: the bodies beyond the joint carry no moment about its axis, no force along its guide. Which
//! equation finds which reaction is found by matching, as for the loops; what must be solved together is solved by cofactors, without
//! a choice of pivots. A link that only a cut joint holds at its other end leaves one number of that joint's reaction open, the force
//! along the link (`links`).

use std::rc::Rc;

use linkage_symbolic::NodeId;

use crate::model::JointKind;
use crate::structure::matching::{self, Matching};

use super::Mechanics;
use super::freedom::{Motions, Tie, Way};
use super::geometry::{slides_along, turns_about};
use super::links::Axial;

/// A number to be found.
#[derive(Clone, Debug)]
pub(super) enum Unknown {
    Reaction(Component),
    /// The couple of a tie.
    Tie(Tie),
    /// A couple along a rod between ball joints. It is zero, and makes one equation too many three for three.
    Spin {
        rod: usize,
        along: Vec<NodeId>,
    },
}

/// A component of a cut joint's reaction on the joint's body.
#[derive(Clone, Debug)]
pub(super) struct Component {
    pub(super) joint: usize,
    pub(super) is_moment: bool,
    pub(super) direction: Vec<NodeId>,
}

#[derive(Clone, Debug)]
pub(super) enum Equation {
    /// No work in a free motion.
    Motion(Way),
    /// What a cut joint does not transmit.
    Released(Component),
}

#[derive(Clone, Debug, Default)]
pub(super) struct System {
    pub(super) unknowns: Vec<Unknown>,
    pub(super) equations: Vec<Equation>,
    /// What drives move.
    pub(super) driven: Vec<Way>,
    pub(super) axial: Vec<Axial>,
    pub(super) matrix: Vec<Vec<NodeId>>,
    pub(super) matching: Matching,
    /// The unknowns that each equation contains.
    pub(super) incidence: Vec<Vec<usize>>,
    /// Equations that are solved together.
    pub(super) blocks: Vec<Vec<usize>>,
}

/// Up to this many equations are solved at once.
pub(super) const LARGEST_BLOCK: usize = 6;

/// From this size on links are taken out of a block.
const LARGE: usize = 3;

impl Mechanics<'_, '_> {
    pub(super) fn system(&mut self) -> Rc<System> {
        if let Some(known) = &self.forces.system {
            return known.clone();
        }
        let plain = self.assembled(Vec::new());
        let links = self.links(&plain);
        let system = match links.is_empty() {
            true => plain,
            false => self.assembled(links),
        };
        let system = Rc::new(system);
        self.forces.system = Some(system.clone());
        system
    }

    /// The system in which some links leave one number open.
    fn assembled(&mut self, axial: Vec<Axial>) -> System {
        let (components, released) = self.reactions(&axial);
        let held = components.len() - released.len() + axial.len();
        let Motions { free, driven, ties } = self.motions(held);
        let mut unknowns: Vec<Unknown> = components.into_iter().map(Unknown::Reaction).collect();
        unknowns.extend(ties.into_iter().map(Unknown::Tie));
        unknowns.extend(self.spins(&axial));
        let mut system = System {
            unknowns,
            driven,
            axial,
            ..System::default()
        };
        for component in released {
            self.add(&mut system, Equation::Released(component));
        }
        for way in free {
            if system.axial.iter().all(|own| own.link != way.body) {
                self.add(&mut system, Equation::Motion(way));
            }
        }
        system.order();
        self.drive_steady(&mut system);
        self.release_held(&mut system);
        system
    }

    /// Rods that may turn about themselves.
    fn spins(&mut self, axial: &[Axial]) -> Vec<Unknown> {
        let mechanism = self.algebra.mechanism;
        let rods = (0..mechanism.bodies.len()).filter(|&body| {
            let kind = mechanism.joints[mechanism.bodies[body].joint].kind;
            kind == JointKind::Ball && axial.iter().all(|own| own.link != body)
        });
        let rods = rods.filter_map(|rod| {
            let along = self.forces.geometry.rod(rod)?;
            Some(Unknown::Spin { rod, along })
        });
        rods.collect()
    }

    pub(super) fn add(&mut self, system: &mut System, equation: Equation) {
        let unknowns = system.unknowns.iter();
        let row: Vec<NodeId> = unknowns
            .map(|unknown| self.coefficient(&equation, unknown))
            .collect();
        let entries = (0..row.len()).filter(|&k| !self.algebra.graph.is_zero(row[k]));
        system.incidence.push(entries.collect());
        system.equations.push(equation);
        system.matrix.push(row);
    }

    /// The components of the cut joints' reactions, and equations for those that are none.
    fn reactions(&mut self, axial: &[Axial]) -> (Vec<Component>, Vec<Component>) {
        let (mut unknowns, mut equations) = (Vec::new(), Vec::new());
        for joint in self.forces.tree.closing.clone() {
            let kind = self.algebra.mechanism.joints[joint].kind;
            let direction = self.forces.geometry.directions[joint].clone();
            let unknown = |is_moment, direction| Component {
                joint,
                is_moment,
                direction,
            };
            if let Some(own) = axial.iter().find(|own| own.joint == joint) {
                let along = self.link_vector(own);
                unknowns.push(unknown(false, along));
                continue;
            }
            let plane = self.forces.geometry.dimensions == 2;
            match direction.clone() {
                Some(guide) if plane => {
                    let normal = vec![self.algebra.graph.neg(guide[1]), guide[0]];
                    unknowns.push(unknown(false, normal));
                }
                _ => unknowns.extend(self.units().into_iter().map(|unit| unknown(false, unit))),
            }
            let one = self.algebra.graph.one();
            match kind {
                JointKind::Pin if plane => {}
                JointKind::Ball => {}
                _ if plane => unknowns.push(unknown(true, vec![one])),
                _ => unknowns.extend(self.units().into_iter().map(|unit| unknown(true, unit))),
            }
            let Some(direction) = direction.filter(|_| !plane) else {
                continue;
            };
            if slides_along(kind) {
                equations.push(unknown(false, direction.clone()));
            }
            if turns_about(kind) {
                equations.push(unknown(true, direction));
            }
        }
        (unknowns, equations)
    }

    fn units(&mut self) -> Vec<Vec<NodeId>> {
        let count = self.forces.geometry.dimensions;
        let (one, zero) = (self.algebra.graph.one(), self.algebra.graph.zero());
        let unit = |axis| {
            (0..count)
                .map(|k| if k == axis { one } else { zero })
                .collect()
        };
        (0..count).map(unit).collect()
    }

    fn coefficient(&mut self, equation: &Equation, unknown: &Unknown) -> NodeId {
        match (equation, unknown) {
            (Equation::Released(released), Unknown::Reaction(own))
                if (released.joint, released.is_moment) == (own.joint, own.is_moment) =>
            {
                self.algebra.dot(&released.direction, &own.direction)
            }
            (Equation::Released(_), _) => self.algebra.graph.zero(),
            (Equation::Motion(way), Unknown::Reaction(own)) => {
                let work = self.work(way, own);
                match self.joins(own.joint, way.body) {
                    1 => work,
                    -1 => self.algebra.graph.neg(work),
                    _ => self.algebra.graph.zero(),
                }
            }
            (Equation::Motion(way), Unknown::Spin { rod, along }) if way.body == *rod => {
                self.algebra.dot(&way.direction, along)
            }
            (Equation::Motion(_), Unknown::Spin { .. }) => self.algebra.graph.zero(),
            (Equation::Motion(way), Unknown::Tie(_)) if way.slides => self.algebra.graph.zero(),
            (Equation::Motion(way), Unknown::Tie(tie)) => {
                let tree = &self.forces.tree;
                let beyond = tie.couples.iter();
                let beyond = beyond.filter(|(body, _)| tree.hangs_on(Some(*body), way.body));
                let share = beyond.map(|(_, share)| share).sum();
                self.algebra.graph.constant(share)
            }
        }
    }

    /// The work of a reaction's component in a motion.
    fn work(&mut self, way: &Way, unknown: &Component) -> NodeId {
        match (way.slides, unknown.is_moment) {
            (true, true) => self.algebra.graph.zero(),
            (true, false) | (false, true) => self.algebra.dot(&way.direction, &unknown.direction),
            (false, false) => {
                let point = self.forces.geometry.points[unknown.joint].clone();
                let arm = self.arm(way.body, &point);
                let moment = self.algebra.moment_of(&arm, &unknown.direction);
                self.algebra.dot(&way.direction, &moment)
            }
        }
    }
}

impl Equation {
    pub(super) fn way(&self) -> Option<&Way> {
        match self {
            Equation::Motion(way) => Some(way),
            Equation::Released(_) => None,
        }
    }
}

impl Unknown {
    pub(super) fn joint(&self) -> Option<usize> {
        match self {
            Unknown::Reaction(own) => Some(own.joint),
            Unknown::Tie(_) | Unknown::Spin { .. } => None,
        }
    }
}

impl System {
    /// Which equation finds which unknown, and in which order.
    pub(super) fn order(&mut self) {
        let rows = vec![1; self.equations.len()];
        self.matching = matching::maximum(&rows, &self.incidence, self.unknowns.len());
        self.blocks = matching::components(&self.incidence, &self.matching);
    }

    /// How many unknowns have an equation.
    pub(super) fn found(&self) -> usize {
        self.matching.equation_of.iter().flatten().count()
    }

    pub(super) fn lacks_equations(&self) -> bool {
        self.found() < self.unknowns.len()
    }

    /// True if gears act on a body.
    pub(super) fn ties(&self, body: usize) -> bool {
        self.unknowns.iter().any(|unknown| match unknown {
            Unknown::Tie(tie) => tie.couples.iter().any(|(own, _)| *own == body),
            Unknown::Reaction(_) | Unknown::Spin { .. } => false,
        })
    }

    /// True if a reaction is found together with many others, by an equation of the body's own motion.
    pub(super) fn in_large_block(&self, joint: usize, body: usize) -> bool {
        let large = self.blocks.iter().filter(|block| block.len() >= LARGE);
        let mut equations = large.flatten().map(|&equation| &self.equations[equation]);
        let unknown =
            |equation: &Equation| matches!(equation, Equation::Motion(way) if way.body == body);
        equations.any(unknown) && self.unknowns.iter().any(|own| own.joint() == Some(joint))
    }
}
