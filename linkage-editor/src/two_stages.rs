//! The two stages of reading a text: its words and names at once, its solution when it is known.

use crate::alike::alike;
use crate::analysis::{Analysis, analyse, names};
use crate::computed::{Evaluated, Evaluation};
use crate::diagnostics::{Diagnostic, Severity};
use crate::document::Document;
use crate::lexer::tokens;
use crate::moved::Change;
use crate::outline::outlines;
use crate::position::Lines;
use crate::probe::Snapshot;
use crate::repair::readable;
use crate::uses::uses;

/// The solution of a text that has been [read](Document::read), in any thread.
#[derive(Debug)]
pub struct Solving {
    name: String,
    text: String,
}

/// The result of [`Solving::run`].
#[derive(Debug)]
pub struct Solved {
    text: String,
    analysis: Analysis,
}

impl Solving {
    /// Compiles the text: finds the groups, closes the loops and checks the ranges. Spans of this
    /// thread's other tokens of proc-macro2 become invalid.
    #[must_use]
    pub fn run(self) -> Solved {
        Solved {
            analysis: analyse(&self.name, &self.text),
            text: self.text,
        }
    }
}

impl Document {
    /// Replaces the text, and waits for its solution. Values are computed when they are first shown.
    pub fn set_text(&mut self, text: &str) {
        let solving = self.read(text);
        self.computed.is_lazy = true;
        if let Some(solving) = solving {
            // Values are computed here.
            let _ = self.finish(solving.run());
        }
    }

    /// Replaces the text, and reads its words and names, without solving anything. Returns the work
    /// that is left: its result is for [`finish`](Self::finish). `None` if there is nothing to solve,
    /// or if the text differs from a solved one in blanks and comments alone.
    ///
    /// Until then messages about the solution are those of an earlier text, moved with their words.
    /// Values are brought by [`take_values`](Self::take_values).
    ///
    /// ```
    /// use linkage_editor::Document;
    ///
    /// let text = "struct Short { unit mm; input phi = 0deg; unknown psi = 0deg; unknown s = 9mm;
    ///     loop polar(80mm, phi) + polar(30mm, psi) = (s, 60mm); }";
    /// let mut document = Document::new("short.mech", "");
    /// let solving = document.read(text).unwrap();
    /// assert!(document.diagnostics().is_empty());
    ///
    /// document.finish(std::thread::spawn(|| solving.run()).join().unwrap());
    /// assert!(document.diagnostics()[0].message.contains("cannot close"));
    /// ```
    #[must_use = "the text is not solved before the result is finished"]
    pub fn read(&mut self, text: &str) -> Option<Solving> {
        self.computed.is_lazy = false;
        let change = Change::between(&self.text, text);
        let later = self.later.iter();
        self.later = later.filter_map(|found| change.message(found)).collect();
        let is_same = self.take_words(text) && self.is_solved;
        self.is_solved = is_same || self.names.facts.is_empty();
        if self.is_solved && !is_same {
            self.later.clear();
        }
        self.runs &= is_same;
        self.diagnostics = self.present_messages();
        (!self.is_solved).then(|| Solving {
            name: self.name.clone(),
            text: text.to_owned(),
        })
    }

    /// Takes the solution of the present text; that of another text changes nothing. Returns the
    /// computation of its values, whose result is for [`take_values`](Self::take_values); `None` if
    /// it has none.
    pub fn finish(&mut self, solved: Solved) -> Option<Evaluation> {
        if self.is_solved || solved.text != self.text {
            return None;
        }
        self.is_solved = true;
        let Analysis {
            diagnostics,
            runs,
            functions,
            ..
        } = solved.analysis;
        if runs {
            self.functions = functions;
        }
        let of_names = &self.names.diagnostics;
        let later = diagnostics.iter().filter(|found| !of_names.contains(found));
        self.later = later.cloned().collect();
        self.diagnostics = diagnostics;
        self.runs = runs;
        self.has_values().then(|| {
            self.computed.add(Snapshot {
                text: solved.text,
                outlines: self.outlines.clone(),
                facts: self.names.facts.clone(),
            })
        })
    }

    /// Takes the values of the last solved text. Returns false for those of an earlier one, which
    /// change nothing.
    pub fn take_values(&mut self, values: Evaluated) -> bool {
        self.computed.take(values)
    }

    /// Reads words and names of a text. Returns true if they are those of the text before.
    fn take_words(&mut self, text: &str) -> bool {
        let before = std::mem::replace(&mut self.text, text.to_owned());
        self.lines = Lines::new(text);
        self.names = names(&self.name, text);
        if self.is_rust() {
            return before == text;
        }
        let words = tokens(text);
        let is_same = alike((&before, &self.tokens), (text, &words));
        self.tokens = words;
        let repaired = readable(text, &self.tokens);
        self.outlines = match &repaired {
            // Bytes that were added at the end are in no token of the text.
            Some(repaired) => outlines(repaired, &tokens(repaired)),
            None => outlines(text, &self.tokens),
        };
        self.uses = uses(text, &self.tokens, &self.outlines);
        for facts in &self.names.facts {
            self.facts.retain(|old| old.mechanism != facts.mechanism);
            self.facts.push(facts.clone());
        }
        is_same
    }

    /// Returns the messages about words and names, and the last ones about the solutions of
    /// mechanisms that can be solved.
    fn present_messages(&self) -> Vec<Diagnostic> {
        let of_names = &self.names.diagnostics;
        let is_sound = of_names
            .iter()
            .all(|found| found.severity == Severity::Warning);
        let is_solvable = |found: &&Diagnostic| match self.outline_at(found.range.start) {
            Some(outline) => {
                let mut facts = self.names.facts.iter();
                facts.any(|facts| facts.mechanism == outline.mechanism.name)
            }
            None => is_sound,
        };
        let later = self.later.iter().filter(is_solvable);
        of_names.iter().chain(later).cloned().collect()
    }
}
