//! Hints for text after a complete expression.

use proc_macro2::{Delimiter, TokenTree};

use super::keyword::is_keyword;
use super::parser::{Parsed, Parser, Reported};
use super::spelling::near_unit;

impl Parser<'_> {
    /// Reports the token after a complete expression, where only `wanted` may stand.
    pub(super) fn unexpected_after_expression<T>(&mut self, wanted: &str) -> Parsed<T> {
        if self.stream.is_punct(0, '^') {
            return self.no_powers();
        }
        self.refuse_decimal_comma()?;
        if self.at_tolerance() {
            return self.misplaced_tolerance();
        }
        let help = self.missing_operator();
        self.expected(wanted, &help)
    }

    pub(super) fn at_decimal_comma(&self) -> bool {
        self.decimal_comma().is_some()
    }

    /// Refuses `1,5mm`, which is read as `1` so far, where nothing else can follow the comma.
    pub(super) fn refuse_decimal_comma(&mut self) -> Parsed<()> {
        let Some([before, after]) = self.decimal_comma() else {
            return Ok(());
        };
        let span = self.stream.previous_span();
        let span = span.to(self
            .stream
            .literal(1)
            .map_or(span, |after| after.span().into()));
        let fact = format!("the number `{before},{after}` has a decimal comma");
        let number = format!("{before}.{after}");
        let help = format!("the decimal sign is a point: write `{number}`");
        let message = self.diagnostics.error_with_help(span, fact, help);
        message.suggest(format!("write `{number}`"), span, number);
        Err(Reported)
    }

    /// Returns the pieces of a number like `1,5mm`, which is read as `1` so far.
    fn decimal_comma(&self) -> Option<[String; 2]> {
        let Some(TokenTree::Literal(before)) = self.stream.previous() else {
            return None;
        };
        let before = before.to_string();
        let is_integer = before.chars().all(|digit| digit.is_ascii_digit());
        let after = self.stream.literal(1)?.to_string();
        (is_integer && self.stream.is_punct(0, ',')).then_some([before, after])
    }

    /// Returns the number that was meant by `104 mmm`, of which `104` has been read.
    pub(super) fn number_with_near_unit(&self) -> Option<String> {
        let number = match self.stream.previous() {
            Some(TokenTree::Literal(number)) => number.to_string(),
            _ => return None,
        };
        let unit = near_unit(&self.stream.ident(0)?.to_string())?;
        let is_bare = number.ends_with(|last: char| last.is_ascii_digit());
        is_bare.then(|| format!("{number}{unit}"))
    }

    fn missing_operator(&self) -> String {
        if let Some(number) = self.number_with_near_unit() {
            return format!("did you mean `{number}`?");
        }
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
