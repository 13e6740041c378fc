//! Velocities and accelerations of points and bodies: with respect to inputs or unknowns, and in
//! time at given speeds.

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::{Algebra, Direction, derivatives::direction, derivatives::partial, scalar};
use crate::forces::geometry::BodyTurn;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, By, Rate, Speeds};
use crate::model::Variable;

/// The speed of an input, if it is listed.
pub(super) fn speed<'m>(algebra: &Algebra<'m>, speeds: &Speeds, input: usize) -> Option<Ex<'m>> {
    speeds.speeds[input].map(|speed| value(algebra, speed))
}

fn acceleration<'m>(algebra: &Algebra<'m>, speeds: &Speeds, input: usize) -> Option<Ex<'m>> {
    speeds.accelerations[input].map(|acceleration| value(algebra, acceleration))
}

fn value<'m>(algebra: &Algebra<'m>, rate: Rate) -> Ex<'m> {
    match rate {
        Rate::Listed(argument) => algebra.input(argument),
        Rate::Unit => algebra.one(),
    }
}

/// True if anything moves in time.
pub(super) fn moves(speeds: &Speeds) -> bool {
    factors_of_gain(speeds) > 0
}

/// The derivative of a number.
pub(super) fn slope<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>, by: By) -> Ex<'m> {
    match by {
        By::Input(input) => {
            let variable = algebra.variable(Variable::Input(input));
            direction::derivative(algebra, x, variable, Direction::Forward)
        }
        By::Alone(variable) => partial::partial(algebra, x, variable),
    }
}

/// The derivative of a point or vector that is part of the motion.
pub(super) fn moved<'m>(algebra: &mut Algebra<'m>, v: Vn<'m>, by: By) -> Vn<'m> {
    v.map(|x| slope(algebra, x, by))
}

/// The angular velocity of a body; the frame does not turn.
pub(super) fn turn<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    body: Option<usize>,
    by: By,
) -> Vn<'m> {
    let Some(body) = body else {
        return bodies.geometry.zero_turn(algebra.graph);
    };
    if let Some(&known) = turns.get(&(body, by)) {
        return known;
    }
    let on = bodies.tree.parent[body];
    let turn = match bodies.geometry.turning[body].clone() {
        BodyTurn::Along => turn(algebra, bodies, turns, on, by),
        BodyTurn::Angle(angle) => {
            let angle = scalar::value_of(&algebra.names, &angle);
            Vector([slope(algebra, angle, by)]).into()
        }
        BodyTurn::About(angle, axis) => {
            let angle = scalar::value_of(&algebra.names, &angle);
            let relative = slope(algebra, angle, by) * axis;
            turn(algebra, bodies, turns, on, by) + relative
        }
        BodyTurn::Frame(axes) => {
            // (y' . z) x + (z' . x) y + (x' . y) z
            (0..3).fold(bodies.geometry.zero_turn(algebra.graph), |sum, k| {
                let [x, y, z] = [k, k + 1, k + 2].map(|k| axes[k % 3]);
                sum + moved(algebra, y, by).dot(z) * x
            })
        }
        // V x V' / V^2
        BodyTurn::Rod(v) => v.moment_of(moved(algebra, v, by)) / v.square(),
    };
    turns.insert((body, by), turn);
    turn
}

/// The velocity of a body's point: `O' + w x (P - O)`.
pub(super) fn velocity_of<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    body: Option<usize>,
    point: Vn<'m>,
    by: By,
) -> Vn<'m> {
    let Some(number) = body else {
        return algebra.graph.zeros(point.len());
    };
    let moved = moved(algebra, bodies.geometry.origins[number], by);
    let arm = bodies.arm(number, point);
    moved + turn(algebra, bodies, turns, body, by).sweeping(arm)
}

