//! Constants, derived quantities and loops.

use crate::model::dispatch::resolve_expression;
use crate::model::expression::agreement::refuse_mismatch;
use crate::model::expression::argument_use::refuse_argument;
use crate::model::expression::frame_items::refuse_frame_loop;
use crate::model::expression::missing_units::{note_unitless, suspect_both_units};
use crate::model::expression::plane_and_space::both_types;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::types::{Expr, Loop, Name, Type};
use crate::syntax::{LoopItem, NamedItem};

/// Value of a constant or `let`. Zero stays zero: it fits every dimension under its name, too.
pub(in crate::model) fn resolve_named(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &NamedItem,
    name: Name,
    context: Context,
) -> Expr {
    let value = resolve_expression(scope, sink, &item.value, context);
    note_unitless(&scope.names, &mut scope.units, sink, name, &value, None);
    let ty = if scope.units.is_taken_for_length(name) {
        scope.units.declared(name, &value.ty)
    } else {
        value.ty.clone()
    };
    scope.names.set_type(name, ty, false);
    value
}

pub(in crate::model) fn resolve_loop(
    scope: &Scope,
    sink: &mut Sink,
    item: &LoopItem,
    context: Context,
) -> Loop {
    let mut left = resolve_expression(scope, sink, &item.left, context);
    let mut right = resolve_expression(scope, sink, &item.right, context);
    let origin = sink.add_origin(item.span);
    refuse_argument(&scope.names, &scope.values, sink, &mut left, "a loop");
    refuse_argument(&scope.names, &scope.values, sink, &mut right, "a loop");
    refuse_frame_loop(sink, &mut left, &mut right, item.span);
    let Some(ty) = Type::common(&left.ty, &right.ty) else {
        if !left.ty.is_error() && !right.ty.is_error() {
            suspect_both_units(&scope.units, sink, &left, &right);
            let (first, second) = both_types(&scope.names, &left, &right);
            let fact = format!("the sides of the loop differ: {first} = {second}");
            let sides = [&left, &right];
            refuse_mismatch(&scope.names, &scope.units, sink, sides, fact, item.span);
        }
        return Loop {
            left,
            right,
            origin,
            of: item.of.clone(),
        };
    };
    let ty = ty.settled();
    if let Some(dimension) = ty.dimension().filter(|dimension| !dimension.is_geometric()) {
        let fact = format!("a loop is about lengths and angles, found {dimension} on both sides");
        let help = "what moves does not depend on forces and times: divide by them";
        sink.error_with_help(item.span, fact, help);
    }
    left.settle(&ty);
    right.settle(&ty);
    Loop {
        left,
        right,
        origin,
        of: item.of.clone(),
    }
}
