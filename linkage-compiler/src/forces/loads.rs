//! The loads on each body: inertia forces and weight, applied loads, springs and dampers.

use std::rc::Rc;

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Vector, Vn};

use crate::algebra::{Algebra, Translate};
use crate::forces::body_loads::{BodyLoads, Loads, PointForce};
use crate::forces::context::{Case, Memo};
use crate::forces::geometry::Geometry;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, Speeds};
use crate::forces::{geometry, inertia, masses, motion, springs};
use crate::model::Expr;

/// The forces at the speeds that are listed, the loads at least.
pub(super) fn case<'c, 'm>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &'c mut Memo<'m>,
    speeds: &Speeds,
) -> &'c mut Case<'m> {
    if !memo.cases.contains_key(speeds) {
        let case = Case {
            loads: Rc::new(all_loads(algebra, bodies, &mut memo.turns, speeds)),
            wrenches: Map::new(),
            solved: Map::new(),
        };
        memo.cases.insert(speeds.clone(), case);
    }
    let case = memo.cases.get_mut(speeds);
    case.expect("just made")
}

/// The loads at the speeds that are listed.
pub(super) fn loads<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
) -> Rc<Loads<'m>> {
    case(algebra, bodies, memo, speeds).loads.clone()
}

/// Computes the loads at the speeds that are listed.
fn all_loads<'m>(
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
