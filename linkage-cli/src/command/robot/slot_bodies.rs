//! The body of a closing roller that has the slot: its direction turns with that body.

use linkage_language::syntax::JointKind;

use super::declared::field;
use super::jointed_links::pose_of;
use super::skeleton::Skeleton;
use super::space_vectors::{cross, length, turned, unit};

/// A change of the running input, in radians or units of length, in which directions turn.
const BESIDE: f64 = 1e-3;

/// The sine between directions that are one, far above rounding.
const PARALLEL: f64 = 1e-9;

/// Puts the body with the slot second, as in joints that bodies hang on.
pub(super) fn put_slots_second(skeleton: &mut Skeleton) {
    let closures = 0..skeleton.closures.len();
    let first: Vec<usize> = closures
        .filter(|index| has_slot_first(skeleton, *index))
        .collect();
    for index in first {
        skeleton.closures[index].bodies.reverse();
    }
}

fn has_slot_first(skeleton: &Skeleton, index: usize) -> bool {
    let closure = &skeleton.closures[index];
    let (JointKind::Roller, Some(along)) = (closure.kind, closure.along) else {
        return false;
    };
    [BESIDE, -BESIDE].into_iter().any(|change| {
        let x = skeleton.reference() + change;
        let direction = skeleton.values_at(x).vector(&field("closing_along", index));
        let direction = unit(direction);
        let poses = skeleton.poses(x);
        let turns_with = |body: Option<usize>| {
            let carried = turned(&pose_of(&poses, body).rotation, along);
            length(cross(direction, carried)) < PARALLEL
        };
        let [first, second] = closure.bodies.map(turns_with);
        first && !second
    })
}
