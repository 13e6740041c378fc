//! What functions ask for.

use linkage_symbolic::NodeId;

use crate::algebra::{Scalar, Value};
use crate::model::{Between, ElementKind, Mechanics as Quantity};

use super::Mechanics;
use super::geometry::{slides_along, turns_about};
use super::system::Unknown;
use super::wrench::Wrench;

impl Mechanics<'_, '_> {
    pub(crate) fn quantity(&mut self, quantity: &Quantity) -> Value {
        match quantity {
            Quantity::Reaction(joint) => Value::Vector(self.reaction(*joint).force),
            Quantity::Moment(joint) => {
                let moment = self.reaction(*joint).moment;
                turn_value(moment)
            }
            Quantity::Drive(input) => Value::Scalar(self.drive(*input).into()),
            Quantity::Power => Value::Scalar(self.power().into()),
            Quantity::KineticEnergy => Value::Scalar(self.kinetic_energy().into()),
            Quantity::PotentialEnergy => Value::Scalar(self.potential_energy().into()),
            Quantity::ShakingForce => Value::Vector(self.shaking_force()),
            Quantity::ShakingMoment(about) => {
                let about = match about {
                    Some(about) => self.algebra.vector_of(about),
                    None => {
                        let count = self.forces.geometry.dimensions;
                        self.algebra.zeros(count)
                    }
                };
                let moment = self.shaking_moment(&about);
                turn_value(moment)
            }
        }
    }

    /// What a joint transmits to its body: without what a drive does in its motion.
    fn reaction(&mut self, joint: usize) -> Wrench {
        if self.forces.tree.closing.contains(&joint) {
            return self.closing_wrench(joint, &[]);
        }
        let declared = &self.algebra.mechanism.joints[joint];
        let (body, kind) = (declared.body, declared.kind);
        let carried = self.wrench(body, &[], &[]);
        let mut reaction = self.opposite_wrench(&carried);
        let Some(direction) = self.forces.geometry.directions[joint].clone() else {
            return reaction;
        };
        // Where nothing drives it, equilibrium leaves nothing along the guide or about the axis.
        if slides_along(kind) && self.is_driven(body, true) {
            reaction.force = self.algebra.across(&direction, &reaction.force);
        }
        if turns_about(kind) && self.is_driven(body, false) {
            reaction.moment = self.algebra.across(&direction, &reaction.moment);
        }
        reaction
    }

    fn is_driven(&mut self, body: usize, slides: bool) -> bool {
        let system = self.system();
        let mut driven = system.driven.iter();
        driven.any(|way| way.body == body && way.slides == slides)
    }

    /// The torque or force of a drive.
    fn drive(&mut self, input: usize) -> NodeId {
        match self.with_reactions {
            true => self.drive_of_joints(input),
            false => self.drive_of_loads(input),
        }
    }

    /// What holds the driven joints against all that is beyond them. Little work where reactions are asked for.
    fn drive_of_joints(&mut self, input: usize) -> NodeId {
        let zero = self.algebra.graph.zero();
        let system = self.system();
        let of_joints = system.driven.iter().fold(zero, |sum, way| {
            let rate = self.driven_rate(way, input);
            if self.algebra.graph.is_zero(rate) {
                return sum;
            }
            let carried = self.wrench(way.body, &[], &[]);
            let along = self.algebra.dot(&way.direction, carried.along(way));
            let work = self.algebra.graph.mul(rate, along);
            self.algebra.graph.sub(sum, work)
        });
        // Gears that run on a driven shaft load it.
        let unknowns = system.unknowns.iter().enumerate();
        unknowns.fold(of_joints, |sum, (index, unknown)| {
            let Unknown::Tie(tie) = unknown else {
                return sum;
            };
            let rate = self.tie_rate(tie, input);
            if self.algebra.graph.is_zero(rate) {
                return sum;
            }
            let couple = self.solved(index);
            let work = self.algebra.graph.mul(rate, couple);
            self.algebra.graph.add(sum, work)
        })
    }

    /// What the loads do when its input moves, with the opposite sign.
    fn drive_of_loads(&mut self, input: usize) -> NodeId {
        let loads = self.loads();
        let zero = self.algebra.graph.zero();
        let mut work = zero;
        for (body, own) in loads.bodies.iter().enumerate() {
            for load in &own.forces {
                let moved = match load.is_mass {
                    true => {
                        let moved = load.point.iter();
                        moved.map(|&x| self.algebra.by_input(x, input)).collect()
                    }
                    false => self.velocity_of(Some(body), &load.point, input),
                };
                let part = self.algebra.dot(&load.force, &moved);
                work = self.algebra.graph.add(work, part);
            }
            if own.couples.is_empty() {
                continue;
            }
            let turn = self.turn(Some(body), input);
            for couple in &own.couples {
                let part = self.algebra.dot(couple, &turn);
                work = self.algebra.graph.add(work, part);
            }
        }
        self.algebra.graph.neg(work)
    }

