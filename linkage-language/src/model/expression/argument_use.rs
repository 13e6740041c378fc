//! Values that cannot depend on arguments.

use super::nodes::error_expr;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::values::Values;
use crate::model::types::{Expr, Name};

/// Reports a value that depends on an argument, but must be known before functions are called.
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
