//! Clauses: a word and what belongs to it, as in `on crank at p2`.

use proc_macro2::{Delimiter, Ident};

use super::ast::{Expr, SourceSpan};
use super::expression::PlusMinus;
use super::parser::{Parsed, Parser};
use super::words;
use crate::diagnostic::text::{list, nearest};

/// A clause that an item may have.
#[derive(Clone, Copy)]
pub(super) struct Rule {
    word: &'static str,
    content: Content,
    point: Point,
    repeats: bool,
}

#[derive(Clone, Copy)]
enum Content {
    /// A name of what these words say.
    Name(&'static str),
    Value,
}

/// Whether `at POINT` belongs to the clause.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Point {
    Never,
    Optional,
    Required,
}

impl Rule {
    /// A word and a name; `what` is what the name is of.
    pub(super) const fn name(word: &'static str, what: &'static str) -> Self {
        Rule {
            content: Content::Name(what),
            ..Self::value(word)
        }
    }

    /// A word and an expression.
    pub(super) const fn value(word: &'static str) -> Self {
        Rule {
            word,
            content: Content::Value,
            point: Point::Never,
            repeats: false,
        }
    }

    pub(super) const fn with_point(self) -> Self {
        Rule {
            point: Point::Required,
            ..self
        }
    }

    pub(super) const fn with_optional_point(self) -> Self {
        Rule {
            point: Point::Optional,
            ..self
        }
    }

    pub(super) const fn repeated(self) -> Self {
        Rule {
            repeats: true,
            ..self
        }
    }

    /// How a clause is read that belongs to other items.
    fn foreign(word: &'static str) -> Self {
        match word {
            "on" | "from" | "to" => Self::name(word, "a name"),
            "mass" | "inertia" => Self::value(word).with_optional_point(),
            _ => Self::value(word),
        }
    }
}

/// A clause as it was read; mistakes in it have been reported.
pub(super) struct Clause {
    word: &'static str,
    pub(super) name: Option<Ident>,
    /// The expression, or what stands for it after a mistake.
    pub(super) value: Expr,
    pub(super) point: Option<Expr>,
    pub(super) span: SourceSpan,
}

/// All clauses of one item.
#[derive(Default)]
pub(super) struct Clauses {
    found: Vec<Clause>,
    /// Something could not be read: what seems to be missing may be there.
    pub(super) broken: bool,
}

impl Clauses {
    pub(super) fn take(&mut self, word: &str) -> Option<Clause> {
        let index = self.found.iter().position(|clause| clause.word == word)?;
        Some(self.found.remove(index))
    }

    pub(super) fn take_name(&mut self, word: &str) -> Option<Ident> {
        self.take(word)?.name
    }

    pub(super) fn take_value(&mut self, word: &str) -> Option<Expr> {
        self.take(word).map(|clause| clause.value)
    }

    pub(super) fn take_all(&mut self, word: &str) -> Vec<Clause> {
        std::iter::from_fn(|| self.take(word)).collect()
    }

    fn has(&self, word: &str) -> bool {
        self.found.iter().any(|clause| clause.word == word)
    }
}

