//! Names of a part, as seen from the mechanism around it.

use proc_macro2::Ident;

use super::nodes::{error_expr, make_expr};
use super::part_messages::{refuse_lonely_part, refuse_unknown_member};
use crate::diagnostic::SourceSpan;
use crate::model::symbols::declared_names::{Names, Symbol};
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, Site, refusal};
use crate::model::types::{Expr, ExprKind, Name, Placed};

/// Resolves `hook.tip`: a name of a part, in the frame of the mechanism around it.
pub(in crate::model) fn resolve_member(
    names: &Names,
    parts: &Parts,
    sink: &mut Sink,
    path: &str,
    member: &Ident,
    context: Context,
    span: SourceSpan,
) -> Expr {
    let text = format!("{path}.{member}");
    if parts.is_part(&text) {
        refuse_lonely_part(names, parts, sink, &text, span);
        return error_expr(sink, span);
    }
    let Some(symbol) = names.find(&text) else {
        refuse_unknown_member(names, parts, sink, path, member);
        return error_expr(sink, span);
    };
    let refused = order_refusal(parts, symbol, context);
    let refused = refused.or_else(|| refusal(symbol, context));
    if let Some((fact, help)) = refused {
        sink.error_with_help(span, fact, help);
        return error_expr(sink, span);
    }
    let (name, ty) = (symbol.name, symbol.ty.clone());
    let mut value = make_expr(sink, ExprKind::Name(name), ty, span);
    let around = parts.placed.iter();
    let around = around.filter(|part| {
        let rest = text.strip_prefix(part.path.as_str());
        rest.is_some_and(|rest| rest.starts_with('.'))
    });
    let mut around: Vec<&Placed> = around.collect();
    // The innermost part comes first.
    around.sort_by_key(|part| std::cmp::Reverse(part.path.len()));
    for part in around {
        value = part.frame().seen(value);
    }
    value
}

/// Returns a message for a name of a part that is used before the part's item: its values and its
/// location are unknown there.
pub(in crate::model) fn order_refusal(
    parts: &Parts,
    symbol: &Symbol,
    context: Context,
) -> Option<(String, String)> {
    let text = &symbol.text;
    let first = text.split('.').next().unwrap_or_default();
    let part = parts.scopes.iter().find(|part| part.name == first)?;
    let body = part.body.as_ref();
    let placed = body.is_some_and(|body| body.is_placed || body.is_turned);
    let ordered = matches!(context.site, Site::LetOrLoop) && part.item > context.item;
    let fact = match symbol.name {
        _ if !ordered => return None,
        Name::Let(_) => format!("`{text}` is used before the part `{first}`"),
        _ if placed => format!("`{text}` is used before it is known where `{first}` stands"),
        _ => return None,
    };
    Some((fact, format!("move the part `{first}` up")))
}
