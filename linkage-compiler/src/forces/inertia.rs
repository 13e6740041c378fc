//! Moments of inertia, and their effects when a body turns.
//!
//! A body with a frame is treated in its own axes, in which its inertia does not change.

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::Translate;
use crate::forces::context::Mechanics;
use crate::forces::geometry::BodyTurn;
use crate::forces::{geometry, masses, motion};
use crate::model::{Expr, Inertia};

/// The rotation of a body: the angular velocity and its rate, in the body's own axes if it has any.
struct Turned<'m> {
    axes: Option<[Vn<'m>; 3]>,
    velocity: Vn<'m>,
    gain: Vn<'m>,
}

/// The rate of a body's moment of momentum beyond that of its masses as points: `I alpha`, in space
/// `I alpha + omega x I omega`.
pub(super) fn inertia_couple<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> Option<Vn<'m>> {
    if mechanics.algebra.mechanism.bodies[body].inertias.is_empty() {
        return None;
    }
    let turned = turned(mechanics, body);
    let couple = inertia_times(mechanics, body, &turned, turned.gain);
    if mechanics.forces.bodies.geometry.is_plane() {
        return Some(couple);
    }
    let momentum = inertia_times(mechanics, body, &turned, turned.velocity);
    let couple = couple + turned.velocity.moment_of(momentum);
    Some(match &turned.axes {
        Some(axes) => out_of_axes(mechanics, axes, couple),
        None => couple,
    })
}

/// Twice the energy of a body's turning beyond that of its masses as points: `omega . I omega`.
pub(super) fn twice_turning_energy<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> Ex<'m> {
    if mechanics.algebra.mechanism.bodies[body].inertias.is_empty() {
        return mechanics.algebra.zero();
    }
    let turned = turned(mechanics, body);
    let momentum = inertia_times(mechanics, body, &turned, turned.velocity);
    turned.velocity.dot(momentum)
}

/// The rotation of a body at the speeds that are listed.
fn turned<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> Turned<'m> {
    match mechanics.forces.bodies.geometry.turning[body] {
        BodyTurn::Frame(axes) => turned_in_axes(mechanics, axes),
        BodyTurn::Rod(along) => turned_rod(mechanics, body, along),
        BodyTurn::Along | BodyTurn::Angle(_) | BodyTurn::About(..) => Turned {
            gain: motion::angular_acceleration(mechanics, body),
            velocity: motion::angular_velocity(mechanics, body),
            axes: None,
        },
    }
}

/// Components `w_x = y' . z` and so on, and their gain: `y" . z - w_y w_z` and so on.
fn turned_in_axes<'m>(mechanics: &mut Mechanics<'_, 'm>, axes: [Vn<'m>; 3]) -> Turned<'m> {
    let velocity = [0, 1, 2].map(|k| {
        let [y, z] = [k + 1, k + 2].map(|k| axes[k % 3]);
        motion::point_velocity(mechanics, y).dot(z)
    });
    let gain = [0, 1, 2].map(|k| {
        let [y, z] = [k + 1, k + 2].map(|k| axes[k % 3]);
        let [w_y, w_z] = [k + 1, k + 2].map(|k| velocity[k % 3]);
        motion::point_acceleration(mechanics, y).dot(z) - w_y * w_z
    });
    Turned {
        axes: Some(axes),
        velocity: Vector(velocity).into(),
        gain: Vector(gain).into(),
    }
}

/// `w`, and `(V x V" - 2 (V . V') w) / V^2`, where a rod that keeps its length has no second term.
fn turned_rod<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize, v: Vn<'m>) -> Turned<'m> {
    let velocity = motion::angular_velocity(mechanics, body);
    let mut across = v.moment_of(motion::point_acceleration(mechanics, v));
    if !mechanics.forces.bodies.facts.rigid_rods.contains(&body) {
        let moved = motion::point_velocity(mechanics, v);
        across = across - (2.0 * v.dot(moved)) * velocity;
    }
    Turned {
        axes: None,
        velocity,
        gain: across / v.square(),
    }
}

/// `a x + b y + c z`
fn out_of_axes<'m>(mechanics: &Mechanics<'_, 'm>, axes: &[Vn<'m>; 3], vector: Vn<'m>) -> Vn<'m> {
    let pairs = vector.iter().zip(axes);
    pairs.fold(mechanics.zero_turn(), |sum, (along, &axis)| {
        sum + along * axis
    })
}

/// A body's inertia, without that of its masses as points, times a turn.
fn inertia_times<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    body: usize,
    turned: &Turned<'m>,
    turn: Vn<'m>,
) -> Vn<'m> {
    let mechanism = mechanics.algebra.mechanism;
    let mut sum = mechanics.zero_turn();
    for (inertia, about) in &mechanism.bodies[body].inertias {
        let whole = match inertia {
            Inertia::Scalar(inertia) => scalar_inertia(mechanics, body, inertia, turn),
            Inertia::Tensor(rows) => tensor_inertia(mechanics, rows, turn),
        };
        sum = sum + whole;
        let Some(about) = about else { continue };
        let points = match (inertia, mechanics.forces.bodies.geometry.axis(body)) {
            // The number says nothing of the masses' products of inertia.
            (Inertia::Scalar(_), Some(axis)) => {
                let turn = turn.along(axis);
                points_about(mechanics, body, about, turned, turn).along(axis)
            }
            (Inertia::Scalar(_), None) | (Inertia::Tensor(_), _) => {
                points_about(mechanics, body, about, turned, turn)
            }
        };
        sum = sum - points;
    }
    sum
}

/// The inertia of the masses as points about a point, times a turn: `sum m r^2 w`, in space
/// `sum m r x (w x r)`.
fn points_about<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    body: usize,
    about: &Expr,
    turned: &Turned<'m>,
    turn: Vn<'m>,
) -> Vn<'m> {
    let about = geometry::vector_of(mechanics.algebra, about);
    let mut sum = mechanics.zero_turn();
    for (mass, point) in masses::masses(mechanics.algebra, body) {
        let arm = point - about;
        let arm = match turned.axes {
            Some(axes) => Vector(axes.map(|axis| axis.dot(arm))).into(),
            None => arm,
        };
        let part = if mechanics.forces.bodies.geometry.is_plane() {
            arm.square() * turn
        } else {
            arm.moment_of(turn.sweeping(arm))
        };
        sum = sum + mass * part;
    }
    sum
}

/// In space a scalar is that of a sphere, of a rod across its line, or about the axis of a body
/// that turns about one.
fn scalar_inertia<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    body: usize,
    inertia: &Expr,
    turn: Vn<'m>,
) -> Vn<'m> {
    let inertia = mechanics.algebra.translate_number(inertia);
    match mechanics.forces.bodies.geometry.axis(body) {
        Some(axis) => inertia * turn.along(axis),
        None => inertia * turn,
    }
}

/// In the axes of the body's frame.
fn tensor_inertia<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    rows: &[[Expr; 3]; 3],
    turn: Vn<'m>,
) -> Vn<'m> {
    let rows = rows.each_ref().map(|row| {
        let row = row
            .each_ref()
            .map(|x| mechanics.algebra.translate_number(x));
        Vn::from(Vector(row)).dot(turn)
    });
    Vector(rows).into()
}
