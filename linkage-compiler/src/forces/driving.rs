//! Torques, forces and power of drives.

use linkage_symbolic::Ex;

use crate::algebra::Algebra;
use crate::forces::context::Memo;
use crate::forces::loading::Loading;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::By;
use crate::forces::system::Unknown;
use crate::forces::{assemble, equilibrium, freedom, loads, motion, virtual_work};

/// The torque or force of a drive, by joints or by virtual work.
pub(super) fn drive<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
    with_reactions: bool,
    input: usize,
) -> Ex<'m> {
    if with_reactions {
        drive_of_joints(algebra, bodies, memo, loading, input)
    } else {
        let loads = loads::loads(algebra, bodies, memo, loading);
        -virtual_work::work(algebra, bodies, &mut memo.turns, &loads, input)
    }
}

/// The force or torque that holds the driven joints against everything beyond them. It costs little
/// if reactions are computed anyway.
fn drive_of_joints<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
    input: usize,
) -> Ex<'m> {
    let system = assemble::system(algebra, bodies, memo);
    let mut sum = algebra.zero();
    for way in &system.driven {
        let rate = freedom::relative_rate(algebra, bodies, &mut memo.turns, way, By::Input(input));
        if !rate.is_zero() {
            sum -= rate
                * equilibrium::wrench(algebra, bodies, memo, loading, way.body, &[], &[])
                    .along(way);
        }
    }
    // Gears that run on a driven shaft load it.
    for (index, unknown) in system.unknowns.iter().enumerate() {
        let Unknown::Tie(tie) = unknown else { continue };
        let rate = freedom::tie_rate(algebra, bodies, &mut memo.turns, tie, input);
        if !rate.is_zero() {
            sum += rate * equilibrium::solved(algebra, bodies, memo, loading, index);
        }
    }
    sum
}

/// `sum Q w`
pub(super) fn power<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
    with_reactions: bool,
) -> Ex<'m> {
    let zero = algebra.zero();
    (0..algebra.mechanism.inputs.len()).fold(zero, |sum, input| {
        match motion::speed(algebra, &loading.speeds, input) {
            None => sum,
            Some(speed) => {
                sum + drive(algebra, bodies, memo, loading, with_reactions, input) * speed
            }
        }
    })
}
