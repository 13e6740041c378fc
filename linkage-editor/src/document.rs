//! A text with all that is known about it.

use std::ops::Range;

use crate::analysis::Analysis;
use crate::computed::{Age, Computed};
use crate::declaration::NameKind;
use crate::diagnostics::Diagnostic;
use crate::facts::Facts;
use crate::function_facts::FunctionFacts;
use crate::lexer::Token;
use crate::name_values::{Value, Values};
use crate::outline::Outline;
use crate::position::Lines;
use crate::statements::statements;
use crate::uses::{Symbol, Use, declaration};

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
    pub(crate) name: String,
    pub(crate) text: String,
    pub(crate) lines: Lines,
    pub(crate) tokens: Vec<Token>,
    pub(crate) outlines: Vec<Outline>,
    pub(crate) uses: Vec<Use>,
    /// The messages and types of the present text that need no solution.
    pub(crate) names: Analysis,
    /// True if the present text has been solved, or has nothing to solve.
    pub(crate) is_solved: bool,
    /// True if the present text has been compiled.
    pub(crate) runs: bool,
    /// The messages that needed a solution, moved with their words.
    pub(crate) later: Vec<Diagnostic>,
    /// The messages that are shown.
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// Types of the names of all mechanisms, each from the last text in which it had no mistake.
    pub(crate) facts: Vec<Facts>,
    /// The functions of the last text that could be compiled.
    pub(crate) functions: Vec<FunctionFacts>,
    pub(crate) computed: Computed,
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
            names: Analysis::default(),
            is_solved: false,
            runs: false,
            later: Vec::new(),
            diagnostics: Vec::new(),
            facts: Vec::new(),
            functions: Vec::new(),
            computed: Computed::default(),
        };
        document.set_text(text);
        document
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

    /// Returns all messages, mechanism by mechanism. Until a text that was [read](Self::read) is
    /// [finished](Self::finish), those that need a solution are last, at their present places.
    #[must_use]
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// Returns true if the present text has been compiled, perhaps in other ranges than the declared
    /// ones.
    #[must_use]
    pub fn runs(&self) -> bool {
        self.runs
    }

    /// Returns true if all messages are those of the present text.
    #[must_use]
    pub fn is_solved(&self) -> bool {
        self.is_solved
    }

    /// Returns true if nothing is left to be computed for the present text.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        self.is_solved && (!self.has_values() || self.computed.is_latest())
    }

    /// Returns true if the present text has values: names of Rust files have none.
    pub(crate) fn has_values(&self) -> bool {
        self.runs && !self.is_rust()
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

    /// Returns a function of a mechanism in the last text that could be compiled.
    pub(crate) fn function(&self, mechanism: &str, name: &str) -> Option<&FunctionFacts> {
        let mut functions = self.functions.iter();
        functions.find(|function| function.mechanism == mechanism && function.name == name)
    }

    /// Returns the values of a mechanism in the last text that could be compiled.
    pub(crate) fn values(&self, mechanism: &str) -> Option<&Values> {
        self.computed.values(mechanism)
    }

    /// Returns the relation of [`values`](Self::values) to the present text.
    pub(crate) fn age_of_values(&self) -> Age {
        match (self.is_solved, self.runs) {
            (true, true) if self.computed.is_latest() => Age::Present,
            (true, true) | (false, _) => Age::Pending,
            (true, false) => Age::BeforeMistakes,
        }
    }

    /// Returns the operations for a name, in the last text that could be compiled.
    pub(crate) fn cost(&self, mechanism: &str, name: &str) -> Option<&str> {
        self.values(mechanism)?.costs.get(name).map(String::as_str)
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
        self.computed.finished(mechanism)?.names.get(name)
    }
}
