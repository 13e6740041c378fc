//! Clauses: a word and its operands, as in `on crank at p2`. The rules of an item list its clauses,
//! which come in any order.

use super::expression_tree::Expr;
use super::keyword::ClauseWord;
use super::mechanics_tree::Member;
use super::parser::{Parsed, Parser};
use super::vocabulary::Word;
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::{list, nearest};

/// A clause that an item may have.
#[derive(Clone, Copy)]
pub(super) struct ClauseRule {
    pub(super) word: ClauseWord,
    content: Content,
    pub(super) point: Point,
    repeats: bool,
}

#[derive(Clone, Copy)]
enum Content {
    /// A name; the text describes it in messages.
    Name(&'static str),
    Value,
}

/// The use of `at POINT` in the clause.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Point {
    Never,
    Optional,
    Required,
}

impl ClauseRule {
    /// A word and a name, which `what` describes.
    pub(super) const fn name(word: ClauseWord, what: &'static str) -> Self {
        ClauseRule {
            content: Content::Name(what),
            ..Self::value(word)
        }
    }

    /// A word and an expression.
    pub(super) const fn value(word: ClauseWord) -> Self {
        ClauseRule {
            word,
            content: Content::Value,
            point: Point::Never,
            repeats: false,
        }
    }

    pub(super) const fn with_point(self) -> Self {
        ClauseRule {
            point: Point::Required,
            ..self
        }
    }

    pub(super) const fn with_optional_point(self) -> Self {
        ClauseRule {
            point: Point::Optional,
            ..self
        }
    }

    pub(super) const fn repeated(self) -> Self {
        ClauseRule {
            repeats: true,
            ..self
        }
    }

    fn is_named(&self) -> bool {
        matches!(self.content, Content::Name(_))
    }

    /// Returns the rule of a clause that belongs to other items.
    fn foreign(word: ClauseWord) -> Self {
        match word {
            ClauseWord::On | ClauseWord::From | ClauseWord::To => Self::name(word, "a name"),
            ClauseWord::Mass | ClauseWord::Inertia => Self::value(word).with_optional_point(),
            ClauseWord::At
            | ClauseWord::Along
            | ClauseWord::About
            | ClauseWord::Turns
            | ClauseWord::Turned
            | ClauseWord::Free
            | ClauseWord::Radius
            | ClauseWord::Length => Self::value(word),
        }
    }
}

/// A clause as it was read; mistakes in it have been reported.
pub(super) struct Clause {
    word: ClauseWord,
    pub(super) name: Option<Member>,
    /// The expression, or its replacement after a mistake.
    pub(super) value: Expr,
    pub(super) point: Option<Expr>,
    pub(super) span: SourceSpan,
}

/// The item of the clauses, for messages.
#[derive(Clone, Copy)]
pub(super) struct Owner<'a> {
    /// Its kind, to follow an article.
    pub(super) what: &'a str,
    /// The form of the item.
    pub(super) form: &'a str,
    pub(super) span: SourceSpan,
}

/// All clauses of one item.
#[derive(Default)]
pub(super) struct Clauses {
    found: Vec<Clause>,
    /// True after a reported mistake: other clauses can seem to be missing, doubled or misplaced
    /// because of it.
    pub(super) broken: bool,
}

impl Clauses {
    pub(super) fn take(&mut self, word: ClauseWord) -> Option<Clause> {
        let index = self.found.iter().position(|clause| clause.word == word)?;
        Some(self.found.remove(index))
    }

    pub(super) fn take_name(&mut self, word: ClauseWord) -> Option<Member> {
        self.take(word)?.name
    }

    pub(super) fn take_value(&mut self, word: ClauseWord) -> Option<Expr> {
        self.take(word).map(|clause| clause.value)
    }

    pub(super) fn take_all(&mut self, word: ClauseWord) -> impl Iterator<Item = Clause> {
        std::iter::from_fn(move || self.take(word))
    }

    fn has(&self, word: ClauseWord) -> bool {
        self.found.iter().any(|clause| clause.word == word)
    }
}

