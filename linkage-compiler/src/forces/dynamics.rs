//! The equation of motion `M q" + h = Q` of the inputs, by virtual work.
//!
//! `M` is the mass matrix, `h` the bias of velocities and weights, `Q` the generalised forces of the
//! declared loads. A drive holds the rest: `torque = M q" + h - Q`.

use std::rc::Rc;

use linkage_symbolic::Ex;

use crate::algebra::{Algebra, positive_definite};
use crate::forces::body_loads::Loads;
use crate::forces::context::Memo;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{By, Speeds};
use crate::forces::{inertia, loads, masses, motion, virtual_work};

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
    let mut sum = algebra.zero();
    for body in 0..algebra.mechanism.bodies.len() {
        for (mass, point) in masses::masses(algebra, body) {
            let [first, second] = by.map(|by| motion::moved(algebra, point, by));
            sum += mass * first.dot(second);
        }
        sum += inertia::turning_inertia(algebra, bodies, &mut memo.turns, body, by);
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
    let loads = loads::inertial_loads(algebra, bodies, turns, &speeds.steady());
    -virtual_work::work(algebra, bodies, turns, &loads, input)
}

/// The work of forces, torques, springs and dampers per motion of an input.
pub(super) fn generalised_force<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
    input: usize,
) -> Ex<'m> {
    let turns = &mut memo.turns;
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
    let matrix = inputs.clone().map(row).collect();
    let loads = loads::loads(algebra, bodies, memo, &speeds);
    let turns = &mut memo.turns;
    let right = inputs.map(|input| virtual_work::work(algebra, bodies, turns, &loads, input));
    let accelerations = Rc::new(positive_definite::solve(matrix, right.collect()));
    memo.driven.insert(speeds, accelerations.clone());
    accelerations[input]
}
