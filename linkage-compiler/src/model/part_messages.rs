//! What is said of names of parts.

use proc_macro2::Ident;

use super::names::Resolver;
use crate::diagnostic::text::{list, nearest};

impl Resolver<'_> {
    /// Reports a mechanism that is not in the call.
    pub(super) fn unknown_mechanism(&mut self, ident: &Ident, names: &[String]) {
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
        self.diagnostics.error_with_help(ident.into(), fact, help);
    }

    /// Reports a name that a part does not have.
    pub(super) fn unknown_member(&mut self, path: &str, member: &Ident) {
        if self.is_broken_part(path) {
            return;
        }
        let text = member.to_string();
        let before = format!("{path}.");
        let symbols = self.symbols.iter();
        let own = symbols.filter_map(|symbol| symbol.text.strip_prefix(&before));
        let own: Vec<&str> = own.filter(|own| !own.contains('.')).collect();
        let mechanism = self.mechanism_of(path);
        let fact = format!("the part `{path}`, a `{mechanism}`, has no `{text}`");
        let help = match nearest(&text, own.iter().copied()) {
            _ if self.is_member(&format!("{path}.{text}")) => {
                "that is a body or a joint: ask for forces like `reaction(joint)`".to_owned()
            }
            Some(name) => format!("did you mean `{path}.{name}`?"),
            None => format!("it has {}", list(&own)),
        };
        self.diagnostics.error_with_help(member.into(), fact, help);
    }

    /// Whether a body or joint of a part has this name.
    fn is_member(&self, path: &str) -> bool {
        let (first, rest) = path.split_once('.').unwrap_or((path, ""));
        let part = self.parts.iter().find(|part| part.name == first);
        part.and_then(|part| part.body.as_ref())
            .is_some_and(|body| {
                let mechanism = body.mechanism();
                let mut bodies = mechanism.bodies.iter().map(|own| &own.name);
                let mut joints = mechanism.joints.iter().filter_map(|own| own.name.as_ref());
                bodies.any(|own| own == rest) || joints.any(|own| own == rest)
            })
    }

    /// What a part is called as a mechanism.
    fn mechanism_of(&self, path: &str) -> String {
        let (first, rest) = path.split_once('.').unwrap_or((path, ""));
        let part = self.parts.iter().find(|part| part.name == first);
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
}
