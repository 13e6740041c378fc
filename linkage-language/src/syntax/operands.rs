//! Operands of clauses: a name, an expression, a point.

use proc_macro2::Ident;

use super::clauses::{ClauseRule, Point};
use super::expression::PlusMinus;
use super::expression_tree::Expr;
use super::keyword::ClauseWord;
use super::mechanics_tree::Member;
use super::parser::{Parsed, Parser};
use super::vocabulary::Word;
use crate::diagnostic::SourceSpan;

impl Parser<'_> {
    /// The name after the word of a clause; a mistake in it has been read over.
    pub(super) fn clause_name(&mut self, word: ClauseWord, what: &str) -> Option<Member> {
        let wanted = format!("{what} after `{}`", word.word());
        let name = if self.lacks_operand() {
            self.expected(&wanted, "")
        } else {
            self.member(&wanted)
        };
        if name.is_err() {
            self.skip_clause();
        }
        name.ok()
    }

    /// `rod`, `hook.rod`
    pub(super) fn member(&mut self, what: &str) -> Parsed<Member> {
        let mut member = Member::from(&self.name(what)?);
        while self.stream.eat_punct('.') {
            let next = self.name("the name of a body or joint of the part")?;
            member.text.push('.');
            member.text.push_str(&next.to_string());
            member.span = member.span.to((&next).into());
        }
        Ok(member)
    }

    /// The expression after the word of a clause or a load; a mistake in it has been read over.
    pub(super) fn clause_value(&mut self, word: &str) -> Expr {
        let span = self.stream.previous_span();
        let value = if self.lacks_operand() || self.stream.is_punct(0, ',') {
            self.expected(&format!("an expression after `{word}`"), "")
        } else {
            self.before_clauses(|parser| parser.sum(PlusMinus::JointIsMistake))
        };
        match value {
            Ok(_) if self.at_decimal_comma() => {
                let _ = self.unexpected_after_expression::<()>("a clause");
                self.stream.skip(2);
                Expr::error(span)
            }
            Ok(value) => value,
            Err(_) => {
                self.skip_clause();
                Expr::error(span)
            }
        }
    }

    /// `at POINT` that belongs to the clause before it.
    pub(super) fn clause_point(&mut self, rule: &ClauseRule, start: SourceSpan) -> Option<Expr> {
        if rule.point == Point::Never {
            return None;
        }
        if self.stream.eat_word(ClauseWord::At.word()) {
            return Some(self.clause_value(ClauseWord::At.word()));
        }
        if rule.point == Point::Optional {
            return None;
        }
        let span = start.to(self.stream.previous_span());
        let fact = format!("`{}` lacks `at`", rule.word.word());
        let after_comma =
            self.stream.is_punct(0, ',') && self.stream.is_word(1, ClauseWord::At.word());
        if after_comma {
            let help = "leave out the comma before `at`";
            self.diagnostics.error_with_help(span, &fact, help);
            self.stream.skip(2);
            return Some(self.clause_value(ClauseWord::At.word()));
        }
        let help = format!("write `{} ... at POINT`", rule.word.word());
        self.diagnostics.error_with_help(span, &fact, &help);
        if !self.at_operand(0) || self.at_item() {
            return Some(Expr::error(span));
        }
        // The point, or `at` misspelt and the point.
        self.stream.skip(usize::from(self.at_operand(1)));
        Some(self.clause_value(ClauseWord::At.word()))
    }

    /// Returns true if a clause begins here instead of an operand, or the item ends. A name may
    /// look like a clause's word, but a name is followed by no operand.
    pub(super) fn lacks_operand(&self) -> bool {
        self.at_clause_word() && self.at_operand(1)
            || self.stream.at_end()
            || self.stream.is_punct(0, ';')
    }

    pub(super) fn at_clause_word(&self) -> bool {
        let is_clause = |ident: &Ident| ClauseWord::from_word(&ident.to_string()).is_some();
        self.stream.ident(0).is_some_and(is_clause)
    }

    /// Something that cannot follow a complete expression.
    pub(super) fn at_operand(&self, ahead: usize) -> bool {
        let is_name = |ident: &Ident| ClauseWord::from_word(&ident.to_string()).is_none();
        self.stream.ident(ahead).is_some_and(is_name)
            || self.stream.literal(ahead).is_some()
            || self.stream.parenthesis(ahead).is_some()
    }

    /// To the next clause or the end of the item, after a mistake.
    pub(super) fn skip_clause(&mut self) {
        let at_clause = |parser: &Self| parser.at_clause_word() && parser.at_operand(1);
        while !self.at_end_of_clause() && !at_clause(self) {
            self.stream.skip(1);
        }
    }

    /// Skips to the next clause that the item can have, after one that it cannot have; `at` may
    /// belong to that clause.
    pub(super) fn skip_to_clause(&mut self, rules: &[ClauseRule]) {
        let is_rule = |word: &Ident| {
            word != ClauseWord::At.word() && rules.iter().any(|rule| word == rule.word.word())
        };
        while !self.at_end_of_clause() && !self.stream.ident(0).is_some_and(is_rule) {
            self.stream.skip(1);
        }
    }

    fn at_end_of_clause(&self) -> bool {
        self.at_end_of_clauses() || self.stream.is_punct(0, ',')
    }

    pub(super) fn at_end_of_clauses(&self) -> bool {
        self.stream.at_end()
            || self.stream.is_punct(0, ';')
            || self.stream.is_punct(0, '#')
            || self.at_item()
    }
}
