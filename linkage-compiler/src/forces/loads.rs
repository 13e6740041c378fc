//! The loads on each body: inertia forces and weight, applied loads, springs, dampers and friction.

use std::rc::Rc;

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::{Algebra, Translate};
use crate::forces::body_loads::{BodyLoads, Loads, PointForce};
use crate::forces::context::{Case, Memo};
use crate::forces::geometry::Geometry;
use crate::forces::loading::{LoadSet, Loading};
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, Speeds};
use crate::forces::{contacts, geometry, inertia, masses, motion, springs};
use crate::model::Expr;

/// The forces of a loading, the loads at least.
pub(super) fn case<'c, 'm>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &'c mut Memo<'m>,
    loading: &Loading,
) -> &'c mut Case<'m> {
    if !memo.cases.contains_key(loading) {
        let case = Case {
            loads: Rc::new(loads_of_set(algebra, bodies, memo, loading)),
            wrenches: Map::new(),
            solved: Map::new(),
        };
        memo.cases.insert(loading.clone(), case);
    }
    let case = memo.cases.get_mut(loading);
    case.expect("just made")
}

/// The loads of a loading.
pub(super) fn loads<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
) -> Rc<Loads<'m>> {
    case(algebra, bodies, memo, loading).loads.clone()
}

/// Computes the loads of a set.
fn loads_of_set<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
) -> Loads<'m> {
    let speeds = &loading.speeds;
    match loading.loads {
        LoadSet::Frictionless => frictionless(algebra, bodies, &mut memo.turns, speeds),
        LoadSet::WithFriction => {
            let contact_forces = memo.contact_forces.get(speeds).cloned();
            let contact_forces = contact_forces.expect("contact forces are found before");
            let turns = &mut memo.turns;
            let mut loads = frictionless(algebra, bodies, turns, speeds);
            add_friction(algebra, bodies, turns, speeds, &contact_forces, &mut loads);
            loads
        }
        LoadSet::Inertia => inertia_alone(algebra, bodies, &mut memo.turns, speeds),
        LoadSet::UnitFriction(number) => {
            let mut loads = Loads::none(algebra.mechanism.bodies.len());
            let friction = &algebra.mechanism.frictions[number];
            let one = algebra.one();
            contacts::add_friction(algebra, bodies, &mut loads, friction, one);
            loads
        }
    }
}

/// Adds the friction of all joints, given their contact forces.
pub(super) fn add_friction<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    contact_forces: &[Ex<'m>],
    loads: &mut Loads<'m>,
) {
    let frictions = algebra.mechanism.frictions.iter();
    for (friction, &force) in frictions.zip(contact_forces) {
        let sense = contacts::sense(algebra, bodies, turns, speeds, friction);
        contacts::add_friction(algebra, bodies, loads, friction, sense * force);
    }
}

/// Returns `-m a` at each mass, and the couple of each body's rotation.
fn inertia_alone<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
) -> Loads<'m> {
    let mut loads = Loads::none(algebra.mechanism.bodies.len());
    for body in 0..algebra.mechanism.bodies.len() {
        for (mass, point) in masses::masses(algebra, body) {
            let force = -(mass * motion::point_acceleration(algebra, speeds, point));
            loads.add(Some(body), Some(point), force);
        }
        if let Some(couple) = inertia::inertia_couple(algebra, bodies, turns, speeds, body) {
            loads.add(Some(body), None, -couple);
        }
    }
    loads
}

/// Computes the loads at the speeds that are listed, without friction.
fn frictionless<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
) -> Loads<'m> {
    let all = 0..algebra.mechanism.bodies.len();
    let mut loads = Loads {
        bodies: all
            .map(|body| inertia_and_weight(algebra, bodies, turns, speeds, body))
            .collect(),
    };
    add_applied(algebra, bodies, turns, speeds, &mut loads);
    loads
}

/// Adds forces, torques, springs and dampers.
pub(super) fn add_applied<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    loads: &mut Loads<'m>,
) {
    let mechanism = algebra.mechanism;
    for load in &mechanism.loads {
        let value = load_vector(algebra, &bodies.geometry, &load.value, load.at.is_some());
        let back = -value;
        let point = load.at.as_ref().map(|at| geometry::vector_of(algebra, at));
        loads.add(load.on, point, value);
        loads.add(load.from, point, back);
    }
    for element in &mechanism.elements {
        springs::add_element(algebra, bodies, turns, speeds, loads, element);
    }
}

/// A force as a vector; a torque as a turn.
fn load_vector<'m>(
    algebra: &mut Algebra<'m>,
    geometry: &Geometry<'m>,
    value: &Expr,
    is_force: bool,
) -> Vn<'m> {
    if is_force || !geometry.is_plane() {
        geometry::vector_of(algebra, value)
    } else {
        Vector([algebra.translate_number(value)]).into()
    }
}

/// Returns `m (g - a)` at each mass of a body, and the couple of its rotation.
fn inertia_and_weight<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    body: usize,
) -> BodyLoads<'m> {
    let mut loads = BodyLoads::default();
    let gravity = masses::gravity(algebra);
    for (mass, point) in masses::masses(algebra, body) {
        let zero = algebra.graph.zeros(point.len());
        let gravity = gravity.unwrap_or(zero);
        // A mass times the square of a speed is one factor for all components.
        let force = if motion::factors_of_gain(speeds) <= point.len() {
            mass * gravity - motion::point_momentum_gain(algebra, speeds, mass, point)
        } else {
            mass * (gravity - motion::point_acceleration(algebra, speeds, point))
        };
        if !force.is_zero() {
            loads.forces.push(PointForce {
                point,
                force,
                mass: Some(mass),
            });
        }
    }
    if motion::moves(speeds) {
        let couple = inertia::inertia_couple(algebra, bodies, turns, speeds, body);
        loads.couples.extend(couple.map(|couple| -couple));
    }
    loads
}
