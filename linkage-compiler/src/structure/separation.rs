//! Separation of a coupled set: its loops are combined until the set falls apart into smaller ones.
//!
//! A coupled set stays as it is written if no combination makes it fall apart.

use std::cmp::Reverse;

use linkage_symbolic::Ex;

use crate::algebra::names::Names;
use crate::structure::combination::{AcrossAndAlong, Expanded};
use crate::structure::equations::{Coordinate, Equation, System};
use crate::structure::reductions::Reductions;
use crate::structure::{combination, equations, matching, set_unknowns};

/// A vector loop that is split by the guide of a slide.
#[derive(Clone)]
struct SplitLoop<'m> {
    /// The index of its equation across the guide.
    index: usize,
    slide: usize,
    whole: Expanded<'m>,
    across: Vec<Ex<'m>>,
    along: Expanded<'m>,
}

/// Returns combinations of the loops of a coupled set of the plane that fall apart into smaller
/// sets; `None` if there are none.
pub(crate) fn separated<'m>(
    names: &Names<'m>,
    reductions: &Reductions<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<System<'m>> {
    if !is_plane(names, equations, coordinates) {
        return None;
    }
    let expanded: Vec<Expanded<'m>> = equations
        .iter()
        .map(|equation| Expanded::new(names, equation.clone(), coordinates))
        .collect();
    let mut found = combined(names, expanded.clone(), coordinates)
        .or_else(|| combined_across_guides(names, expanded, coordinates))?;
    set_unknowns::place_eliminated(names, reductions, &mut found, coordinates)?;
    Some((found, coordinates.to_vec()))
}

/// True for at least two equations of the plane.
fn is_plane(names: &Names<'_>, equations: &[Equation<'_>], coordinates: &[Coordinate]) -> bool {
    let in_space = |c: &Coordinate| c.unknown.is_some_and(|k| names.components_of(k) > 2);
    equations.len() > 1
        && equations.iter().all(|e| e.rows.len() < 3)
        && !coordinates.iter().any(in_space)
}

/// The most coordinates that an equation may gain on a detour: a point instead of two links.
const DETOUR: usize = 2;

/// The most equations of a set in which detours are tried: their number grows with the cube.
const MOST_WITH_DETOURS: usize = 12;

/// Combines equations until the set falls apart: by steps that leave out unknowns, or by one that
/// exchanges them first.
fn combined<'m>(
    names: &Names<'m>,
    mut expanded: Vec<Expanded<'m>>,
    coordinates: &[Coordinate],
) -> Option<Vec<Equation<'m>>> {
    loop {
        let all = 0..expanded.len();
        let steps: Vec<Step<'m>> = all
            .flat_map(|index| steps(names, &expanded, index, coordinates, 0))
            .collect();
        if let Some(candidate) = best_separating(names, &expanded, &steps, coordinates) {
            return Some(candidate);
        }
        let mut most_saved = steps.into_iter().rev();
        let saved =
            |step: &Step<'m>| expanded[step.index].contained.len() - step.expanded.contained.len();
        let first = most_saved.next();
        let best = most_saved.fold(first, |best, step| {
            best.filter(|best| saved(best) >= saved(&step))
                .or(Some(step))
        });
        match best {
            Some(step) => expanded[step.index] = step.expanded,
            None => return by_detour(names, &expanded, coordinates),
        }
    }
}

/// A combination in the place of an equation.
struct Step<'m> {
    index: usize,
    expanded: Expanded<'m>,
}

/// Returns the equations after the step that leaves the smallest sets, if they fall apart.
fn best_separating<'m>(
    names: &Names<'m>,
    expanded: &[Expanded<'m>],
    steps: &[Step<'m>],
    coordinates: &[Coordinate],
) -> Option<Vec<Equation<'m>>> {
    let separating = steps.iter().rev().filter_map(|step| {
        let mut candidate: Vec<Equation<'m>> = expanded.iter().map(equation).collect();
        candidate[step.index] = step.expanded.equation.clone();
        let size = largest_set(names, &candidate, coordinates)?;
        let before = expanded[step.index].contained.len();
        // The equation that becomes shorter the most is the long way round.
        let saved = before.saturating_sub(step.expanded.contained.len());
        // Of two that do not differ in this, the one that more is known of stays.
        let rows = &expanded[step.index].equation.rows;
        let symbols = equations::symbols_of(names.graph, rows).len();
        Some(((size, Reverse(saved), Reverse(symbols)), candidate))
    });
    let best = separating.min_by_key(|(size, _)| *size);
    best.map(|(_, candidate)| candidate)
}

fn equation<'m>(expanded: &Expanded<'m>) -> Equation<'m> {
    expanded.equation.clone()
}

/// Exchanges unknowns of one equation, and combines it again.
fn by_detour<'m>(
    names: &Names<'m>,
    expanded: &[Expanded<'m>],
    coordinates: &[Coordinate],
) -> Option<Vec<Equation<'m>>> {
    if expanded.len() > MOST_WITH_DETOURS {
        return None;
    }
    (0..expanded.len()).find_map(|index| {
        let detours = steps(names, expanded, index, coordinates, 1 + DETOUR);
        detours.into_iter().find_map(|detour| {
            let mut changed = expanded.to_vec();
            changed[index] = detour.expanded;
            let steps = steps(names, &changed, index, coordinates, 0);
            best_separating(names, &changed, &steps, coordinates)
        })
    })
}

