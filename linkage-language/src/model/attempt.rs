//! Attempts to resolve a mechanism.
//!
//! A default or estimate `0` without a unit, and an unknown without an estimate, are numbers, or
//! lengths if the mechanism makes sense only with lengths. An unknown without an estimate can be a
//! point or a direction, too.

use super::library::Source;
use crate::diagnostic::{Diagnostics, Origins};
use crate::model::declare::struct_names::declare_names;
use crate::model::expression::bare_numbers::refuse_bare_coordinates;
use crate::model::items::evaluators::resolve_functions;
use crate::model::items::struct_block::resolve_items;
use crate::model::symbols::assumed_units::Unitless;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::zeros::Zeros;
use crate::model::types::{Mechanism, Name};
use crate::syntax::Item;

/// Up to so many zeros every choice is tried; of more, the first so many.
const TRIED_ZEROS: usize = 8;

/// The outcome of resolving with some numbers without a unit taken for lengths.
pub(super) struct Attempt {
    pub(super) mechanism: Mechanism,
    pub(super) origins: Origins,
    pub(super) diagnostics: Diagnostics,
    /// The assumptions about zeros.
    pub(super) zeros: Zeros,
    /// All names declared with a bare zero.
    names: Vec<Name>,
    /// All names declared with other numbers without a unit.
    pub(super) unitless: Vec<Unitless>,
    /// Names among them that were found next to lengths.
    pub(super) suspects: Vec<Name>,
}

/// Returns the attempt with the fewest mistakes, among these the one with the fewest zeros taken
/// for lengths. All attempts take `lengths` for lengths.
pub(super) fn fewest_mistakes(source: &Source, lengths: &[Name]) -> Attempt {
    let mut best = attempt(source, Zeros::lengths(lengths));
    let names = best.names.clone();
    let tried = names.len().min(TRIED_ZEROS);
    let mut choices: Vec<u32> = (1..1 << tried).collect();
    choices.sort_by_key(|choice| choice.count_ones());
    for choice in choices {
        if best.diagnostics.is_empty() {
            break;
        }
        let is_length = |index: &usize| choice & 1 << index != 0;
        let chosen = (0..tried).filter(is_length).map(|index| names[index]);
        let lengths: Vec<Name> = lengths.iter().copied().chain(chosen).collect();
        best = fewer_mistakes(best, attempt(source, Zeros::lengths(&lengths)));
    }
    with_points(source, best)
}

/// Takes unknowns without an estimate, one after the other, for the type that leads to the fewest
/// mistakes.
fn with_points(source: &Source, mut best: Attempt) -> Attempt {
    let unknowns = source
        .definition
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Unknown(item) if !item.is_frame() => Some(item.estimate.is_none()),
            _ => None,
        });
    let open = unknowns.enumerate().filter(|(_, open)| *open);
    for (index, _) in open {
        for (components, length) in [(1, true), (2, true), (3, true), (2, false), (3, false)] {
            if best.diagnostics.is_empty() {
                return best;
            }
            let zeros = best.zeros.with(Name::Unknown(index), components, length);
            best = fewer_mistakes(best, attempt(source, zeros));
        }
    }
    best
}

fn fewer_mistakes(best: Attempt, other: Attempt) -> Attempt {
    if other.diagnostics.len() < best.diagnostics.len() {
        other
    } else {
        best
    }
}

/// One attempt, with names taken for this.
pub(super) fn attempt(source: &Source, zeros: Zeros) -> Attempt {
    let mut sink = Sink::default();
    let mut scope = declare_names(source, zeros, &mut sink);
    let mut mechanism = resolve_items(&mut scope, &mut sink, source);
    mechanism.evaluators = resolve_functions(&scope, &mut sink, source.definition);
    refuse_bare_coordinates(&scope.names, &mut sink, &mechanism);
    let symbols = scope.names.symbols.iter();
    let bare_zeros = symbols.filter(|symbol| symbol.bare_zero);
    Attempt {
        mechanism,
        origins: sink.origins,
        diagnostics: sink.diagnostics,
        names: bare_zeros.map(|symbol| symbol.name).collect(),
        zeros: scope.units.zeros,
        unitless: scope.units.unitless,
        suspects: sink.suspects,
    }
}
