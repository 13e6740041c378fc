//! What functions ask for.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::{Translate, Value};
use crate::model::{Between, Element, ElementKind, MechanicalQuantity as Quantity};

use super::Mechanics;
use super::geometry::{Turns, slides_along, turns_of};
use super::motion::By;
use super::system::Unknown;
use super::wrench::Wrench;

impl<'m> Mechanics<'_, 'm> {
    pub(crate) fn quantity(&mut self, quantity: &Quantity) -> Value<'m> {
        match quantity {
            Quantity::Reaction(joint) => self.reaction(*joint).force.into(),
            Quantity::Moment(joint) => turn_value(self.reaction(*joint).moment),
            Quantity::Drive(input) => self.drive(*input).into(),
            Quantity::Power => self.power().into(),
            Quantity::KineticEnergy => self.kinetic_energy().into(),
            Quantity::PotentialEnergy => self.potential_energy().into(),
            Quantity::ShakingForce => self.shaking_force().into(),
            Quantity::ShakingMoment(about) => {
                let about = match about {
                    Some(about) => self.algebra.vector_of(about),
                    None => self.zero_vector(),
                };
                turn_value(self.shaking_moment(about))
            }
        }
    }

    /// What a joint transmits to its body: without what a drive does in its motion.
    fn reaction(&mut self, joint: usize) -> Wrench<'m> {
        if self.forces.tree.closing.contains(&joint) {
            return self.closing_wrench(joint, &[]);
        }
        let declared = &self.algebra.mechanism.joints[joint];
        let (body, kind) = (declared.body, declared.kind);
        let mut reaction = -self.wrench(body, &[], &[]);
        let Some(direction) = self.forces.geometry.directions[joint] else {
            return reaction;
        };
        // Where nothing drives it, equilibrium leaves nothing along the guide or about the axis.
        if slides_along(kind) && self.is_driven(body, true) {
            reaction.force = reaction.force.across(direction);
        }
        if turns_of(kind) == Turns::AboutAxis && self.is_driven(body, false) {
            reaction.moment = reaction.moment.across(direction);
        }
        reaction
    }

    fn is_driven(&mut self, body: usize, slides: bool) -> bool {
        let system = self.system();
        let mut driven = system.driven.iter();
        driven.any(|way| way.body == body && way.slides == slides)
    }

    /// The torque or force of a drive.
    fn drive(&mut self, input: usize) -> Ex<'m> {
        match self.with_reactions {
            true => self.drive_of_joints(input),
            false => self.drive_of_loads(input),
        }
    }

    /// What holds the driven joints against all that is beyond them. Little work where reactions are asked for.
    fn drive_of_joints(&mut self, input: usize) -> Ex<'m> {
        let system = self.system();
        let mut sum = self.algebra.zero();
        for way in &system.driven {
            let rate = self.relative_rate(way, By::Input(input));
            if !rate.is_zero() {
                sum -= rate * self.wrench(way.body, &[], &[]).along(way);
            }
        }
        // Gears that run on a driven shaft load it.
        for (index, unknown) in system.unknowns.iter().enumerate() {
            let Unknown::Tie(tie) = unknown else { continue };
            let rate = self.tie_rate(tie, input);
            if !rate.is_zero() {
                sum += rate * self.solved(index);
            }
        }
        sum
    }

    /// What the loads do when its input moves, with the opposite sign: `-(sum F . p' + sum M . w)`.
    fn drive_of_loads(&mut self, input: usize) -> Ex<'m> {
        let input = By::Input(input);
        let loads = self.loads();
        let mut work = self.algebra.zero();
        for (body, own) in loads.bodies.iter().enumerate() {
            for load in &own.forces {
                let moved = match load.mass {
                    Some(_) => self.moved(load.point, input),
                    None => self.velocity_of(Some(body), load.point, input),
                };
                work += load.force.dot(moved);
            }
            for couple in &own.couples {
                work += couple.dot(self.turn(Some(body), input));
            }
        }
        -work
    }

    /// `sum Q w`
    fn power(&mut self) -> Ex<'m> {
        let zero = self.algebra.zero();
        (0..self.drives()).fold(zero, |sum, input| match self.speed(input) {
            None => sum,
            Some(speed) => sum + self.drive(input) * speed,
        })
    }

    /// `1/2 (sum m v^2 + sum w . I w)`
    fn kinetic_energy(&mut self) -> Ex<'m> {
        let mut twice = self.algebra.zero();
        for body in 0..self.algebra.mechanism.bodies.len() {
            for (mass, point) in self.masses(body) {
                twice += mass * self.point_velocity(point).square();
            }
            twice += self.twice_turning_energy(body);
        }
        0.5 * twice
    }

    /// Of the weights, zero at the origin, and of springs, zero without force: `1/2 sum c (l - l_0)^2 - sum m g . p`.
    fn potential_energy(&mut self) -> Ex<'m> {
        let mut sum = self.algebra.zero();
        if let Some(gravity) = self.gravity() {
            for body in 0..self.algebra.mechanism.bodies.len() {
                for (mass, point) in self.masses(body) {
                    sum -= mass * gravity.dot(point);
                }
            }
        }
        for element in &self.algebra.mechanism.elements {
            sum += match element.kind {
                ElementKind::Damper => self.algebra.zero(),
                ElementKind::Spring => self.spring_energy(element),
            };
        }
        sum
    }

    /// `1/2 c (l - l_0)^2`
    fn spring_energy(&mut self, spring: &Element) -> Ex<'m> {
        let length = match &spring.between {
            Between::Joint(joint) => self.joint_coordinate(*joint),
            Between::Points([from, to]) => {
                let [start, end] = [&from.1, &to.1].map(|at| self.algebra.vector_of(at));
                (end - start).length()
            }
        };
        let free = match &spring.free {
            Some(free) => self.algebra.translate_number(free),
            None => self.algebra.zero(),
        };
        let stiffness = self.algebra.translate_number(&spring.value);
        0.5 * (stiffness * (length - free).square())
    }

    /// `-sum m a`
    fn shaking_force(&mut self) -> Vn<'m> {
        let mut sum = self.zero_vector();
        for body in 0..self.algebra.mechanism.bodies.len() {
            for (mass, point) in self.masses(body) {
                sum = sum - mass * self.point_acceleration(point);
            }
        }
        sum
    }

    /// Minus the rate of the moment of momentum about a fixed point: `-sum (p - o) x m a`, and what the bodies' turning takes.
    fn shaking_moment(&mut self, about: Vn<'m>) -> Vn<'m> {
        let mut sum = self.zero_turn();
        for body in 0..self.algebra.mechanism.bodies.len() {
            for (mass, point) in self.masses(body) {
                let force = mass * self.point_acceleration(point);
                sum = sum - (point - about).moment_of(force);
            }
            if let Some(couple) = self.inertia_couple(body) {
                sum = sum - couple;
            }
        }
        sum
    }
}

/// A scalar in the plane.
fn turn_value(turn: Vn) -> Value {
    match turn.in_space() {
        Some(_) => turn.into(),
        None => turn.at(0).into(),
    }
}
