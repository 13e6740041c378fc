//! Attempts to resolve a mechanism. Defaults and estimates written as `0` without a unit are numbers, or lengths if the mechanism makes
//! sense only so.

use super::names::Resolver;
use super::types::{Mechanism, Name};
use super::unitless::Unitless;
use crate::diagnostic::{Diagnostics, Origins};
use crate::syntax::MechanismDef;

/// Up to so many zeros every choice is tried; of more, the first so many.
const TRIED_ZEROS: usize = 8;

/// The outcome of resolving with some numbers without a unit taken for lengths.
pub(super) struct Attempt {
    pub(super) mechanism: Mechanism,
    pub(super) origins: Origins,
    pub(super) diagnostics: Diagnostics,
    /// Names that were taken for lengths.
    pub(super) lengths: Vec<Name>,
    /// All names declared with a bare zero.
    zeros: Vec<Name>,
    /// All names declared with other numbers without a unit.
    pub(super) unitless: Vec<Unitless>,
    /// Those of them that lengths were found beside.
    pub(super) suspects: Vec<Name>,
}

/// The attempt with the fewest mistakes, among these the one with the fewest zeros taken for lengths; `lengths` are taken for such in all.
pub(super) fn best_attempt(definition: &MechanismDef, lengths: &[Name]) -> Attempt {
    let mut best = attempt(definition, lengths);
    let zeros = best.zeros.clone();
    let tried = zeros.len().min(TRIED_ZEROS);
    let mut choices: Vec<u32> = (1..1 << tried).collect();
    choices.sort_by_key(|choice| choice.count_ones());
    for choice in choices {
        if best.diagnostics.is_empty() {
            break;
        }
        let is_length = |index: &usize| choice & 1 << index != 0;
        let chosen = (0..tried).filter(is_length).map(|index| zeros[index]);
        let lengths: Vec<Name> = lengths.iter().copied().chain(chosen).collect();
        let other = attempt(definition, &lengths);
        if other.diagnostics.len() < best.diagnostics.len() {
            best = other;
        }
    }
    best
}

/// One attempt, with these names as lengths.
pub(super) fn attempt(definition: &MechanismDef, lengths: &[Name]) -> Attempt {
    let mut origins = Origins::default();
    let mut diagnostics = Diagnostics::default();
    let mut resolver = Resolver::new(definition, lengths, &mut origins, &mut diagnostics);
    let mut mechanism = resolver.items(definition);
    mechanism.evaluators = resolver.functions(definition);
    resolver.refuse_bare_coordinates(&mechanism);
    let zeros = resolver.symbols.iter().filter(|symbol| symbol.bare_zero);
    let zeros = zeros.map(|symbol| symbol.name).collect();
    let (unitless, suspects) = (resolver.unitless, resolver.suspects);
    Attempt {
        mechanism,
        lengths: lengths.to_vec(),
        unitless,
        suspects,
        origins,
        diagnostics,
        zeros,
    }
}
