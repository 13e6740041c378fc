//! Gaps of curves.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::builder::Plot;
use linkage_core::format::rounded;
use linkage_formats::svg::short;

/// Rows from the first to the last one in which some curve is not finite.
pub(super) type Rows = (usize, usize);

/// More gaps than this are counted, not listed.
const LISTED: usize = 4;

pub(super) fn gaps(plot: &Plot) -> Vec<Rows> {
    let missing = |row: usize| {
        let values = plot.curves.iter().map(|curve| curve.quantity.values[row]);
        values.into_iter().any(|x| !x.is_finite())
    };
    let rows = 0..plot.abscissa.values.len();
    let mut gaps: Vec<Rows> = Vec::new();
    for row in rows.filter(|row| missing(*row)) {
        match gaps.last_mut() {
            Some((_, last)) if *last + 1 == row => *last = row,
            _ => gaps.push((row, row)),
        }
    }
    gaps
}

/// The gaps as text.
pub(super) fn gap_notes(plot: &Plot) -> Vec<String> {
    let gaps = gaps(plot);
    if gaps.is_empty() {
        return Vec::new();
    }
    let axis = &plot.abscissa;
    let value = |row: usize| rounded(axis.values[row]);
    let stretch = |&(first, last): &Rows| match first == last {
        true => format!("{}", value(first)),
        false => format!("{} to {}", value(first), value(last)),
    };
    let mut stretches: Vec<String> = gaps.iter().take(LISTED).map(stretch).collect();
    if gaps.len() > LISTED {
        stretches.push(format!("and {} more", gaps.len() - LISTED));
    }
    let unit = &axis.unit;
    Vec::from([format!(
        "Gaps at {} = {} {unit}: the mechanism cannot be assembled there, or a value is infinite.",
        axis.name,
        stretches.join(", "),
    )])
}

/// Between the strokes of hatching, along an axis.
const SPACING: f64 = 9.0;

/// `d` of strokes that fill a rectangle between two corners. They belong to the whole plane, so
/// that those of neighbours meet.
pub(super) fn hatching([left, top]: [f64; 2], [right, bottom]: [f64; 2]) -> String {
    let first = ((left + top) / SPACING).ceil() as i64;
    let last = ((right + bottom) / SPACING).floor() as i64;
    let strokes = (first..=last).map(|n| {
        let sum = n as f64 * SPACING;
        let ends = [left.max(sum - bottom), right.min(sum - top)];
        let [from, to] = ends.map(|x| format!("{} {}", short(x), short(sum - x)));
        format!("M{from}L{to}")
    });
    strokes.collect()
}

/// The pieces of consecutive rows between gaps of these values.
pub(super) fn pieces(values: &[f64]) -> Vec<core::ops::Range<usize>> {
    let mut pieces: Vec<core::ops::Range<usize>> = Vec::new();
    for (row, _) in values.iter().enumerate().filter(|(_, x)| x.is_finite()) {
        match pieces.last_mut() {
            Some(piece) if piece.end == row => piece.end += 1,
            _ => pieces.push(row..row + 1),
        }
    }
    pieces
}
