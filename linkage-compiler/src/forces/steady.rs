//! Facts about the motion that only numbers show: joints that move at a steady rate, rods that keep
//! their length.

use linkage_symbolic::{Ex, Vn};

use crate::forces::context::Mechanics;
use crate::forces::joint_motion::JointMotion;
use crate::forces::positions::{EQUAL, Positions, SLOW};
use crate::forces::speeds::By;
use crate::forces::{freedom, motion};
use crate::model::Rotation;

/// Looks at some positions; those that do not close count for nothing.
pub(super) fn record_steady_motion(mechanics: &mut Mechanics<'_, '_>, positions: &Positions) {
    for body in 0..mechanics.algebra.mechanism.bodies.len() {
        for way in freedom::ways(mechanics, body) {
            record_rate(mechanics, &way, positions);
        }
        if let Some(along) = mechanics.forces.bodies.geometry.rod(body)
            && keeps_its_length(mechanics, along, positions)
        {
            mechanics.forces.bodies.facts.rigid_rods.push(body);
        }
    }
}

/// True if a body moves in its own joint, and at a steady rate.
fn record_rate<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    way: &JointMotion<'m>,
    positions: &Positions,
) {
    let drives = 0..motion::drives(mechanics);
    let rates: Vec<Ex> = drives
        .map(|input| freedom::relative_rate(mechanics, way, By::Input(input)))
        .collect();
    let rates = positions.numbers(&rates);
    let moves = rates.iter().flatten().any(|rate| rate.abs() > EQUAL);
    let way = (way.body, way.slides);
    if moves && all_alike(&rates) {
        mechanics.forces.bodies.facts.steady.push(way);
    }
    if !moves && !rates.is_empty() && !hangs_freely(mechanics, way.0) {
        mechanics.forces.bodies.facts.still.push(way);
    }
}

/// True if a body's own joint lets it turn in every way: which of them rest says nothing of the
/// others.
fn hangs_freely(mechanics: &Mechanics<'_, '_>, body: usize) -> bool {
    let mechanism = mechanics.algebra.mechanism;
    let joint = &mechanism.joints[mechanism.bodies[body].joint];
    joint.kind.rotation() == Rotation::Freely
}

/// True if `(V^2)'` is nothing beside `V^2`.
fn keeps_its_length<'m>(
    mechanics: &mut Mechanics<'_, 'm>,
    along: Vn<'m>,
    positions: &Positions,
) -> bool {
    let square = along.square();
    let mut numbers = vec![square];
    numbers.extend(
        (0..motion::drives(mechanics))
            .map(|input| motion::slope(mechanics, square, By::Input(input))),
    );
    let keeps = |numbers: &Vec<f64>| {
        let (square, slopes) = (numbers[0], &numbers[1..]);
        slopes.iter().all(|slope| slope.abs() < EQUAL * square)
    };
    let numbers = positions.numbers(&numbers);
    !numbers.is_empty() && numbers.iter().all(keeps)
}

/// True if there are several and they do not differ.
fn all_alike(rates: &[Vec<f64>]) -> bool {
    let Some((first, others)) = rates.split_first() else {
        return false;
    };
    let like = |(a, b): (&f64, &f64)| (a - b).abs() <= EQUAL * b.abs().max(SLOW);
    !others.is_empty() && others.iter().all(|rates| rates.iter().zip(first).all(like))
}
