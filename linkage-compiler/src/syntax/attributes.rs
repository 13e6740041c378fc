//! Attributes and visibilities: passed through or refused, never understood.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use super::ast::{Attribute, SourceSpan};
use super::parser::{Parsed, Parser};
use super::stream::Stream;

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
        let arguments = std::iter::from_fn(|| stream.next()).collect();
        Ok(Attribute {
            name,
            tokens,
            arguments,
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

    /// `pub`, `pub(crate)`, `pub(in path)` or nothing.
    pub(super) fn visibility(&mut self) -> TokenStream {
        let mut visibility = TokenStream::new();
        if self.stream.is_word(0, "pub") {
            visibility.extend(self.stream.next());
            if self.stream.group(0, Delimiter::Parenthesis).is_some() {
                visibility.extend(self.stream.next());
            }
        }
        visibility
    }
}
