//! The pose in which a file draws its mechanism, for the comparison with the assembled one.

use crate::number::short_length;
use crate::placement::{Vector, difference, dot, length, normals};

/// The part of the size that rounding takes, beside that of the file.
const ROUNDING: f64 = 1e-9;

/// The pose of a file: points and inputs, with the names of the text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawn {
    /// The function of the text that returns the points that move.
    pub function: &'static str,
    /// The unit of lengths.
    pub unit: &'static str,
    /// The largest rounding error of a coordinate in the file.
    pub band: f64,
    /// All points.
    pub points: Vec<DrawnPoint>,
    /// Coordinates that inputs drive. An input has none if its points show no motion.
    pub drives: Vec<Drive>,
}

/// A point where the file draws it.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnPoint {
    /// The field of the function, or the name of a fixed point.
    pub name: String,
    /// The coordinates; the last one is zero in the plane.
    pub position: [f64; 3],
    /// True for points that do not move, which are no fields.
    pub is_fixed: bool,
}

/// A coordinate that an input drives.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// The name of the input in the text.
    pub input: String,
    /// The change of the coordinate with the input.
    pub rate: f64,
    /// The coordinate as a function of points.
    pub measure: Measure,
}

/// A coordinate as a function of points, which are indices.
#[derive(Clone, Debug, PartialEq)]
pub enum Measure {
    /// The angle of the direction from a pivot to a point, about an axis, in radians.
    Turn {
        /// The fixed end of the direction.
        pivot: usize,
        /// Its other end.
        point: usize,
        /// The axis, a unit vector.
        axis: [f64; 3],
        /// Two points of the link that it is measured from, unless this is the frame.
        base: Option<[usize; 2]>,
    },
    /// The distance of two points.
    Distance([usize; 2]),
    /// The position of a point along a direction.
    Shift {
        /// The point that moves.
        point: usize,
        /// The point that the position is counted from, unless it is fixed.
        origin: Option<usize>,
        /// The direction where it is drawn, a unit vector.
        along: [f64; 3],
        /// Two points of the link that the direction turns with, in the plane.
        base: Option<[usize; 2]>,
    },
}

impl Drawn {
    /// Returns the point that is farthest from where it is drawn, and the distance. Coordinates that
    /// are no number count as infinite.
    #[must_use]
    pub fn farthest(&self, found: &[[f64; 3]]) -> Option<(&DrawnPoint, f64)> {
        let distances = self.points.iter().zip(found).map(|(point, found)| {
            let distance = length(difference(*found, point.position));
            (
                point,
                if distance.is_nan() {
                    f64::INFINITY
                } else {
                    distance
                },
            )
        });
        distances.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Returns the distance that a point may have from its drawing: both coordinates may be off by
    /// the rounding of the file.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.band * std::f64::consts::SQRT_2 + ROUNDING * self.size()
    }

    /// Returns the difference that a driven coordinate may have, in radians or in the unit of
    /// lengths: that of points at the tolerance.
    #[must_use]
    pub fn allowed(&self, measure: &Measure) -> f64 {
        let both_ends = 2.0 * self.tolerance();
        let arm = |ends: [usize; 2]| {
            let [start, end] = ends.map(|index| self.points[index].position);
            length(difference(end, start)).max(f64::MIN_POSITIVE)
        };
        match *measure {
            Measure::Turn {
                pivot, point, base, ..
            } => {
                let of_base = base.map_or(0.0, |base| both_ends / arm(base));
                ROUNDING + both_ends / arm([pivot, point]) + of_base
            }
            Measure::Shift {
                point,
                base: Some(base),
                ..
            } => both_ends * (1.0 + arm([point, base[0]]) / arm(base)),
            Measure::Distance(_) | Measure::Shift { base: None, .. } => both_ends,
        }
    }

    /// Returns a sentence with the largest distance, which shows a wrong unit at once.
    pub(crate) fn confirmation(&self) -> Option<String> {
        let pairs =
            (0..self.points.len()).flat_map(|second| (0..second).map(move |first| (first, second)));
        let distances = pairs.map(|(first, second)| {
            let [first, second] = [first, second].map(|index| &self.points[index]);
            (
                first,
                second,
                length(difference(first.position, second.position)),
            )
        });
        let (first, second, distance) = distances.max_by(|a, b| a.2.total_cmp(&b.2))?;
        Some(format!(
            "the largest distance, of `{}` and `{}`, is {}{}: confirm it",
            first.name,
            second.name,
            short_length(distance),
            self.unit
        ))
    }

    /// Returns the largest distance of a point from the first one.
    #[must_use]
    pub fn size(&self) -> f64 {
        let first = self.points.first().map_or([0.0; 3], |point| point.position);
        let distances = self.points.iter();
        let distances = distances.map(|point| length(difference(point.position, first)));
        distances.fold(0.0, f64::max)
    }

    /// Returns the change of a coordinate between the drawing and found points: in radians, or in
    /// the unit of lengths.
    #[must_use]
    pub fn change(&self, measure: &Measure, found: &[[f64; 3]]) -> f64 {
        let drawn: Vec<Vector> = self.points.iter().map(|point| point.position).collect();
        let angle = |points: &[Vector], ends: [usize; 2], axis: Vector| {
            let direction = difference(points[ends[1]], points[ends[0]]);
            let [x, y] = normals(axis).map(|normal| dot(normal, direction));
            y.atan2(x)
        };
        let turned = |ends: [usize; 2], axis: Vector| {
            wrapped(angle(found, ends, axis) - angle(&drawn, ends, axis))
        };
        match *measure {
            Measure::Turn {
                pivot,
                point,
                axis,
                base,
            } => {
                let base = base.map_or(0.0, |base| turned(base, axis));
                wrapped(turned([pivot, point], axis) - base)
            }
            Measure::Distance([a, b]) => {
                let distance = |points: &[Vector]| length(difference(points[a], points[b]));
                distance(found) - distance(&drawn)
            }
            Measure::Shift {
                point,
                origin,
                along,
                base,
            } => {
                let from = |points: &[Vector]| match origin {
                    Some(origin) => difference(points[point], points[origin]),
                    None => points[point],
                };
                let turn = base.map_or(0.0, |base| turned(base, [0.0, 0.0, 1.0]));
                let (sin, cos) = turn.sin_cos();
                let [x, y, z] = along;
                let now = [cos * x - sin * y, sin * x + cos * y, z];
                dot(from(found), now) - dot(from(&drawn), along)
            }
        }
    }

    /// Returns the difference between the change of a driven coordinate that an input asks for and
    /// the change of the found points. `change` is that of the input from its reference.
    #[must_use]
    pub fn missed(&self, drive: &Drive, change: f64, found: &[[f64; 3]]) -> f64 {
        let difference = self.change(&drive.measure, found) - drive.rate * change;
        match drive.measure {
            Measure::Turn { .. } => wrapped(difference).abs(),
            Measure::Distance(_) | Measure::Shift { .. } => difference.abs(),
        }
    }
}

/// An angle without whole turns.
fn wrapped(angle: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    angle - turn * (angle / turn).round()
}
