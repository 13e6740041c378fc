//! The equation of motion `M q" + h = Q` of the inputs, by virtual work.
//!
//! `M` is the mass matrix, `h` the bias of velocities and weights, `Q` the generalised forces of the
//! declared loads. A drive holds the rest: `torque = M q" + h - Q`.

use std::rc::Rc;

use linkage_symbolic::Ex;

use crate::algebra::{Algebra, positive_definite};
use crate::forces::body_loads::Loads;
use crate::forces::context::Memo;
use crate::forces::loading::{LoadSet, Loading};
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, By, Speeds};
use crate::forces::{
    contact_forces, contacts, fixed_pins, friction, inertia, loads, masses, motion, virtual_work,
};

/// An entry of the mass matrix: `sum m p_a . p_b + sum w_a . I w_b`, with velocities at unit speeds
/// of the inputs.
pub(super) fn inertia<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    mut inputs: [usize; 2],
) -> Ex<'m> {
    // The matrix is symmetric.
    inputs.sort_unstable();
    if let Some(&known) = memo.inertias.get(&inputs) {
        return known;
    }
    let by = inputs.map(By::Input);
    let turns = &mut memo.turns;
    let mut sum = algebra.zero();
    for body in 0..algebra.mechanism.bodies.len() {
        if let Some(inertia) = fixed_pins::inertia_about_pin(algebra, bodies, body) {
            let [first, second] = by.map(|by| motion::turn(algebra, bodies, turns, Some(body), by));
            sum += inertia * first.dot(second);
            continue;
        }
        for (mass, point) in masses::masses(algebra, body) {
            let [first, second] = by.map(|by| motion::moved(algebra, point, by));
            sum += mass * first.dot(second);
        }
        sum += inertia::turning_inertia(algebra, bodies, turns, body, by);
    }
    memo.inertias.insert(inputs, sum);
    sum
}

/// The drive of an input for velocities and weights, at zero acceleration and without loads.
pub(super) fn bias<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
    input: usize,
) -> Ex<'m> {
    let turns = &mut memo.turns;
    let by = By::Input(input);
    let velocities = match speeds.single() {
        None => inertial_work(algebra, bodies, turns, &speeds.steady(), by),
        Some((drive, unit)) => {
            let speed = motion::speed(algebra, speeds, drive);
            let speed = speed.expect("the drive has a speed");
            inertial_work(algebra, bodies, turns, &unit, by) * speed.square()
        }
    };
    velocities - weight_work(algebra, by)
}

/// The work against inertia forces per motion of an input: `sum m a . p_a + sum M . w_a`.
fn inertial_work<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    by: By,
) -> Ex<'m> {
    let mut sum = algebra.zero();
    if !motion::moves(speeds) {
        return sum;
    }
    for body in 0..algebra.mechanism.bodies.len() {
        let turn = motion::turn(algebra, bodies, turns, Some(body), by);
        if let Some(inertia) = fixed_pins::inertia_about_pin(algebra, bodies, body) {
            let gain = motion::angular_acceleration(algebra, bodies, turns, speeds, body);
            sum += inertia * gain.dot(turn);
            continue;
        }
        for (mass, point) in masses::masses(algebra, body) {
            let acceleration = motion::point_acceleration(algebra, speeds, point);
            sum += mass * acceleration.dot(motion::moved(algebra, point, by));
        }
        if let Some(couple) = inertia::inertia_couple(algebra, bodies, turns, speeds, body) {
            sum += couple.dot(turn);
        }
    }
    sum
}

/// The work of weights per motion of an input: `sum m g . p_a`.
fn weight_work<'m>(algebra: &mut Algebra<'m>, by: By) -> Ex<'m> {
    let mut sum = algebra.zero();
    let Some(gravity) = masses::gravity(algebra) else {
        return sum;
    };
    for body in 0..algebra.mechanism.bodies.len() {
        for (mass, point) in masses::masses(algebra, body) {
            sum += (mass * gravity).dot(motion::moved(algebra, point, by));
        }
    }
    sum
}

