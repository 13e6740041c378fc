//! Bodies: the joints that they are attached by, their rotation, their masses.

use super::clauses::{resolve_point, resolve_scalar};
use super::inertia::resolve_inertia;
use super::joints::resolve_joint;
use crate::diagnostic::SourceSpan;
use crate::model::dispatch::resolve_expression;
use crate::model::expression::argument_use::refuse_argument;
use crate::model::expression::clause_values::refuse_clause;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::types::{Body, Dimension, Expr, Joint, Mechanism, Rotation, Type};
use crate::syntax::{self, BodyItem, JointKind};

/// Resolves a body and the joint that it is attached by. Both have the same number.
pub(in crate::model) fn resolve_body(
    scope: &Scope,
    sink: &mut Sink,
    item: &BodyItem,
    index: usize,
) -> (Body, Joint) {
    let joint = resolve_joint(scope, sink, &item.joint, index);
    let turns = match &item.turns {
        Some(turns) => Some(resolve_turns(scope, sink, turns, item.joint.kind)),
        None => {
            check_turns(sink, item);
            None
        }
    };
    let masses = item
        .masses
        .iter()
        .map(|part| {
            let mass = resolve_scalar(scope, sink, &part.mass, Dimension::MASS, "mass", "100g");
            (mass, resolve_point(scope, sink, &part.at))
        })
        .collect();
    refuse_second_point(sink, item);
    let inertias = item
        .inertias
        .iter()
        .map(|part| resolve_inertia(scope, sink, part, turns.as_ref()))
        .collect();
    let body = Body {
        name: item.name.to_string(),
        joint: index,
        turns,
        masses,
        inertias,
        origin: sink.add_origin((&item.name).into()),
    };
    (body, joint)
}

/// Refuses a second inertia about a point. Each is that of the whole body, masses included, so two
/// contradict each other.
fn refuse_second_point(sink: &mut Sink, item: &BodyItem) {
    let mut points = item.inertias.iter().filter_map(|part| part.at.as_ref());
    if let (Some(_), Some(second)) = (points.next(), points.next()) {
        let fact = format!(
            "a second `inertia` of `{}` about a point: each is that of the whole body",
            item.name
        );
        let help = "write the sum about one point; what a part has about its own centre of mass needs no `at`";
        sink.error_with_help(second.span, fact, help);
    }
}

/// Resolves the rotation of a body: in the plane an angle; in space a frame, the direction of a rod
/// between balls, or the angle about the joint's axis.
fn resolve_turns(scope: &Scope, sink: &mut Sink, expr: &syntax::Expr, kind: JointKind) -> Expr {
    let mut value = resolve_expression(scope, sink, expr, Context::MECHANICS);
    refuse_argument(
        &scope.names,
        &scope.values,
        sink,
        &mut value,
        "what a body turns with",
    );
    if matches!(value.ty, Type::Zero(1)) {
        value.settle(&Type::Scalar(Dimension::ANGLE));
    }
    let angle = matches!(value.ty, Type::Scalar(found) if found.is_number_or_angle());
    let (fits, wanted, example) = match (sink.components, kind.rotation()) {
        (None, _) => return value,
        (Some(2), _) => (angle, "an angle", "turns phi"),
        (_, Rotation::AboutAxis) => (
            angle || value.ty == Type::Frame,
            "the angle about the joint's axis or a frame",
            "turns phi",
        ),
        (_, Rotation::Freely) => (
            matches!(value.ty, Type::Vector(3, _)) || value.ty == Type::Frame,
            "a frame or the vector along a slender rod",
            "turns q - p",
        ),
        (_, Rotation::Not) => (value.ty == Type::Frame, "a frame", "turns frame(p, x, z)"),
    };
    if fits {
        value
    } else {
        refuse_clause(&scope.names, sink, value, "turns", wanted, example)
    }
}

/// Reports a missing `turns`, unless the body turns with the body that it is attached to.
fn check_turns(sink: &mut Sink, item: &BodyItem) {
    if !item.joint.kind.turns() {
        return;
    }
    let help = match (sink.components, item.joint.kind.rotation()) {
        (Some(2) | None, _) => {
            "name its angle: `turns phi`; a body that does not turn has `turns 0deg`"
        }
        (_, Rotation::Freely) => {
            "name the vector along it if it is a slender rod, `turns q - p`, or its frame: `turns frame(p, x, z)`"
        }
        (_, Rotation::AboutAxis | Rotation::Not) => {
            "name its angle about the joint's axis, `turns phi`, or its frame: `turns frame(p, x, z)`"
        }
    };
    let fact = format!("how does `{}` turn? A `turns` is missing", item.name);
    sink.error_with_help((&item.name).into(), fact, help);
}

/// Each body must hang, over others, on the frame.
pub(in crate::model) fn refuse_circles(sink: &mut Sink, mechanism: &Mechanism) {
    let on = |body: usize| mechanism.joints[body].on;
    for (start, body) in mechanism.bodies.iter().enumerate() {
        let chain = std::iter::successors(on(start), |body| on(*body));
        let chain: Vec<usize> = chain.take(mechanism.bodies.len()).collect();
        let Some(length) = chain.iter().position(|body| *body == start) else {
            continue;
        };
        // The first body of the circle reports it.
        if chain[..length].iter().any(|body| *body < start) {
            continue;
        }
        let names: Vec<&str> = chain[..=length]
            .iter()
            .map(|body| mechanism.bodies[*body].name.as_str())
            .collect();
        let fact = match length {
            0 => format!("`{}` hangs on itself", body.name),
            _ => format!(
                "`{}` hangs on itself: on `{}`",
                body.name,
                names.join("`, on `")
            ),
        };
        let help =
            "let one of them hang on `frame`, and write the joint that closes the loop by itself";
        let span: SourceSpan = sink.span(body.origin);
        sink.error_with_help(span, fact, help);
    }
}
