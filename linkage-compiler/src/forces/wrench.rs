//! What a body and all that hang on it carry together: a force, and a moment about the body's origin.
//!
//! The reactions of cut joints count if one of the two bodies hangs on that body and the other does not.

use crate::forces::loads;
use crate::forces::motion;
use crate::forces::reactions;
use crate::forces::system;
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

/// Neither force nor moment.
pub(super) fn zero_wrench<'m>(mechanics: &Mechanics<'_, 'm>) -> Wrench<'m> {
    Wrench {
        force: mechanics.zero_vector(),
        moment: mechanics.zero_turn(),
    }
}

/// Of a body and those that hang on it. Cut joints in `inside` join two of them and cancel; the unknowns in `open`
/// count as 0.
pub(super) fn wrench<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    body: usize,
    inside: &[usize],
    open: &[usize],
) -> Wrench<'m> {
    let closing = mechanics.forces.tree.closing.iter().copied();
    let (inside, crossing): (Vec<usize>, Vec<usize>) = closing
        .filter(|&joint| is_inside(mechanics, joint, body) || joins(mechanics, joint, body) != 0)
        .partition(|&joint| is_inside(mechanics, joint, body) || inside.contains(&joint));
    let system = system::system(mechanics);
    let touches = |unknown: &&usize| match &system.unknowns[**unknown] {
        Unknown::Reaction(own) => crossing.contains(&own.joint),
        Unknown::Spin { .. } => false,
        Unknown::Tie(tie) => {
            let mut bodies = tie.couples.iter();
            bodies.any(|(own, _)| mechanics.forces.tree.hangs_on(Some(*own), body))
        }
    };
    let open: Vec<usize> = open.iter().filter(touches).copied().collect();
    let carried = Carried { body, inside, open };
    if let Some(&known) = mechanics.case().wrenches.get(&carried) {
        return known;
    }
    let Carried { inside, open, .. } = &carried;
    let mut sum = own_wrench(mechanics, body);
    for joint in crossing {
        let sign = at_ends(mechanics, joint, body);
        if sign == 0 {
            continue;
        }
        let reaction = reactions::closing_wrench(mechanics, joint, open);
        let reaction = if sign < 0 { -reaction } else { reaction };
        let point = mechanics.forces.geometry.points[joint];
        sum = sum + reaction.with_arm(mechanics.arm(body, point));
    }
    for (index, unknown) in system.unknowns.iter().enumerate() {
        let Unknown::Tie(tie) = unknown else { continue };
        let own = tie.couples.iter().find(|(own, _)| *own == body);
        if let Some(&(_, share)) = own.filter(|_| !open.contains(&index)) {
            let couple = Vector([share * reactions::solved(mechanics, index)]);
            sum.moment = sum.moment + couple.into();
        }
    }
    for child in mechanics.forces.tree.children[body].clone() {
        let mut beyond = wrench(mechanics, child, inside, open);
        if open.is_empty() && is_balanced(mechanics, &system, child, inside) {
            beyond.moment = mechanics.zero_turn();
        }
        let point = mechanics.forces.geometry.origins[child];
        sum = sum + beyond.with_arm(mechanics.arm(body, point));
    }
    mechanics.case().wrenches.insert(carried, sum);
    sum
}

/// Whether equilibrium leaves no moment about a body's own pin in the plane: the reactions of all cut joints
/// beyond it count, and were found by that.
fn is_balanced<'m>(
    mechanics: &Mechanics<'_, 'm>,
    system: &System<'m>,
    body: usize,
    inside: &[usize],
) -> bool {
    let mut ways = system.equations.iter().filter_map(Equation::way);
    mechanics.forces.geometry.is_plane()
        && ways.any(|way| way.body == body && !way.slides)
        && inside
            .iter()
            .all(|&joint| joins(mechanics, joint, body) == 0)
}

/// The loads on a body alone.
fn own_wrench<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> Wrench<'m> {
    let loads = loads::loads(mechanics);
    let own = &loads.bodies[body];
    let mut sum = zero_wrench(mechanics);
    for load in &own.forces {
        let arm = mechanics.arm(body, load.point);
        let force = Wrench {
            force: load.force,
            ..zero_wrench(mechanics)
        };
        sum = sum
            + match load
                .mass
                .and_then(|mass| moment_of_mass(mechanics, body, mass, arm))
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
fn moment_of_mass<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    body: usize,
    mass: Ex<'m>,
    arm: Vn<'m>,
) -> Option<Vn<'m>> {
    let mechanism = mechanics.algebra.mechanism;
    let joint = &mechanism.joints[mechanism.bodies[body].joint];
    let origin = mechanics.forces.geometry.origins[body];
    let rests = joint.on.is_none() && origin.iter().all(|x| x.is_fixed());
    let is_pin = turns_of(joint.kind) == Turns::AboutAxis && !slides_along(joint.kind);
    if !mechanics.forces.geometry.is_plane() || !is_pin || !rests {
        return None;
    }
    let gain = motion::angular_acceleration(mechanics, body);
    let square = arm.square();
    if !gain.is_zero() && !square.is_fixed() {
        return None;
    }
    let weight = loads::gravity(mechanics).map(|gravity| mass * gravity);
    let weighs = weight.map_or(mechanics.zero_turn(), |weight| arm.moment_of(weight));
    Some(weighs - (mass * square) * gain)
}

/// 1 if the reaction of a cut joint acts on what hangs on a body, -1 if its opposite does, 0 if neither or both.
pub(super) fn joins(mechanics: &Mechanics<'_, '_>, joint: usize, body: usize) -> i32 {
    let declared = &mechanics.algebra.mechanism.joints[joint];
    let tree = &mechanics.forces.tree;
    i32::from(tree.hangs_on(Some(declared.body), body))
        - i32::from(tree.hangs_on(declared.on, body))
}

/// The same for the body alone.
fn at_ends(mechanics: &Mechanics<'_, '_>, joint: usize, body: usize) -> i32 {
    let declared = &mechanics.algebra.mechanism.joints[joint];
    i32::from(declared.body == body) - i32::from(declared.on == Some(body))
}

/// True if both bodies of a cut joint hang on a body.
fn is_inside(mechanics: &Mechanics<'_, '_>, joint: usize, body: usize) -> bool {
    let declared = &mechanics.algebra.mechanism.joints[joint];
    let tree = &mechanics.forces.tree;
    tree.hangs_on(Some(declared.body), body) && tree.hangs_on(declared.on, body)
}
