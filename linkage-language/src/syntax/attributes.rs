//! Attributes and visibilities: passed through or refused. Only `allow` is interpreted.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use super::ast::{Attribute, MechanismDef};
use super::parser::{Parsed, Parser};
use super::stream::{Stream, without_invisible_groups};
use crate::diagnostic::SourceSpan;

/// `crate`, `super`, `self`, or `in` and a path.
fn is_scope(group: &Group) -> bool {
    let words: Vec<String> = group
        .stream()
        .into_iter()
        .map(|token| token.to_string())
        .collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let is_path = |path: &[&str]| {
        let text = path.concat();
        !text.is_empty()
            && text
                .split("::")
                .all(|segment| syn::parse_str::<SegmentName>(segment).is_ok())
    };
    match words[..] {
        ["crate" | "super" | "self"] => true,
        ["in", ref path @ ..] => is_path(path),
        _ => false,
    }
}

/// One segment of a path, keywords such as `crate` included.
struct SegmentName;

impl MechanismDef {
    /// Returns the lints that the user allows in all code of the mechanism.
    pub fn allows(&self) -> TokenStream {
        let allows = self
            .attributes
            .iter()
            .filter(|attribute| attribute.name == "allow");
        allows
            .flat_map(|attribute| attribute.tokens.clone())
            .collect()
    }
}

impl Attribute {
    /// Returns true for `allow(deprecated)`, `allow(warnings)`: warnings are uses of deprecated
    /// items, so rustc then hides them.
    pub fn allows_warnings(&self) -> bool {
        let lints = self.arguments.to_string();
        self.name == "allow" && (lints.contains("deprecated") || lints.contains("warnings"))
    }

    /// Returns true for `allow(unused)`, `allow(dead_code)`: unused items are meant so.
    pub fn allows_unused(&self) -> bool {
        let lints = self.arguments.to_string();
        self.name == "allow" && (lints.contains("unused") || lints.contains("dead_code"))
    }
}

impl syn::parse::Parse for SegmentName {
    fn parse(input: syn::parse::ParseStream) -> syn::Result<Self> {
        use syn::ext::IdentExt;
        syn::Ident::parse_any(input).map(|_| Self)
    }
}

impl Parser<'_> {
    /// `#[...] #[...]`, doc comments included.
    pub(super) fn attributes(&mut self) -> Parsed<Vec<Attribute>> {
        let mut attributes = Vec::new();
        while self.stream.is_punct(0, '#') {
            if self.stream.is_punct(1, '!') {
                let help = "write `#[...]` before the item";
                return self.fail("an inner attribute cannot stand here", help);
            }
            let Some(group) = self.stream.group(1, Delimiter::Bracket).cloned() else {
                self.stream.skip(1);
                return self.expected("`[` after `#`", "");
            };
            let hash = self.stream.next();
            let span = self.stream.previous_span().to(group.span_close().into());
            self.stream.skip(1);
            let group = without_invisible_groups(&group);
            let tokens = hash
                .into_iter()
                .chain([TokenTree::Group(group.clone())])
                .collect();
            attributes.push(self.attribute(&group, tokens, span)?);
        }
        Ok(attributes)
    }

    fn attribute(
        &mut self,
        group: &Group,
        tokens: TokenStream,
        span: SourceSpan,
    ) -> Parsed<Attribute> {
        let mut stream = Stream::inside(group);
        let mut name = None;
        while let Some(segment) = stream.ident(0) {
            name = Some(segment.to_string());
            stream.skip(1);
            if stream.is_puncts("::") {
                stream.skip(2);
            }
        }
        let Some(name) = name else {
            return self.fail_at(span, "the attribute has no name", "");
        };
        let arguments: Vec<TokenTree> = std::iter::from_fn(|| stream.next()).collect();
        let well_formed = match &arguments[..] {
            [] | [TokenTree::Group(_)] => true,
            [TokenTree::Punct(equals), _, ..] => equals.as_char() == '=',
            _ => false,
        };
        if !well_formed {
            let fact = format!("attribute `{name}` is malformed");
            let help = "write `#[name]`, `#[name(...)]` or `#[name = ...]`";
            return self.fail_at(span, fact, help);
        }
        Ok(Attribute {
            name,
            tokens,
            arguments: arguments.into_iter().collect(),
            span,
        })
    }

    /// Reports attributes other than doc comments.
    pub(super) fn only_documentation(&mut self, attributes: &[Attribute], item: &str) {
        for attribute in attributes
            .iter()
            .filter(|attribute| attribute.name != "doc")
        {
            let fact = format!("attribute `{}` on {item} has no effect", attribute.name);
            let help = "attributes go on the struct, on a `param` or on a function";
            self.diagnostics.error_with_help(attribute.span, fact, help);
        }
    }

    /// `pub`, `pub`, `pub(in path)` or nothing.
    pub(super) fn visibility(&mut self) -> TokenStream {
        let mut visibility = TokenStream::new();
        if self.stream.is_word(0, "pub") {
            visibility.extend(self.stream.next());
            if let Some(group) = self.stream.group(0, Delimiter::Parenthesis).cloned() {
                self.stream.skip(1);
                if is_scope(&group) {
                    visibility.extend([TokenTree::Group(group)]);
                } else {
                    let fact = "the scope behind `pub` is malformed";
                    let help = "write `pub`, `pub(super)`, `pub(self)` or `pub(in path)`";
                    let span = group.span_open();
                    self.diagnostics.error_with_help(span.into(), fact, help);
                }
            }
        }
        visibility
    }
}
