//! The questions that an editor asks of a document.

use std::ops::Range;

use crate::actions::{self, Action};
use crate::colours::{self, ColouredWord};
use crate::completion::{self, Completion};
use crate::diagnostics::Edit;
use crate::document::Document;
use crate::hints::{self, Hint};
use crate::hover::{self, Hover};
use crate::navigation;
use crate::rename;
use crate::signature::{self, Signature};
use crate::symbols::{self, Symbol};

impl Document {
    /// Describes the word at a byte: kind, unit and value of a name, its range, its cost in
    /// operations and its comment; the meaning of a word of the language or a unit.
    #[must_use]
    pub fn hover(&self, offset: usize) -> Option<Hover> {
        hover::hover(self, offset)
    }

    /// Returns the words that can be written before a byte, whatever has been written of them.
    /// Editors choose those that fit.
    #[must_use]
    pub fn completions(&self, offset: usize) -> Vec<Completion> {
        completion::completions(self, offset)
    }

    /// Returns the call around a byte.
    #[must_use]
    pub fn signature(&self, offset: usize) -> Option<Signature> {
        signature::signature(self, offset)
    }

    /// Returns the values of derived quantities, and the solutions of unknowns that differ from
    /// their estimates. There are none while the text has mistakes.
    #[must_use]
    pub fn hints(&self) -> Vec<Hint> {
        hints::hints(self)
    }

    /// Returns the words that declare the name at a byte.
    #[must_use]
    pub fn definition(&self, offset: usize) -> Option<Range<usize>> {
        navigation::definition(self, offset)
    }

    /// Returns all uses of the name at a byte, in order, with its declaration if that is wanted.
    #[must_use]
    pub fn references(&self, offset: usize, with_declaration: bool) -> Vec<Range<usize>> {
        navigation::references(self, offset, with_declaration)
    }

    /// Returns the bytes of the name at a byte that can be renamed.
    #[must_use]
    pub fn renamable(&self, offset: usize) -> Option<Range<usize>> {
        rename::renamable(self, offset)
    }

    /// Returns the changes that give the name at a byte another text. Fields of results keep their
    /// names: `{ tracer }` becomes `{ tracer: pen }`.
    ///
    /// # Errors
    ///
    /// The reason, if there is no name at the byte, the new text is no name, or another name has it.
    pub fn renamed(&self, offset: usize, name: &str) -> Result<Vec<Edit>, String> {
        rename::renamed(self, offset, name)
    }

    /// Returns the mechanisms, their names and functions.
    #[must_use]
    pub fn symbols(&self) -> Vec<Symbol> {
        symbols::symbols(self)
    }

    /// Returns the changes that can be made at some bytes: those that messages propose, computed
    /// estimates, declarations of unknown words, a function with the picture.
    #[must_use]
    pub fn actions(&self, range: Range<usize>) -> Vec<Action> {
        actions::actions(self, &range)
    }

    /// Returns the words of a text with their meanings, in order. Marks, brackets and unknown words
    /// are left out.
    #[must_use]
    pub fn words(&self) -> Vec<ColouredWord> {
        colours::words(self)
    }
}
