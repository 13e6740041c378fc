//! Velocities and accelerations of points and bodies: with respect to inputs or unknowns, and in
//! time at given speeds.

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::{Direction, derivatives::direction, derivatives::partial, scalar};
use crate::forces::context::Mechanics;
use crate::forces::geometry::BodyTurn;
use crate::forces::speeds::By;
use crate::model::Variable;

/// The number of inputs.
pub(super) fn drives(mechanics: &Mechanics<'_, '_>) -> usize {
    mechanics.algebra.mechanism.inputs.len()
}

/// The speed of an input, if it is listed.
pub(super) fn speed<'m>(mechanics: &Mechanics<'_, 'm>, input: usize) -> Option<Ex<'m>> {
    mechanics.question.speeds.speeds[input].map(|argument| mechanics.algebra.input(argument))
}

fn acceleration<'m>(mechanics: &Mechanics<'_, 'm>, input: usize) -> Option<Ex<'m>> {
    mechanics.question.speeds.accelerations[input].map(|argument| mechanics.algebra.input(argument))
}

/// True if anything moves in time.
pub(super) fn moves(mechanics: &Mechanics<'_, '_>) -> bool {
    factors_of_gain(mechanics) > 0
}

/// The derivative of a number.
pub(super) fn slope<'m>(mechanics: &mut Mechanics<'_, 'm>, x: Ex<'m>, by: By) -> Ex<'m> {
    match by {
        By::Input(input) => {
            let variable = mechanics.algebra.variable(Variable::Input(input));
            direction::derivative(mechanics.algebra, x, variable, Direction::Forward)
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
    if let Some(&known) = mechanics.forces.memo.turns.get(&(body, by)) {
        return known;
    }
    let on = mechanics.forces.bodies.tree.parent[body];
    let turn = match mechanics.forces.bodies.geometry.turning[body].clone() {
        BodyTurn::Along => turn(mechanics, on, by),
        BodyTurn::Angle(angle) => {
            let angle = scalar::value_of(mechanics.algebra, &angle);
            Vector([slope(mechanics, angle, by)]).into()
        }
        BodyTurn::About(angle, axis) => {
            let angle = scalar::value_of(mechanics.algebra, &angle);
            let relative = slope(mechanics, angle, by) * axis;
            turn(mechanics, on, by) + relative
        }
        BodyTurn::Frame(axes) => {
            // (y' . z) x + (z' . x) y + (x' . y) z
            (0..3).fold(mechanics.zero_turn(), |sum, k| {
                let [x, y, z] = [k, k + 1, k + 2].map(|k| axes[k % 3]);
                sum + moved(mechanics, y, by).dot(z) * x
            })
        }
        // V x V' / V^2
        BodyTurn::Rod(v) => v.moment_of(moved(mechanics, v, by)) / v.square(),
    };
    mechanics.forces.memo.turns.insert((body, by), turn);
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
    let moved = moved(
        mechanics,
        mechanics.forces.bodies.geometry.origins[number],
        by,
    );
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

/// The number of factors of [`gain`]: accelerations, and products of two speeds.
pub(super) fn factors_of_gain(mechanics: &Mechanics<'_, '_>) -> usize {
    let count = |arguments: &[Option<usize>]| arguments.iter().flatten().count();
    count(&mechanics.question.speeds.accelerations)
        + count(&mechanics.question.speeds.speeds).pow(2)
}

/// The rate of a velocity, given the quantity's derivatives with respect to the inputs:
/// `sum q_ij w_i w_j + sum q_i e_i`.
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

/// The rate of momentum of a mass at the point.
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
    let count = mechanics.forces.bodies.geometry.turns();
    in_time(mechanics, count, |mechanics, by| {
        turn(mechanics, Some(body), by)
    })
}

/// The angular acceleration of a body.
pub(super) fn angular_acceleration<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> Vn<'m> {
    let count = mechanics.forces.bodies.geometry.turns();
    gain(mechanics, count, |mechanics, by| {
        turn(mechanics, Some(body), by)
    })
}
