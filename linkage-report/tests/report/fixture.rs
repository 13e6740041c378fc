//! Mechanisms with sweeps written by hand.

pub(crate) mod curved_slots;
mod four_bar;
pub(crate) mod pictures;
mod quick_return;
mod spatial;

pub(crate) use curved_slots::curved_slots;
pub(crate) use four_bar::{FourBar, MOTION};
pub(crate) use quick_return::quick_return;
pub(crate) use spatial::spatial;

use linkage_runtime::{Column, Heading, Input, Meaning, Picture, Table};

/// The results of a sweep.
pub(crate) struct Sweep {
    heading: &'static Heading,
    columns: Vec<Vec<f64>>,
    rows: usize,
}

impl Sweep {
    /// `position` gives the numbers of all columns.
    pub(crate) fn new(
        heading: &'static Heading,
        inputs: &[f64],
        position: impl Fn(f64) -> Vec<f64>,
    ) -> Self {
        let mut columns = vec![Vec::new(); heading.columns.len()];
        for &input in inputs {
            let numbers = position(input);
            assert_eq!(numbers.len(), columns.len());
            for (column, number) in columns.iter_mut().zip(numbers) {
                column.push(number);
            }
        }
        Self {
            heading,
            columns,
            rows: inputs.len(),
        }
    }
}

impl Table for Sweep {
    fn heading(&self) -> &'static Heading {
        self.heading
    }

    fn rows(&self) -> usize {
        self.rows
    }

    fn column(&self, index: usize) -> &[f64] {
        &self.columns[index]
    }
}

/// A crank's angle over a turn.
pub(crate) const PHI: Input = Input {
    name: "phi",
    unit: "rad",
    reference: 0.5,
    range: Some((0.0, std::f64::consts::TAU)),
};

pub(crate) const fn value(name: &'static str, unit: &'static str) -> Column {
    column(name, unit, Meaning::Value)
}

pub(crate) const fn pictured(name: &'static str, unit: &'static str) -> Column {
    column(name, unit, Meaning::Picture)
}

/// The heading of a function whose columns are those of this picture.
pub(crate) const fn picture_heading(
    columns: &'static [Column],
    picture: &'static Picture,
) -> Heading {
    Heading {
        function: "pictured",
        arguments: &["phi"],
        columns,
        picture: pictures::drawn(picture),
    }
}

/// Columns of a picture: coordinates in millimetres, then the components of directions.
pub(crate) const fn drawn_columns<const N: usize>(coordinates: usize) -> [Column; N] {
    let mut columns = [pictured("picture.x", "mm"); N];
    let mut i = coordinates;
    while i < N {
        columns[i] = pictured("picture.direction", "");
        i += 1;
    }
    columns
}

pub(crate) const fn column(name: &'static str, unit: &'static str, meaning: Meaning) -> Column {
    Column {
        name,
        unit,
        meaning,
    }
}

pub(crate) type Point = [f64; 2];

pub(crate) fn polar(length: f64, angle: f64) -> Point {
    [length * angle.cos(), length * angle.sin()]
}

pub(crate) fn plus(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1]]
}

pub(crate) fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

/// The point to the left of the way from `a` to `b`, at these distances from both; NaN if there is none.
pub(crate) fn joined(a: Point, from_a: f64, b: Point, from_b: f64) -> Point {
    let [x, y] = minus(b, a);
    let square = x * x + y * y;
    let along = 0.5 * (1.0 + (from_a * from_a - from_b * from_b) / square);
    let left = (from_a * from_a / square - along * along).sqrt();
    plus(a, [along * x - left * y, along * y + left * x])
}
