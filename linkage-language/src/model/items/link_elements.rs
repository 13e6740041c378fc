//! Links, slots and wheels that pictures show.

use crate::model::dispatch::resolve_expression;
use crate::model::expression::nodes::make_expr;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::types::{
    Dimension, Expr, ExprKind, Function, LinkElements, PairOfWheels, PairedWheel, RigidLink,
    StraightSlot, Type,
};
use crate::syntax;

/// Returns the links and slots that joints and links stand for, and the wheels that turn in joints. Loops have
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
    let slots = elements.slots.iter().map(|slot| StraightSlot {
        name: slot.name.to_string(),
        slider: resolve_expression(scope, sink, &slot.slider, Context::MECHANICS),
        start: resolve_expression(scope, sink, &slot.start, Context::MECHANICS),
        direction: resolve_direction(scope, sink, &slot.angle),
    });
    let slots = slots.collect();
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
    LinkElements {
        links,
        slots,
        pairs,
    }
}

fn resolve_wheel(
    scope: &Scope,
    sink: &mut Sink,
    wheel: &syntax::PairedWheel,
) -> Option<PairedWheel> {
    let pivot = wheel.pivot.as_ref()?;
    let centre = resolve_expression(scope, sink, pivot, Context::MECHANICS);
    let angle = wheel.angle.as_ref();
    let direction = angle.map(|angle| resolve_direction(scope, sink, angle));
    Some(PairedWheel { centre, direction })
}

/// Returns the unit vector of a direction.
fn resolve_direction(scope: &Scope, sink: &mut Sink, angle: &syntax::Expr) -> Expr {
    let value = resolve_expression(scope, sink, angle, Context::MECHANICS);
    let kind = ExprKind::Call(Function::Dir, vec![value]);
    let ty = Type::Vector(2, Dimension::NUMBER);
    make_expr(sink, kind, ty, angle.span)
}
