//! A text with the results of its analysis, and those of the last text without a mistake.

use std::cell::OnceCell;
use std::ops::Range;

use crate::analysis::{Analysis, analyse};
use crate::diagnostics::Diagnostic;
use crate::facts::Facts;
use crate::lexer::{Token, tokens};
use crate::name_values::{Value, Values, values};
use crate::outline::{NameKind, Outline, outlines};
use crate::position::Lines;
use crate::repair::readable;
use crate::statements::statements;
use crate::uses::{Symbol, Use, declaration, uses};

/// A text and all that is known about it.
///
/// Messages and names are those of the present text, also while it is being written. Values are
/// those of the last text that could be compiled.
///
/// A change makes spans of this thread's other tokens of proc-macro2 invalid.
///
/// ```
/// use linkage_editor::Document;
///
/// let text = "struct Crank { unit mm; param r = 30mm; input phi = 30deg; let tip = polar(r, phi); }";
/// let mut document = Document::new("crank.mech", text);
/// assert!(document.diagnostics().is_empty());
/// let hover = document.hover(text.find("tip").unwrap()).unwrap();
/// assert!(hover.markdown.contains("(25.98076mm, 15mm)"), "{}", hover.markdown);
///
/// document.set_text(&text.replace("polar(r", "polar(q"));
/// assert_eq!(document.diagnostics()[0].message, "unknown name `q`");
/// ```
#[derive(Debug)]
pub struct Document {
    name: String,
    pub(crate) text: String,
    pub(crate) lines: Lines,
    pub(crate) tokens: Vec<Token>,
    pub(crate) outlines: Vec<Outline>,
    pub(crate) uses: Vec<Use>,
    analysis: Analysis,
    /// Types of the names of all mechanisms, each from the last text in which it had no mistake.
    facts: Vec<Facts>,
    runnable: Option<Runnable>,
}

/// The last text that could be compiled.
#[derive(Debug)]
struct Runnable {
    text: String,
    outlines: Vec<Outline>,
    facts: Vec<Facts>,
    values: OnceCell<Vec<Values>>,
}

impl Document {
    /// Reads a text. A name that ends with `.rs` is that of a Rust file with calls of `mechanism!`,
    /// of which only messages are known.
    #[must_use]
    pub fn new(name: &str, text: &str) -> Self {
        let mut document = Self {
            name: name.to_owned(),
            text: String::new(),
            lines: Lines::new(""),
            tokens: Vec::new(),
            outlines: Vec::new(),
            uses: Vec::new(),
            analysis: Analysis::default(),
            facts: Vec::new(),
            runnable: None,
        };
        document.set_text(text);
        document
    }

    /// Replaces the text.
    pub fn set_text(&mut self, text: &str) {
        text.clone_into(&mut self.text);
        self.lines = Lines::new(text);
        self.analysis = analyse(&self.name, text);
        if self.is_rust() {
            return;
        }
        self.tokens = tokens(text);
        let repaired = readable(text, &self.tokens);
        self.outlines = match &repaired {
            // Bytes that were added at the end are in no token of the text.
            Some(repaired) => outlines(repaired, &tokens(repaired)),
            None => outlines(text, &self.tokens),
        };
        self.uses = uses(text, &self.tokens, &self.outlines);
        for facts in &self.analysis.facts {
            self.facts.retain(|old| old.mechanism != facts.mechanism);
            self.facts.push(facts.clone());
        }
        if self.analysis.runs && !self.analysis.facts.is_empty() {
            self.runnable = Some(Runnable {
                text: text.to_owned(),
                outlines: self.outlines.clone(),
                facts: self.analysis.facts.clone(),
                values: OnceCell::new(),
            });
        }
    }

    /// Replaces some bytes of the text, without an analysis: [`set_text`](Self::set_text) follows
    /// after the last of several replacements.
    ///
    /// # Panics
    ///
    /// If the range is not in the text, or cuts a character.
    #[must_use]
    pub fn edit(text: &str, range: Range<usize>, replacement: &str) -> String {
        [&text[..range.start], replacement, &text[range.end..]].concat()
    }

    /// Returns the text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns the lines of the text.
    #[must_use]
    pub fn lines(&self) -> &Lines {
        &self.lines
    }

