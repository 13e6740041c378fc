//! Links and wheels that pictures show.

use crate::model::dispatch::resolve_expression;
use crate::model::expression::nodes::make_expr;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::types::{
    Dimension, ExprKind, Function, LinkElements, PairOfWheels, PairedWheel, RigidLink, Type,
};
use crate::syntax;

/// Returns the links that joints and links stand for, and the wheels that turn in joints. Loops have
/// the same names, so that mistakes are reported there.
pub(in crate::model) fn resolve_link_elements(
    scope: &Scope,
    sink: &mut Sink,
    elements: &syntax::LinkElements,
) -> LinkElements {
    let links = elements.links.iter().map(|link| RigidLink {
        name: link.name.to_string(),
        joints: link
            .joints
            .iter()
            .map(|joint| resolve_expression(scope, sink, joint, Context::MECHANICS))
            .collect(),
    });
    let links = links.collect();
    let pairs = elements.pairs.iter().filter_map(|pair| {
        let [first, second] = &pair.wheels;
        let first = resolve_wheel(scope, sink, first)?;
        let second = resolve_wheel(scope, sink, second)?;
        Some(PairOfWheels {
            wheels: [first, second],
            touch: pair.touch,
        })
    });
    let pairs = pairs.collect();
    LinkElements { links, pairs }
}

fn resolve_wheel(
    scope: &Scope,
    sink: &mut Sink,
    wheel: &syntax::PairedWheel,
) -> Option<PairedWheel> {
    let pivot = wheel.pivot.as_ref()?;
    let centre = resolve_expression(scope, sink, pivot, Context::MECHANICS);
    let direction = wheel.angle.as_ref().map(|angle| {
        let value = resolve_expression(scope, sink, angle, Context::MECHANICS);
        let kind = ExprKind::Call(Function::Dir, vec![value]);
        let ty = Type::Vector(2, Dimension::NUMBER);
        make_expr(sink, kind, ty, angle.span)
    });
    Some(PairedWheel { centre, direction })
}