/// The work of forces, torques, springs, dampers and friction per motion of an input. Friction is
/// that of drives which hold the motion.
pub(super) fn generalised_force<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
    input: usize,
) -> Ex<'m> {
    let mut loads = Loads::none(algebra.mechanism.bodies.len());
    loads::add_applied(algebra, bodies, &mut memo.turns, speeds, &mut loads);
    if friction::acts(algebra.mechanism, speeds) {
        let forces = friction::contact_forces(algebra, bodies, memo, speeds);
        let turns = &mut memo.turns;
        loads::add_friction(algebra, bodies, turns, speeds, &forces, &mut loads);
    }
    virtual_work::work(algebra, bodies, &mut memo.turns, &loads, input)
}

/// The work of forces, torques, springs and dampers per motion of an input.
fn applied_work<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    input: usize,
) -> Ex<'m> {
    let mut loads = Loads::none(algebra.mechanism.bodies.len());
    loads::add_applied(algebra, bodies, turns, speeds, &mut loads);
    virtual_work::work(algebra, bodies, turns, &loads, input)
}

/// The acceleration of an input if no drive acts: a component of the solution of `M q" = Q - h`.
pub(super) fn driven_acceleration<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
    input: usize,
) -> Ex<'m> {
    let speeds = speeds.steady();
    if let Some(known) = memo.driven.get(&speeds) {
        return known[input];
    }
    let inputs = 0..algebra.mechanism.inputs.len();
    let row = |a: usize| {
        (0..=a)
            .map(|b| inertia(algebra, bodies, memo, [a, b]))
            .collect()
    };
    let matrix: Vec<Vec<Ex>> = inputs.clone().map(row).collect();
    let right = inputs.map(|input| {
        applied_work(algebra, bodies, &mut memo.turns, &speeds, input)
            - bias(algebra, bodies, memo, &speeds, input)
    });
    let right = right.collect();
    let mut accelerations = positive_definite::solve(Vec::clone(&matrix), right);
    if friction::acts(algebra.mechanism, &speeds) {
        accelerations = with_friction(algebra, bodies, memo, &speeds, matrix, accelerations);
    }
    let accelerations = Rc::new(accelerations);
    memo.driven.insert(speeds, accelerations.clone());
    accelerations[input]
}

/// The same with friction, given the mass matrix and the accelerations without friction. Reactions
/// depend on accelerations, and these on the friction that reactions cause: both are linear in the
/// contact forces.
fn with_friction<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
    matrix: Vec<Vec<Ex<'m>>>,
    frictionless: Vec<Ex<'m>>,
) -> Vec<Ex<'m>> {
    let shares: Vec<Vec<Ex>> = (0..algebra.mechanism.frictions.len())
        .map(|number| {
            let work = friction_work(algebra, bodies, &mut memo.turns, speeds, number);
            positive_definite::solve(matrix.clone(), work)
        })
        .collect();
    let mut surfaces = friction::surfaces(algebra, bodies, memo, speeds);
    for input in 0..frictionless.len() {
        let accelerated = Speeds::unit_acceleration(algebra.mechanism, input);
        let unit = Loading::new(&accelerated, LoadSet::Inertia);
        let forces = friction::forces_in(algebra, bodies, memo, &unit);
        let surfaces = surfaces.iter_mut().flatten();
        for (surface, force) in surfaces.zip(forces.into_iter().flatten()) {
            surface.start = surface.start + frictionless[input] * force;
            for (share, accelerations) in surface.shares.iter_mut().zip(&shares) {
                *share = *share + accelerations[input] * force;
            }
        }
    }
    let sizes = contact_forces::sizes(algebra, &surfaces);
    let sum = |(input, frictionless): (usize, Ex<'m>)| {
        let shares = shares.iter().zip(&sizes);
        shares.fold(frictionless, |sum, (share, &size)| {
            sum + share[input] * size
        })
    };
    frictionless.into_iter().enumerate().map(sum).collect()
}

/// The work of one joint's friction per motion of each input, for a contact force of 1.
fn friction_work<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    speeds: &Speeds,
    number: usize,
) -> Vec<Ex<'m>> {
    let friction = &algebra.mechanism.frictions[number];
    let sense = contacts::sense(algebra, bodies, turns, speeds, friction);
    let mut loads = Loads::none(algebra.mechanism.bodies.len());
    contacts::add_friction(algebra, bodies, &mut loads, friction, sense);
    let inputs = 0..algebra.mechanism.inputs.len();
    inputs
        .map(|input| virtual_work::work(algebra, bodies, turns, &loads, input))
        .collect()
}
