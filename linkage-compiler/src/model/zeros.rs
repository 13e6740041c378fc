//! Attempts to resolve a mechanism. Defaults and estimates written as `0` without a unit, and unknowns without an estimate: numbers, or lengths if the mechanism makes
//! sense only so. What has no estimate may be a point or a direction, too.

use super::library::Source;
use super::names::Resolver;
use super::types::{Mechanism, Name, Type};
use super::unitless::Unitless;
use crate::diagnostic::{Diagnostics, Origins};
use crate::syntax::Item;

/// Up to so many zeros every choice is tried; of more, the first so many.
const TRIED_ZEROS: usize = 8;

/// What zeros are taken for.
#[derive(Clone, Default)]
pub(super) struct Zeros {
    /// Those that are lengths; the others are numbers.
    pub(super) lengths: Vec<Name>,
    /// Unknowns without an estimate that are vectors, with the number of their components.
    vectors: Vec<(Name, usize)>,
}

impl Zeros {
    /// These are lengths, all others numbers.
    pub(super) fn lengths(lengths: &[Name]) -> Self {
        Self {
            lengths: lengths.to_vec(),
            vectors: Vec::new(),
        }
    }

    /// The zero that stands for an estimate that is not given.
    pub(super) fn of(&self, name: Name) -> Type {
        let mut vectors = self.vectors.iter();
        let count = vectors.find_map(|(own, count)| (*own == name).then_some(*count));
        Type::Zero(count.unwrap_or(1))
    }

    fn is_length(&self, name: Name) -> bool {
        self.lengths.contains(&name)
    }

    /// With another choice for an unknown without an estimate.
    fn with(&self, name: Name, components: usize, length: bool) -> Self {
        let mut other = self.clone();
        other.vectors.retain(|(own, _)| *own != name);
        if components > 1 {
            other.vectors.push((name, components));
        }
        if length && !self.is_length(name) {
            other.lengths.push(name);
        }
        if !length {
            other.lengths.retain(|own| *own != name);
        }
        other
    }
}

/// The outcome of resolving with some numbers without a unit taken for lengths.
pub(super) struct Attempt {
    pub(super) mechanism: Mechanism,
    pub(super) origins: Origins,
    pub(super) diagnostics: Diagnostics,
    /// What names were taken for.
    pub(super) zeros: Zeros,
    /// All names declared with a bare zero.
    names: Vec<Name>,
    /// All names declared with other numbers without a unit.
    pub(super) unitless: Vec<Unitless>,
    /// Those of them that lengths were found beside.
    pub(super) suspects: Vec<Name>,
}

/// The attempt with the fewest mistakes, among these the one with the fewest zeros taken for lengths; `lengths` are taken for such in all.
pub(super) fn best_attempt(source: &Source, lengths: &[Name]) -> Attempt {
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

/// Unknowns without an estimate, one after the other, as what they make the fewest mistakes as.
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
    match other.diagnostics.len() < best.diagnostics.len() {
        true => other,
        false => best,
    }
}

/// One attempt, with names taken for this.
pub(super) fn attempt(source: &Source, zeros: Zeros) -> Attempt {
    let mut origins = Origins::default();
    let mut diagnostics = Diagnostics::default();
    let mut resolver = Resolver::new(source, &zeros, &mut origins, &mut diagnostics);
    let mut mechanism = resolver.items(source);
    mechanism.evaluators = resolver.functions(source.definition);
    resolver.refuse_bare_coordinates(&mechanism);
    let names = resolver.symbols.iter().filter(|symbol| symbol.bare_zero);
    let names = names.map(|symbol| symbol.name).collect();
    let (unitless, suspects) = (resolver.unitless, resolver.suspects);
    Attempt {
        mechanism,
        origins,
        diagnostics,
        zeros,
        names,
        unitless,
        suspects,
    }
}