impl Parser<'_> {
    /// The clauses of an item in any order, commas between them or not, to the end of the item.
    pub(super) fn clauses(&mut self, item: &str, rules: &[Rule]) -> Clauses {
        let mut clauses = Clauses::default();
        loop {
            let is_decimal_comma = self.stream.is_punct(0, ',') && self.stream.literal(1).is_some();
            if !is_decimal_comma {
                self.stream.eat_punct(',');
            }
            if self.at_end_of_clauses() {
                return clauses;
            }
            if self.clause(item, rules, &mut clauses).is_err() {
                clauses.broken = true;
                self.stream.skip(1);
                self.skip_clause();
            }
        }
    }

    /// Reports a clause that is missing.
    pub(super) fn require(
        &mut self,
        clauses: &Clauses,
        item: &str,
        span: SourceSpan,
        (word, wanted): (&str, &str),
    ) {
        if !clauses.broken && !clauses.has(word) {
            let fact = format!("the `{item}` lacks `{word}`");
            let help = format!("write `{wanted}`");
            self.diagnostics.error_with_help(span, &fact, &help);
        }
    }

    fn at_end_of_clauses(&self) -> bool {
        self.stream.at_end()
            || self.stream.is_punct(0, ';')
            || self.stream.is_punct(0, '#')
            || self.at_item()
    }

    fn clause(&mut self, item: &str, rules: &[Rule], clauses: &mut Clauses) -> Parsed<()> {
        let start = self.stream.span();
        let (rule, known) = self.rule(item, rules)?;
        self.stream.skip(1);
        let second = known && !rule.repeats && clauses.has(rule.word);
        if second {
            let fact = format!("a second `{}`", rule.word);
            let help = format!("`{item}` has one");
            self.diagnostics.error_with_help(start, &fact, &help);
        }
        let mut clause = Clause {
            word: rule.word,
            name: None,
            value: Expr::error(start),
            point: None,
            span: start,
        };
        match rule.content {
            Content::Name(what) => {
                clause.name = self.clause_name(rule.word, what);
                clauses.broken |= clause.name.is_none();
            }
            Content::Value => clause.value = self.clause_value(rule.word),
        }
        clause.point = self.clause_point(&rule);
        clause.span = start.to(self.stream.previous_span());
        if known && !second {
            clauses.found.push(clause);
        }
        Ok(())
    }

    /// What the next word begins, and whether the item may have it.
    fn rule(&mut self, item: &str, rules: &[Rule]) -> Parsed<(Rule, bool)> {
        let Some(ident) = self.stream.ident(0).cloned() else {
            return self.unexpected_after_expression("a clause or `;`");
        };
        let word = ident.to_string();
        if let Some(rule) = rules.iter().find(|rule| rule.word == word) {
            return Ok((*rule, true));
        }
        let words: Vec<&str> = rules.iter().map(|rule| rule.word).collect();
        let all = format!("clauses of `{item}` are {}", list(&words));
        if let Some(word) = words::clause(&word) {
            let fact = format!("`{word}` does not belong to `{item}`");
            let span = (&ident).into();
            self.diagnostics.error_with_help(span, &fact, &all);
            return Ok((Rule::foreign(word), false));
        }
        let meant = nearest(&word, words.iter().copied());
        let help = meant.map_or(all, |meant| format!("did you mean `{meant}`?"));
        let reported = self.expected("a clause or `;`", &help);
        match rules.iter().find(|rule| Some(rule.word) == meant) {
            Some(rule) => Ok((*rule, true)),
            None => reported,
        }
    }

    fn clause_name(&mut self, word: &str, what: &str) -> Option<Ident> {
        let wanted = format!("{what} after `{word}`");
        let name = match self.lacks_operand() {
            true => self.expected(&wanted, ""),
            false => self.name(&wanted),
        };
        if name.is_err() {
            self.skip_clause();
        }
        name.ok()
    }

    /// The expression after a clause's or a load's word; a mistake in it has been read over.
    pub(super) fn clause_value(&mut self, word: &str) -> Expr {
        let span = self.stream.previous_span();
        let value = match self.lacks_operand() {
            true => self.expected(&format!("an expression after `{word}`"), ""),
            false => self.sum(PlusMinus::JointIsMistake),
        };
        value.unwrap_or_else(|_| {
            self.skip_clause();
            Expr::error(span)
        })
    }

    fn clause_point(&mut self, rule: &Rule) -> Option<Expr> {
        if rule.point == Point::Never {
            return None;
        }
        if self.stream.eat_word("at") {
            return Some(self.clause_value("at"));
        }
        if rule.point == Point::Optional {
            return None;
        }
        let word = rule.word;
        let help = format!("write `{word} ... at POINT`");
        let _ = self.expected::<()>(&format!("`at` to complete `{word}`"), &help);
        // With a comma in front it is meant all the same.
        if self.stream.is_punct(0, ',') && self.stream.is_word(1, "at") {
            self.stream.skip(2);
            return Some(self.clause_value("at"));
        }
        Some(Expr::error(self.stream.previous_span()))
    }

    /// A clause begins here where an operand should stand. A name may look like a clause's word, but what follows
    /// a name is no operand.
    fn lacks_operand(&self) -> bool {
        self.at_clause_word() && self.at_operand(1)
    }

    pub(super) fn at_clause_word(&self) -> bool {
        self.stream
            .ident(0)
            .is_some_and(|ident| words::clause(&ident.to_string()).is_some())
    }

    fn at_operand(&self, ahead: usize) -> bool {
        let is_name = |ident: &Ident| words::clause(&ident.to_string()).is_none();
        self.stream.ident(ahead).is_some_and(is_name)
            || self.stream.literal(ahead).is_some()
            || self.stream.group(ahead, Delimiter::Parenthesis).is_some()
    }

    /// To the next clause or the end of the item, after a mistake.
    fn skip_clause(&mut self) {
        while !self.at_end_of_clauses()
            && !self.stream.is_punct(0, ',')
            && !(self.at_clause_word() && self.at_operand(1))
        {
            self.stream.skip(1);
        }
    }
}
