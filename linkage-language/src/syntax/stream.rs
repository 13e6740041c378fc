//! Tokens of one block, with a position.

use proc_macro2::{Delimiter, Group, Ident, Literal, Spacing, Span, TokenStream, TokenTree};

use crate::diagnostic::SourceSpan;

/// The tokens between two delimiters. Reading past the end is allowed and finds nothing.
pub(super) struct Stream {
    tokens: Vec<TokenTree>,
    position: usize,
    /// The place of "the end" if something is missing there.
    end: Span,
}

impl Stream {
    pub(super) fn new(tokens: TokenStream) -> Self {
        let tokens = flatten(tokens);
        let end = tokens.last().map_or_else(Span::call_site, TokenTree::span);
        Stream {
            tokens,
            position: 0,
            end,
        }
    }

    pub(super) fn inside(group: &Group) -> Self {
        Stream {
            tokens: flatten(group.stream()),
            position: 0,
            end: group.span_close(),
        }
    }

    pub(super) fn peek(&self, ahead: usize) -> Option<&TokenTree> {
        self.tokens.get(self.position + ahead)
    }

    pub(super) fn next(&mut self) -> Option<TokenTree> {
        let token = self.peek(0).cloned()?;
        self.position += 1;
        Some(token)
    }

    pub(super) fn skip(&mut self, count: usize) {
        self.position = (self.position + count).min(self.tokens.len());
    }

    pub(super) fn at_end(&self) -> bool {
        self.peek(0).is_none()
    }

    pub(super) fn previous(&self) -> Option<&TokenTree> {
        self.tokens.get(self.position.checked_sub(1)?)
    }

    /// The next token, or the end of the block.
    pub(super) fn span(&self) -> SourceSpan {
        self.peek(0).map_or(self.end, TokenTree::span).into()
    }

    /// The token last read.
    pub(super) fn previous_span(&self) -> SourceSpan {
        self.previous().map_or(self.end, TokenTree::span).into()
    }

    pub(super) fn is_punct(&self, ahead: usize, wanted: char) -> bool {
        matches!(self.peek(ahead), Some(TokenTree::Punct(punct)) if punct.as_char() == wanted)
    }

    /// Returns true if the next tokens are these characters, with or without spaces between them.
    pub(super) fn is_puncts(&self, wanted: &str) -> bool {
        wanted
            .chars()
            .enumerate()
            .all(|(ahead, wanted)| self.is_punct(ahead, wanted))
    }

    pub(super) fn is_joint(&self) -> bool {
        matches!(self.peek(0), Some(TokenTree::Punct(punct)) if punct.spacing() == Spacing::Joint)
    }

    pub(super) fn eat_punct(&mut self, wanted: char) -> bool {
        let found = self.is_punct(0, wanted);
        self.skip(usize::from(found));
        found
    }

    pub(super) fn ident(&self, ahead: usize) -> Option<&Ident> {
        match self.peek(ahead) {
            Some(TokenTree::Ident(ident)) => Some(ident),
            _ => None,
        }
    }

    pub(super) fn literal(&self, ahead: usize) -> Option<&Literal> {
        match self.peek(ahead) {
            Some(TokenTree::Literal(literal)) => Some(literal),
            _ => None,
        }
    }

    pub(super) fn is_word(&self, ahead: usize, wanted: &str) -> bool {
        self.ident(ahead).is_some_and(|ident| ident == wanted)
    }

    pub(super) fn eat_word(&mut self, wanted: &str) -> bool {
        let found = self.is_word(0, wanted);
        self.skip(usize::from(found));
        found
    }

    pub(super) fn group(&self, ahead: usize, delimiter: Delimiter) -> Option<&Group> {
        match self.peek(ahead) {
            Some(TokenTree::Group(group)) if group.delimiter() == delimiter => Some(group),
            _ => None,
        }
    }

    /// Returns a parenthesis or its equivalent: an expression from a `macro_rules` macro.
    pub(super) fn parenthesis(&self, ahead: usize) -> Option<&Group> {
        self.group(ahead, Delimiter::Parenthesis)
            .or_else(|| self.group(ahead, Delimiter::None))
    }
}

/// Opens the invisible groups of `macro_rules` fragments. A group with an expression of several
/// tokens is kept: it has the precedence of a parenthesis.
fn flatten(tokens: TokenStream) -> Vec<TokenTree> {
    let mut flat = Vec::new();
    for token in tokens {
        match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
                let inner = flatten(group.stream());
                if inner.len() <= 1 || starts_declaration(&inner[0]) {
                    flat.extend(inner);
                } else {
                    flat.push(TokenTree::Group(group));
                }
            }
            other => flat.push(other),
        }
    }
    flat
}

/// Opens all invisible groups in a group, as `$m:meta`, `$p:path` and `$e:expr` leave them in an
/// attribute. None of them has a neighbour that could bind more strongly.
pub(super) fn without_invisible_groups(group: &Group) -> Group {
    fn opened(tokens: TokenStream) -> TokenStream {
        tokens
            .into_iter()
            .flat_map(|token| match token {
                TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
                    opened(group.stream())
                }
                TokenTree::Group(group) => {
                    TokenTree::Group(without_invisible_groups(&group)).into()
                }
                other => other.into(),
            })
            .collect()
    }
    let mut plain = Group::new(group.delimiter(), opened(group.stream()));
    plain.set_span(group.span());
    plain
}

/// `pub` and `#[...]`, from `$v:vis` and the like.
fn starts_declaration(token: &TokenTree) -> bool {
    match token {
        TokenTree::Ident(ident) => ident == "pub",
        TokenTree::Punct(punct) => punct.as_char() == '#',
        _ => false,
    }
}