impl Parser<'_> {
    /// The clauses of an item, commas between them or not, to its end.
    pub(super) fn clauses(&mut self, owner: Owner, rules: &[ClauseRule]) -> Clauses {
        let mut clauses = Clauses::default();
        loop {
            self.stream.eat_punct(',');
            if self.at_end_of_clauses() {
                return clauses;
            }
            let start = self.stream.span();
            match self.clause_word(owner, rules, &clauses) {
                Ok((rule, known)) => {
                    let second = self.is_second(owner, &rule, start, &clauses);
                    let clause = self.clause(&rule, start);
                    let lost = rule.is_named() && clause.name.is_none();
                    clauses.broken |= lost || !known;
                    if known && !second {
                        clauses.found.push(clause);
                    }
                }
                Err(_) => {
                    clauses.broken = true;
                    self.stream.skip(1);
                    self.skip_to_clause(rules);
                }
            }
        }
    }

    /// Reads the word of the next clause. The flag is true if the item can have the clause.
    fn clause_word(
        &mut self,
        owner: Owner,
        rules: &[ClauseRule],
        clauses: &Clauses,
    ) -> Parsed<(ClauseRule, bool)> {
        let Some(ident) = self.stream.ident(0).cloned() else {
            return self.unexpected_after_expression("a clause or `;`");
        };
        let find = |word: &str| {
            let mut rules = rules.iter();
            rules.find(|rule| rule.word.word() == word).copied()
        };
        let word = ident.to_string();
        if let Some(rule) = find(&word) {
            self.stream.skip(1);
            return Ok((rule, true));
        }
        let words: Vec<&str> = rules.iter().map(|rule| rule.word.word()).collect();
        let help = format!("clauses of a {} are {}", owner.what, list(&words));
        if let Some(foreign) = ClauseWord::from_word(&word) {
            if !clauses.broken {
                let fact = format!("`{word}` does not belong to a {}", owner.what);
                let span = (&ident).into();
                self.diagnostics.error_with_help(span, &fact, &help);
            }
            self.stream.skip(1);
            return Ok((ClauseRule::foreign(foreign), false));
        }
        if let Some(rule) = nearest(&word, words).and_then(find) {
            let help = format!("did you mean `{}`?", rule.word.word());
            let _ = self.expected::<()>("a clause or `;`", &help);
            self.stream.skip(1);
            return Ok((rule, true));
        }
        let first = rules[0].word;
        let is_body = !self.at_operand(1) && !self.stream.is_word(1, "on");
        if first == ClauseWord::On && clauses.found.is_empty() && !clauses.broken && is_body {
            let _ = self.expected::<()>("`on`", &format!("write `on {word}`"));
            return Ok((rules[0], true));
        }
        self.expected("a clause or `;`", &help)
    }

    fn is_second(
        &mut self,
        owner: Owner,
        rule: &ClauseRule,
        start: SourceSpan,
        clauses: &Clauses,
    ) -> bool {
        let second = !rule.repeats && clauses.has(rule.word);
        if second && !clauses.broken {
            let fact = format!("a second `{}`", rule.word.word());
            let help = format!("a {} has one", owner.what);
            self.diagnostics.error_with_help(start, &fact, &help);
        }
        second
    }

    /// Reads the rest of a clause after its word.
    fn clause(&mut self, rule: &ClauseRule, start: SourceSpan) -> Clause {
        let (name, value) = match rule.content {
            Content::Name(what) => (self.clause_name(rule.word, what), Expr::error(start)),
            Content::Value => {
                // It reads better with its `by`.
                if rule.word == ClauseWord::Turned {
                    self.stream.eat_word("by");
                }
                (None, self.clause_value(rule.word.word()))
            }
        };
        let lost = rule.is_named() && name.is_none();
        let point = if lost && !self.stream.is_word(0, "at") {
            None
        } else {
            self.clause_point(rule, start)
        };
        Clause {
            word: rule.word,
            name,
            value,
            point,
            span: start.to(self.stream.previous_span()),
        }
    }

    /// Reports those of the words that no clause begins with.
    pub(super) fn require(&mut self, clauses: &Clauses, owner: Owner, words: &[ClauseWord]) {
        let missing = words.iter().filter(|word| !clauses.has(**word));
        let missing: Vec<&str> = missing.map(|word| word.word()).collect();
        if !missing.is_empty() && !clauses.broken {
            let fact = format!("the {} lacks {}", owner.what, list(&missing));
            self.lacks(owner, &fact);
        }
    }

    pub(super) fn lacks(&mut self, owner: Owner, fact: &str) {
        let help = format!("write `{}`", owner.form);
        self.diagnostics.error_with_help(owner.span, fact, &help);
    }
}