/// Derivatives by the inputs times their speeds: `sum q_i w_i`.
pub(super) fn in_time<'m>(
    algebra: &mut Algebra<'m>,
    speeds: &Speeds,
    count: usize,
    mut derivative: impl FnMut(&mut Algebra<'m>, By) -> Vn<'m>,
) -> Vn<'m> {
    let zero = algebra.graph.zeros(count);
    (0..algebra.mechanism.inputs.len()).fold(zero, |sum, input| {
        match speed(algebra, speeds, input) {
            None => sum,
            Some(speed) => sum + speed * derivative(algebra, By::Input(input)),
        }
    })
}

/// The number of factors of [`gain`]: accelerations, and products of two speeds.
pub(super) fn factors_of_gain(speeds: &Speeds) -> usize {
    let products = speeds.speeds.iter().flatten().count().pow(2);
    products + speeds.accelerations.iter().flatten().count()
}

/// The rate of a velocity, given the quantity's derivatives with respect to the inputs:
/// `sum q_ij w_i w_j + sum q_i e_i`.
pub(super) fn gain<'m>(
    algebra: &mut Algebra<'m>,
    speeds: &Speeds,
    count: usize,
    derivative: impl FnMut(&mut Algebra<'m>, By) -> Vn<'m>,
) -> Vn<'m> {
    let one = algebra.one();
    gain_times(algebra, speeds, one, count, derivative)
}

/// The same times a number, which goes to the speeds.
fn gain_times<'m>(
    algebra: &mut Algebra<'m>,
    speeds: &Speeds,
    factor: Ex<'m>,
    count: usize,
    mut derivative: impl FnMut(&mut Algebra<'m>, By) -> Vn<'m>,
) -> Vn<'m> {
    let mut sum = algebra.graph.zeros(count);
    for i in 0..algebra.mechanism.inputs.len() {
        let (first_speed, second_rate) =
            (speed(algebra, speeds, i), acceleration(algebra, speeds, i));
        if first_speed.is_none() && second_rate.is_none() {
            continue;
        }
        let first = derivative(algebra, By::Input(i));
        if let Some(acceleration) = second_rate {
            sum = sum + (factor * acceleration) * first;
        }
        let Some(first_speed) = first_speed else {
            continue;
        };
        for j in 0..algebra.mechanism.inputs.len() {
            let Some(other) = speed(algebra, speeds, j) else {
                continue;
            };
            let second = moved(algebra, first, By::Input(j));
            sum = sum + (factor * (first_speed * other)) * second;
        }
    }
    sum
}

/// The velocity of a point that is part of the motion, in time.
pub(super) fn point_velocity<'m>(
    algebra: &mut Algebra<'m>,
    speeds: &Speeds,
    point: Vn<'m>,
) -> Vn<'m> {
    in_time(algebra, speeds, point.len(), |algebra, by| {
        moved(algebra, point, by)
    })
}

/// Its acceleration.
pub(super) fn point_acceleration<'m>(
    algebra: &mut Algebra<'m>,
    speeds: &Speeds,
    point: Vn<'m>,
) -> Vn<'m> {
    gain(algebra, speeds, point.len(), |algebra, by| {
        moved(algebra, point, by)
    })
}

/// The rate of momentum of a mass at the point.
pub(super) fn point_momentum_gain<'m>(
    algebra: &mut Algebra<'m>,
    speeds: &Speeds,
    mass: Ex<'m>,
    point: Vn<'m>,
) -> Vn<'m> {
    let moved = |algebra: &mut Algebra<'m>, by| moved(algebra, point, by);
    gain_times(algebra, speeds, mass, point.len(), moved)
}

/// The angular velocity of a body, in time.
pub(super) fn angular_velocity<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    body: usize,
) -> Vn<'m> {
    let count = bodies.geometry.turns();
    in_time(algebra, speeds, count, |algebra, by| {
        turn(algebra, bodies, turns, Some(body), by)
    })
}

/// The angular acceleration of a body.
pub(super) fn angular_acceleration<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    body: usize,
) -> Vn<'m> {
    let count = bodies.geometry.turns();
    gain(algebra, speeds, count, |algebra, by| {
        turn(algebra, bodies, turns, Some(body), by)
    })
}
