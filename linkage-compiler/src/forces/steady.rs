//! Facts about the motion that only numbers show: joints that move at a steady rate, rods that keep
//! their length.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::Algebra;
use crate::forces::joint_motion::JointMotion;
use crate::forces::multibody::{Multibody, NumericFacts};
use crate::forces::positions::{EQUAL, Positions, SLOW};
use crate::forces::speeds::{AngularVelocities, By};
use crate::forces::{freedom, motion};
use crate::model::{Mechanism, Rotation};

/// Finds the facts at some positions; those that do not close count for nothing.
pub(super) fn steady_motion<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    positions: &Positions,
) -> NumericFacts {
    let mut facts = NumericFacts::default();
    for body in 0..algebra.mechanism.bodies.len() {
        for way in freedom::ways(algebra.mechanism, algebra.graph, &bodies.geometry, body) {
            record_rate(algebra, bodies, turns, &mut facts, &way, positions);
        }
        if let Some(along) = bodies.geometry.rod(body)
            && keeps_its_length(algebra, along, positions)
        {
            facts.rigid_rods.push(body);
        }
    }
    facts
}

/// Records that a body moves at a steady rate in its joint, or that it rests there.
fn record_rate<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    facts: &mut NumericFacts,
    way: &JointMotion<'m>,
    positions: &Positions,
) {
    let drives = 0..algebra.mechanism.inputs.len();
    let rates: Vec<Ex> = drives
        .map(|input| freedom::relative_rate(algebra, bodies, turns, way, By::Input(input)))
        .collect();
    let rates = positions.numbers(&rates);
    let moves = rates.iter().flatten().any(|rate| rate.abs() > EQUAL);
    let way = (way.body, way.slides);
    if moves && all_alike(&rates) {
        facts.steady.push(way);
    }
    if !moves && !rates.is_empty() && !hangs_freely(algebra.mechanism, way.0) {
        facts.still.push(way);
    }
}

/// True if a body's own joint lets it turn in every way: which of them rest says nothing of the
/// others.
fn hangs_freely(mechanism: &Mechanism, body: usize) -> bool {
    let joint = &mechanism.joints[mechanism.bodies[body].joint];
    joint.kind.rotation() == Rotation::Freely
}

/// True if `(V^2)'` is nothing beside `V^2`.
fn keeps_its_length<'m>(algebra: &mut Algebra<'m>, along: Vn<'m>, positions: &Positions) -> bool {
    let square = along.square();
    let mut numbers = vec![square];
    numbers.extend(
        (0..algebra.mechanism.inputs.len())
            .map(|input| motion::slope(algebra, square, By::Input(input))),
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
