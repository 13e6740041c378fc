//! Combinations of equations: a loop less a multiple of another one, or across its guide, in which
//! unknowns cancel.
//!
//! Loops are equations between vectors, and so are their sums and differences. A mechanism may be
//! written by any of them: a loop that goes the long way round contains another one, and two pins
//! of one plate on one line give an equation without the position of the plate.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, V2, Vector, numerically_equal, substitute};

use crate::algebra::names::Names;
use crate::structure::equation_difference::{cancels, ratio, subtracted, symbol_range};
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::polynomials::Polynomials;
use crate::structure::{distance, equations, polynomials};

/// An equation and its rows as polynomials in all coordinates, if they are polynomials.
#[derive(Clone, Debug)]
pub(crate) struct Expanded<'m> {
    pub(crate) equation: Equation<'m>,
    polynomials: Option<Polynomials<'m>>,
    /// The coordinates that it contains.
    pub(crate) contained: Vec<usize>,
    /// True for the row of a vector loop across a guide: only rows across the same guide are
    /// subtracted from it, as those of two pins on one line.
    is_across: bool,
}

impl<'m> Expanded<'m> {
    pub(crate) fn new(
        names: &Names<'m>,
        equation: Equation<'m>,
        coordinates: &[Coordinate],
    ) -> Self {
        let polynomials = polynomials::polynomials(names, &equation.rows, coordinates);
        let contained = equations::incidence(names, &equation, coordinates);
        Self {
            equation,
            polynomials,
            contained,
            is_across: false,
        }
    }

    /// The same as a row across a guide.
    pub(crate) fn across(self) -> Self {
        Self {
            is_across: true,
            ..self
        }
    }
}

/// Returns an equation without the terms that cancel in it, if it contains fewer coordinates then.
pub(crate) fn without_cancelled<'m>(
    names: &Names<'m>,
    target: &Expanded<'m>,
    coordinates: &[Coordinate],
) -> Option<Expanded<'m>> {
    let polynomials = target.polynomials.clone()?;
    let fewer = target.contained.len().saturating_sub(1);
    with_at_most(names, target, polynomials, coordinates, fewer)
}

/// Returns an equation less multiples of another one, each with at most `most` coordinates.
pub(crate) fn differences<'m>(
    names: &Names<'m>,
    target: &Expanded<'m>,
    other: &Expanded<'m>,
    coordinates: &[Coordinate],
    most: usize,
) -> Vec<Expanded<'m>> {
    let (Some(minuend), Some(subtrahend)) = (&target.polynomials, &other.polynomials) else {
        return Vec::new();
    };
    if minuend.rows.len() != subtrahend.rows.len() || minuend.rows.len() > 2 {
        return Vec::new();
    }
    let mut ratios: Vec<Vec<Ex<'m>>> = Vec::new();
    for &k in &target.contained {
        let range = symbol_range(names, coordinates, k);
        let Some(ratio) = ratio(minuend, subtrahend, range.clone()) else {
            continue;
        };
        let is_across = target.is_across || other.is_across;
        let is_whole = ratio[0].constant_value().is_some_and(|x| x.abs() == 1.0);
        if is_across && !is_whole {
            continue;
        }
        if !ratios.contains(&ratio) && cancels(minuend, subtrahend, &ratio, range) {
            ratios.push(ratio);
        }
    }
    let multiples = ratios.iter().filter_map(|ratio| {
        let difference = subtracted(minuend, subtrahend, ratio);
        let mut difference = with_at_most(names, target, difference, coordinates, most)?;
        difference.equation.absorb(&other.equation, &[]);
        Some(difference)
    });
    multiples.collect()
}

