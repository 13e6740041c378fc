//! What a body and all that hang on it carry together: a force, and a moment about the body's origin.
//!
//! The reactions of cut joints count if one of the two bodies hangs on that body and the other does not.

use std::ops::{Add, Neg};

use linkage_symbolic::{Ex, Vector, Vn};

use super::Mechanics;
use super::freedom::Way;
use super::geometry::{Turns, slides_along, turns_of};
use super::system::{Equation, System, Unknown};

/// A force and a moment about a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wrench<'m> {
    pub(super) force: Vn<'m>,
    pub(super) moment: Vn<'m>,
}

/// What a wrench was made of.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Carried {
    body: usize,
    /// Cut joints that cancel.
    inside: Vec<usize>,
    /// Unknowns that count as 0.
    open: Vec<usize>,
}

impl<'m> Wrench<'m> {
    /// About a point from which the force has an arm: `F`, `M + r x F`.
    pub(super) fn with_arm(self, arm: Vn<'m>) -> Self {
        Self {
            force: self.force,
            moment: self.moment + arm.moment_of(self.force),
        }
    }

    /// What does work in a motion.
    pub(super) fn along(self, way: &Way<'m>) -> Ex<'m> {
        way.direction.dot(match way.slides {
            true => self.force,
            false => self.moment,
        })
    }
}

impl Add for Wrench<'_> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            force: self.force + other.force,
            moment: self.moment + other.moment,
        }
    }
}

impl Neg for Wrench<'_> {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            force: -self.force,
            moment: -self.moment,
        }
    }
}

impl<'m> Mechanics<'_, 'm> {
    /// Neither force nor moment.
    pub(super) fn zero_wrench(&self) -> Wrench<'m> {
        Wrench {
            force: self.zero_vector(),
            moment: self.zero_turn(),
        }
    }

    /// Of a body and those that hang on it. Cut joints in `inside` join two of them and cancel; the unknowns in `open`
    /// count as 0.
    pub(super) fn wrench(&mut self, body: usize, inside: &[usize], open: &[usize]) -> Wrench<'m> {
        let closing = self.forces.tree.closing.iter().copied();
        let (inside, crossing): (Vec<usize>, Vec<usize>) = closing
            .filter(|&joint| self.is_inside(joint, body) || self.joins(joint, body) != 0)
            .partition(|&joint| self.is_inside(joint, body) || inside.contains(&joint));
        let system = self.system();
        let touches = |unknown: &&usize| match &system.unknowns[**unknown] {
            Unknown::Reaction(own) => crossing.contains(&own.joint),
            Unknown::Spin { .. } => false,
            Unknown::Tie(tie) => {
                let mut bodies = tie.couples.iter();
                bodies.any(|(own, _)| self.forces.tree.hangs_on(Some(*own), body))
            }
        };
        let open: Vec<usize> = open.iter().filter(touches).copied().collect();
        let carried = Carried { body, inside, open };
        if let Some(&known) = self.case().wrenches.get(&carried) {
            return known;
        }
        let Carried { inside, open, .. } = &carried;
        let mut sum = self.own_wrench(body);
        for joint in crossing {
            let sign = self.at_ends(joint, body);
            if sign == 0 {
                continue;
            }
            let reaction = self.closing_wrench(joint, open);
            let reaction = if sign < 0 { -reaction } else { reaction };
            let point = self.forces.geometry.points[joint];
            sum = sum + reaction.with_arm(self.arm(body, point));
        }
        for (index, unknown) in system.unknowns.iter().enumerate() {
            let Unknown::Tie(tie) = unknown else { continue };
            let own = tie.couples.iter().find(|(own, _)| *own == body);
            if let Some(&(_, share)) = own.filter(|_| !open.contains(&index)) {
                let couple = Vector([share * self.solved(index)]);
                sum.moment = sum.moment + couple.into();
            }
        }
        for child in self.forces.tree.children[body].clone() {
            let mut beyond = self.wrench(child, inside, open);
            if open.is_empty() && self.is_balanced(&system, child, inside) {
                beyond.moment = self.zero_turn();
            }
            let point = self.forces.geometry.origins[child];
            sum = sum + beyond.with_arm(self.arm(body, point));
        }
        self.case().wrenches.insert(carried, sum);
        sum
    }

    /// Whether equilibrium leaves no moment about a body's own pin in the plane: the reactions of all cut joints
    /// beyond it count, and were found by that.
    fn is_balanced(&self, system: &System<'m>, body: usize, inside: &[usize]) -> bool {
        let mut ways = system.equations.iter().filter_map(Equation::way);
        self.forces.geometry.is_plane()
            && ways.any(|way| way.body == body && !way.slides)
            && inside.iter().all(|&joint| self.joins(joint, body) == 0)
    }

    /// The loads on a body alone.
    fn own_wrench(&mut self, body: usize) -> Wrench<'m> {
        let loads = self.loads();
        let own = &loads.bodies[body];
        let mut sum = self.zero_wrench();
        for load in &own.forces {
            let arm = self.arm(body, load.point);
            let force = Wrench {
                force: load.force,
                ..self.zero_wrench()
            };
            sum = sum
                + match load
                    .mass
                    .and_then(|mass| self.moment_of_mass(body, mass, arm))
                {
                    Some(moment) => Wrench { moment, ..force },
                    None => force.with_arm(arm),
                };
        }
        for &couple in &own.couples {
            sum.moment = sum.moment + couple;
        }
        sum
    }

    /// The moment of a mass, its inertia and weight, about its body's own joint, if that is a pin of the plane on the
    /// frame: what turns evenly has no moment but that of its weight.
    fn moment_of_mass(&mut self, body: usize, mass: Ex<'m>, arm: Vn<'m>) -> Option<Vn<'m>> {
        let mechanism = self.algebra.mechanism;
        let joint = &mechanism.joints[mechanism.bodies[body].joint];
        let origin = self.forces.geometry.origins[body];
        let rests = joint.on.is_none() && origin.iter().all(|x| x.is_fixed());
        let is_pin = turns_of(joint.kind) == Turns::AboutAxis && !slides_along(joint.kind);
        if !self.forces.geometry.is_plane() || !is_pin || !rests {
            return None;
        }
        let gain = self.angular_acceleration(body);
        let square = arm.square();
        if !gain.is_zero() && !square.is_fixed() {
            return None;
        }
        let weight = self.gravity().map(|gravity| mass * gravity);
        let weighs = weight.map_or(self.zero_turn(), |weight| arm.moment_of(weight));
        Some(weighs - (mass * square) * gain)
    }

    /// 1 if the reaction of a cut joint acts on what hangs on a body, -1 if its opposite does, 0 if neither or both.
    pub(super) fn joins(&self, joint: usize, body: usize) -> i32 {
        let declared = &self.algebra.mechanism.joints[joint];
        let tree = &self.forces.tree;
        i32::from(tree.hangs_on(Some(declared.body), body))
            - i32::from(tree.hangs_on(declared.on, body))
    }

    /// The same for the body alone.
    fn at_ends(&self, joint: usize, body: usize) -> i32 {
        let declared = &self.algebra.mechanism.joints[joint];
        i32::from(declared.body == body) - i32::from(declared.on == Some(body))
    }

    /// True if both bodies of a cut joint hang on a body.
    fn is_inside(&self, joint: usize, body: usize) -> bool {
        let declared = &self.algebra.mechanism.joints[joint];
        let tree = &self.forces.tree;
        tree.hangs_on(Some(declared.body), body) && tree.hangs_on(declared.on, body)
    }
}
