//! The cells of a grid after a walk.

use super::layout::Layout;
use super::node::Node;
use alloc::vec::Vec;

/// Cells between which a boundary is beside: across an edge it takes two.
const BESIDE: usize = 2;

/// A cell after a walk.
#[derive(Clone, Debug, Default)]
pub(super) struct Cell {
    pub(super) found: CellState,
    /// At how many places on its border evaluators reach the solution,
    pub(super) served: usize,
    /// at how many they do not, although it exists,
    pub(super) missed: usize,
    /// and at how many it does not exist.
    pub(super) absent: usize,
    /// True if the determinant nearly vanishes in it: a boundary is near, although it may lie
    /// between all places.
    pub(super) vanishing: bool,
    /// A place where it is missed, as offsets from the centre in cells.
    pub(super) example: Option<Vec<f64>>,
    /// The second differences of the state along the cell, input by input; empty if its centre was
    /// not reached.
    pub(super) bends: Vec<f64>,
}

/// The state of a cell after a walk.
#[derive(Clone, Debug, Default)]
pub(super) enum CellState {
    /// No cell beside it was filled.
    #[default]
    Unseen,
    /// A dead point is on the way to its centre.
    Beyond,
    /// Its centre was not reached, and no dead point was met.
    Lost,
    /// Its solution does not exist at the same places of a face as a neighbour's.
    Refused,
    /// A neighbour holds another solution.
    Other,
    /// Its centre was reached.
    Filled(Node),
}

impl Cell {
    pub(super) fn node(self) -> Option<Node> {
        match self.found {
            CellState::Filled(node) => Some(node),
            CellState::Unseen
            | CellState::Beyond
            | CellState::Lost
            | CellState::Refused
            | CellState::Other => None,
        }
    }

    /// Returns whether the solution ends in it, or nearly does.
    fn has_boundary(&self) -> bool {
        matches!(self.found, CellState::Beyond) || self.absent > 0 || self.vanishing
    }

    /// Returns the number of places at which the solution exists, or may exist, and is not served.
    /// Cells without a path to them are behind the `boundary`, if there is one.
    fn left_out(&self, places: usize, boundary: bool) -> usize {
        match self.found {
            CellState::Unseen if !boundary => places,
            CellState::Unseen | CellState::Beyond => 0,
            CellState::Lost => places,
            CellState::Refused | CellState::Other => self.served + self.missed,
            CellState::Filled(_) => self.missed,
        }
    }
}

/// The sum over all cells, in places on their borders.
#[derive(Clone, Debug, Default)]
pub(super) struct Sum {
    /// All places.
    pub(super) places: usize,
    pub(super) served: usize,
    /// Places at which the solution is not served where it exists.
    pub(super) left_out: usize,
    /// Those of them for which no boundary of the solution is to blame: it is neither in the cell
    /// nor beside it, and nowhere for cells that do not continue a neighbour, since ways around a
    /// cusp of the boundary may lead to different solutions anywhere.
    pub(super) regular: usize,
    /// True if the solution ends in some cell, or nearly does.
    pub(super) boundary: bool,
    /// The number of the cell that leaves out most of the regular places.
    pub(super) worst: Option<usize>,
    /// The second differences of the state, input by input, along the cells that leave out regular
    /// places; else along those that leave out any, else along all.
    pub(super) bends: Vec<f64>,
}

impl Sum {
    /// The sum of all cells, each with so many places.
    pub(super) fn new(cells: &[Cell], layout: &Layout<'_>, places: usize) -> Self {
        let mut sum = Self {
            places: cells.len() * places,
            boundary: cells.iter().any(Cell::has_boundary),
            ..Self::default()
        };
        let beside = beside_boundary(cells, layout);
        let mut most = 0;
        let mut bends = [const { Vec::new() }; 3];
        for (number, cell) in cells.iter().enumerate() {
            if matches!(cell.found, CellState::Filled(_)) {
                sum.served += cell.served;
            }
            let left_out = cell.left_out(places, sum.boundary);
            sum.left_out += left_out;
            let around =
                sum.boundary && matches!(cell.found, CellState::Refused | CellState::Other);
            let regular = left_out > 0 && !around && !beside[number];
            let rank = usize::from(left_out > 0) + usize::from(regular);
            add(&mut bends[rank], &cell.bends);
            if regular {
                sum.regular += left_out;
            }
            if regular && left_out > most {
                most = left_out;
                sum.worst = Some(number);
            }
        }
        let bent = |bends: &Vec<f64>| bends.iter().any(|&bend| bend > 0.0);
        sum.bends = bends.into_iter().rev().find(bent).unwrap_or_default();
        sum
    }

    /// Returns a number of places as a share of all.
    pub(super) fn share(&self, places: usize) -> f64 {
        places as f64 / self.places as f64
    }
}

fn add(sum: &mut Vec<f64>, terms: &[f64]) {
    if sum.len() < terms.len() {
        sum.resize(terms.len(), 0.0);
    }
    for (sum, terms) in sum.iter_mut().zip(terms) {
        *sum += terms;
    }
}

/// Returns the cells with a boundary, and those within a few steps from neighbour to neighbour of
/// one. The effort to fill a cell depends on its distance from a boundary in cells, however small
/// they are.
fn beside_boundary(cells: &[Cell], layout: &Layout<'_>) -> Vec<bool> {
    let mut near: Vec<bool> = cells.iter().map(Cell::has_boundary).collect();
    for _ in 0..BESIDE {
        let before = near.clone();
        for number in (0..cells.len()).filter(|&number| before[number]) {
            let slots = layout.slots(number);
            for axis in 0..slots.len() {
                for up in [false, true] {
                    if let Some(next) = layout.neighbour(&slots, axis, up) {
                        near[layout.number(&next)] = true;
                    }
                }
            }
        }
    }
    near
}
