//! Moments of inertia, and their effects when a body turns.
//!
//! A body with a frame is treated in its own axes, in which its inertia does not change.

use linkage_symbolic::{Ex, Graph, Vector, Vn};

use crate::algebra::{Algebra, Translate};
use crate::forces::geometry::{BodyTurn, Geometry};
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, By, Speeds};
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
pub(super) fn inertia_couple<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    body: usize,
) -> Option<Vn<'m>> {
    if algebra.mechanism.bodies[body].inertias.is_empty() {
        return None;
    }
    let turned = turned(algebra, bodies, turns, speeds, body);
    let couple = inertia_times(algebra, &bodies.geometry, body, turned.axes, turned.gain);
    if bodies.geometry.is_plane() {
        return Some(couple);
    }
    let momentum = inertia_times(
        algebra,
        &bodies.geometry,
        body,
        turned.axes,
        turned.velocity,
    );
    let couple = couple + turned.velocity.moment_of(momentum);
    Some(match &turned.axes {
        Some(axes) => out_of_axes(algebra.graph, axes, couple),
        None => couple,
    })
}

/// Twice the energy of a body's turning beyond that of its masses as points: `omega . I omega`.
pub(super) fn twice_turning_energy<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    body: usize,
) -> Ex<'m> {
    if algebra.mechanism.bodies[body].inertias.is_empty() {
        return algebra.zero();
    }
    let turned = turned(algebra, bodies, turns, speeds, body);
    let momentum = inertia_times(
        algebra,
        &bodies.geometry,
        body,
        turned.axes,
        turned.velocity,
    );
    turned.velocity.dot(momentum)
}

/// `w_a . I w_b` of a body beyond its masses as points, for its angular velocities at unit speeds of
/// two inputs.
pub(super) fn turning_inertia<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    body: usize,
    inputs: [By; 2],
) -> Ex<'m> {
    if algebra.mechanism.bodies[body].inertias.is_empty() {
        return algebra.zero();
    }
    let axes = axes(&bodies.geometry, body);
    let [first, second] = inputs.map(|by| match axes {
        Some(axes) => components_of_turn(axes, |y| motion::moved(algebra, y, by)),
        None => motion::turn(algebra, bodies, turns, Some(body), by),
    });
    first.dot(inertia_times(algebra, &bodies.geometry, body, axes, second))
}

/// The axes of a body with a frame.
fn axes<'m>(geometry: &Geometry<'m>, body: usize) -> Option<[Vn<'m>; 3]> {
    match geometry.turning[body] {
        BodyTurn::Frame(axes) => Some(axes),
        BodyTurn::Along | BodyTurn::Angle(_) | BodyTurn::About(..) | BodyTurn::Rod(_) => None,
    }
}

/// Components of an angular velocity in a body's axes, from the rates of the axes: `w_x = y' . z`
/// and so on.
fn components_of_turn<'m>(axes: [Vn<'m>; 3], mut rate: impl FnMut(Vn<'m>) -> Vn<'m>) -> Vn<'m> {
    let components = [0, 1, 2].map(|k| {
        let [y, z] = [k + 1, k + 2].map(|k| axes[k % 3]);
        rate(y).dot(z)
    });
    Vector(components).into()
}

/// The rotation of a body at the speeds that are listed.
fn turned<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    body: usize,
) -> Turned<'m> {
    match bodies.geometry.turning[body] {
        BodyTurn::Frame(axes) => turned_in_axes(algebra, speeds, axes),
        BodyTurn::Rod(along) => turned_rod(algebra, bodies, turns, speeds, body, along),
        BodyTurn::Along | BodyTurn::Angle(_) | BodyTurn::About(..) => Turned {
            gain: motion::angular_acceleration(algebra, bodies, turns, speeds, body),
            velocity: motion::angular_velocity(algebra, bodies, turns, speeds, body),
            axes: None,
        },
    }
}

