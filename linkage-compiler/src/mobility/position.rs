//! Positions of a mechanism: its unknowns somewhere, and the ways in which each can change.

use crate::algebra::Nominal;
use crate::message_format::MessageFormat;
use crate::model::{Mechanism, Type, unknown_frames};
use crate::vector::{Vector, cross, dot, norm};

/// A part that can change on its own.
#[derive(Clone, Debug)]
pub(crate) enum Movable {
    /// A body in space, by its name, its origin and two of its axes: three shifts and three turns.
    Body {
        name: String,
        origin: usize,
        axes: [usize; 2],
    },
    /// One component of an unknown.
    Component { unknown: usize, component: usize },
}

/// A column of the matrix: the part that changes, and one of its ways.
pub(crate) type Column = (usize, usize);

/// Unknowns somewhere.
#[derive(Clone)]
pub(crate) struct Position<'w, 'm> {
    pub(crate) mechanism: &'m Mechanism,
    pub(crate) nominal: &'w Nominal,
    pub(crate) words: &'w MessageFormat<'m>,
    /// The length that counts like a radian.
    pub(crate) length: f64,
    /// The values of each unknown, with all components; NaN for unknown ones.
    pub(crate) values: Vec<Vec<f64>>,
    pub(crate) movers: Vec<Movable>,
}

/// The rows of the loops, each with the loop that it is of.
pub(crate) struct LoopRows {
    /// Their numbers among all rows: some cannot be evaluated.
    pub(crate) kept: Vec<usize>,
    pub(crate) loops: Vec<usize>,
    pub(crate) missed: Vec<f64>,
    pub(crate) columns: Vec<Column>,
    pub(crate) matrix: Vec<Vec<f64>>,
}

impl<'w, 'm> Position<'w, 'm> {
    /// Builds the position of a mechanism with these values, with all components; NaN for unknown
    /// ones. `length` counts like a radian.
    pub(crate) fn new(
        words: &'w MessageFormat<'m>,
        nominal: &'w Nominal,
        length: f64,
        mut values: Vec<Vec<f64>>,
    ) -> Self {
        let mechanism = words.mechanism();
        let movers = movers(mechanism);
        for mover in &movers {
            if let Movable::Body { axes, .. } = mover {
                make_rigid(&mut values, *axes);
            }
        }
        Self {
            mechanism,
            nominal,
            words,
            length,
            values,
            movers,
        }
    }
}

impl Position<'_, '_> {
    pub(crate) fn columns(&self) -> Vec<Column> {
        let movers = self.movers.iter().enumerate();
        let ways = movers.filter_map(|(index, mover)| match mover {
            Movable::Body { origin, axes, .. } => {
                let mut parts = [*origin, axes[0], axes[1]].into_iter();
                let known = parts.all(|part| self.values[part].iter().all(|x| x.is_finite()));
                known.then_some((index, 6))
            }
            Movable::Component { unknown, component } => {
                let known = self.values[*unknown][*component].is_finite();
                known.then_some((index, 1))
            }
        });
        let columns = ways.flat_map(|(index, count)| (0..count).map(move |way| (index, way)));
        columns.collect()
    }

    /// All unknowns after a change.
    pub(crate) fn moved(&self, column: Column, step: f64) -> Vec<Vec<f64>> {
        let mut values = self.values.clone();
        self.shift(&mut values, column, step);
        values
    }

    pub(crate) fn shift(&self, values: &mut [Vec<f64>], (mover, way): Column, step: f64) {
        match &self.movers[mover] {
            Movable::Body { origin, .. } if way < 3 => values[*origin][way] += step * self.length,
            Movable::Body { axes, .. } => {
                let about: Vector = [0, 1, 2].map(|k| if k == way - 3 { 1.0 } else { 0.0 });
                let (sin, cos) = step.sin_cos();
                for &axis in axes {
                    let axis_before = [0, 1, 2].map(|k| values[axis][k]);
                    let across = cross(about, axis_before);
                    // The part along the axis of the turn stays.
                    (0..3)
                        .filter(|&k| k != way - 3)
                        .for_each(|k| values[axis][k] = axis_before[k] * cos + across[k] * sin);
                }
            }
            Movable::Component { unknown, component } => {
                values[*unknown][*component] += step * self.unit(*unknown);
            }
        }
    }

    /// Returns the size of an unknown that counts like a radian.
    pub(crate) fn unit(&self, unknown: usize) -> f64 {
        match halves(&self.mechanism.unknowns[unknown].ty) {
            0 => 1.0,
            _ => self.length,
        }
    }
}

/// Returns the bodies, and the components outside of bodies.
fn movers(mechanism: &Mechanism) -> Vec<Movable> {
    let bodies = unknown_frames::bodies_of_space(mechanism);
    let is_part = |unknown: &usize| bodies.iter().any(|(_, parts)| parts.contains(unknown));
    let alone = (0..mechanism.unknowns.len()).filter(|unknown| !is_part(unknown));
    let alone = alone.flat_map(|unknown| {
        let count = mechanism.unknowns[unknown].ty.components().unwrap_or(1);
        (0..count).map(move |component| Movable::Component { unknown, component })
    });
    let bodies = bodies.iter().map(|(name, parts)| Movable::Body {
        name: name.clone(),
        origin: parts[0],
        axes: [parts[1], parts[2]],
    });
    bodies.chain(alone).collect()
}

/// Makes axes perpendicular and of length 1, if both are known: on the way to an assembly they are
/// so except for the steps' errors.
fn make_rigid(values: &mut [Vec<f64>], axes: [usize; 2]) {
    let [first, second]: [Vector; 2] = axes.map(|axis| [0, 1, 2].map(|k| values[axis][k]));
    let first = first.map(|x| x / norm(first));
    let along = dot(first, second);
    let second = [0, 1, 2].map(|k| second[k] - along * first[k]);
    let second = second.map(|x| x / norm(second));
    if first.iter().chain(&second).all(|x| x.is_finite()) {
        values[axes[0]] = first.to_vec();
        values[axes[1]] = second.to_vec();
    }
}

pub(crate) fn halves(ty: &Type) -> i32 {
    ty.dimension().map_or(0, |dimension| dimension.half_lengths)
}
