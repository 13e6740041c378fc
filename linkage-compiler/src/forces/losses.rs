//! The power that friction takes, and the efficiency that it leaves.

use linkage_symbolic::Ex;

use crate::algebra::Algebra;
use crate::forces::context::Memo;
use crate::forces::loading::{LoadSet, Loading};
use crate::forces::multibody::Multibody;
use crate::forces::speeds::Speeds;
use crate::forces::{contacts, driving, friction, springs};

/// The power that friction turns into heat: `sum mu R |w|`.
pub(super) fn friction_power<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
) -> Ex<'m> {
    let contact_forces = friction::contact_forces(algebra, bodies, memo, speeds);
    let frictions = algebra.mechanism.frictions.iter();
    let mut sum = algebra.zero();
    for (friction, &force) in frictions.zip(contact_forces.iter()) {
        let speed = springs::joint_speed(algebra, bodies, &mut memo.turns, speeds, friction.joint);
        sum += contacts::rate_of_friction(algebra, friction) * force * speed.abs();
    }
    sum
}

/// The efficiency: power without friction over power with it while the drives deliver power, the
/// reverse while the loads deliver it. Friction that takes more than the loads deliver makes it
/// negative: the mechanism is self-locking.
pub(super) fn efficiency<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
    with_reactions: bool,
) -> Ex<'m> {
    let frictionless = Loading::new(speeds, LoadSet::Frictionless);
    let useful = driving::power(algebra, bodies, memo, &frictionless, with_reactions);
    let spent = useful + friction_power(algebra, bodies, memo, speeds);
    // One division: a choice of two becomes a branch in machine code.
    useful.select(useful, spent) / useful.select(spent, useful)
}
