//! How points and bodies move: by each input or unknown, and in time at given speeds.

use crate::algebra::adjoint;
use crate::algebra::partial;
use crate::algebra::scalar;
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

/// How many inputs there are.
pub(super) fn drives(mechanics: &Mechanics<'_, '_>) -> usize {
    mechanics.algebra.mechanism.inputs.len()
}

/// The speed of an input, if it is listed.
pub(super) fn speed<'m>(mechanics: &Mechanics<'_, 'm>, input: usize) -> Option<Ex<'m>> {
    mechanics.speeds.speeds[input].map(|place| mechanics.algebra.input(place))
}

fn acceleration<'m>(mechanics: &Mechanics<'_, 'm>, input: usize) -> Option<Ex<'m>> {
    mechanics.speeds.accelerations[input].map(|place| mechanics.algebra.input(place))
}

/// Whether anything moves in time.
pub(super) fn moves(mechanics: &Mechanics<'_, '_>) -> bool {
    factors_of_gain(mechanics) > 0
}

/// The derivative of a number.
pub(super) fn slope<'m>(mechanics: &mut Mechanics<'_, 'm>, x: Ex<'m>, by: By) -> Ex<'m> {
    match by {
        By::Input(input) => {
            let variable = mechanics.algebra.variable(Variable::Input(input));
            adjoint::derivative(mechanics.algebra, x, variable, Direction::Forward)
        }
        By::Alone(variable) => partial::partial(mechanics.algebra, x, variable),
    }
}

/// The derivative of a point or vector that is part of the motion.
pub(super) fn moved<'m>(mechanics: &mut Mechanics<'_, 'm>, v: Vn<'m>, by: By) -> Vn<'m> {
    v.map(|x| slope(mechanics, x, by))
}

/// The angular velocity of a body; the frame does not turn.
pub(super) fn turn<'m>(mechanics: &mut Mechanics<'_, 'm>, body: Option<usize>, by: By) -> Vn<'m> {
    let Some(body) = body else {
        return mechanics.zero_turn();
    };
    if let Some(&known) = mechanics.forces.motion.turns.get(&(body, by)) {
        return known;
    }
    let on = mechanics.forces.tree.parent[body];
    let turn = match mechanics.forces.geometry.turning[body].clone() {
        Turning::Along => turn(mechanics, on, by),
        Turning::Angle(angle) => {
            let angle = scalar::value_of(mechanics.algebra, &angle);
            Vector([slope(mechanics, angle, by)]).into()
        }
        Turning::About(angle, axis) => {
            let angle = scalar::value_of(mechanics.algebra, &angle);
            let own = slope(mechanics, angle, by) * axis;
            turn(mechanics, on, by) + own
        }
        Turning::Frame(axes) => {
            // (y' . z) x + (z' . x) y + (x' . y) z
            (0..3).fold(mechanics.zero_turn(), |sum, k| {
                let [x, y, z] = [k, k + 1, k + 2].map(|k| axes[k % 3]);
                sum + moved(mechanics, y, by).dot(z) * x
            })
        }
        // V x V' / V^2
        Turning::Rod(v) => v.moment_of(moved(mechanics, v, by)) / v.square(),
    };
    mechanics.forces.motion.turns.insert((body, by), turn);
    turn
}

/// The velocity of a body's point: `O' + w x (P - O)`.
pub(super) fn velocity_of<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    body: Option<usize>,
    point: Vn<'m>,
    by: By,
) -> Vn<'m> {
    let Some(number) = body else {
        return mechanics.graph().zeros(point.len());
    };
    let moved = moved(mechanics, mechanics.forces.geometry.origins[number], by);
    let arm = mechanics.arm(number, point);
    moved + turn(mechanics, body, by).sweeping(arm)
}

/// Derivatives by the inputs times their speeds: `sum q_i w_i`.
pub(super) fn in_time<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    count: usize,
    mut derivative: impl FnMut(&mut Mechanics<'_, 'm>, By) -> Vn<'m>,
) -> Vn<'m> {
    let zero = mechanics.graph().zeros(count);
    (0..drives(mechanics)).fold(zero, |sum, input| match speed(mechanics, input) {
        None => sum,
        Some(speed) => sum + speed * derivative(mechanics, By::Input(input)),
    })
}

/// How many factors [`gain`](Self::gain) has: accelerations, and products of two speeds.
pub(super) fn factors_of_gain(mechanics: &Mechanics<'_, '_>) -> usize {
    let of = |all: &[Option<usize>]| all.iter().flatten().count();
    of(&mechanics.speeds.accelerations) + of(&mechanics.speeds.speeds).pow(2)
}

/// What a quantity, whose derivatives by the inputs are given, gains in speed: `sum q_ij w_i w_j + sum q_i e_i`.
pub(super) fn gain<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    count: usize,
    derivative: impl FnMut(&mut Mechanics<'_, 'm>, By) -> Vn<'m>,
) -> Vn<'m> {
    let one = mechanics.algebra.one();
    gain_times(mechanics, one, count, derivative)
}

/// The same times a number, which goes to the speeds.
fn gain_times<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    factor: Ex<'m>,
    count: usize,
    mut derivative: impl FnMut(&mut Mechanics<'_, 'm>, By) -> Vn<'m>,
) -> Vn<'m> {
    let mut sum = mechanics.graph().zeros(count);
    for i in 0..drives(mechanics) {
        let (first_speed, second_rate) = (speed(mechanics, i), acceleration(mechanics, i));
        if first_speed.is_none() && second_rate.is_none() {
            continue;
        }
        let first = derivative(mechanics, By::Input(i));
        if let Some(acceleration) = second_rate {
            sum = sum + (factor * acceleration) * first;
        }
        let Some(first_speed) = first_speed else {
            continue;
        };
        for j in 0..drives(mechanics) {
            let Some(other) = speed(mechanics, j) else {
                continue;
            };
            let second = moved(mechanics, first, By::Input(j));
            sum = sum + (factor * (first_speed * other)) * second;
        }
    }
    sum
}

/// The velocity of a point that is part of the motion, in time.
pub(super) fn point_velocity<'m>(mechanics: &mut Mechanics<'_, 'm>, point: Vn<'m>) -> Vn<'m> {
    in_time(mechanics, point.len(), |mechanics, by| {
        moved(mechanics, point, by)
    })
}

/// Its acceleration.
pub(super) fn point_acceleration<'m>(mechanics: &mut Mechanics<'_, 'm>, point: Vn<'m>) -> Vn<'m> {
    gain(mechanics, point.len(), |mechanics, by| {
        moved(mechanics, point, by)
    })
}

/// What a mass at it gains in momentum.
pub(super) fn point_momentum_gain<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    mass: Ex<'m>,
    point: Vn<'m>,
) -> Vn<'m> {
    let moved = |mechanics: &mut Mechanics<'_, 'm>, by| moved(mechanics, point, by);
    gain_times(mechanics, mass, point.len(), moved)
}

/// The angular velocity of a body, in time.
pub(super) fn angular_velocity<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> Vn<'m> {
    let count = mechanics.forces.geometry.turns();
    in_time(mechanics, count, |mechanics, by| {
        turn(mechanics, Some(body), by)
    })
}

/// What it gains.
pub(super) fn angular_acceleration<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> Vn<'m> {
    let count = mechanics.forces.geometry.turns();
    gain(mechanics, count, |mechanics, by| {
        turn(mechanics, Some(body), by)
    })
}
