//! Messages about names of parts.

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::{list, nearest};
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::sink::Sink;
use crate::model::types::Name;

/// Reports a mechanism that is not in the call.
pub(in crate::model) fn refuse_unknown_mechanism(sink: &mut Sink, ident: &Ident, names: &[String]) {
    let text = ident.to_string();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let fact = format!("there is no mechanism `{text}` in this call");
    let help = match nearest(&text, names.iter().copied()) {
        Some(name) => format!("did you mean `{name}`?"),
        None if names.is_empty() => {
            format!("write `struct {text} {{ ... }}` in the same `mechanism!`")
        }
        None => format!("the others are {}", list(&names)),
    };
    sink.error_with_help(ident.into(), fact, help);
}

/// Reports a name that a part does not have.
pub(in crate::model) fn refuse_unknown_member(
    names: &Names,
    parts: &Parts,
    sink: &mut Sink,
    path: &str,
    member: &Ident,
) {
    if parts.is_broken_part(path) {
        return;
    }
    let text = member.to_string();
    let before = format!("{path}.");
    let symbols = names.symbols.iter();
    let names = symbols.filter_map(|symbol| symbol.text.strip_prefix(&before));
    let names: Vec<&str> = names.filter(|name| !name.contains('.')).collect();
    let mechanism = mechanism_name(parts, path);
    let fact = format!("the part `{path}`, a `{mechanism}`, has no `{text}`");
    let help = match nearest(&text, names.iter().copied()) {
        _ if is_body_or_joint(parts, &format!("{path}.{text}")) => {
            "that is a body or a joint: ask for forces like `reaction(joint)`".to_owned()
        }
        Some(name) => format!("did you mean `{path}.{name}`?"),
        None => format!("it has {}", list(&names)),
    };
    sink.error_with_help(member.into(), fact, help);
}

/// Returns true if a body or joint of a part has this name.
fn is_body_or_joint(parts: &Parts, path: &str) -> bool {
    let (first, rest) = path.split_once('.').unwrap_or((path, ""));
    let part = parts.scopes.iter().find(|part| part.name == first);
    part.and_then(|part| part.body.as_ref())
        .is_some_and(|body| {
            let mechanism = body.mechanism();
            let mut bodies = mechanism.bodies.iter().map(|body| &body.name);
            let mut joints = mechanism
                .joints
                .iter()
                .filter_map(|joint| joint.name.as_ref());
            bodies.any(|name| name == rest) || joints.any(|name| name == rest)
        })
}

/// Returns the name of the mechanism that a part is.
fn mechanism_name(parts: &Parts, path: &str) -> String {
    let (first, rest) = path.split_once('.').unwrap_or((path, ""));
    let part = parts.scopes.iter().find(|part| part.name == first);
    let Some(body) = part.and_then(|part| part.body.as_ref()) else {
        return String::new();
    };
    let mechanism = body.mechanism();
    let inner = mechanism.paths_of_parts().into_iter();
    let mut inner = inner.filter(|(path, _)| path == rest);
    inner
        .next()
        .map_or(mechanism.name.clone(), |(_, name)| name)
}

/// A part is no value.
pub(in crate::model) fn refuse_lonely_part(
    names: &Names,
    parts: &Parts,
    sink: &mut Sink,
    path: &str,
    span: SourceSpan,
) {
    if parts.is_broken_part(path) {
        return;
    }
    let before = format!("{path}.");
    let mut symbols = names.symbols.iter();
    let example = symbols.find(|symbol| {
        matches!(symbol.name, Name::Let(_) | Name::Unknown(_)) && symbol.text.starts_with(&before)
    });
    let fact = format!("`{path}` is a part, which has no value of its own");
    let help = match example {
        Some(symbol) => format!("name what of it, like `{}`, {}", symbol.text, symbol.kind()),
        None => "name what of it".to_owned(),
    };
    sink.error_with_help(span, fact, help);
}
