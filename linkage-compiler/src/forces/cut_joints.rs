//! The side of a cut joint on which a body is.

use crate::forces::context::Mechanics;

/// Returns 1 if the reaction of a cut joint acts on a body or its descendants, -1 if its opposite
/// does, and 0 if neither or both do.
pub(super) fn joins(mechanics: &Mechanics<'_, '_>, joint: usize, body: usize) -> i32 {
    let declared = &mechanics.algebra.mechanism.joints[joint];
    let tree = &mechanics.forces.bodies.tree;
    i32::from(tree.hangs_on(Some(declared.body), body))
        - i32::from(tree.hangs_on(declared.on, body))
}

/// The same for the body alone.
pub(super) fn at_ends(mechanics: &Mechanics<'_, '_>, joint: usize, body: usize) -> i32 {
    let declared = &mechanics.algebra.mechanism.joints[joint];
    i32::from(declared.body == body) - i32::from(declared.on == Some(body))
}

/// True if both bodies of a cut joint hang on a body.
pub(super) fn is_inside(mechanics: &Mechanics<'_, '_>, joint: usize, body: usize) -> bool {
    let declared = &mechanics.algebra.mechanism.joints[joint];
    let tree = &mechanics.forces.bodies.tree;
    tree.hangs_on(Some(declared.body), body) && tree.hangs_on(declared.on, body)
}
