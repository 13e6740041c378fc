//! Forces, torques, springs, dampers.

use super::clauses::{resolve_point, resolve_scalar, resolve_vector};
use crate::diagnostic::SourceSpan;
use crate::model::dispatch::resolve_expression;
use crate::model::expression::members::{find_body, find_joint};
use crate::model::symbols::member_names::MemberNames;
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::types::{
    Between, Body, Dimension, Element, ElementKind, Expr, Load, Rotation, Type,
};
use crate::syntax::{self, ElementItem, LoadItem, Member, Word};

/// The dimension of a value, and an example of one.
#[derive(Clone, Copy)]
struct Measure {
    dimension: Dimension,
    example: &'static str,
}

impl Measure {
    fn new(dimension: Dimension, example: &'static str) -> Self {
        Self { dimension, example }
    }
}

/// `force vector on BODY [from BODY] at point;`
pub(in crate::model) fn resolve_force(scope: &Scope, sink: &mut Sink, item: &LoadItem) -> Load {
    let [on, from] = find_two_bodies(&scope.parts, &scope.members, sink, item);
    let at = item.at.as_ref().map(|at| resolve_point(scope, sink, at));
    if at.is_none() {
        let help = "name the point where it acts: `at p`";
        sink.error_with_help(item.span, "a `force` without `at`", help);
    }
    let value = resolve_vector(
        scope,
        sink,
        &item.value,
        Some(Dimension::FORCE),
        "force",
        "(0, -500N)",
    );
    make_load(value, [on, from], at)
}

/// `torque moment on BODY [from BODY];`
pub(in crate::model) fn resolve_torque(scope: &Scope, sink: &mut Sink, item: &LoadItem) -> Load {
    let bodies = find_two_bodies(&scope.parts, &scope.members, sink, item);
    if let Some(at) = &item.at {
        let fact = "a `torque` acts on a body, wherever";
        sink.error_with_help(at.span, fact, "leave out `at`");
    }
    let value = match sink.components {
        Some(3) => resolve_vector(
            scope,
            sink,
            &item.value,
            Some(Dimension::MOMENT),
            "torque",
            "(0, 0, 3N*mm)",
        ),
        _ => resolve_scalar(
            scope,
            sink,
            &item.value,
            Dimension::MOMENT,
            "torque",
            "3N*mm",
        ),
    };
    make_load(value, bodies, None)
}

fn make_load(value: Expr, [on, from]: [Option<usize>; 2], at: Option<Expr>) -> Load {
    Load {
        value,
        on,
        from,
        at,
    }
}

fn find_two_bodies(
    parts: &Parts,
    members: &MemberNames,
    sink: &mut Sink,
    item: &LoadItem,
) -> [Option<usize>; 2] {
    let on = find_body(parts, members, sink, &item.on);
    let from = match &item.from {
        Some(from) => find_body(parts, members, sink, from),
        None => Some(None),
    };
    refuse_same_body(sink, on, from, &item.on, item.span);
    [on.flatten(), from.flatten()]
}

/// Reports a load between a body and itself.
fn refuse_same_body(
    sink: &mut Sink,
    first: Option<Option<usize>>,
    second: Option<Option<usize>>,
    name: &Member,
    span: SourceSpan,
) {
    if first.is_none() || first != second {
        return;
    }
    let fact = match first.flatten() {
        Some(_) => format!("this acts between `{name}` and itself, which has no effect"),
        None => "this acts on `frame` alone, which has no effect".to_owned(),
    };
    let help = "name a body that moves, and another or none";
    sink.error_with_help(span, fact, help);
}

/// `spring stiffness BETWEEN [, free length];`
pub(in crate::model) fn resolve_spring(
    scope: &Scope,
    sink: &mut Sink,
    item: &ElementItem,
    bodies: &[Body],
) -> Element {
    let before = sink.diagnostics.len();
    let (between, turning) = resolve_between(scope, sink, item);
    if turning == Some(true) && sink.diagnostics.len() == before {
        refuse_without_angle(sink, &between, bodies, item.span);
    }
    let (stiffness, free_of) = if turning.unwrap_or_default() {
        (
            Measure::new(Dimension::MOMENT, "300N*mm"),
            Measure::new(Dimension::ANGLE, "20deg"),
        )
    } else {
        (
            Measure::new(Dimension::from_powers(-1, 1, 0), "2.5N/mm"),
            Measure::new(Dimension::LENGTH, "40mm"),
        )
    };
    let known = turning.is_some();
    let value = resolve_element_value(scope, sink, &item.value, known, stiffness, "spring");
    let free = item.free.as_ref();
    let free =
        free.map(|length| resolve_element_value(scope, sink, length, known, free_of, "free"));
    Element {
        kind: ElementKind::Spring,
        value,
        between,
        free,
        origin: sink.add_origin(item.span),
    }
}

