//! How points and bodies move: by each input, and in time at given speeds.

use std::collections::HashMap;

use linkage_symbolic::NodeId;

use crate::algebra::{Algebra, Direction};
use crate::model::{Mechanism, Variable};

use super::Mechanics;
use super::geometry::Turning;

/// The speeds and accelerations that a function lists, as places among inputs and arguments, by drive.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Speeds {
    pub(super) speeds: Vec<Option<usize>>,
    pub(super) accelerations: Vec<Option<usize>>,
}

/// Angular velocities by each input, made when they are asked for.
#[derive(Debug, Default)]
pub(super) struct Motion {
    turns: HashMap<(usize, usize), Vec<NodeId>>,
}

impl Speeds {
    pub(super) fn listed(mechanism: &Mechanism, listed: &[usize]) -> Self {
        let drives = mechanism.inputs.len();
        let place = |argument: Option<usize>| {
            let place = argument.map(|argument| drives + argument);
            place.filter(|place| listed.contains(place))
        };
        let inputs = mechanism.inputs.iter();
        Self {
            speeds: inputs.clone().map(|input| place(input.speed)).collect(),
            accelerations: inputs.map(|input| place(input.acceleration)).collect(),
        }
    }
}

impl Algebra<'_> {
    /// The derivative by an input.
    pub(super) fn by_input(&mut self, node: NodeId, input: usize) -> NodeId {
        let variable = self.variable(Variable::Input(input));
        self.derivative(node, variable, Direction::Forward)
    }

    fn vector_by_input(&mut self, v: &[NodeId], input: usize) -> Vec<NodeId> {
        v.iter().map(|&x| self.by_input(x, input)).collect()
    }
}

impl Mechanics<'_, '_> {
    pub(super) fn drives(&self) -> usize {
        self.algebra.mechanism.inputs.len()
    }

    pub(super) fn speed(&mut self, input: usize) -> Option<NodeId> {
        self.speeds.speeds[input].map(|place| self.algebra.input(place))
    }

    fn acceleration(&mut self, input: usize) -> Option<NodeId> {
        self.speeds.accelerations[input].map(|place| self.algebra.input(place))
    }

    /// Whether anything moves in time.
    pub(super) fn moves(&self) -> bool {
        let Speeds {
            speeds,
            accelerations,
        } = &self.speeds;
        speeds.iter().chain(accelerations).any(Option::is_some)
    }

    /// The angular velocity of a body by an input; the frame does not turn.
    pub(super) fn turn(&mut self, body: Option<usize>, input: usize) -> Vec<NodeId> {
        let Some(body) = body else {
            let count = self.forces.geometry.turns();
            return self.algebra.zeros(count);
        };
        if let Some(known) = self.forces.motion.turns.get(&(body, input)) {
            return known.clone();
        }
        let turn = self.turn_by(
            body,
            &mut |mechanics, node| mechanics.algebra.by_input(node, input),
            &mut |mechanics, on| mechanics.turn(on, input),
        );
        let turns = &mut self.forces.motion.turns;
        turns.insert((body, input), turn.clone());
        turn
    }

    /// The angular velocity of a body by anything, given derivatives of numbers and the turn of the body that it hangs on.
    pub(super) fn turn_by(
        &mut self,
        body: usize,
        slope: &mut dyn FnMut(&mut Self, NodeId) -> NodeId,
        of_parent: &mut dyn FnMut(&mut Self, Option<usize>) -> Vec<NodeId>,
    ) -> Vec<NodeId> {
        match self.forces.geometry.turning[body].clone() {
            Turning::Along => {
                let on = self.forces.tree.parent[body];
                of_parent(self, on)
            }
            Turning::Angle(angle) => {
                let node = self.algebra.node(&angle);
                vec![slope(self, node)]
            }
            Turning::About(angle, axis) => {
                let node = self.algebra.node(&angle);
                let rate = slope(self, node);
                let own = self.algebra.times(rate, &axis);
                let on = self.forces.tree.parent[body];
                let carried = of_parent(self, on);
                self.algebra.plus(&carried, &own)
            }
            Turning::Frame(axes) => {
                // (y' . z) x + (z' . x) y + (x' . y) z
                let zero = self.algebra.zeros(3);
                (0..3).fold(zero, |sum, k| {
                    let (next, after) = (&axes[(k + 1) % 3], &axes[(k + 2) % 3]);
                    let moved: Vec<_> = next.iter().map(|&x| slope(self, x)).collect();
                    let rate = self.algebra.dot(&moved, after);
                    let part = self.algebra.times(rate, &axes[k]);
                    self.algebra.plus(&sum, &part)
                })
            }
            Turning::Rod(along) => {
                let moved: Vec<_> = along.iter().map(|&x| slope(self, x)).collect();
                let across = self.algebra.moment_of(&along, &moved);
                let square = self.algebra.sum_of_squares(&along);
                let graph = &mut self.algebra.graph;
                across.into_iter().map(|x| graph.div(x, square)).collect()
            }
        }
    }

