//! Doc strings of generated items, and the words in them.

use proc_macro2::TokenStream;
use quote::quote;

use super::code;
use linkage_compiler::ir::{CompiledMechanism, Role, plain};
use linkage_language::syntax::Attribute;

/// `#[doc = " ..."]` for each line.
pub(super) fn doc(text: &str) -> TokenStream {
    code::tokens(&doc_text(text))
}

/// The text of [`doc`].
pub(super) fn doc_text(text: &str) -> String {
    let lines = text.lines();
    lines
        .map(|line| match line {
            "" => "#[doc = \"\"]".to_owned(),
            line => format!("#[doc = {:?}]", format!(" {line}")),
        })
        .collect()
}

/// The user's attributes, docs included, and then a generated paragraph: `note` after the docs,
/// `alone` if there are none.
pub(super) fn with_note(
    attributes: &[&TokenStream],
    documented: bool,
    note: &str,
    alone: &str,
) -> TokenStream {
    let doc = match (documented, note.is_empty()) {
        (true, true) => TokenStream::new(),
        (true, false) => doc(&format!("\n{note}")),
        (false, _) => doc(alone),
    };
    quote!(#(#attributes)* #doc)
}

/// A drawing as a paragraph of docs; empty without one. Only rustdoc reads it: an editor would show
/// its text.
pub(super) fn drawing(html: &str) -> TokenStream {
    if html.is_empty() {
        return TokenStream::new();
    }
    let paragraph = format!("\n {html}");
    quote!(#[cfg_attr(doc, doc = #paragraph)])
}

/// The tokens of attributes.
pub(super) fn tokens(attributes: &[Attribute]) -> Vec<&TokenStream> {
    attributes.iter().map(|a| &a.tokens).collect()
}

/// True if the user wrote a doc comment.
pub(super) fn documented(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|a| a.name == "doc")
}

/// The description of a field that follows its name: `, in mm`, or `` : derivative of `p` by `phi`,
/// in mm/rad ``.
pub(super) fn behind_name(about: &str) -> String {
    match about {
        "" => String::new(),
        unit if unit.starts_with("in ") => format!(", {unit}"),
        about => format!(": {about}"),
    }
}

/// Words as a sentence of their own.
pub(super) fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(|letter| letter.to_uppercase());
    let first: String = first.into_iter().flatten().collect();
    format!("{first}{}.", letters.as_str())
}

/// `, in mm`, or nothing for a pure number.
pub(super) fn in_unit(unit: &str) -> String {
    if unit.is_empty() {
        String::new()
    } else {
        format!(", in {unit}")
    }
}

/// `` `phi`, in rad ``, `` `omega`, the speed of `phi`, in rad/s ``
pub(super) fn argument(name: &str, index: usize, unit: &CompiledMechanism) -> String {
    let Some(argument) = index.checked_sub(unit.inputs.len()) else {
        return format!("`{name}`{}", in_unit(&unit.inputs[index].unit));
    };
    let argument = &unit.arguments[argument];
    let input = |input: usize| plain(&unit.inputs[input].name);
    let role = match argument.role {
        Role::Speed(of) => format!(", the speed of `{}`", input(of)),
        Role::Acceleration(of) => format!(", the acceleration of `{}`", input(of)),
        Role::Load => String::new(),
    };
    format!("`{name}`{role}{}", in_unit(&argument.unit))
}
