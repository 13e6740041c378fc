//! Directions in which a loop in space is moved by its unknowns, for messages.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, SymbolId, substitute};

use crate::algebra::{Bound, Names, Nominal};
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::vector::{Vector as Direction, cross, dot, norm};

/// Step of central differences, in radians or as a share of a length: near the cube root of a
/// double's precision, where truncation and rounding are alike.
const STEP: f64 = 1e-5;

/// A column of which less than this share points across those before it adds no direction: far
/// above the error of the differences.
const ALONG: f64 = 1e-6;

/// Three digits are enough to recognise a direction.
const DIGITS: f64 = 1000.0;

/// Returns the directions in which no unknown moves a loop of three rows at their estimates: `none
/// of them moves it along (0, 0, 1)`. Nothing if they move it in all directions.
pub(crate) fn short_of<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    equation: &Equation<'m>,
    unknowns: &[Coordinate],
) -> Option<String> {
    let rows: [Ex<'m>; 3] = equation.rows.clone().try_into().ok()?;
    let mut reached: Vec<Direction> = Vec::new();
    for coordinate in unknowns {
        let column = column(names, nominal, rows, coordinate)?;
        let across = reached.iter().fold(column, |rest, unit| {
            let along = dot(rest, *unit);
            [0, 1, 2].map(|k| rest[k] - along * unit[k])
        });
        if norm(across) > ALONG * norm(column) {
            reached.push(across.map(|x| x / norm(across)));
        }
    }
    match reached[..] {
        [only] if unknowns.len() == 1 => Some(format!("it is moved along {} only", words(only))),
        [only] => Some(format!("they move it along {} only", words(only))),
        [a, b] => Some(format!(
            "none of them moves it along {}",
            words(cross(a, b))
        )),
        _ => None,
    }
}

/// Returns the change of the rows with one coordinate, at the estimates.
fn column<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    rows: [Ex<'m>; 3],
    coordinate: &Coordinate,
) -> Option<Direction> {
    coordinate.unknown?;
    let unknowns = &names.mechanism.unknowns;
    if unknowns.iter().any(|unknown| unknown.estimate.is_none()) {
        return None;
    }
    let ahead = rows_at(names, nominal, rows, coordinate, STEP);
    let behind = rows_at(names, nominal, rows, coordinate, -STEP);
    let column = [0, 1, 2].map(|k| (ahead[k] - behind[k]) / (2.0 * STEP));
    column.iter().all(|x| x.is_finite()).then_some(column)
}

/// The rows at the estimates with one coordinate moved: by radians, or by a share of the estimate.
fn rows_at<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    rows: [Ex<'m>; 3],
    moved: &Coordinate,
    step: f64,
) -> Vec<f64> {
    let mut values: Map<SymbolId, Ex<'m>> = Map::new();
    for (unknown, bound) in names.bound.iter().enumerate() {
        let estimate = &nominal.estimates[unknown];
        match bound {
            Bound::Angle(index) => {
                let angle = &names.angles[*index];
                let shift = if moved.kind == CoordinateKind::Angle(*index) {
                    step
                } else {
                    0.0
                };
                let value = estimate[0] + shift;
                let numbers = [value.cos(), value.sin(), value];
                let numbers = numbers.map(|x| names.graph.number(x));
                values.extend(angle.symbols().into_iter().zip(numbers));
            }
            Bound::Lengths(symbols) => {
                for ((symbol, _), estimate) in symbols.iter().zip(estimate) {
                    let shift = if moved.kind == CoordinateKind::Length(*symbol) {
                        step * estimate.abs().max(1.0)
                    } else {
                        0.0
                    };
                    let value = names.graph.number(estimate + shift);
                    values.insert(*symbol, value);
                }
            }
        }
    }
    let rows = substitute(&rows, &values);
    nominal.evaluate(&rows)
}

/// A unit vector to three digits; of the two signs, the one whose first component other than 0 is
/// positive.
fn words(direction: Direction) -> String {
    let rounded = direction.map(|x| (DIGITS * x).round() / DIGITS);
    let first = rounded.into_iter().find(|x| *x != 0.0).unwrap_or(1.0);
    let [x, y, z] = rounded.map(|x| x * first.signum() + 0.0);
    format!("({x}, {y}, {z})")
}
