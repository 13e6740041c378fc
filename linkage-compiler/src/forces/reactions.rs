//! Reactions of joints.

use crate::algebra::Algebra;
use crate::forces::context::Memo;
use crate::forces::loading::Loading;
use crate::forces::multibody::Multibody;
use crate::forces::system::System;
use crate::forces::wrench::Wrench;
use crate::forces::{assemble, equilibrium};
use crate::model::Rotation;

/// The force and moment that a joint transmits to its body, without the part of a drive in its
/// motion.
pub(super) fn reaction<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
    joint: usize,
) -> Wrench<'m> {
    if bodies.tree.closing.contains(&joint) {
        return equilibrium::closing_wrench(algebra, bodies, memo, loading, joint, &[]);
    }
    let declared = &algebra.mechanism.joints[joint];
    let (body, kind) = (declared.body, declared.kind);
    let mut reaction = -equilibrium::wrench(algebra, bodies, memo, loading, body, &[], &[]);
    let Some(direction) = bodies.geometry.directions[joint] else {
        return reaction;
    };
    let system = assemble::system(algebra, bodies, memo);
    // Where nothing drives it, equilibrium leaves nothing along the guide or about the axis.
    if kind.slides() && is_driven(&system, body, true) {
        reaction.force = reaction.force.across(direction);
    }
    // A roller of the plane has a direction, too, and no moment at all.
    let has_axis = kind.rotation() == Rotation::AboutAxis && !bodies.geometry.is_plane();
    if has_axis && is_driven(&system, body, false) {
        reaction.moment = reaction.moment.across(direction);
    }
    reaction
}

fn is_driven(system: &System, body: usize, slides: bool) -> bool {
    let mut driven = system.driven.iter();
    driven.any(|way| way.body == body && way.slides == slides)
}