/// Components of the angular velocity, and their gain: `y" . z - w_y w_z` and so on.
fn turned_in_axes<'m>(algebra: &mut Algebra<'m>, speeds: &Speeds, axes: [Vn<'m>; 3]) -> Turned<'m> {
    let velocity = components_of_turn(axes, |y| motion::point_velocity(algebra, speeds, y));
    let gain = [0, 1, 2].map(|k| {
        let [y, z] = [k + 1, k + 2].map(|k| axes[k % 3]);
        let [w_y, w_z] = [k + 1, k + 2].map(|k| velocity.at(k % 3));
        motion::point_acceleration(algebra, speeds, y).dot(z) - w_y * w_z
    });
    Turned {
        axes: Some(axes),
        velocity,
        gain: Vector(gain).into(),
    }
}

/// `w`, and `(V x V" - 2 (V . V') w) / V^2`, where a rod that keeps its length has no second term.
fn turned_rod<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    body: usize,
    v: Vn<'m>,
) -> Turned<'m> {
    let velocity = motion::angular_velocity(algebra, bodies, turns, speeds, body);
    let mut across = v.moment_of(motion::point_acceleration(algebra, speeds, v));
    if !bodies.facts.rigid_rods.contains(&body) {
        let moved = motion::point_velocity(algebra, speeds, v);
        across = across - (2.0 * v.dot(moved)) * velocity;
    }
    Turned {
        axes: None,
        velocity,
        gain: across / v.square(),
    }
}

/// `a x + b y + c z`
fn out_of_axes<'m>(graph: &'m Graph, axes: &[Vn<'m>; 3], vector: Vn<'m>) -> Vn<'m> {
    let pairs = vector.iter().zip(axes);
    pairs.fold(graph.zeros(3), |sum, (along, &axis)| sum + along * axis)
}

/// A body's inertia, without that of its masses as points, times a turn.
pub(super) fn inertia_times<'m>(
    algebra: &mut Algebra<'m>,
    geometry: &Geometry<'m>,
    body: usize,
    axes: Option<[Vn<'m>; 3]>,
    turn: Vn<'m>,
) -> Vn<'m> {
    let mechanism = algebra.mechanism;
    let mut sum = geometry.zero_turn(algebra.graph);
    for (inertia, about) in &mechanism.bodies[body].inertias {
        let whole = match inertia {
            Inertia::Scalar(inertia) => scalar_inertia(algebra, geometry, body, inertia, turn),
            Inertia::Tensor(rows) => tensor_inertia(algebra, rows, turn),
        };
        sum = sum + whole;
        let Some(about) = about else { continue };
        let points = match (inertia, geometry.axis(body)) {
            // The number says nothing of the masses' products of inertia.
            (Inertia::Scalar(_), Some(axis)) => {
                let turn = turn.along(axis);
                points_about(algebra, geometry, body, about, axes, turn).along(axis)
            }
            (Inertia::Scalar(_), None) | (Inertia::Tensor(_), _) => {
                points_about(algebra, geometry, body, about, axes, turn)
            }
        };
        sum = sum - points;
    }
    sum
}

/// The inertia of the masses as points about a point, times a turn: `sum m r^2 w`, in space
/// `sum m r x (w x r)`.
fn points_about<'m>(
    algebra: &mut Algebra<'m>,
    geometry: &Geometry<'m>,
    body: usize,
    about: &Expr,
    axes: Option<[Vn<'m>; 3]>,
    turn: Vn<'m>,
) -> Vn<'m> {
    let about = geometry::vector_of(algebra, about);
    let mut sum = geometry.zero_turn(algebra.graph);
    for (mass, point) in masses::masses(algebra, body) {
        let arm = point - about;
        let arm = match axes {
            Some(axes) => Vector(axes.map(|axis| axis.dot(arm))).into(),
            None => arm,
        };
        let part = if geometry.is_plane() {
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
    algebra: &mut Algebra<'m>,
    geometry: &Geometry<'m>,
    body: usize,
    inertia: &Expr,
    turn: Vn<'m>,
) -> Vn<'m> {
    let inertia = algebra.translate_number(inertia);
    match geometry.axis(body) {
        Some(axis) => inertia * turn.along(axis),
        None => inertia * turn,
    }
}

/// In the axes of the body's frame.
fn tensor_inertia<'m>(algebra: &mut Algebra<'m>, rows: &[[Expr; 3]; 3], turn: Vn<'m>) -> Vn<'m> {
    let rows = rows.each_ref().map(|row| {
        let row = row.each_ref().map(|x| algebra.translate_number(x));
        Vn::from(Vector(row)).dot(turn)
    });
    Vector(rows).into()
}
