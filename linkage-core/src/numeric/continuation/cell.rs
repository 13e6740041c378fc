//! One cell of a table: polynomials for the state over a small part of the range.

use super::follow::Follower;
use super::polynomial::{NODES, TERMS, evaluate, fit};
use alloc::vec;
use alloc::vec::Vec;

/// Beyond this place of a cell there is no state: half a cell outside the table.
pub(super) const OUTSIDE: f64 = 2.0;

/// The error of a table between its nodes, at most: one Newton step leaves rounding.
const ERROR: f64 = 1e-9;

/// A cell whose last Chebyshev coefficient is larger is not looked at any closer.
const TAIL: f64 = 1e-7;

/// Two neighbouring cells differ by no more where they meet.
const JOINT: f64 = 1e-8;

/// A second Newton step may be this much larger than a third one, which is nothing but rounding,
/// and this large anyway.
const NOISE: (f64, f64) = (4.0, 4e-15);

/// The determinant must not vary more than this within a cell.
const VARIATION: f64 = 8.0;

/// The places between the nodes where a cell is checked.
const CHECKS: [f64; 3] = [-1.0, 0.0, 1.0];

/// A range as tables see it: -1/2 at its lower end, 1/2 at its upper end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) middle: f64,
    pub(super) length: f64,
}

impl Frame {
    pub(super) fn new(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            middle: low + 0.5 * (high - low),
            length: high - low,
        }
    }

    /// The upper or lower end (`side` 1 or -1).
    pub(super) fn end(&self, side: f64) -> f64 {
        if side > 0.0 { self.high } else { self.low }
    }

    /// The input at a place.
    pub(super) fn x(&self, position: f64) -> f64 {
        self.middle + position * self.length
    }

    /// The place of an input; 0 in a range without length.
    pub(super) fn position(&self, x: f64) -> f64 {
        if self.length > 0.0 {
            (x - self.middle) / self.length
        } else {
            0.0
        }
    }
}

/// A cell.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cell {
    /// The place of its centre.
    pub(super) centre: f64,
    /// 2 over its length.
    pub(super) inverse: f64,
    /// Half of the smallest determinant, with its sign.
    pub(super) floor: f64,
    /// The largest error found.
    pub(super) error: f64,
    /// Power by power, the numbers of the state side by side.
    pub(super) coefficients: Vec<f64>,
}

impl Cell {
    /// A cell in which the state does not depend on the input.
    pub(super) fn constant(state: &[f64], floor: f64) -> Self {
        let mut coefficients = vec![0.0; TERMS * state.len()];
        coefficients[..state.len()].copy_from_slice(state);
        Self {
            centre: 0.0,
            inverse: 0.0,
            floor,
            error: 0.0,
            coefficients,
        }
    }

    /// The state at a place.
    pub(super) fn state(&self, position: f64, state: &mut [f64]) {
        evaluate(&self.coefficients, self.t(position), state);
    }

    /// A place as the polynomials see it: from -1 to 1 in this cell.
    pub(super) fn t(&self, position: f64) -> f64 {
        (position - self.centre) * self.inverse
    }

    /// The place of `t`.
    pub(super) fn position(&self, t: f64) -> f64 {
        self.centre + t / self.inverse
    }
}