/// Returns a scalar equation in which an angle is replaced by the rest of a vector loop that
/// contains it, with at most `most` coordinates.
pub(crate) fn replacements<'m>(
    names: &Names<'m>,
    target: &Expanded<'m>,
    other: &Expanded<'m>,
    coordinates: &[Coordinate],
    most: usize,
) -> Vec<Expanded<'m>> {
    let Some(loop_rows) = &other.polynomials else {
        return Vec::new();
    };
    let [row] = target.equation.rows[..] else {
        return Vec::new();
    };
    // A distance is solved as a link, not by its square.
    if target.is_across
        || loop_rows.rows.len() != 2
        || distance::distance(names, row, coordinates).is_some()
    {
        return Vec::new();
    }
    let common = target
        .contained
        .iter()
        .filter(|k| other.contained.contains(k));
    let replaced = common.filter_map(|&k| {
        let CoordinateKind::Angle(angle) = coordinates[k].kind else {
            return None;
        };
        let mut rest = loop_rows.clone();
        let rotor = polynomials::take_rotor(names, &mut rest, angle, &[])?;
        let range = symbol_range(names, coordinates, k);
        let alone = range.clone().all(|symbol| !rest.mention(symbol));
        if !alone || !rotor.z.is_fixed() || rotor.z.is_zero() {
            return None;
        }
        let [x, y] = rest.expressions(names.graph)[..] else {
            return None;
        };
        let turned = (-Vector([x, y])).turned_back(rotor.z);
        let [cos, sin] = if rotor.sense < 0.0 {
            turned.conjugate().0
        } else {
            turned.0
        };
        let symbols = &names.angles[angle];
        let map: Map<_, _> = [(symbols.cos, cos), (symbols.sin, sin)]
            .into_iter()
            .collect();
        let rows = substitute(&target.equation.rows, &map);
        let polynomials = polynomials::polynomials(names, &rows, coordinates)?;
        let mut replaced = with_at_most(names, target, polynomials, coordinates, most)?;
        replaced.equation.absorb(&other.equation, &[]);
        Some(replaced)
    });
    replaced.collect()
}

/// The equations of a vector loop across the guide of a slide, without the slide, and along it.
pub(crate) struct AcrossAndAlong<'m> {
    pub(crate) across: Expanded<'m>,
    pub(crate) along: Expanded<'m>,
}

/// Splits a vector loop by the guide of its slide `slide`.
pub(crate) fn split<'m>(
    names: &Names<'m>,
    target: &Expanded<'m>,
    slide: usize,
    coordinates: &[Coordinate],
) -> Option<AcrossAndAlong<'m>> {
    let polynomials = target.polynomials.as_ref()?;
    let CoordinateKind::Length(symbol) = coordinates[slide].kind else {
        return None;
    };
    let [x, y] = target.equation.rows[..] else {
        return None;
    };
    let first = polynomials::first_symbol(names, coordinates, slide);
    let guide: V2 = Vector(polynomials.slope(names.graph, first)?.try_into().ok()?);
    let rows = Vector([x, y]);
    let row = |row: Ex<'m>| {
        let equation = Equation {
            rows: vec![row],
            relation: None,
            ..target.equation.clone()
        };
        Expanded::new(names, equation, coordinates)
    };
    let across = row(guide.cross(rows));
    let across = without_cancelled(names, &across, coordinates).unwrap_or(across);
    let symbol = names.graph.ex(names.graph.symbol_node(symbol));
    let rest = rows - symbol * guide;
    let factor = if guide.is_unit() {
        names.one()
    } else {
        guide.square()
    };
    let is_free = !across.contained.contains(&slide);
    is_free.then(|| AcrossAndAlong {
        across,
        along: row(factor * symbol + guide.dot(rest)),
    })
}

/// Returns an equation with other rows, if these contain at most `most` coordinates.
fn with_at_most<'m>(
    names: &Names<'m>,
    target: &Expanded<'m>,
    mut polynomials: Polynomials<'m>,
    coordinates: &[Coordinate],
    most: usize,
) -> Option<Expanded<'m>> {
    let zero = names.zero();
    for row in &mut polynomials.rows {
        row.retain(|_, coefficient| !numerically_equal(*coefficient, zero));
    }
    let contained: Vec<usize> = (0..coordinates.len())
        .filter(|&k| symbol_range(names, coordinates, k).any(|symbol| polynomials.mention(symbol)))
        .collect();
    if contained.len() > most || contained.is_empty() {
        return None;
    }
    let equation = Equation {
        rows: polynomials.expressions(names.graph),
        relation: None,
        distance: None,
        ..target.equation.clone()
    };
    Some(Expanded {
        equation,
        polynomials: Some(polynomials),
        contained,
        is_across: target.is_across,
    })
}
