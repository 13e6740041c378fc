//! Joints, bodies and elements as messages name them.

use crate::model::{ElementKind, Mechanism};

/// A joint as messages name it.
pub(super) fn joint_name(mechanism: &Mechanism, joint: usize) -> String {
    let declared = &mechanism.joints[joint];
    match &declared.name {
        Some(name) => format!("`{name}`"),
        None => format!("the joint of `{}`", mechanism.bodies[declared.body].name),
    }
}

/// A body as messages name it; `None` is the frame.
pub(super) fn body_name(mechanism: &Mechanism, body: Option<usize>) -> String {
    match body {
        Some(body) => format!("`{}`", mechanism.bodies[body].name),
        None => "the frame".to_owned(),
    }
}

/// A spring or damper as messages name it.
pub(super) fn element_name(kind: ElementKind) -> &'static str {
    match kind {
        ElementKind::Spring => "spring",
        ElementKind::Damper => "damper",
    }
}
