//! What acts on each body: inertia forces and weight, applied loads, springs and dampers.

use linkage_symbolic::NodeId;

use crate::model::{Between, Element, ElementKind, Expr, JointKind};

use super::geometry::Turning;
use super::wrench::Wrench;
use super::{Case, Mechanics};

/// By body: forces at points, and couples.
#[derive(Clone, Debug, Default)]
pub(super) struct Loads {
    pub(super) bodies: Vec<BodyLoads>,
}

#[derive(Clone, Debug, Default)]
pub(super) struct BodyLoads {
    pub(super) forces: Vec<PointForce>,
    pub(super) couples: Vec<Vec<NodeId>>,
}

#[derive(Clone, Debug)]
pub(super) struct PointForce {
    pub(super) point: Vec<NodeId>,
    pub(super) force: Vec<NodeId>,
    /// A centre of mass, whose expression moves with the body.
    pub(super) is_mass: bool,
}

impl Mechanics<'_, '_> {
    /// The loads at the speeds that are listed.
    pub(super) fn loads(&mut self) -> Loads {
        if let Some(case) = self.forces.cases.get(&self.speeds) {
            return case.loads.clone();
        }
        let mechanism = self.algebra.mechanism;
        let mut loads = Loads {
            bodies: vec![BodyLoads::default(); mechanism.bodies.len()],
        };
        for body in 0..mechanism.bodies.len() {
            self.add_masses(&mut loads, body);
        }
        for load in &mechanism.loads {
            let value = self.load_vector(&load.value, load.at.is_some());
            let back = self.algebra.opposite(&value);
            let point = load.at.as_ref().map(|at| self.algebra.vector_of(at));
            loads.add(load.on, point.clone(), value);
            loads.add(load.from, point, back);
        }
        for element in &mechanism.elements {
            self.add_element(&mut loads, element);
        }
        let case = Case {
            loads: loads.clone(),
            ..Case::default()
        };
        self.forces.cases.insert(self.speeds.clone(), case);
        loads
    }

    /// A force as a vector; a torque as a turn.
    fn load_vector(&mut self, value: &Expr, is_force: bool) -> Vec<NodeId> {
        match is_force || self.forces.geometry.dimensions == 3 {
            true => self.algebra.vector_of(value),
            false => vec![self.algebra.number_of(value)],
        }
    }

    /// Weight and inertia of a body.
    fn add_masses(&mut self, loads: &mut Loads, body: usize) {
        let gravity = self.gravity();
        for (mass, point) in self.masses(body) {
            let zero = self.algebra.zeros(point.len());
            let weight = gravity.clone().unwrap_or_else(|| zero.clone());
            let gain = match self.moves() {
                true => self.point_acceleration(&point),
                false => zero,
            };
            let field = self.algebra.difference(&weight, &gain);
            if field.iter().all(|&x| self.algebra.graph.is_zero(x)) {
                continue;
            }
            let force = self.algebra.times(mass, &field);
            loads.bodies[body].forces.push(PointForce {
                point,
                force,
                is_mass: true,
            });
        }
        if self.moves()
            && let Some(couple) = self.inertia_couple(body)
        {
            let couple = self.algebra.opposite(&couple);
            loads.bodies[body].couples.push(couple);
        }
    }

    pub(super) fn gravity(&mut self) -> Option<Vec<NodeId>> {
        let gravity = self.algebra.mechanism.gravity.as_ref()?;
        Some(self.algebra.vector_of(gravity))
    }

    /// A body's masses and where they are.
    pub(super) fn masses(&mut self, body: usize) -> Vec<(NodeId, Vec<NodeId>)> {
        let mechanism = self.algebra.mechanism;
        let masses = mechanism.bodies[body].masses.iter();
        masses
            .map(|(mass, at)| (self.algebra.number_of(mass), self.algebra.vector_of(at)))
            .collect()
    }

    fn add_element(&mut self, loads: &mut Loads, element: &Element) {
        if element.kind == ElementKind::Damper && !self.moves() {
            return;
        }
        match &element.between {
            Between::Points([from, to]) => {
                let points = [&from.1, &to.1].map(|at| self.algebra.vector_of(at));
                let bodies = [from.0, to.0];
                let pull = self.pull(element, bodies, &points);
                let back = self.algebra.opposite(&pull);
                let [start, end] = points;
                loads.add(bodies[0], Some(start), pull);
                loads.add(bodies[1], Some(end), back);
            }
            Between::Joint(joint) => {
                let wrench = self.joint_element(element, *joint);
                let joint = &self.algebra.mechanism.joints[*joint];
                let [on, body] = [joint.on, Some(joint.body)];
                let back = self.opposite_wrench(&wrench);
                let point = self.algebra.vector_of(&joint.at);
                for (body, wrench) in [(body, wrench), (on, back)] {
                    loads.add(body, Some(point.clone()), wrench.force);
                    loads.add(body, None, wrench.moment);
                }
            }
        }
    }

