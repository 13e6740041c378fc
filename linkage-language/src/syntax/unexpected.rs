//! Hints for text after a complete expression.

use proc_macro2::{Delimiter, TokenTree};

use super::keyword::is_keyword;
use super::parser::{Parsed, Parser, Reported};
use crate::diagnostic::SourceSpan;

impl Parser<'_> {
    /// Reports the token after a complete expression, where only `wanted` may stand.
    pub(super) fn unexpected_after_expression<T>(&mut self, wanted: &str) -> Parsed<T> {
        if self.stream.is_punct(0, '^') {
            return self.no_powers();
        }
        if let Some(number) = self.decimal_comma() {
            let help = format!("write `{number}`: the decimal sign is a point");
            let fact = format!("expected {wanted}, found {}", self.found());
            let digits = self
                .stream
                .peek(1)
                .map(TokenTree::span)
                .map(SourceSpan::from);
            let whole = digits.map(|digits| self.stream.previous_span().to(digits));
            let message = self
                .diagnostics
                .error_with_help(self.stream.span(), fact, help);
            if let Some(span) = whole {
                message.suggest(format!("write `{number}`"), span, number);
            }
            return Err(Reported);
        }
        if self.at_tolerance() {
            return self.misplaced_tolerance();
        }
        let help = self.missing_operator();
        self.expected(wanted, &help)
    }

    pub(super) fn at_decimal_comma(&self) -> bool {
        self.decimal_comma().is_some()
    }

    /// Returns the number that was meant by `1,5mm`, which is read as `1` so far.
    fn decimal_comma(&self) -> Option<String> {
        let Some(TokenTree::Literal(before)) = self.stream.previous() else {
            return None;
        };
        let before = before.to_string();
        let is_integer = before.chars().all(|digit| digit.is_ascii_digit());
        let after = self.stream.literal(1)?;
        (is_integer && self.stream.is_punct(0, ',')).then(|| format!("{before}.{after}"))
    }

    fn missing_operator(&self) -> String {
        let before = match self.stream.previous() {
            Some(token @ (TokenTree::Literal(_) | TokenTree::Ident(_))) => token.to_string(),
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis => {
                "(...)".to_owned()
            }
            _ => return String::new(),
        };
        match self.stream.peek(0) {
            Some(TokenTree::Literal(after)) => format!(
                "write `{before} +- {after}` for a tolerance, `{before} * {after}` for a product"
            ),
            Some(TokenTree::Ident(after)) if after == "as" => "leave the conversion out".to_owned(),
            Some(TokenTree::Ident(after)) if is_keyword(&after.to_string()) => String::new(),
            Some(TokenTree::Ident(after)) => format!("write `{before} * {after}` for a product"),
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis => {
                format!("write `{before} * (...)` for a product")
            }
            _ => String::new(),
        }
    }
}
