//! Tables of numbers with headings, and small samples made of them.

use linkage_report::Report;
use linkage_runtime::{Column, Heading, Input, Meaning, Table};
use std::f64::consts::TAU;

/// The angle of a crank, without a range.
pub(super) const PHI: Input = Input {
    name: "phi",
    unit: "rad",
    reference: 0.0,
    range: None,
};

/// The angle of a shaft over a turn.
pub(super) const SHAFT: Input = Input {
    name: "shaft",
    unit: "rad",
    reference: 0.0,
    range: Some((0.0, TAU)),
};

/// A table filled position by position.
pub struct Sheet {
    heading: &'static Heading,
    columns: Vec<Vec<f64>>,
}

impl Sheet {
    /// The numbers of `row`, one for each column, at every position.
    #[must_use]
    pub fn new<const N: usize>(
        heading: &'static Heading,
        positions: &[f64],
        row: impl Fn(f64) -> [f64; N],
    ) -> Self {
        let rows: Vec<[f64; N]> = positions.iter().map(|&position| row(position)).collect();
        let columns = (0..N).map(|i| rows.iter().map(|row| row[i]).collect());
        Self {
            heading,
            columns: columns.collect(),
        }
    }
}

impl Table for Sheet {
    fn heading(&self) -> &'static Heading {
        self.heading
    }

    fn rows(&self) -> usize {
        self.columns[0].len()
    }

    fn column(&self, index: usize) -> &[f64] {
        &self.columns[index]
    }
}

pub(super) const fn column(name: &'static str, unit: &'static str, meaning: Meaning) -> Column {
    Column {
        name,
        unit,
        meaning,
    }
}

pub(super) const fn shown(name: &'static str, unit: &'static str) -> Column {
    column(name, unit, Meaning::Picture)
}

/// The numbers of a row: those of all vectors, one after the other, then `last` in the columns that remain.
pub(super) fn flat<const N: usize, const D: usize>(vectors: &[[f64; D]], last: f64) -> [f64; N] {
    let mut row = [last; N];
    for (number, value) in row.iter_mut().zip(vectors.iter().flatten()) {
        *number = *value;
    }
    row
}

/// A derivative by central differences: what is tested is how it is shown.
pub(super) fn slope<const N: usize>(f: impl Fn(f64) -> [f64; N], at: f64, step: f64) -> [f64; N] {
    let (low, high) = (f(at - step), f(at + step));
    std::array::from_fn(|i| (high[i] - low[i]) / (2.0 * step))
}

// A cam at as many positions as a test wants.

static CAM: Heading = Heading {
    function: "cam",
    arguments: &["phi"],
    columns: &[
        column("lift", "mm", Meaning::Value),
        column("force", "N", Meaning::Value),
    ],
    picture: None,
};

/// Lift `8 sin phi` and force `5 cos phi` over a turn.
#[must_use]
pub fn many(count: usize) -> Report {
    cam(&PHI.positions(count))
}

/// The same, from a whole turn down to zero.
#[must_use]
pub fn falling(count: usize) -> Report {
    let mut positions = PHI.positions(count);
    positions.reverse();
    cam(&positions)
}

fn cam(positions: &[f64]) -> Report {
    let row = |phi: f64| [8.0 * phi.sin(), 5.0 * phi.cos()];
    Report::new("Cam", &PHI, positions).table(&Sheet::new(&CAM, positions, row))
}

// Quantities that are constant but for the last bit, and zeros of both signs.

// Each has a unit, and so an axis, of its own.
static GUIDED: Heading = Heading {
    function: "guided",
    arguments: &["phi"],
    columns: &[
        column("slider.y", "mm", Meaning::Value),
        column("share", "", Meaning::Value),
        column("across", "N", Meaning::Value),
    ],
    picture: None,
};

/// The report about what a straight guide gives.
#[must_use]
pub fn roundoff() -> Report {
    let positions = PHI.positions(37);
    Report::new("Roundoff", &PHI, &positions).table(&Sheet::new(&GUIDED, &positions, row))
}

/// The one number and the next, in turn, every ten degrees.
fn row(phi: f64) -> [f64; 3] {
    let tens = (phi.to_degrees() / 10.0).round();
    if tens % 2.0 > 0.5 {
        [8.0, 0.5, -0.0]
    } else {
        [8.0_f64.next_up(), 0.5_f64.next_up(), 0.0]
    }
}
