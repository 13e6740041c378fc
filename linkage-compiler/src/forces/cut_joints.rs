//! The side of a cut joint on which a body is.

use crate::forces::tree::Tree;
use crate::model::Mechanism;

/// Returns 1 if the reaction of a cut joint acts on a body or its descendants, -1 if its opposite
/// does, and 0 if neither or both do.
pub(super) fn joins(mechanism: &Mechanism, tree: &Tree, joint: usize, body: usize) -> i32 {
    let declared = &mechanism.joints[joint];
    i32::from(tree.hangs_on(Some(declared.body), body))
        - i32::from(tree.hangs_on(declared.on, body))
}

/// The same for the body alone.
pub(super) fn at_ends(mechanism: &Mechanism, joint: usize, body: usize) -> i32 {
    let declared = &mechanism.joints[joint];
    i32::from(declared.body == body) - i32::from(declared.on == Some(body))
}

/// True if both bodies of a cut joint hang on a body.
pub(super) fn is_inside(mechanism: &Mechanism, tree: &Tree, joint: usize, body: usize) -> bool {
    let declared = &mechanism.joints[joint];
    tree.hangs_on(Some(declared.body), body) && tree.hangs_on(declared.on, body)
}