/// Returns the combinations of an equation with others that have fewer coordinates, or up to
/// `allowed` more than that.
fn steps<'m>(
    names: &Names<'m>,
    expanded: &[Expanded<'m>],
    index: usize,
    coordinates: &[Coordinate],
    allowed: usize,
) -> Vec<Step<'m>> {
    let target = &expanded[index];
    let most = (target.contained.len() + allowed).saturating_sub(1);
    let cancelled = combination::without_cancelled(names, target, coordinates);
    let mut found: Vec<Expanded<'m>> = cancelled.into_iter().collect();
    for (other_index, other) in expanded.iter().enumerate() {
        if other_index != index {
            found.extend(combination::differences(
                names,
                target,
                other,
                coordinates,
                most,
            ));
            found.extend(combination::replacements(
                names,
                target,
                other,
                coordinates,
                most,
            ));
        }
    }
    let found = found.into_iter();
    found.map(|expanded| Step { index, expanded }).collect()
}

/// Returns the number of coordinates in the largest of the sets that equations fall apart into;
/// `None` if they do not, or if they do not determine the coordinates any more.
fn largest_set<'m>(
    names: &Names<'m>,
    candidate: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<usize> {
    let incidence: Vec<Vec<usize>> = candidate
        .iter()
        .map(|equation| equations::incidence(names, equation, coordinates))
        .collect();
    let rows: Vec<usize> = candidate.iter().map(|e| e.rows.len()).collect();
    let matching = matching::maximum(&rows, &incidence, coordinates.len());
    if matching.equation_of.iter().any(Option::is_none) {
        return None;
    }
    let sets = matching::components(&incidence, &matching);
    let size = |set: &Vec<usize>| -> usize { set.iter().map(|&k| rows[k]).sum() };
    (sets.len() > 1).then(|| sets.iter().map(size).max().unwrap_or(0))
}

/// Combines vector loops across the guides of slides that no other loop contains: the rest of such
/// a loop only gives its slide.
fn combined_across_guides<'m>(
    names: &Names<'m>,
    mut expanded: Vec<Expanded<'m>>,
    coordinates: &[Coordinate],
) -> Option<Vec<Equation<'m>>> {
    let mut splits: Vec<SplitLoop<'m>> = Vec::new();
    for slide in 0..coordinates.len() {
        let mut with = (0..expanded.len()).filter(|&k| expanded[k].contained.contains(&slide));
        let (Some(index), None) = (with.next(), with.next()) else {
            continue;
        };
        let Some(AcrossAndAlong { across, along }) =
            combination::split(names, &expanded[index], slide, coordinates)
        else {
            continue;
        };
        let rows = across.equation.rows.clone();
        let whole = std::mem::replace(&mut expanded[index], across);
        splits.push(SplitLoop {
            index,
            slide,
            whole,
            across: rows,
            along,
        });
    }
    if splits.is_empty() {
        return None;
    }
    if let Some(found) = apart_across_guides(names, &expanded, &splits, coordinates) {
        return Some(found);
    }
    let kept = without_slides(coordinates, &splits);
    let rows = expanded.iter().enumerate().map(|(index, row)| {
        let row = Expanded::new(names, row.equation.clone(), &kept);
        let is_across = splits.iter().any(|split| split.index == index);
        if is_across { row.across() } else { row }
    });
    let rows = rows.collect();
    let mut found = combined(names, rows, &kept)?;
    // A loop that stayed as it was is a vector loop again.
    let mut along = Vec::new();
    for split in splits {
        if found[split.index].rows == split.across {
            found[split.index] = split.whole.equation;
        } else {
            along.push(split.along.equation);
        }
    }
    found.extend(along);
    Some(found)
}

/// Returns the coordinates without the slides of split loops.
fn without_slides(coordinates: &[Coordinate], splits: &[SplitLoop]) -> Vec<Coordinate> {
    let is_kept = |k: &usize| splits.iter().all(|split| split.slide != *k);
    let kept = (0..coordinates.len()).filter(is_kept);
    kept.map(|k| coordinates[k].clone()).collect()
}

/// Returns the equations across and along the guides, if those across fall apart without further
/// combinations: two pins of a body on parallel guides give its angle. Loops that need not be split
/// for this stay vector loops.
fn apart_across_guides<'m>(
    names: &Names<'m>,
    across: &[Expanded<'m>],
    splits: &[SplitLoop<'m>],
    coordinates: &[Coordinate],
) -> Option<Vec<Equation<'m>>> {
    let mut equations: Vec<Equation<'m>> = across.iter().map(equation).collect();
    let mut needed: Vec<SplitLoop<'m>> = splits.to_vec();
    largest_set(names, &equations, &without_slides(coordinates, &needed))?;
    for split in splits {
        let mut rest = needed.clone();
        rest.retain(|other| other.index != split.index);
        let mut whole = equations.clone();
        whole[split.index] = split.whole.equation.clone();
        if largest_set(names, &whole, &without_slides(coordinates, &rest)).is_some() {
            (equations, needed) = (whole, rest);
        }
    }
    let along = needed.into_iter().map(|split| split.along.equation);
    equations.extend(along);
    Some(equations)
}
