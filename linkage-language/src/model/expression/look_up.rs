//! Names in expressions: which one is meant, and whether it can be used there.

use proc_macro2::Ident;

use super::link_messages::refuse_lonely_link;
use super::part_messages::refuse_lonely_part;
use super::refused_names::refuse_unknown_name;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, refusal};
use crate::model::types::{Name, Type};

/// Returns the name that a text means in this place; reports a text that means none.
pub(in crate::model) fn look_up_name(
    scope: &Scope,
    sink: &mut Sink,
    ident: &Ident,
    context: Context,
) -> Option<(Name, Type)> {
    let text = ident.to_string();
    let Some(symbol) = scope.names.find(&text) else {
        if scope.parts.is_part(&text) {
            refuse_lonely_part(&scope.names, &scope.parts, sink, &text, ident.into());
            return None;
        }
        if text == "PI" {
            return Some((Name::Pi, Type::NUMBER));
        }
        if refuse_lonely_link(&scope.parts, &scope.members.links, sink, ident) {
            return None;
        }
        if !scope.members.links.nameless {
            refuse_unknown_name(&scope.names, &scope.members, sink, ident, Some(context));
        }
        return None;
    };
    if let Some((fact, help)) = refusal(symbol, context) {
        sink.error_with_help(ident.into(), fact, help);
        return None;
    }
    Some((symbol.name, symbol.ty.clone()))
}
