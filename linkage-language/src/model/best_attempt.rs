//! Numbers without a unit that are used as lengths: reported at their declaration, not at the place
//! where dimensions differ.
//!
//! If a number meets a length, the declarations without a unit that the number comes from are
//! suspects. If the mechanism has fewer mistakes with suspects as lengths, their units are missing.

use super::attempt::{Attempt, attempt, fewest_mistakes};
use super::library::Source;
use crate::diagnostic::Diagnostics;
use crate::model::symbols::assumed_units::Unitless;
use crate::model::symbols::zeros::Zeros;
use crate::model::types::Name;

/// Returns the attempt to resolve a mechanism whose mistakes are the most informative ones.
pub(super) fn best_attempt(source: &Source) -> Attempt {
    let best = fewest_mistakes(source, &[]);
    let lengths = suspected(source, &best);
    if lengths.is_empty() {
        return best;
    }
    let with_units = fewest_mistakes(source, &lengths);
    if with_units.diagnostics.len() >= best.diagnostics.len() {
        return best;
    }
    without_needless(source, lengths, with_units).with_missing_units()
}

/// All names that may lack a unit of length, those too that are noticed only when others have one.
fn suspected(source: &Source, first: &Attempt) -> Vec<Name> {
    let mut lengths: Vec<Name> = Vec::new();
    let mut suspects = first.suspects.clone();
    loop {
        suspects.retain(|name| !lengths.contains(name));
        suspects.sort_unstable();
        suspects.dedup();
        if suspects.is_empty() {
            return lengths;
        }
        lengths.append(&mut suspects);
        suspects = attempt(source, Zeros::lengths(&lengths)).suspects;
    }
}

/// The attempt with those lengths alone that lessen the mistakes.
fn without_needless(source: &Source, mut lengths: Vec<Name>, mut best: Attempt) -> Attempt {
    for name in lengths.clone() {
        let fewer: Vec<Name> = lengths
            .iter()
            .copied()
            .filter(|other| *other != name)
            .collect();
        let other = fewest_mistakes(source, &fewer);
        if other.diagnostics.len() <= best.diagnostics.len() {
            (lengths, best) = (fewer, other);
        }
    }
    best
}

impl Attempt {
    /// Adds messages at the numbers that were taken for lengths, before all others.
    fn with_missing_units(mut self) -> Attempt {
        let mut messages = Diagnostics::default();
        for unitless in self
            .unitless
            .iter()
            .filter(|unitless| self.zeros.lengths.contains(&unitless.name))
        {
            let Unitless {
                text,
                number,
                length,
                ..
            } = unitless;
            let fact = format!("`{number}` has no unit, but `{text}` is used as a length");
            let help = match unitless.beside {
                Some(beside) => format!("write `{length}`, and give {beside} a unit, too"),
                None => format!("write `{length}`"),
            };
            let message = messages.error_with_help(unitless.span, fact, help);
            message.suggest(format!("write `{length}`"), unitless.span, length);
        }
        messages.append(self.diagnostics);
        self.diagnostics = messages;
        self
    }
}
