//! Arguments: loads and speeds that functions take at run time.

use crate::model::declare::passes::Taken;
use crate::model::dispatch::resolve_expression;
use crate::model::expression::frame_items::refuse_frame_item;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, Site};
use crate::model::types::{Argument, Dimension, Input, Name, Type};
use crate::syntax::NamedItem;

/// Resolves all arguments in the order of their names. Speeds and accelerations are declared at
/// their inputs.
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