/// The source of the first guess for a new cell.
#[derive(Clone, Copy)]
pub(super) enum Guess<'a> {
    /// A solution at a place inside it or on its border.
    State(f64, &'a [f64]),
    /// The neighbour.
    Cell(&'a Cell),
}

/// Makes the cell of a given centre and length, if the solution can be followed through it and it
/// is accurate.
pub(super) fn attempt(
    follower: &mut Follower<'_>,
    frame: &Frame,
    centre: f64,
    length: f64,
    guess: Guess<'_>,
) -> Option<Cell> {
    let width = match guess {
        Guess::State(_, state) => state.len(),
        Guess::Cell(cell) => cell.coefficients.len() / TERMS,
    };
    let mut cell = Cell {
        centre,
        inverse: 2.0 / length,
        floor: 0.0,
        error: 0.0,
        coefficients: vec![0.0; TERMS * width],
    };
    let mut determinants = Extent::new();
    let values = at_nodes(follower, frame, &cell, guess, width, &mut determinants)?;
    if fit(&values, &mut cell.coefficients, width) > TAIL {
        return None;
    }
    check(follower, frame, &mut cell, width, &mut determinants)?;
    if let Guess::Cell(neighbour) = guess {
        meets(neighbour, &cell, width)?;
    }
    cell.floor = 0.5 * determinants.least()?;
    Some(cell)
}

/// The solution at the nodes.
fn at_nodes(
    follower: &mut Follower<'_>,
    frame: &Frame,
    cell: &Cell,
    guess: Guess<'_>,
    width: usize,
    determinants: &mut Extent,
) -> Option<Vec<f64>> {
    let mut values = vec![0.0; TERMS * width];
    let mut settle = |node: usize, values: &mut [f64]| {
        let x = frame.x(cell.position(NODES[node]));
        let determinant = follower.settle(&[x], &mut values[node * width..][..width])?;
        determinants.include(determinant);
        Some(())
    };
    match guess {
        Guess::Cell(neighbour) => {
            for node in 0..TERMS {
                let position = cell.position(NODES[node]);
                neighbour.state(position, &mut values[node * width..][..width]);
                settle(node, &mut values)?;
            }
        }
        Guess::State(position, state) => {
            // Outward from the known solution, each node from the one before.
            let above = NODES.partition_point(|&node| cell.position(node) < position);
            for (index, node) in (above..TERMS).enumerate() {
                let from = index.checked_sub(1).map(|_| (node - 1) * width);
                start(&mut values, node * width, from, state);
                settle(node, &mut values)?;
            }
            for (index, node) in (0..above).rev().enumerate() {
                let from = index.checked_sub(1).map(|_| (node + 1) * width);
                start(&mut values, node * width, from, state);
                settle(node, &mut values)?;
            }
        }
    }
    Some(values)
}

/// The first guess at a node: the solution at its neighbour, or the known one.
fn start(values: &mut [f64], at: usize, from: Option<usize>, state: &[f64]) {
    match from {
        Some(from) => values.copy_within(from..from + state.len(), at),
        None => values[at..at + state.len()].copy_from_slice(state),
    }
}

/// Measures the error between the nodes, and whether one Newton step removes it.
fn check(
    follower: &mut Follower<'_>,
    frame: &Frame,
    cell: &mut Cell,
    width: usize,
    determinants: &mut Extent,
) -> Option<()> {
    let mut state = vec![0.0; width];
    let (mut second, mut noise, mut size) = (0.0_f64, 0.0_f64, 1.0_f64);
    for t in CHECKS {
        evaluate(&cell.coefficients, t, &mut state);
        let x = [frame.x(cell.position(t))];
        let first = follower.correct(&x, &mut state)?;
        cell.error = cell.error.max(first.size);
        if first.size > ERROR {
            return None;
        }
        determinants.include(first.determinant);
        second = second.max(follower.correct(&x, &mut state)?.size);
        noise = noise.max(follower.correct(&x, &mut state)?.size);
        size = state
            .iter()
            .fold(size, |most, number| most.max(number.abs()));
    }
    (second <= NOISE.0 * noise + NOISE.1 * size).then_some(())
}

/// Returns whether a cell continues its neighbour.
fn meets(neighbour: &Cell, cell: &Cell, width: usize) -> Option<()> {
    let side = if cell.centre > neighbour.centre {
        1.0
    } else {
        -1.0
    };
    let (mut one, mut other) = (vec![0.0; width], vec![0.0; width]);
    evaluate(&neighbour.coefficients, side, &mut one);
    evaluate(&cell.coefficients, -side, &mut other);
    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= JOINT;
    one.iter().zip(&other).all(close).then_some(())
}

/// The determinants of smallest and largest magnitude, of one sign.
struct Extent {
    least: f64,
    most: f64,
}

impl Extent {
    fn new() -> Self {
        Self {
            least: f64::INFINITY,
            most: 0.0,
        }
    }

    fn include(&mut self, determinant: f64) {
        if determinant.abs() < self.least.abs() {
            self.least = determinant;
        }
        self.most = self.most.max(determinant.abs());
    }

    /// The smallest; `None` if they vary too much.
    fn least(&self) -> Option<f64> {
        (self.least.abs() * VARIATION >= self.most).then_some(self.least)
    }
}
