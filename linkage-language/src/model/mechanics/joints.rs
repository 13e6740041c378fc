//! Joints: between which bodies, where, along which direction.

use super::clauses::{resolve_direction, resolve_point};
use crate::model::expression::members::find_body;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::types::{Expr, Joint};
use crate::syntax::{JointItem, JointKind, JointPart, Word};

/// `pin NAME = BODY on BODY at point;`
pub(in crate::model) fn resolve_joint_item(
    scope: &Scope,
    sink: &mut Sink,
    item: &JointItem,
) -> Joint {
    let body = find_body(&scope.parts, &scope.members, sink, &item.body);
    if body == Some(None) {
        let fact = "the body of a joint moves, `frame` does not";
        let kind = item.joint.kind.word();
        let help = format!("name the frame second: `{kind} NAME = BODY on frame`");
        sink.error_with_help(item.body.span, fact, help);
    }
    let joint = resolve_joint(scope, sink, &item.joint, body.flatten().unwrap_or_default());
    if body.is_some_and(|body| body.is_some() && body == joint.on) {
        let fact = format!("a joint between `{}` and itself", item.body);
        sink.error_with_help(item.joint.span, fact, "name two bodies");
    }
    joint
}

/// Resolves a joint of a body or of a joint item.
pub(in crate::model) fn resolve_joint(
    scope: &Scope,
    sink: &mut Sink,
    part: &JointPart,
    body: usize,
) -> Joint {
    let on = find_body(&scope.parts, &scope.members, sink, &part.on).flatten();
    let at = resolve_point(scope, sink, &part.at);
    let word = part.kind.direction_word().word();
    let direction = part
        .direction
        .as_ref()
        .map(|direction| resolve_direction(scope, sink, direction, word));
    check_joint_kind(sink, part, direction.as_ref());
    Joint {
        name: part.name.as_ref().map(ToString::to_string),
        kind: part.kind,
        body,
        on,
        at,
        direction,
        origin: sink.add_origin(part.span),
    }
}

/// Reports a joint that does not exist in the plane or in space, and a missing or needless
/// direction.
fn check_joint_kind(sink: &mut Sink, part: &JointPart, direction: Option<&Expr>) {
    let Some(components) = sink.components else {
        return;
    };
    let plane = components == 2;
    let kind = part.kind.word();
    let (fact, help) = match (part.kind, plane, direction) {
        (JointKind::Ball, true, _) => (
            "a `ball` in the plane".to_owned(),
            "write `pin`, or points of space `(x, y, z)`".to_owned(),
        ),
        (JointKind::Cylinder, true, _) => (
            "a `cylinder` in the plane".to_owned(),
            "write `slide`, or points of space `(x, y, z)`".to_owned(),
        ),
        (JointKind::Roller, false, _) => (
            "a `roller` in space".to_owned(),
            "write `cylinder`, or points of the plane `(x, y)`".to_owned(),
        ),
        (JointKind::Roller, true, None) => (
            "a `roller` without `along`".to_owned(),
            "name the direction of its slot: `along (1, 0)`".to_owned(),
        ),
        (JointKind::Slide, _, None) => (
            "a `slide` without `along`".to_owned(),
            "name the direction of its guide: `along dir(phi)`".to_owned(),
        ),
        (JointKind::Pin | JointKind::Cylinder, false, None) => (
            format!("a `{kind}` in space without `about`"),
            "name its axis: `about (0, 0, 1)`".to_owned(),
        ),
        (JointKind::Pin, true, Some(_)) => (
            "a `pin` in the plane has no axis to choose".to_owned(),
            "leave out `about`".to_owned(),
        ),
        (JointKind::Ball | JointKind::Fixed, _, Some(_)) => (
            format!("a `{kind}` has no direction"),
            "leave it out".to_owned(),
        ),
        (JointKind::Pin, true, None)
        | (JointKind::Pin | JointKind::Cylinder, false, Some(_))
        | (JointKind::Slide, _, Some(_))
        | (JointKind::Roller, true, Some(_))
        | (JointKind::Ball, false, None)
        | (JointKind::Fixed, _, None) => return,
    };
    sink.error_with_help(part.span, fact, help);
}