/// Reports a spring in a pin of space without an angle. The angle is known if a body is attached by
/// the pin and turns with an angle; in the plane all angles are known.
fn refuse_without_angle(sink: &mut Sink, between: &Between, bodies: &[Body], span: SourceSpan) {
    let (Between::Joint(joint), Some(3)) = (between, sink.components) else {
        return;
    };
    // Joints that bodies hang by have the numbers of the bodies.
    let help = match bodies.get(*joint).map(|body| &body.turns) {
        Some(Some(turns)) if matches!(turns.ty, Type::Scalar(_) | Type::Error) => return,
        Some(_) => "let the body turn with that angle: `turns phi`",
        None => "let one of its bodies hang by this pin and turn with that angle: `turns phi`",
    };
    let fact = "a spring in a pin of space needs the angle about its axis";
    sink.error_with_help(span, fact, help);
}

/// `damper damping BETWEEN;`
pub(in crate::model) fn resolve_damper(
    scope: &Scope,
    sink: &mut Sink,
    item: &ElementItem,
) -> Element {
    let (between, turning) = resolve_between(scope, sink, item);
    let damping = if turning.unwrap_or_default() {
        Measure::new(Dimension::from_powers(1, 1, 1), "5N*mm*s")
    } else {
        Measure::new(Dimension::from_powers(-1, 1, 1), "0.2N*s/mm")
    };
    let value = resolve_element_value(
        scope,
        sink,
        &item.value,
        turning.is_some(),
        damping,
        "damper",
    );
    if let Some(free) = &item.free {
        let fact = "a `damper` has no length without force";
        sink.error_with_help(free.span, fact, "leave out `free`");
    }
    Element {
        kind: ElementKind::Damper,
        value,
        between,
        free: None,
        origin: sink.add_origin(item.span),
    }
}

/// A value of a spring or damper. Where its joint is not known, nothing is said of the dimension.
fn resolve_element_value(
    scope: &Scope,
    sink: &mut Sink,
    value: &syntax::Expr,
    joint_is_known: bool,
    measure: Measure,
    word: &str,
) -> Expr {
    if joint_is_known {
        resolve_scalar(scope, sink, value, measure.dimension, word, measure.example)
    } else {
        resolve_expression(scope, sink, value, Context::MECHANICS)
    }
}

/// Resolves the place of a spring or damper. The flag is true for an angle, `None` if the joint is
/// unknown.
fn resolve_between(scope: &Scope, sink: &mut Sink, item: &ElementItem) -> (Between, Option<bool>) {
    match &item.between {
        syntax::Between::Points(ends) => {
            let [(from, start), (to, end)] = &**ends;
            let (first, second) = (
                find_body(&scope.parts, &scope.members, sink, from),
                find_body(&scope.parts, &scope.members, sink, to),
            );
            refuse_same_body(sink, first, second, from, item.span);
            let ends = [
                (first.flatten(), resolve_point(scope, sink, start)),
                (second.flatten(), resolve_point(scope, sink, end)),
            ];
            (Between::Points(ends), Some(false))
        }
        syntax::Between::Joint(name) => {
            let joint = find_joint(&scope.parts, &scope.members, sink, name);
            let kind = joint.map(|joint| scope.members.joints[joint]);
            let turning = kind.map(|kind| match (kind.rotation(), kind.slides()) {
                (Rotation::AboutAxis, false) => true,
                (Rotation::Not, true) => false,
                (Rotation::AboutAxis, true) | (Rotation::Not, false) | (Rotation::Freely, _) => {
                    let fact = format!("`{name}` is a `{}`", kind.word());
                    let help =
                        "springs and dampers act on a `pin`, on a `slide`, or between two points";
                    sink.error_with_help(name.span, fact, help);
                    !kind.slides()
                }
            });
            (Between::Joint(joint.unwrap_or_default()), turning)
        }
    }
}
