//! Attributes: which lints are silenced in generated code, and where the user's attributes go.

use proc_macro2::{TokenStream, TokenTree};

use super::code;
use linkage_language::syntax::Attribute;

/// Allows lints about style, which generated code has none of. Lints that users may `forbid` for
/// good reasons (`missing_docs`, `unsafe_code`) are not in the list: an `allow` would be an error
/// there.
pub(super) fn allow() -> TokenStream {
    code::tokens(
        "#[allow(
            dead_code,
            deprecated,
            non_camel_case_types,
            non_snake_case,
            non_upper_case_globals,
            unreachable_pub,
            unused_imports,
            unused_parens,
            unused_qualifications,
            unused_variables,
            clippy::all,
            clippy::nursery,
            clippy::pedantic,
            clippy::restriction
        )]",
    )
}

/// The derives of every generated data type, without those that the user asks for anyway, and
/// without those that are written out (`ours`).
pub(super) fn derives<'a>(
    user: impl IntoIterator<Item = &'a Attribute>,
    ours: &[&str],
) -> TokenStream {
    let taken = derived(user);
    let wanted = [
        ("Clone", "::core::clone::Clone"),
        ("Copy", "::core::marker::Copy"),
        ("Debug", "::core::fmt::Debug"),
        ("PartialEq", "::core::cmp::PartialEq"),
    ];
    let paths: Vec<_> = wanted
        .into_iter()
        .filter(|(name, _)| !ours.contains(name) && !taken.iter().any(|t| t == name))
        .map(|(_, p)| p)
        .collect();
    if paths.is_empty() {
        TokenStream::new()
    } else {
        code::tokens(&format!("#[derive({})]", paths.join(",")))
    }
}

/// The derives of the user.
pub(super) fn derived<'a>(user: impl IntoIterator<Item = &'a Attribute>) -> Vec<String> {
    let derives = user.into_iter().filter(|a| a.name == "derive");
    derives.flat_map(derived_names).collect()
}

/// Last path segments of `derive(a, b::c)`.
fn derived_names(attribute: &Attribute) -> Vec<String> {
    let mut names = Vec::new();
    let mut last = None;
    let mut pending: Vec<TokenTree> = attribute.arguments.clone().into_iter().collect();
    pending.reverse();
    while let Some(token) = pending.pop() {
        match token {
            TokenTree::Group(group) => {
                let inner: Vec<_> = group.stream().into_iter().collect();
                pending.extend(inner.into_iter().rev());
            }
            TokenTree::Ident(ident) => last = Some(ident.to_string()),
            TokenTree::Punct(punct) if punct.as_char() == ',' => names.extend(last.take()),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
    names.extend(last);
    names
}

/// True if the user wrote an attribute of this name.
pub(super) fn has(attributes: &[Attribute], name: &str) -> bool {
    attributes.iter().any(|a| a.name == name)
}

/// The attributes of a function by their destination: `cfg` goes to every item made for it,
/// `derive` to the result type, the others to the method.
pub(super) struct FunctionAttributes<'a> {
    pub everywhere: Vec<&'a TokenStream>,
    pub result: Vec<&'a Attribute>,
    pub method: Vec<&'a TokenStream>,
}

pub(super) fn split(attributes: &[Attribute]) -> FunctionAttributes<'_> {
    let mut split = FunctionAttributes {
        everywhere: vec![],
        result: vec![],
        method: vec![],
    };
    for attribute in attributes {
        match attribute.name.as_str() {
            "cfg" => split.everywhere.push(&attribute.tokens),
            "derive" => split.result.push(attribute),
            _ => split.method.push(&attribute.tokens),
        }
    }
    split
}

/// The text of the attributes that go to every item made for a function.
pub(super) fn everywhere(attributes: &[Attribute]) -> String {
    let everywhere = split(attributes).everywhere;
    everywhere.into_iter().map(code::text).collect()
}
