//! Syntax tree to model: a mechanism with its parts.

use std::rc::Rc;

use proc_macro2::Ident;

use super::best_attempt::best_attempt;
use super::library::{Book, Library, Model, PartSource, Source};
use crate::diagnostic::Diagnostics;
use crate::model::types::LengthUnit;
use crate::syntax::{Item, MechanismDef, PartItem};

/// Checks names, dimensions and argument counts. Returns `None` after a mistake. Reports as many
/// mistakes as possible, without consequences of reported ones.
pub fn resolve<'a>(
    definition: &'a MechanismDef,
    library: &Library<'a>,
    diagnostics: &mut Diagnostics,
) -> Option<Model> {
    let source = source(library, definition, None);
    let attempt = best_attempt(&source);
    diagnostics.append(attempt.diagnostics);
    let model = Model {
        mechanism: attempt.mechanism,
        origins: attempt.origins,
    };
    let mut parts = source.parts.iter();
    let whole = parts.all(|found| matches!(found, PartSource::Sound(_)));
    (whole && diagnostics.is_empty()).then_some(model)
}

/// Returns all that is needed to resolve a mechanism.
fn source<'a>(
    library: &Library<'a>,
    definition: &'a MechanismDef,
    unit: Option<LengthUnit>,
) -> Source<'a> {
    let length =
        unit.unwrap_or_else(|| declared_length_unit(definition).unwrap_or(LengthUnit::Metre));
    let items = definition.items.iter();
    let parts = items.filter_map(|item| match item {
        Item::Part(item) => Some(find_part(library, item, length)),
        _ => None,
    });
    Source {
        definition,
        unit,
        parts: parts.collect(),
    }
}

/// Returns the mechanism that a part is, with lengths in a unit.
fn find_part(library: &Library, item: &PartItem, unit: LengthUnit) -> PartSource {
    let is_meant = |book: &&Book| book.definition.name == item.mechanism;
    let Some(book) = library.books.iter().find(is_meant) else {
        let names = library.books.iter().map(|book| &book.definition.name);
        return PartSource::Unknown(names.map(Ident::to_string).collect());
    };
    match &book.model {
        None => PartSource::Broken,
        Some(model) if model.mechanism.unit == unit => PartSource::Sound(model.clone()),
        Some(_) => resolve_in_unit(library, book.definition, unit),
    }
}

/// Resolves a mechanism with lengths in another unit than its own.
fn resolve_in_unit<'a>(
    library: &Library<'a>,
    definition: &'a MechanismDef,
    unit: LengthUnit,
) -> PartSource {
    let attempt = best_attempt(&source(library, definition, Some(unit)));
    if attempt.diagnostics.is_empty() {
        PartSource::Sound(Rc::new(Model {
            mechanism: attempt.mechanism,
            origins: attempt.origins,
        }))
    } else {
        PartSource::Broken
    }
}

/// Returns the length unit that a mechanism declares.
fn declared_length_unit(definition: &MechanismDef) -> Option<LengthUnit> {
    let mut items = definition.items.iter();
    items.find_map(|item| match item {
        Item::Unit(item) => LengthUnit::from_name(&item.unit.to_string()),
        _ => None,
    })
}
