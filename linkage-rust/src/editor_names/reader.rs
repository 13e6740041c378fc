//! The words within an item or a function, read from its tokens.

use linkage_language::syntax::{first_spelling, is_clause_word};
use proc_macro2::{Delimiter, Group, Ident, Literal, TokenTree};

use super::uses::{Clauses, Use};
use crate::spanned::aside;

/// The declared names of an item.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Declares {
    Nothing,
    /// The first name.
    First,
    /// Each name in front of `=`.
    Several,
}

/// Reads the words within an item or a function.
pub(super) struct Reader<'u> {
    pub(super) clauses: Clauses,
    pub(super) uses: &'u mut Vec<Use>,
}

impl Reader<'_> {
    /// Returns the names that are fields by themselves.
    pub(super) fn quantities(&mut self, tokens: &[TokenTree]) -> Vec<String> {
        let mut fields = Vec::new();
        for quantity in tokens.split(|token| is_punct(Some(token), ',')) {
            let named = quantity
                .iter()
                .rposition(|token| is_punct(Some(token), '#'))
                .map_or(quantity, |doc| &quantity[(doc + 2).min(quantity.len())..]);
            match named {
                [TokenTree::Ident(_), colon, value @ ..] if is_punct(Some(colon), ':') => {
                    self.expression(value, Declares::Nothing);
                }
                _ => {
                    self.expression(named, Declares::Nothing);
                    if let [TokenTree::Ident(field)] = named {
                        fields.push(field.to_string());
                    }
                }
            }
        }
        fields
    }

    /// `KIND on BODY at POINT`, or `KIND NAME on BODY at POINT`, which declares the joint.
    pub(super) fn joint(&mut self, tokens: &[TokenTree]) {
        let [TokenTree::Ident(kind), rest @ ..] = tokens else {
            return self.expression(tokens, Declares::Nothing);
        };
        self.uses.push(Use::Item(kind.clone()));
        let is_named =
            matches!(rest, [TokenTree::Ident(name), ..] if !is_clause_word(&name.to_string()));
        let (name, clauses) = rest.split_at(usize::from(is_named));
        self.expression(name, Declares::First);
        self.words(clauses, Declares::Nothing, true);
    }

    pub(super) fn expression(&mut self, tokens: &[TokenTree], declares: Declares) {
        self.words(tokens, declares, false);
    }

    /// Reads the words of an item. After a value, a word begins a clause and is no name.
    fn words(&mut self, tokens: &[TokenTree], declares: Declares, mut is_after_value: bool) {
        let mut index = 0;
        while let Some(token) = tokens.get(index) {
            let before = index.checked_sub(1).and_then(|before| tokens.get(before));
            let begins_clause =
                is_after_value || is_punct(before, ',') && begins_clause(&tokens[index + 1..]);
            let is_after =
                std::mem::replace(&mut is_after_value, !matches!(token, TokenTree::Punct(_)));
            index += 1;
            match token {
                TokenTree::Group(group) => self.group(group, tokens.first()),
                TokenTree::Ident(word)
                    if is_after || begins_clause && is_clause_word(&word.to_string()) =>
                {
                    is_after_value = false;
                    self.uses.push(Use::Clause(word.clone(), self.clauses));
                }
                TokenTree::Ident(name) => {
                    let declares = match declares {
                        Declares::Nothing => false,
                        Declares::First => index == 1,
                        Declares::Several => is_punct(tokens.get(index), '='),
                    };
                    let mut path = vec![name.clone()];
                    while let (true, Some(TokenTree::Ident(member))) =
                        (is_punct(tokens.get(index), '.'), tokens.get(index + 1))
                    {
                        path.push(member.clone());
                        index += 2;
                    }
                    let is_call = matches!(tokens.get(index), Some(TokenTree::Group(group))
                        if group.delimiter() == Delimiter::Parenthesis);
                    self.uses.push(match is_call && !declares {
                        true => Use::Call(name.clone()),
                        false => Use::Name { path, declares },
                    });
                }
                TokenTree::Literal(literal) => self.uses.extend(unit_of(literal).map(Use::Unit)),
                TokenTree::Punct(_) => {}
            }
        }
    }

    /// Reads a parenthesis, a list, or the values that are given to a part.
    fn group(&mut self, group: &Group, first: Option<&TokenTree>) {
        let inner: Vec<TokenTree> = group.stream().into_iter().collect();
        match (group.delimiter(), first) {
            (Delimiter::Brace, Some(TokenTree::Ident(part))) => self.given(part, &inner),
            _ => self.expression(&inner, Declares::Nothing),
        }
    }

    /// `NAME = expression, ...` of a part: the names are those of its mechanism.
    fn given(&mut self, part: &Ident, tokens: &[TokenTree]) {
        for one in tokens.split(|token| is_punct(Some(token), ',')) {
            let (name, value) = match one {
                [TokenTree::Ident(name), equals, value @ ..] if is_punct(Some(equals), '=') => {
                    (Some(name), value)
                }
                _ => (None, one),
            };
            self.uses.extend(name.map(|name| Use::Name {
                path: vec![aside(part), name.clone()],
                declares: false,
            }));
            self.expression(value, Declares::Nothing);
        }
    }
}

/// Returns the unit of a number, at its place.
fn unit_of(literal: &Literal) -> Option<Ident> {
    let text = literal.to_string();
    let digits = text.trim_end_matches(char::is_alphabetic).len();
    first_spelling(&text[digits..]).map(|unit| Ident::new(unit, literal.span()))
}

/// Returns true for tokens that can follow the word of a clause.
fn begins_clause(tokens: &[TokenTree]) -> bool {
    let is_plain = |index| match tokens.get(index) {
        Some(TokenTree::Ident(name)) => !is_clause_word(&name.to_string()),
        Some(TokenTree::Group(_) | TokenTree::Literal(_)) => true,
        Some(TokenTree::Punct(_)) | None => false,
    };
    let is_named = matches!(tokens.first(), Some(TokenTree::Ident(_))) && !is_plain(1);
    is_plain(0) || is_named
}

pub(super) fn is_punct(token: Option<&TokenTree>, wanted: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == wanted)
}
