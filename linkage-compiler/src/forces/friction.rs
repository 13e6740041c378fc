//! Friction of joints from the reactions that it changes.
//!
//! Reactions are linear in the loads, so each is that without friction plus shares of the friction in
//! all joints. The shares are the reactions to the friction of one joint alone, by the same system of
//! reactions. `contact_forces` finds the contact forces from these numbers.

use std::rc::Rc;

use linkage_symbolic::{Ex, Vn};

use crate::algebra::Algebra;
use crate::forces::contact_forces::{self, Surface};
use crate::forces::context::Memo;
use crate::forces::loading::{LoadSet, Loading};
use crate::forces::multibody::Multibody;
use crate::forces::speeds::Speeds;
use crate::forces::{contacts, reactions};
use crate::model::Mechanism;

/// The surfaces of each joint with friction.
pub(super) type Surfaces<'m> = Vec<Vec<Surface<'m>>>;

/// The loads at the speeds that are listed, friction among them if anything moves.
pub(super) fn loading<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
) -> Loading {
    if !acts(algebra.mechanism, speeds) {
        return Loading::new(speeds, LoadSet::Frictionless);
    }
    contact_forces(algebra, bodies, memo, speeds);
    Loading::new(speeds, LoadSet::WithFriction)
}

/// True if a joint has friction and anything moves.
pub(super) fn acts(mechanism: &Mechanism, speeds: &Speeds) -> bool {
    !mechanism.frictions.is_empty() && speeds.has_speed()
}

/// Returns the contact force of each joint with friction, the sum of its surfaces.
pub(super) fn contact_forces<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
) -> Rc<Vec<Ex<'m>>> {
    if let Some(known) = memo.contact_forces.get(speeds) {
        return known.clone();
    }
    let surfaces = surfaces(algebra, bodies, memo, speeds);
    let sizes = Rc::new(contact_forces::sizes(algebra, &surfaces));
    memo.contact_forces.insert(speeds.clone(), sizes.clone());
    sizes
}

/// Returns the surfaces with their forces, for drives that hold the motion.
pub(super) fn surfaces<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
) -> Surfaces<'m> {
    let frictionless = Loading::new(speeds, LoadSet::Frictionless);
    let start = forces_in(algebra, bodies, memo, &frictionless);
    let shares = shares(algebra, bodies, memo, speeds);
    let joints = start.into_iter().enumerate();
    joints
        .map(|(joint, starts)| {
            let surfaces = starts.into_iter().enumerate();
            let surface = |(surface, start): (usize, Vn<'m>)| Surface {
                start,
                shares: shares.iter().map(|forces| forces[joint][surface]).collect(),
            };
            surfaces.map(surface).collect()
        })
        .collect()
}

/// Returns the forces on all surfaces for the friction of each joint in its sense, if its contact
/// force is 1.
fn shares<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    speeds: &Speeds,
) -> Vec<Vec<Vec<Vn<'m>>>> {
    let frictions = algebra.mechanism.frictions.iter().enumerate();
    frictions
        .map(|(number, friction)| {
            let sense = contacts::sense(algebra, bodies, &mut memo.turns, speeds, friction);
            let forces = unit_forces(algebra, bodies, memo, number);
            let joints = forces.into_iter();
            joints
                .map(|surfaces| surfaces.into_iter().map(|force| sense * force).collect())
                .collect()
        })
        .collect()
}

/// Returns the forces on all surfaces for the friction of one joint, of contact force 1 and against
/// a positive speed.
pub(super) fn unit_forces<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    number: usize,
) -> Vec<Vec<Vn<'m>>> {
    let at_rest = Speeds::at_rest(algebra.mechanism);
    let unit = Loading::new(&at_rest, LoadSet::UnitFriction(number));
    forces_in(algebra, bodies, memo, &unit)
}

/// Returns the forces on all surfaces for some loads.
pub(super) fn forces_in<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
) -> Vec<Vec<Vn<'m>>> {
    let frictions = algebra.mechanism.frictions.iter();
    frictions
        .map(|friction| {
            let reaction = reactions::reaction(algebra, bodies, memo, loading, friction.joint);
            contacts::surface_forces(algebra, bodies, friction, reaction)
        })
        .collect()
}
