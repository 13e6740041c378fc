//! How points and bodies move: by each input or unknown, and in time at given speeds.

use linkage_symbolic::lookup::Map;

use linkage_symbolic::{Ex, SymbolId, Vector, Vn};

use crate::algebra::Direction;
use crate::model::{Mechanism, Variable};

use super::Mechanics;
use super::geometry::Turning;

/// The speeds and accelerations that a function lists, as places among inputs and arguments, by drive.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Speeds {
    speeds: Vec<Option<usize>>,
    accelerations: Vec<Option<usize>>,
}

/// What derivatives are by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum By {
    /// An input, which moves the unknowns, too.
    Input(usize),
    /// An unknown or input that changes alone.
    Alone(SymbolId),
}

/// Angular velocities of bodies, made when they are asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Motion<'m> {
    turns: Map<(usize, By), Vn<'m>>,
}

impl Speeds {
    /// Those among the arguments that a function lists.
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

impl<'m> Mechanics<'_, 'm> {
    /// How many inputs there are.
    pub(super) fn drives(&self) -> usize {
        self.algebra.mechanism.inputs.len()
    }

    /// The speed of an input, if it is listed.
    pub(super) fn speed(&self, input: usize) -> Option<Ex<'m>> {
        self.speeds.speeds[input].map(|place| self.algebra.input(place))
    }

    fn acceleration(&self, input: usize) -> Option<Ex<'m>> {
        self.speeds.accelerations[input].map(|place| self.algebra.input(place))
    }

    /// Whether anything moves in time.
    pub(super) fn moves(&self) -> bool {
        self.factors_of_gain() > 0
    }

    /// The derivative of a number.
    pub(super) fn slope(&mut self, x: Ex<'m>, by: By) -> Ex<'m> {
        match by {
            By::Input(input) => {
                let variable = self.algebra.variable(Variable::Input(input));
                self.algebra.derivative(x, variable, Direction::Forward)
            }
            By::Alone(variable) => self.algebra.partial(x, variable),
        }
    }

    /// The derivative of a point or vector that is part of the motion.
    pub(super) fn moved(&mut self, v: Vn<'m>, by: By) -> Vn<'m> {
        v.map(|x| self.slope(x, by))
    }

    /// The angular velocity of a body; the frame does not turn.
    pub(super) fn turn(&mut self, body: Option<usize>, by: By) -> Vn<'m> {
        let Some(body) = body else {
            return self.zero_turn();
        };
        if let Some(&known) = self.forces.motion.turns.get(&(body, by)) {
            return known;
        }
        let on = self.forces.tree.parent[body];
        let turn = match self.forces.geometry.turning[body].clone() {
            Turning::Along => self.turn(on, by),
            Turning::Angle(angle) => {
                let angle = self.algebra.value_of(&angle);
                Vector([self.slope(angle, by)]).into()
            }
            Turning::About(angle, axis) => {
                let angle = self.algebra.value_of(&angle);
                let own = self.slope(angle, by) * axis;
                self.turn(on, by) + own
            }
            Turning::Frame(axes) => {
                // (y' . z) x + (z' . x) y + (x' . y) z
                (0..3).fold(self.zero_turn(), |sum, k| {
                    let [x, y, z] = [k, k + 1, k + 2].map(|k| axes[k % 3]);
                    sum + self.moved(y, by).dot(z) * x
                })
            }
            // V x V' / V^2
            Turning::Rod(v) => v.moment_of(self.moved(v, by)) / v.square(),
        };
        self.forces.motion.turns.insert((body, by), turn);
        turn
    }

    /// The velocity of a body's point: `O' + w x (P - O)`.
    pub(super) fn velocity_of(&mut self, body: Option<usize>, point: Vn<'m>, by: By) -> Vn<'m> {
        let Some(number) = body else {
            return self.graph().zeros(point.len());
        };
        let moved = self.moved(self.forces.geometry.origins[number], by);
        let arm = self.arm(number, point);
        moved + self.turn(body, by).sweeping(arm)
    }

    /// Derivatives by the inputs times their speeds: `sum q_i w_i`.
    pub(super) fn in_time(
        &mut self,
        count: usize,
        mut derivative: impl FnMut(&mut Self, By) -> Vn<'m>,
    ) -> Vn<'m> {
        let zero = self.graph().zeros(count);
        (0..self.drives()).fold(zero, |sum, input| match self.speed(input) {
            None => sum,
            Some(speed) => sum + speed * derivative(self, By::Input(input)),
        })
    }

    /// How many factors [`gain`](Self::gain) has: accelerations, and products of two speeds.
    pub(super) fn factors_of_gain(&self) -> usize {
        let of = |all: &[Option<usize>]| all.iter().flatten().count();
        of(&self.speeds.accelerations) + of(&self.speeds.speeds).pow(2)
    }

    /// What a quantity, whose derivatives by the inputs are given, gains in speed: `sum q_ij w_i w_j + sum q_i e_i`.
    pub(super) fn gain(
        &mut self,
        count: usize,
        derivative: impl FnMut(&mut Self, By) -> Vn<'m>,
    ) -> Vn<'m> {
        let one = self.algebra.one();
        self.gain_times(one, count, derivative)
    }

    /// The same times a number, which goes to the speeds.
    fn gain_times(
        &mut self,
        factor: Ex<'m>,
        count: usize,
        mut derivative: impl FnMut(&mut Self, By) -> Vn<'m>,
    ) -> Vn<'m> {
        let mut sum = self.graph().zeros(count);
        for i in 0..self.drives() {
            let (speed, acceleration) = (self.speed(i), self.acceleration(i));
            if speed.is_none() && acceleration.is_none() {
                continue;
            }
            let first = derivative(self, By::Input(i));
            if let Some(acceleration) = acceleration {
                sum = sum + (factor * acceleration) * first;
            }
            let Some(speed) = speed else { continue };
            for j in 0..self.drives() {
                let Some(other) = self.speed(j) else { continue };
                let second = self.moved(first, By::Input(j));
                sum = sum + (factor * (speed * other)) * second;
            }
        }
        sum
    }

    /// The velocity of a point that is part of the motion, in time.
    pub(super) fn point_velocity(&mut self, point: Vn<'m>) -> Vn<'m> {
        self.in_time(point.len(), |mechanics, by| mechanics.moved(point, by))
    }

    /// Its acceleration.
    pub(super) fn point_acceleration(&mut self, point: Vn<'m>) -> Vn<'m> {
        self.gain(point.len(), |mechanics, by| mechanics.moved(point, by))
    }

    /// What a mass at it gains in momentum.
    pub(super) fn point_momentum_gain(&mut self, mass: Ex<'m>, point: Vn<'m>) -> Vn<'m> {
        let moved = |mechanics: &mut Self, by| mechanics.moved(point, by);
        self.gain_times(mass, point.len(), moved)
    }

    /// The angular velocity of a body, in time.
    pub(super) fn angular_velocity(&mut self, body: usize) -> Vn<'m> {
        let count = self.forces.geometry.turns();
        self.in_time(count, |mechanics, by| mechanics.turn(Some(body), by))
    }

    /// What it gains.
    pub(super) fn angular_acceleration(&mut self, body: usize) -> Vn<'m> {
        let count = self.forces.geometry.turns();
        self.gain(count, |mechanics, by| mechanics.turn(Some(body), by))
    }
}