    /// The velocity of a body's point by an input.
    pub(super) fn velocity_of(
        &mut self,
        body: Option<usize>,
        point: &[NodeId],
        input: usize,
    ) -> Vec<NodeId> {
        let Some(number) = body else {
            return self.algebra.zeros(point.len());
        };
        let origin = self.forces.geometry.origins[number].clone();
        let moved = self.algebra.vector_by_input(&origin, input);
        let arm = self.algebra.difference(point, &origin);
        let turn = self.turn(body, input);
        let swept = self.algebra.swept(&turn, &arm);
        self.algebra.plus(&moved, &swept)
    }

    /// Derivatives by the inputs times their speeds.
    pub(super) fn in_time(
        &mut self,
        count: usize,
        mut by: impl FnMut(&mut Self, usize) -> Vec<NodeId>,
    ) -> Vec<NodeId> {
        let zero = self.algebra.zeros(count);
        (0..self.drives()).fold(zero, |sum, input| match self.speed(input) {
            None => sum,
            Some(speed) => {
                let slope = by(self, input);
                let part = self.algebra.times(speed, &slope);
                self.algebra.plus(&sum, &part)
            }
        })
    }

    /// What a quantity, whose derivatives by the inputs are given, gains in speed: `sum q_ij w_i w_j + sum q_i e_i`.
    pub(super) fn gain(
        &mut self,
        count: usize,
        mut by: impl FnMut(&mut Self, usize) -> Vec<NodeId>,
    ) -> Vec<NodeId> {
        let mut sum = self.algebra.zeros(count);
        for i in 0..self.drives() {
            let (speed, acceleration) = (self.speed(i), self.acceleration(i));
            if speed.is_none() && acceleration.is_none() {
                continue;
            }
            let first = by(self, i);
            if let Some(acceleration) = acceleration {
                let part = self.algebra.times(acceleration, &first);
                sum = self.algebra.plus(&sum, &part);
            }
            let Some(speed) = speed else { continue };
            for j in 0..self.drives() {
                let Some(other) = self.speed(j) else { continue };
                let second = self.algebra.vector_by_input(&first, j);
                let product = self.algebra.graph.mul(speed, other);
                let part = self.algebra.times(product, &second);
                sum = self.algebra.plus(&sum, &part);
            }
        }
        sum
    }

    /// The velocity of a point that is part of the motion, in time.
    pub(super) fn point_velocity(&mut self, point: &[NodeId]) -> Vec<NodeId> {
        self.in_time(point.len(), |mechanics, input| {
            mechanics.algebra.vector_by_input(point, input)
        })
    }

    pub(super) fn point_acceleration(&mut self, point: &[NodeId]) -> Vec<NodeId> {
        self.gain(point.len(), |mechanics, input| {
            mechanics.algebra.vector_by_input(point, input)
        })
    }

    pub(super) fn angular_velocity(&mut self, body: usize) -> Vec<NodeId> {
        let count = self.forces.geometry.turns();
        self.in_time(count, |mechanics, input| mechanics.turn(Some(body), input))
    }

    pub(super) fn angular_acceleration(&mut self, body: usize) -> Vec<NodeId> {
        let count = self.forces.geometry.turns();
        self.gain(count, |mechanics, input| mechanics.turn(Some(body), input))
    }
}
