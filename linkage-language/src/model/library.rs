//! The mechanisms of one call, of which others can be parts.

use std::rc::Rc;

use crate::diagnostic::Origins;
use crate::model::types::{LengthUnit, Mechanism};
use crate::syntax::MechanismDef;

/// A mechanism without a mistake, and where its items are written.
#[derive(Clone, Debug)]
pub struct Model {
    pub mechanism: Mechanism,
    pub origins: Origins,
}

/// The mechanisms of a call, as far as they have been resolved.
#[derive(Debug, Default)]
pub struct Library<'a> {
    pub(super) books: Vec<Book<'a>>,
}

#[derive(Debug)]
pub(super) struct Book<'a> {
    pub(super) definition: &'a MechanismDef,
    /// `None` if it has a mistake, which has been reported.
    pub(super) model: Option<Rc<Model>>,
}

/// The mechanism that a part is.
#[derive(Clone, Debug)]
pub(super) enum PartSource {
    Sound(Rc<Model>),
    /// It has a mistake, and its content is unknown.
    Broken,
    /// There is no mechanism of that name, but these.
    Unknown(Vec<String>),
}

/// The input of resolving a mechanism.
pub(super) struct Source<'a> {
    pub(super) definition: &'a MechanismDef,
    /// The length unit of the mechanism that it is a part of.
    pub(super) unit: Option<LengthUnit>,
    /// The mechanisms of its parts, in the order of the items.
    pub(super) parts: Vec<PartSource>,
}

impl<'a> Library<'a> {
    /// Adds a mechanism; `None` if it has mistakes.
    pub fn add(&mut self, definition: &'a MechanismDef, model: Option<Rc<Model>>) {
        self.books.push(Book { definition, model });
    }
}
