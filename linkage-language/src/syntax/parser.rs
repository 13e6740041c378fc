//! Shared parts of all grammar rules: the position, the sink for mistakes, names and lists.

use proc_macro2::{Delimiter, Group, Ident, Literal, TokenTree};

use super::keyword::is_keyword;
use super::stream::Stream;
use crate::diagnostic::{Diagnostics, SourceSpan};

/// A mistake that has been reported; the rule that recovers from it carries on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reported;

pub(super) type Parsed<T> = Result<T, Reported>;

/// Deepest nesting of parentheses and signs, so that no later phase runs out of stack.
const NESTING_LIMIT: usize = 64;
/// Most operators in one item, for the same reason: a chain of operators is a deep tree.
const OPERATOR_LIMIT: usize = 1000;

pub(super) struct Parser<'a> {
    pub(super) stream: Stream,
    pub(super) diagnostics: &'a mut Diagnostics,
    nesting: usize,
    operators: usize,
    /// Clauses may follow the expression that is being read, outside of its parentheses.
    clauses_follow: bool,
}

impl<'a> Parser<'a> {
    pub(super) fn new(stream: Stream, diagnostics: &'a mut Diagnostics) -> Self {
        Parser {
            stream,
            diagnostics,
            nesting: 0,
            operators: 0,
            clauses_follow: false,
        }
    }

    /// Applies a rule to the content of a group.
    pub(super) fn within<T>(&mut self, group: &Group, rule: impl FnOnce(&mut Parser) -> T) -> T {
        let mut inner = Parser {
            stream: Stream::inside(group),
            diagnostics: &mut *self.diagnostics,
            nesting: self.nesting,
            operators: self.operators,
            clauses_follow: false,
        };
        let result = rule(&mut inner);
        self.operators = inner.operators;
        result
    }

    /// A rule that may contain itself.
    pub(super) fn nested<T>(&mut self, rule: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.nesting == NESTING_LIMIT {
            let fact = format!("the expression is nested more than {NESTING_LIMIT} levels deep");
            return self.fail(fact, "name parts of it with `let`");
        }
        self.nesting += 1;
        let result = rule(self);
        self.nesting -= 1;
        result
    }

    pub(super) fn clauses_follow(&self) -> bool {
        self.clauses_follow
    }

    /// Applies a rule whose expression ends before a clause.
    pub(super) fn before_clauses<T>(
        &mut self,
        rule: impl FnOnce(&mut Self) -> Parsed<T>,
    ) -> Parsed<T> {
        self.clauses_follow = true;
        let result = rule(self);
        self.clauses_follow = false;
        result
    }

    pub(super) fn count_operator(&mut self) -> Parsed<()> {
        self.operators += 1;
        if self.operators <= OPERATOR_LIMIT {
            return Ok(());
        }
        let fact = format!("more than {OPERATOR_LIMIT} operators in one item");
        self.fail(fact, "name parts of it with `let`")
    }

    pub(super) fn start_item(&mut self) {
        self.operators = 0;
    }

    /// A mistake at the next token.
    pub(super) fn fail<T>(&mut self, fact: impl AsRef<str>, help: &str) -> Parsed<T> {
        self.fail_at(self.stream.span(), fact, help)
    }

    /// A mistake; an empty `help` leaves that line out.
    pub(super) fn fail_at<T>(
        &mut self,
        span: SourceSpan,
        fact: impl AsRef<str>,
        help: &str,
    ) -> Parsed<T> {
        match help {
            "" => self.diagnostics.error(span, fact.as_ref()),
            _ => self.diagnostics.error_with_help(span, fact.as_ref(), help),
        };
        Err(Reported)
    }

    /// `expected WANTED, found NEXT TOKEN`
    pub(super) fn expected<T>(&mut self, wanted: &str, help: &str) -> Parsed<T> {
        let found = self.found();
        self.fail(format!("expected {wanted}, found {found}"), help)
    }

    /// Returns the next token as text.
    pub(super) fn found(&self) -> String {
        match self.stream.peek(0) {
            None => "the end".to_owned(),
            Some(TokenTree::Group(group)) => match group.delimiter() {
                Delimiter::Parenthesis => "`(`".to_owned(),
                Delimiter::Bracket => "`[`".to_owned(),
                Delimiter::Brace => "`{`".to_owned(),
                Delimiter::None => "an expression".to_owned(),
            },
            Some(TokenTree::Ident(ident)) if is_keyword(&ident.to_string()) => {
                format!("keyword `{ident}`")
            }
            Some(token) => format!("`{token}`"),
        }
    }

    /// Reads a name chosen by the user; `what` describes it in messages.
    pub(super) fn name(&mut self, what: &str) -> Parsed<Ident> {
        let Some(ident) = self.stream.ident(0).cloned() else {
            return self.expected(what, "");
        };
        let text = ident.to_string();
        if is_keyword(&text) {
            let help = format!("choose another name, like `{text}_`");
            let help = if text == "_" { "choose a name" } else { &help };
            return self.fail(
                format!("`{text}` is a keyword of Rust and cannot be a name"),
                help,
            );
        }
        if let Some(plain) = text.strip_prefix("r#") {
            let help = format!("choose another name, like `{plain}_`");
            return self.fail(
                format!("the raw identifier `{text}` cannot be a name"),
                &help,
            );
        }
        self.stream.skip(1);
        Ok(ident)
    }

    pub(super) fn literal(&mut self) -> Option<Literal> {
        let literal = self.stream.literal(0).cloned()?;
        self.stream.skip(1);
        Some(literal)
    }

    /// Reads `rule , rule , ...` to the end of the group, with an optional trailing comma. Returns
    /// true if there was one.
    pub(super) fn comma_list<T>(
        &mut self,
        closing: &str,
        mut rule: impl FnMut(&mut Self) -> Parsed<T>,
    ) -> Parsed<(Vec<T>, bool)> {
        let mut list = Vec::new();
        let mut trailing = false;
        while !self.stream.at_end() {
            list.push(rule(self)?);
            trailing = self.stream.eat_punct(',');
            if !trailing && !self.stream.at_end() {
                return self.unexpected_after_expression(&format!("`,` or `{closing}`"));
            }
        }
        Ok((list, trailing))
    }
}
