//! The mechanisms of one call, of which others can be parts.

use std::rc::Rc;

use proc_macro2::Ident;

use super::items::length_unit;
use super::types::{LengthUnit, Mechanism};
use super::unitless;
use crate::diagnostic::{Diagnostics, Origins};
use crate::syntax::{Item, MechanismDef, PartItem};

/// A mechanism without a mistake, and where its items are written.
#[derive(Clone, Debug)]
pub(crate) struct Model {
    pub(crate) mechanism: Mechanism,
    pub(crate) origins: Origins,
}

/// The mechanisms of a call, as far as they have been resolved.
#[derive(Debug, Default)]
pub(crate) struct Library<'a> {
    books: Vec<Book<'a>>,
}

#[derive(Debug)]
struct Book<'a> {
    definition: &'a MechanismDef,
    /// `None` if it has a mistake, which has been reported.
    model: Option<Rc<Model>>,
}

/// What a part is made of.
#[derive(Clone, Debug)]
pub(super) enum Found {
    Sound(Rc<Model>),
    /// Nothing can be said about what it consists of.
    Broken,
    /// There is no mechanism of that name, but these.
    Unknown(Vec<String>),
}

/// What a mechanism is resolved from.
pub(super) struct Source<'a> {
    pub(super) definition: &'a MechanismDef,
    /// The length unit of the mechanism that it is a part of.
    pub(super) unit: Option<LengthUnit>,
    /// What its parts are made of, in the order of the items.
    pub(super) parts: Vec<Found>,
}

impl<'a> Library<'a> {
    /// A mechanism is known from now on; `None` if it has mistakes.
    pub(crate) fn add(&mut self, definition: &'a MechanismDef, model: Option<Rc<Model>>) {
        self.books.push(Book { definition, model });
    }

    /// All that is needed to resolve a mechanism.
    pub(super) fn source(
        &self,
        definition: &'a MechanismDef,
        unit: Option<LengthUnit>,
    ) -> Source<'a> {
        let own = unit.unwrap_or_else(|| length_unit(definition).unwrap_or(LengthUnit::Metre));
        let items = definition.items.iter();
        let parts = items.filter_map(|item| match item {
            Item::Part(item) => Some(self.found(item, own)),
            _ => None,
        });
        Source {
            definition,
            unit,
            parts: parts.collect(),
        }
    }

    /// The mechanism that a part is, with lengths in a unit.
    fn found(&self, item: &PartItem, unit: LengthUnit) -> Found {
        let is_meant = |book: &&Book| book.definition.name == item.mechanism;
        let Some(book) = self.books.iter().find(is_meant) else {
            let names = self.books.iter().map(|book| &book.definition.name);
            return Found::Unknown(names.map(Ident::to_string).collect());
        };
        match &book.model {
            None => Found::Broken,
            Some(model) if model.mechanism.unit == unit => Found::Sound(model.clone()),
            Some(_) => self.in_unit(book.definition, unit),
        }
    }

    /// A mechanism with lengths in another unit than its own.
    fn in_unit(&self, definition: &'a MechanismDef, unit: LengthUnit) -> Found {
        let attempt = unitless::best_attempt(&self.source(definition, Some(unit)));
        match attempt.diagnostics.is_empty() {
            true => Found::Sound(Rc::new(Model {
                mechanism: attempt.mechanism,
                origins: attempt.origins,
            })),
            false => Found::Broken,
        }
    }
}

/// Checks names, dimensions and argument counts. `None` if anything was wrong; as much as can be found is reported, consequences of what has
/// been reported are not.
pub(crate) fn resolve<'a>(
    definition: &'a MechanismDef,
    library: &Library<'a>,
    diagnostics: &mut Diagnostics,
) -> Option<Model> {
    let source = library.source(definition, None);
    let attempt = unitless::best_attempt(&source);
    diagnostics.append(attempt.diagnostics);
    let model = Model {
        mechanism: attempt.mechanism,
        origins: attempt.origins,
    };
    let mut parts = source.parts.iter();
    let whole = parts.all(|found| matches!(found, Found::Sound(_)));
    (whole && diagnostics.is_empty()).then_some(model)
}
