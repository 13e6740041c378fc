//! What acts on each body: inertia forces and weight, applied loads, springs and dampers.

use crate::algebra::scalar;
use crate::forces::geometry;
use std::rc::Rc;

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::Translate;
use crate::model::{Between, Element, ElementKind, Expr};

use super::Mechanics;
use super::geometry::{Turning, slides_along};
use super::wrench::Wrench;

/// By body: forces at points, and couples.
#[derive(Clone, Debug)]
pub(super) struct Loads<'m> {
    pub(super) bodies: Vec<BodyLoads<'m>>,
}

#[derive(Clone, Debug, Default)]
pub(super) struct BodyLoads<'m> {
    pub(super) forces: Vec<PointForce<'m>>,
    pub(super) couples: Vec<Vn<'m>>,
}

#[derive(Clone, Debug)]
pub(super) struct PointForce<'m> {
    pub(super) point: Vn<'m>,
    pub(super) force: Vn<'m>,
    /// Of inertia and weight: the mass that has its centre there. Its expression moves with the body.
    pub(super) mass: Option<Ex<'m>>,
}

impl<'m> Mechanics<'_, 'm> {
    /// The loads at the speeds that are listed.
    pub(super) fn loads(&mut self) -> Rc<Loads<'m>> {
        self.case().loads.clone()
    }

    /// The same, found anew.
    pub(super) fn all_loads(&mut self) -> Loads<'m> {
        let mechanism = self.algebra.mechanism;
        let bodies = mechanism.bodies.len();
        let mut loads = Loads {
            bodies: (0..bodies)
                .map(|body| self.inertia_and_weight(body))
                .collect(),
        };
        for load in &mechanism.loads {
            let value = self.load_vector(&load.value, load.at.is_some());
            let back = -value;
            let point = load
                .at
                .as_ref()
                .map(|at| geometry::vector_of(self.algebra, at));
            loads.add(load.on, point, value);
            loads.add(load.from, point, back);
        }
        for element in &mechanism.elements {
            self.add_element(&mut loads, element);
        }
        loads
    }

    /// A force as a vector; a torque as a turn.
    fn load_vector(&mut self, value: &Expr, is_force: bool) -> Vn<'m> {
        match is_force || !self.forces.geometry.is_plane() {
            true => geometry::vector_of(self.algebra, value),
            false => Vector([self.algebra.translate_number(value)]).into(),
        }
    }

    /// `m (g - a)` at each mass of a body, and what its turning takes.
    fn inertia_and_weight(&mut self, body: usize) -> BodyLoads<'m> {
        let mut loads = BodyLoads::default();
        let gravity = self.gravity();
        for (mass, point) in self.masses(body) {
            let zero = self.graph().zeros(point.len());
            let gravity = gravity.unwrap_or(zero);
            // A mass times the square of a speed is one factor for all components.
            let force = match self.factors_of_gain() <= point.len() {
                true => mass * gravity - self.point_momentum_gain(mass, point),
                false => mass * (gravity - self.point_acceleration(point)),
            };
            if !force.is_zero() {
                loads.forces.push(PointForce {
                    point,
                    force,
                    mass: Some(mass),
                });
            }
        }
        if self.moves() {
            let couple = self.inertia_couple(body);
            loads.couples.extend(couple.map(|couple| -couple));
        }
        loads
    }

    /// The field of gravity, if there is one.
    pub(super) fn gravity(&mut self) -> Option<Vn<'m>> {
        let gravity = self.algebra.mechanism.gravity.as_ref()?;
        Some(geometry::vector_of(self.algebra, gravity))
    }

    /// A body's masses and where they are.
    pub(super) fn masses(&mut self, body: usize) -> Vec<(Ex<'m>, Vn<'m>)> {
        let masses = self.algebra.mechanism.bodies[body].masses.iter();
        masses
            .map(|(mass, at)| {
                let mass = self.algebra.translate_number(mass);
                (mass, geometry::vector_of(self.algebra, at))
            })
            .collect()
    }

    /// A spring or damper on both of its bodies; a damper needs speeds.
    fn add_element(&mut self, loads: &mut Loads<'m>, element: &Element) {
        match element.kind {
            ElementKind::Damper if !self.moves() => return,
            ElementKind::Damper | ElementKind::Spring => {}
        }
        match &element.between {
            Between::Points([from, to]) => {
                let [start, end] = [&from.1, &to.1].map(|at| geometry::vector_of(self.algebra, at));
                let pull = self.pull(element, [(from.0, start), (to.0, end)]);
                let back = -pull;
                loads.add(from.0, Some(start), pull);
                loads.add(to.0, Some(end), back);
            }
            Between::Joint(joint) => {
                let wrench = self.joint_element(element, *joint);
                let joint = &self.algebra.mechanism.joints[*joint];
                let back = -wrench;
                let point = geometry::vector_of(self.algebra, &joint.at);
                for (body, wrench) in [(Some(joint.body), wrench), (joint.on, back)] {
                    loads.add(body, Some(point), wrench.force);
                    loads.add(body, None, wrench.moment);
                }
            }
        }
    }

    /// The force of a spring or damper on the point where it begins.
    fn pull(&mut self, element: &Element, ends: [(Option<usize>, Vn<'m>); 2]) -> Vn<'m> {
        let rate = self.algebra.translate_number(&element.value);
        let between = ends[1].1 - ends[0].1;
        let factor = match (element.kind, &element.free) {
            (ElementKind::Damper, _) => {
                // rate (d . d') / d^2
                let [start, end] = ends.map(|(body, point)| {
                    self.in_time(between.len(), |mechanics, by| {
                        mechanics.velocity_of(body, point, by)
                    })
                });
                let (along, square) = (between.dot(end - start), between.square());
                rate * along / square
            }
            (ElementKind::Spring, None) => rate,
            (ElementKind::Spring, Some(free)) => {
                // rate (1 - free / length)
                let free = self.algebra.translate_number(free);
                let length = between.length();
                rate * (length - free) / length
            }
        };
        factor * between
    }

    /// The force or couple of a spring or damper in a joint on the joint's body.
    fn joint_element(&mut self, element: &Element, joint: usize) -> Wrench<'m> {
        let rate = self.algebra.translate_number(&element.value);
        let place = match (element.kind, &element.free) {
            (ElementKind::Damper, _) => self.joint_speed(joint),
            (ElementKind::Spring, None) => self.joint_coordinate(joint),
            (ElementKind::Spring, Some(free)) => {
                let place = self.joint_coordinate(joint);
                place - self.algebra.translate_number(free)
            }
        };
        let strength = -(rate * place);
        let mut wrench = self.zero_wrench();
        match self.forces.geometry.directions[joint] {
            Some(guide) if self.acts_along_guide(joint) => wrench.force = strength * guide,
            Some(axis) => wrench.moment = strength * axis,
            None => wrench.moment = Vector([strength]).into(),
        }
        wrench
    }

    /// Whether what acts in a joint acts along its guide, and not on its angle.
    fn acts_along_guide(&self, joint: usize) -> bool {
        slides_along(self.algebra.mechanism.joints[joint].kind)
    }

    /// How far a joint has turned (its body against the one that it hangs on), or slid from that one's origin.
    pub(super) fn joint_coordinate(&self, joint: usize) -> Ex<'m> {
        let declared = &self.algebra.mechanism.joints[joint];
        let (body, on) = (declared.body, declared.on);
        let geometry = &self.forces.geometry;
        if let Some(guide) = geometry.directions[joint].filter(|_| self.acts_along_guide(joint)) {
            let point = geometry.points[joint];
            return guide.dot(on.map_or(point, |on| self.arm(on, point)));
        }
        if let Turning::About(angle, _) = &geometry.turning[body] {
            return scalar::value_of(self.algebra, angle);
        }
        let [own, other] =
            [Some(body), on].map(|body| geometry.angle(self.algebra, &self.forces.tree, body));
        scalar::value_of(self.algebra, &own.combined(&other, -1.0))
    }

    /// How fast that grows.
    fn joint_speed(&mut self, joint: usize) -> Ex<'m> {
        let declared = &self.algebra.mechanism.joints[joint];
        let (body, on) = (Some(declared.body), declared.on);
        let relative = if self.acts_along_guide(joint) {
            let point = self.forces.geometry.points[joint];
            self.in_time(point.len(), |mechanics, by| {
                mechanics.velocity_of(body, point, by) - mechanics.velocity_of(on, point, by)
            })
        } else {
            let count = self.forces.geometry.turns();
            self.in_time(count, |mechanics, by| {
                mechanics.turn(body, by) - mechanics.turn(on, by)
            })
        };
        match self.forces.geometry.directions[joint] {
            Some(way) => way.dot(relative),
            None => relative.at(0),
        }
    }
}

impl<'m> Loads<'m> {
    /// A force at a point, or a couple.
    fn add(&mut self, body: Option<usize>, point: Option<Vn<'m>>, value: Vn<'m>) {
        let Some(body) = body else { return };
        let loads = &mut self.bodies[body];
        match point {
            None => loads.couples.push(value),
            Some(point) => loads.forces.push(PointForce {
                point,
                force: value,
                mass: None,
            }),
        }
    }
}
