//! The reactions of cut joints from the motions of the tree's joints: a linear system, in small groups.
//!
//! Each free motion gives an equation: the bodies beyond the joint carry no moment about its axis, no force along its guide. Which
//! equation finds which reaction is found by matching, as for the loops; what must be solved together is solved by cofactors, without
//! a choice of pivots. A link that only a cut joint holds at its other end leaves one number of that joint's reaction open, the force
//! along the link: its own moment gives the part across (`Axial`).

use std::rc::Rc;

use linkage_symbolic::NodeId;

use crate::model::JointKind;
use crate::structure::matching::{self, Matching};

use super::Mechanics;
use super::freedom::{FreeMotion, Way};
use super::geometry::{slides_along, turns_about};
use super::wrench::Wrench;

/// A component of a cut joint's reaction on the joint's body.
#[derive(Clone, Debug)]
pub(super) struct Unknown {
    pub(super) joint: usize,
    is_moment: bool,
    direction: Vec<NodeId>,
}

#[derive(Clone, Debug)]
pub(super) enum Equation {
    /// No work in a free motion.
    Motion(FreeMotion),
    /// What a cut joint does not transmit.
    Released(Unknown),
}

/// The part of a reaction that holds a link against turning.
#[derive(Clone, Debug)]
struct Axial {
    joint: usize,
    link: usize,
}

