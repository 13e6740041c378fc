//! Tables and grids in numbers, for who prints them.

use super::grid::{Grid, Terms};
use super::scale::Scale;
use super::table::Table;
use alloc::vec::Vec;

/// The map of an input to a place, -1/2 at the lower end of the range and 1/2 at the upper one, and
/// to a slot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// The input in the middle of the range.
    pub middle: f64,
    /// The length of the range.
    pub length: f64,
    /// Places for each unit of the input.
    pub rate: f64,
    /// The same where the range repeats, else 0: the place less its nearest integer is taken.
    pub turns: f64,
    /// Returns the number of slots.
    pub slots: usize,
}

impl Axis {
    fn new(scale: &Scale) -> Self {
        Self {
            middle: scale.frame.middle,
            length: scale.frame.length,
            rate: scale.rate,
            turns: scale.turns,
            slots: scale.slots(),
        }
    }
}

/// A table as [`Table::state`] reads it.
#[derive(Clone, Debug, PartialEq)]
pub struct TableLayout<'a> {
    /// The axis of the input.
    pub axis: Axis,
    /// For each slot the number of its cell.
    pub index: &'a [u16],
    /// The cells, from the lower end of the range.
    pub cells: Vec<CellLayout<'a>>,
}

/// A cell of a table. The state is a polynomial in `t = (place - centre) * inverse`, and there is
/// none for `|t|` above [`OUTSIDE`](Self::OUTSIDE).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellLayout<'a> {
    /// The place of its centre.
    pub centre: f64,
    /// 2 over its length.
    pub inverse: f64,
    /// Half of the smallest determinant, with its sign.
    pub floor: f64,
    /// Power by power, the numbers of the state side by side.
    pub coefficients: &'a [f64],
}

impl CellLayout<'_> {
    /// Beyond this there is no state: half a cell outside the table.
    pub const OUTSIDE: f64 = super::cell::OUTSIDE;
}

impl Table {
    /// Its numbers.
    #[must_use]
    pub fn layout(&self) -> TableLayout<'_> {
        let cells = self.cells.iter().map(|cell| CellLayout {
            centre: cell.centre,
            inverse: cell.inverse,
            floor: cell.floor,
            coefficients: &cell.coefficients,
        });
        TableLayout {
            axis: Axis::new(&self.scale),
            index: &self.index,
            cells: cells.collect(),
        }
    }
}

/// A grid as [`Grid::state`] reads it.
#[derive(Clone, Debug, PartialEq)]
pub struct GridLayout<'a> {
    /// The axes of the inputs.
    pub axes: Vec<Axis>,
    /// Cell by cell, the last input changing fastest; `None` where the solution cannot be reached.
    pub nodes: Vec<Option<NodeLayout<'a>>>,
    /// The data of a cell.
    pub terms: Terms,
}

/// A cell of a grid. There is no state farther from its centre, in cells along any input, than
/// [`OUTSIDE`](Self::OUTSIDE).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeLayout<'a> {
    /// Term by term, the numbers of the state side by side. Of degree 1 the state at the centre and
    /// its slopes, input by input; of polynomials, over two inputs, power by power of the second
    /// one, and for each of these power by power of the first.
    pub coefficients: &'a [f64],
    /// Half of the smallest determinant, with its sign.
    pub floor: f64,
}

impl NodeLayout<'_> {
    /// Beyond this there is no state: half a cell outside the grid.
    pub const OUTSIDE: f64 = super::grid::OUTSIDE;
}

impl Grid {
    /// Its numbers.
    #[must_use]
    pub fn layout(&self) -> GridLayout<'_> {
        let nodes = self.nodes.iter().map(|node| {
            node.as_ref().map(|node| NodeLayout {
                coefficients: &node.coefficients,
                floor: node.floor,
            })
        });
        GridLayout {
            axes: self.axes.iter().map(Axis::new).collect(),
            nodes: nodes.collect(),
            terms: self.terms,
        }
    }
}
