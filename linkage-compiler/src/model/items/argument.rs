//! Arguments: loads and speeds that functions take at run time.

use super::passes::Taken;
use crate::model::expression::dispatch::resolve_expression;
use crate::model::expression::frame_items::refuse_frame_item;
use crate::model::expression::nodes::error_expr;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, Site};
use crate::model::symbols::values::Values;
use crate::model::types::{Argument, Dimension, Expr, Input, Name, Type};
use crate::syntax::NamedItem;

/// All arguments in the order of their names; speeds and accelerations stand at their inputs.
pub(in crate::model) fn resolve_arguments(
    scope: &mut Scope,
    sink: &mut Sink,
    items: &[(usize, Taken)],
    inputs: &[Input],
) -> Vec<Argument> {
    let mut arguments = Vec::new();
    let mut input = 0;
    for (position, item) in items {
        match item {
            Taken::Argument(item) => {
                let argument = resolve_argument(scope, sink, item, arguments.len(), *position);
                arguments.push(argument);
            }
            Taken::Rates(item) => {
                let rates = [&item.speed, &item.acceleration];
                for (order, ident) in (1..).zip(rates) {
                    let Some(ident) = ident else { continue };
                    let name = Name::Argument(arguments.len());
                    let dimension = inputs[input].dimension.rate(order);
                    scope.names.set_type(name, Type::Scalar(dimension), false);
                    arguments.push(Argument {
                        name: ident.to_string(),
                        dimension,
                        reference: None,
                    });
                }
                input += 1;
            }
        }
    }
    arguments
}

/// `argument NAME = value;`
fn resolve_argument(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &NamedItem,
    index: usize,
    position: usize,
) -> Argument {
    let context = Context {
        site: Site::Argument,
        item: position,
    };
    let mut reference = resolve_expression(scope, sink, &item.value, context);
    refuse_frame_item(sink, &mut reference, "an argument is a scalar");
    let bare_zero = matches!(reference.ty, Type::Zero(1));
    let mut ty = scope.units.declared(Name::Argument(index), &reference.ty);
    reference.settle(&ty);
    if !matches!(ty, Type::Scalar(_) | Type::Error) {
        let fact = format!("an argument is a scalar, found {ty}");
        let help = "declare one argument for each component";
        sink.error_with_help(item.value.span, fact, help);
        ty = Type::Error;
    }
    let dimension = ty.dimension().unwrap_or(Dimension::NUMBER);
    scope.names.set_type(Name::Argument(index), ty, bare_zero);
    Argument {
        name: item.name.to_string(),
        dimension,
        reference: Some(reference),
    }
}

/// Reports what must be known before functions are called and depends on an argument.
pub(in crate::model) fn refuse_argument(
    names: &Names,
    values: &Values,
    sink: &mut Sink,
    value: &mut Expr,
    what: &str,
) {
    let Some(argument) = values.argument_below(value) else {
        return;
    };
    let name = Name::Argument(argument);
    let symbol = names.symbol(name);
    let text = symbol.map_or("", |symbol| symbol.text.as_str());
    let fact = format!("{what} depends on the argument `{text}`");
    let help = "nothing that moves depends on arguments: declare a `param` or an `input`";
    let span = sink.span(value.origin);
    sink.error_with_help(span, fact, help);
    *value = error_expr(sink, span);
}