    fn power(&mut self) -> NodeId {
        let zero = self.algebra.graph.zero();
        (0..self.drives()).fold(zero, |sum, input| match self.speed(input) {
            None => sum,
            Some(speed) => {
                let drive = self.drive(input);
                let power = self.algebra.graph.mul(drive, speed);
                self.algebra.graph.add(sum, power)
            }
        })
    }

    fn kinetic_energy(&mut self) -> NodeId {
        let mut twice = self.algebra.graph.zero();
        for body in 0..self.algebra.mechanism.bodies.len() {
            for (mass, point) in self.masses(body) {
                let velocity = self.point_velocity(&point);
                let square = self.algebra.sum_of_squares(&velocity);
                let part = self.algebra.graph.mul(mass, square);
                twice = self.algebra.graph.add(twice, part);
            }
            let turning = self.twice_turning_energy(body);
            twice = self.algebra.graph.add(twice, turning);
        }
        self.half(twice)
    }

    /// Of the weights, zero at the origin, and of springs, zero without force.
    fn potential_energy(&mut self) -> NodeId {
        let mut sum = self.algebra.graph.zero();
        if let Some(gravity) = self.gravity() {
            for body in 0..self.algebra.mechanism.bodies.len() {
                for (mass, point) in self.masses(body) {
                    let depth = self.algebra.dot(&gravity, &point);
                    let part = self.algebra.graph.mul(mass, depth);
                    sum = self.algebra.graph.sub(sum, part);
                }
            }
        }
        for element in &self.algebra.mechanism.elements {
            if element.kind == ElementKind::Damper {
                continue;
            }
            let place = match &element.between {
                Between::Joint(joint) => self.joint_coordinate(*joint),
                Between::Points([from, to]) => {
                    let [start, end] = [&from.1, &to.1].map(|at| self.algebra.vector_of(at));
                    let between = self.algebra.difference(&end, &start);
                    self.algebra.length(&between)
                }
            };
            let free = match &element.free {
                Some(free) => self.algebra.number_of(free),
                None => self.algebra.graph.zero(),
            };
            let rate = self.algebra.number_of(&element.value);
            let longer = self.algebra.graph.sub(place, free);
            let square = self.algebra.graph.square(longer);
            let twice = self.algebra.graph.mul(rate, square);
            let part = self.half(twice);
            sum = self.algebra.graph.add(sum, part);
        }
        sum
    }

    fn half(&mut self, twice: NodeId) -> NodeId {
        let half = self.algebra.graph.constant(0.5);
        self.algebra.graph.mul(half, twice)
    }

    /// Minus the sum of mass times acceleration.
    fn shaking_force(&mut self) -> Vec<NodeId> {
        let count = self.forces.geometry.dimensions;
        let mut sum = self.algebra.zeros(count);
        for body in 0..self.algebra.mechanism.bodies.len() {
            for (mass, point) in self.masses(body) {
                let gain = self.point_acceleration(&point);
                let part = self.algebra.times(mass, &gain);
                sum = self.algebra.difference(&sum, &part);
            }
        }
        sum
    }

    /// Minus the rate of the moment of momentum about a fixed point.
    fn shaking_moment(&mut self, about: &[NodeId]) -> Vec<NodeId> {
        let count = self.forces.geometry.turns();
        let mut sum = self.algebra.zeros(count);
        for body in 0..self.algebra.mechanism.bodies.len() {
            for (mass, point) in self.masses(body) {
                let gain = self.point_acceleration(&point);
                let force = self.algebra.times(mass, &gain);
                let arm = self.algebra.difference(&point, about);
                let part = self.algebra.moment_of(&arm, &force);
                sum = self.algebra.difference(&sum, &part);
            }
            if let Some(couple) = self.inertia_couple(body) {
                sum = self.algebra.difference(&sum, &couple);
            }
        }
        sum
    }
}

/// A scalar in the plane.
fn turn_value(turn: Vec<NodeId>) -> Value {
    match turn[..] {
        [moment] => Value::Scalar(Scalar::from(moment)),
        _ => Value::Vector(turn),
    }
}