#[derive(Clone, Debug)]
pub(super) struct System {
    pub(super) unknowns: Vec<Unknown>,
    pub(super) equations: Vec<Equation>,
    axial: Vec<Axial>,
    matrix: Vec<Vec<NodeId>>,
    pub(super) matching: Matching,
    /// The unknowns that each equation contains.
    incidence: Vec<Vec<usize>>,
    /// Equations that are solved together.
    blocks: Vec<Vec<usize>>,
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
        let (unknowns, mut equations) = self.reactions(&axial);
        let released = equations.len();
        let motions = self.free_motions(unknowns.len() - released + axial.len());
        let taken = |motion: &FreeMotion| {
            let mut bodies = motion.iter().map(|(_, way)| way.body);
            bodies.all(|body| axial.iter().any(|own| own.link == body))
        };
        let motions = motions.into_iter().filter(|motion| !taken(motion));
        equations.extend(motions.map(Equation::Motion));
        let matrix: Vec<Vec<NodeId>> = equations
            .iter()
            .map(|equation| {
                let row = unknowns.iter();
                row.map(|unknown| self.coefficient(equation, unknown))
                    .collect()
            })
            .collect();
        let incidence: Vec<Vec<usize>> = matrix
            .iter()
            .map(|row| {
                let entries = (0..row.len()).filter(|&k| !self.algebra.graph.is_zero(row[k]));
                entries.collect()
            })
            .collect();
        let matching = matching::maximum(&vec![1; equations.len()], &incidence, unknowns.len());
        let blocks = matching::components(&incidence, &matching);
        System {
            unknowns,
            equations,
            axial,
            matrix,
            matching,
            incidence,
            blocks,
        }
    }

    /// The components of the cut joints' reactions, and equations for those that are none.
    fn reactions(&mut self, axial: &[Axial]) -> (Vec<Unknown>, Vec<Equation>) {
        let (mut unknowns, mut equations) = (Vec::new(), Vec::new());
        for joint in self.forces.tree.closing.clone() {
            let kind = self.algebra.mechanism.joints[joint].kind;
            let direction = self.forces.geometry.directions[joint].clone();
            let unknown = |is_moment, direction| Unknown {
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
                equations.push(Equation::Released(unknown(false, direction.clone())));
            }
            if turns_about(kind) {
                equations.push(Equation::Released(unknown(true, direction)));
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
        match equation {
            Equation::Released(component) => {
                match component.joint == unknown.joint && component.is_moment == unknown.is_moment {
                    true => self.algebra.dot(&component.direction, &unknown.direction),
                    false => self.algebra.graph.zero(),
                }
            }
            Equation::Motion(motion) => {
                let zero = self.algebra.graph.zero();
                motion.iter().fold(zero, |sum, (factor, way)| {
                    let sign = f64::from(self.joins(unknown.joint, way.body));
                    if sign == 0.0 {
                        return sum;
                    }
                    let work = self.work(way, unknown);
                    let factor = self.algebra.graph.constant(sign * factor);
                    let work = self.algebra.graph.mul(factor, work);
                    self.algebra.graph.add(sum, work)
                })
            }
        }
    }

    /// The work of a reaction's component in a motion.
    fn work(&mut self, way: &Way, unknown: &Unknown) -> NodeId {
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

    /// Links of large blocks that one cut joint holds, and all rods.
    fn links(&self, system: &System) -> Vec<Axial> {
        let mut links: Vec<Axial> = Vec::new();
        for &joint in &self.forces.tree.closing {
            let declared = &self.algebra.mechanism.joints[joint];
            let plane = self.forces.geometry.dimensions == 2;
            let kind = if plane {
                JointKind::Pin
            } else {
                JointKind::Ball
            };
            if declared.kind != kind {
                continue;
            }
            let ends = [Some(declared.body), declared.on].into_iter().flatten();
            let mut links_here = ends.filter(|&body| self.is_link(body, joint, kind));
            let wanted = match plane {
                true => links_here.find(|&body| system.in_large_block(joint, body)),
                false => links_here.find(|&body| self.is_rod(body)),
            };
            links.extend(wanted.map(|link| Axial { joint, link }));
        }
        links
    }

    /// True if a body hangs by a pin (in space a ball joint), nothing hangs on it, and one cut joint holds it.
    fn is_link(&self, body: usize, joint: usize, kind: JointKind) -> bool {
        let mechanism = self.algebra.mechanism;
        let own = &mechanism.joints[mechanism.bodies[body].joint];
        let mut closing = self.forces.tree.closing.iter();
        own.kind == kind
            && self.forces.tree.children[body].is_empty()
            && closing.all(|&other| other == joint || self.joins(other, body) == 0)
    }

    /// From a link's origin to the cut joint at its other end.
    fn link_vector(&mut self, axial: &Axial) -> Vec<NodeId> {
        let point = self.forces.geometry.points[axial.joint].clone();
        self.arm(axial.link, &point)
    }

    /// The reaction of a cut joint on its body; unknowns in `open` count as 0.
    pub(super) fn closing_wrench(&mut self, joint: usize, open: &[usize]) -> Wrench {
        let system = self.system();
        let mut sum = match system.axial.iter().find(|own| own.joint == joint) {
            Some(axial) => self.across_link(axial),
            None => {
                let geometry = &self.forces.geometry;
                let (dimensions, turns) = (geometry.dimensions, geometry.turns());
                Wrench {
                    force: self.algebra.zeros(dimensions),
                    moment: self.algebra.zeros(turns),
                }
            }
        };
        for (index, unknown) in system.unknowns.iter().enumerate() {
            if unknown.joint != joint || open.contains(&index) {
                continue;
            }
            let size = self.solved(index);
            let part = self.algebra.times(size, &unknown.direction);
            match unknown.is_moment {
                true => sum.moment = self.algebra.plus(&sum.moment, &part),
                false => sum.force = self.algebra.plus(&sum.force, &part),
            }
        }
        sum
    }

    /// The part of a reaction that holds a link against its own loads: `-M perp(V) / V^2`, in space `(V x M) / V^2`.
    fn across_link(&mut self, axial: &Axial) -> Wrench {
        let loads = self.own_wrench(axial.link);
        let along = self.link_vector(axial);
        let square = self.algebra.sum_of_squares(&along);
        let across = match loads.moment[..] {
            [moment] => {
                let across = [along[1], self.algebra.graph.neg(along[0])];
                self.algebra.times(moment, &across)
            }
            _ => self.algebra.moment_of(&along, &loads.moment),
        };
        let graph = &mut self.algebra.graph;
        let mut force: Vec<NodeId> = across.into_iter().map(|x| graph.div(x, square)).collect();
        if self.algebra.mechanism.joints[axial.joint].body != axial.link {
            force = self.algebra.opposite(&force);
        }
        let turns = self.forces.geometry.turns();
        Wrench {
            force,
            moment: self.algebra.zeros(turns),
        }
    }

    /// The value of an unknown.
    fn solved(&mut self, unknown: usize) -> NodeId {
        self.loads();
        if let Some(&known) = self.case().solved.get(&unknown) {
            return known;
        }
        let system = self.system();
        let equation = system.matching.equation_of[unknown];
        let block = system
            .blocks
            .iter()
            .find(|block| equation.is_some_and(|e| block.contains(&e)));
        let Some(block) = block.filter(|block| block.len() <= LARGEST_BLOCK) else {
            // Reported by the check of bodies and joints.
            return self.algebra.graph.constant(f64::NAN);
        };
        let own: Vec<usize> = block
            .iter()
            .flat_map(|&equation| system.matching.coordinates_of[equation].clone())
            .collect();
        let right: Vec<NodeId> = block
            .iter()
            .map(|&equation| self.right_hand_side(&system, equation, &own))
            .collect();
        let matrix: Vec<Vec<NodeId>> = block
            .iter()
            .map(|&equation| own.iter().map(|&k| system.matrix[equation][k]).collect())
            .collect();
        let determinant = self.algebra.determinant(&matrix);
        let numerators = self.algebra.cofactor_products(&matrix, &right);
        for (&unknown, numerator) in own.iter().zip(numerators) {
            let value = self.algebra.graph.div(numerator, determinant);
            self.case().solved.insert(unknown, value);
        }
        self.case().solved[&unknown]
    }

    /// Minus what an equation says of all that is known before its block is solved.
    fn right_hand_side(&mut self, system: &System, equation: usize, block: &[usize]) -> NodeId {
        let contained = &system.incidence[equation];
        let is_open = |unknown: &usize| !contained.contains(unknown) || block.contains(unknown);
        let open: Vec<usize> = (0..system.unknowns.len()).filter(is_open).collect();
        let known = match &system.equations[equation] {
            Equation::Released(component) => {
                let wrench = self.closing_wrench(component.joint, &open);
                let own = if component.is_moment {
                    wrench.moment
                } else {
                    wrench.force
                };
                self.algebra.dot(&component.direction, &own)
            }
            Equation::Motion(motion) => {
                let zero = self.algebra.graph.zero();
                motion.iter().fold(zero, |sum, (factor, way)| {
                    let wrench = self.wrench(way.body, &[], &open);
                    let own = if way.slides {
                        wrench.force
                    } else {
                        wrench.moment
                    };
                    let work = self.algebra.dot(&way.direction, &own);
                    let factor = self.algebra.graph.constant(*factor);
                    let work = self.algebra.graph.mul(factor, work);
                    self.algebra.graph.add(sum, work)
                })
            }
        };
        self.algebra.graph.neg(known)
    }
}

impl System {
    /// True if a reaction is found together with many others, by an equation of the body's own motion.
    fn in_large_block(&self, joint: usize, body: usize) -> bool {
        let large = self.blocks.iter().filter(|block| block.len() >= LARGE);
        let mut equations = large.flatten().map(|&equation| &self.equations[equation]);
        let unknown = |equation: &Equation| match equation {
            Equation::Motion(motion) => matches!(&motion[..], [(_, way)] if way.body == body),
            Equation::Released(_) => false,
        };
        equations.any(unknown) && self.unknowns.iter().any(|own| own.joint == joint)
    }

    /// True if one of the free motions contains such a way.
    pub(super) fn has_motion(&self, is_way: impl Fn(&Way) -> bool) -> bool {
        self.equations.iter().any(|equation| match equation {
            Equation::Motion(motion) => motion.iter().any(|(_, way)| is_way(way)),
            Equation::Released(_) => false,
        })
    }

    /// Blocks that are too large to solve.
    pub(super) fn too_large(&self) -> impl Iterator<Item = &Vec<usize>> {
        self.blocks
            .iter()
            .filter(|block| block.len() > LARGEST_BLOCK)
    }
}