    /// Returns all messages, mechanism by mechanism.
    #[must_use]
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.analysis.diagnostics
    }

    /// Returns true if the present text can be compiled, perhaps in other ranges than the declared
    /// ones.
    #[must_use]
    pub fn runs(&self) -> bool {
        self.analysis.runs
    }

    /// Returns true for a text of the language alone, which can be formatted.
    #[must_use]
    pub fn is_text(&self) -> bool {
        !self.is_rust()
    }

    /// Returns true for a Rust file.
    pub(crate) fn is_rust(&self) -> bool {
        self.name.ends_with(".rs")
    }

    /// Returns the token that contains a byte; between two tokens the word or number.
    pub(crate) fn token_at(&self, offset: usize) -> Option<usize> {
        let after = self
            .tokens
            .partition_point(|token| token.range.end <= offset);
        let touches = |index: usize| {
            let token = self.tokens.get(index)?;
            let touches = token.range.start <= offset && offset <= token.range.end;
            let is_solid = matches!(
                token.kind,
                crate::lexer::Kind::Word | crate::lexer::Kind::Number
            );
            (touches && is_solid).then_some(index)
        };
        let before = after.checked_sub(1).and_then(touches);
        touches(after)
            .or(before)
            .or((after < self.tokens.len()).then_some(after))
    }

    /// Returns the use of a name at a byte, or just before it.
    pub(crate) fn use_at(&self, offset: usize) -> Option<&Use> {
        let mut uses = self.uses.iter();
        uses.find(|found| found.range.start <= offset && offset <= found.range.end)
    }

    /// Returns the mechanism around a byte, or the last one before it.
    pub(crate) fn outline_at(&self, offset: usize) -> Option<&Outline> {
        let mut outlines = self.outlines.iter();
        let around = outlines.find(|outline| outline.contains(offset));
        around.or_else(|| {
            let before = self.outlines.iter();
            before
                .rev()
                .find(|outline| outline.mechanism.range.end <= offset)
        })
    }

    /// Returns the length unit that a mechanism declares.
    pub(crate) fn length_unit(&self, outline: &Outline) -> &str {
        let items = statements(&self.text, &self.tokens, &outline.body, ';');
        let mut items = items.iter().map(|item| &self.text[item.clone()]);
        let unit = items.find_map(|item| item.strip_prefix("unit "));
        unit.map_or("m", str::trim)
    }

    /// Returns what is known of a mechanism's types.
    pub(crate) fn facts(&self, mechanism: &str) -> Option<&Facts> {
        self.facts.iter().find(|facts| facts.mechanism == mechanism)
    }

    /// Returns the values of a mechanism in the last text that could be compiled.
    pub(crate) fn values(&self, mechanism: &str) -> Option<&Values> {
        let runnable = self.runnable.as_ref()?;
        let all = runnable.values.get_or_init(|| {
            let facts = runnable.facts.iter();
            facts
                .map(|facts| values(&runnable.text, &runnable.outlines, facts))
                .collect()
        });
        let mut facts = runnable.facts.iter();
        all.get(facts.position(|facts| facts.mechanism == mechanism)?)
    }

    /// Returns true if [`values`](Self::values) are those of the present text.
    pub(crate) fn values_are_present(&self) -> bool {
        let runnable = self.runnable.as_ref();
        runnable.is_some_and(|runnable| runnable.text == self.text)
    }

    /// Returns the operations for a name, in the last text that could be compiled.
    pub(crate) fn cost(&self, mechanism: &str, name: &str) -> Option<String> {
        let Runnable {
            text,
            outlines,
            facts,
            ..
        } = self.runnable.as_ref()?;
        let facts = facts.iter().find(|facts| facts.mechanism == mechanism)?;
        crate::name_values::cost(text, outlines, facts, name)
    }

    /// Returns the mechanism of a symbol, its name and its kind.
    pub(crate) fn named(&self, symbol: Symbol) -> (&Outline, &str, NameKind) {
        let mechanism = match symbol {
            Symbol::Mechanism(mechanism)
            | Symbol::Name(mechanism, _)
            | Symbol::Function(mechanism, _)
            | Symbol::Field(mechanism, ..) => mechanism,
        };
        let declared = declaration(&self.outlines, symbol);
        (&self.outlines[mechanism], &declared.name, declared.kind)
    }

    /// Returns the value of a name of a mechanism, if values have been computed: a list of words does
    /// not wait for them.
    pub(crate) fn computed_value(&self, mechanism: &str, name: &str) -> Option<&Value> {
        let runnable = self.runnable.as_ref()?;
        let mut facts = runnable.facts.iter();
        let index = facts.position(|facts| facts.mechanism == mechanism)?;
        runnable.values.get()?.get(index)?.names.get(name)
    }
}