    /// The force of a spring or damper on the point where it begins.
    fn pull(
        &mut self,
        element: &Element,
        bodies: [Option<usize>; 2],
        points: &[Vec<NodeId>; 2],
    ) -> Vec<NodeId> {
        let rate = self.algebra.number_of(&element.value);
        let between = self.algebra.difference(&points[1], &points[0]);
        if element.kind == ElementKind::Damper {
            // rate (d . d') d / d^2
            let [start, end] = [0, 1].map(|k| {
                self.in_time(between.len(), |mechanics, input| {
                    mechanics.velocity_of(bodies[k], &points[k], input)
                })
            });
            let moved = self.algebra.difference(&end, &start);
            let product = self.algebra.dot(&between, &moved);
            let square = self.algebra.sum_of_squares(&between);
            let graph = &mut self.algebra.graph;
            let force = graph.mul(rate, product);
            let factor = graph.div(force, square);
            return self.algebra.times(factor, &between);
        }
        let factor = match &element.free {
            None => rate,
            Some(free) => {
                // rate (1 - free / length)
                let free = self.algebra.number_of(free);
                let length = self.algebra.length(&between);
                let graph = &mut self.algebra.graph;
                let longer = graph.sub(length, free);
                let force = graph.mul(rate, longer);
                graph.div(force, length)
            }
        };
        self.algebra.times(factor, &between)
    }

    /// The force or couple of a spring or damper in a joint on the joint's body.
    fn joint_element(&mut self, element: &Element, joint: usize) -> Wrench {
        let declared = &self.algebra.mechanism.joints[joint];
        let rate = self.algebra.number_of(&element.value);
        let way = self.forces.geometry.directions[joint].clone();
        let slides = declared.kind == JointKind::Slide;
        let place = match element.kind {
            ElementKind::Damper => self.joint_speed(joint),
            ElementKind::Spring => {
                let place = self.joint_coordinate(joint);
                match &element.free {
                    None => place,
                    Some(free) => {
                        let free = self.algebra.number_of(free);
                        self.algebra.graph.sub(place, free)
                    }
                }
            }
        };
        let strength = self.algebra.graph.mul(rate, place);
        let strength = self.algebra.graph.neg(strength);
        let geometry = &self.forces.geometry;
        let (forces, turns) = (geometry.dimensions, geometry.turns());
        let mut wrench = Wrench {
            force: self.algebra.zeros(forces),
            moment: self.algebra.zeros(turns),
        };
        match way {
            Some(way) if slides => wrench.force = self.algebra.times(strength, &way),
            Some(axis) => wrench.moment = self.algebra.times(strength, &axis),
            None => wrench.moment = vec![strength],
        }
        wrench
    }

    /// How far a joint has turned (its body against the one that it hangs on), or slid from that one's origin.
    pub(super) fn joint_coordinate(&mut self, joint: usize) -> NodeId {
        let declared = &self.algebra.mechanism.joints[joint];
        let (body, on) = (declared.body, declared.on);
        if declared.kind == JointKind::Slide {
            let point = self.forces.geometry.points[joint].clone();
            let way = self.forces.geometry.directions[joint].clone();
            let from = match on {
                Some(on) => self.arm(on, &point),
                None => point,
            };
            return self.algebra.dot(&way.unwrap_or_default(), &from);
        }
        if let Turning::About(angle, _) = self.forces.geometry.turning[body].clone() {
            return self.algebra.node(&angle);
        }
        let geometry = &self.forces.geometry;
        let own = geometry.angle(self.algebra, &self.forces.tree, Some(body));
        let other = geometry.angle(self.algebra, &self.forces.tree, on);
        let relative = self.algebra.combine(&own, &other, -1.0);
        self.algebra.node(&relative)
    }

    fn joint_speed(&mut self, joint: usize) -> NodeId {
        let declared = &self.algebra.mechanism.joints[joint];
        let (body, on) = (Some(declared.body), declared.on);
        let way = self.forces.geometry.directions[joint].clone();
        let relative = if declared.kind == JointKind::Slide {
            let point = self.forces.geometry.points[joint].clone();
            self.in_time(point.len(), |mechanics, input| {
                let own = mechanics.velocity_of(body, &point, input);
                let other = mechanics.velocity_of(on, &point, input);
                mechanics.algebra.difference(&own, &other)
            })
        } else {
            let count = self.forces.geometry.turns();
            self.in_time(count, |mechanics, input| {
                let own = mechanics.turn(body, input);
                let other = mechanics.turn(on, input);
                mechanics.algebra.difference(&own, &other)
            })
        };
        match way {
            Some(way) => self.algebra.dot(&way, &relative),
            None => relative[0],
        }
    }
}

impl Loads {
    fn add(&mut self, body: Option<usize>, point: Option<Vec<NodeId>>, value: Vec<NodeId>) {
        let Some(body) = body else { return };
        let loads = &mut self.bodies[body];
        match point {
            None => loads.couples.push(value),
            Some(point) => loads.forces.push(PointForce {
                point,
                force: value,
                is_mass: false,
            }),
        }
    }
}
