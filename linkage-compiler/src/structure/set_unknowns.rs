//! Unknowns that were eliminated before a set fell apart: the sets that find them.

use linkage_symbolic::SymbolId;

use crate::algebra::Bound;
use crate::algebra::names::Names;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::reductions::Reductions;
use crate::structure::{equations, matching};

/// Gives each unknown that was eliminated to the last of the sets that determine it. A set without
/// unknowns of the mechanism is named by those of the whole; `None` if one of these is not
/// estimated, and the assembly of that set therefore open.
pub(crate) fn place_eliminated<'m>(
    names: &Names<'m>,
    reductions: &Reductions<'m>,
    found: &mut [Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<()> {
    let mut eliminated: Vec<usize> = found.iter().flat_map(|e| e.eliminated.clone()).collect();
    eliminated.sort_unstable();
    eliminated.dedup();
    let incidence: Vec<Vec<usize>> = found
        .iter()
        .map(|equation| equations::incidence(names, equation, coordinates))
        .collect();
    let rows: Vec<usize> = found.iter().map(|e| e.rows.len()).collect();
    let matching = matching::maximum(&rows, &incidence, coordinates.len());
    let sets = matching::components(&incidence, &matching);
    for equation in found.iter_mut() {
        equation.eliminated.clear();
    }
    let coordinates_of = |set: &[usize]| -> Vec<usize> {
        let all = set.iter().flat_map(|&k| &matching.coordinates_of[k]);
        all.copied().collect()
    };
    for &unknown in &eliminated {
        let needed = determined_by(names, reductions, unknown, coordinates);
        let determines = |set: &&Vec<usize>| coordinates_of(set).iter().any(|k| needed.contains(k));
        let last = sets.iter().rfind(determines).or(sets.last())?;
        found[last[0]].eliminated.push(unknown);
    }
    let named = coordinates.iter().filter_map(|c| c.unknown);
    let all: Vec<usize> = named.chain(eliminated).collect();
    for set in &sets {
        let mut found_here = coordinates_of(set).into_iter();
        let is_named = found_here.any(|k| coordinates[k].unknown.is_some())
            || set.iter().any(|&k| !found[k].eliminated.is_empty());
        if !is_named {
            if !all.iter().all(|&k| is_estimated(names, k)) {
                return None;
            }
            found[set[0]].eliminated.clone_from(&all);
        }
    }
    Some(())
}

/// True if all unknowns of a set are estimated.
pub(crate) fn are_estimated<'m>(
    names: &Names<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> bool {
    let mut named = coordinates.iter().filter_map(|c| c.unknown);
    let mut eliminated = equations.iter().flat_map(|e| &e.eliminated);
    named.all(|k| is_estimated(names, k)) && eliminated.all(|&k| is_estimated(names, k))
}

/// True for an unknown whose estimate was written. That of a part is its separate assembly, which
/// is not known yet.
fn is_estimated(names: &Names<'_>, unknown: usize) -> bool {
    let unknown = &names.mechanism.unknowns[unknown];
    unknown.estimate.is_some() && !unknown.of_part
}

/// Returns the coordinates that an eliminated unknown is an expression of.
fn determined_by(
    names: &Names<'_>,
    reductions: &Reductions<'_>,
    unknown: usize,
    coordinates: &[Coordinate],
) -> Vec<usize> {
    let mut open: Vec<SymbolId> = match &names.bound[unknown] {
        Bound::Angle(angle) => names.angles[*angle].symbols().to_vec(),
        Bound::Lengths(symbols) => symbols.iter().map(|(symbol, _)| *symbol).collect(),
    };
    let mut seen: Vec<SymbolId> = Vec::new();
    while let Some(symbol) = open.pop() {
        if seen.contains(&symbol) {
            continue;
        }
        seen.push(symbol);
        if let Some(&value) = reductions.substitutions.get(&symbol) {
            open.extend(equations::symbols_of(names.graph, &[value]));
        }
    }
    let is_seen = |c: &Coordinate| match c.kind {
        CoordinateKind::Angle(angle) => {
            let symbols = names.angles[angle].symbols();
            symbols.iter().any(|symbol| seen.contains(symbol))
        }
        CoordinateKind::Length(symbol) => seen.contains(&symbol),
    };
    (0..coordinates.len())
        .filter(|&k| is_seen(&coordinates[k]))
        .collect()
}
