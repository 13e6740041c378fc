//! The cells of a grid, reached one from the other.

use super::super::follow::Follower;
use super::super::scale::Scale;
use super::border::{Border, BorderState, Joint, agree};
use super::cells::{Cell, CellState};
use super::fit::Fit;
use super::layout::{Layout, Places};
use super::node::Node;
use super::path::{PathEnd, follow};
use super::served::served;
use super::slopes::slopes;
use alloc::collections::VecDeque;
use alloc::vec;
use alloc::vec::Vec;

/// A determinant below this share of the one at the reference means that a dead point is near: its
/// distance goes with the square of the determinant.
pub(super) const NEAR: f64 = 0.1;

/// A solution at a place.
pub(super) struct Solution<'a> {
    pub(super) at: &'a [f64],
    pub(super) state: &'a [f64],
    pub(super) determinant: f64,
}

/// Fills the grid from the solution at the reference.
pub(super) fn fill(
    follower: &mut Follower<'_>,
    axes: &[Scale],
    (places, fit): (&Places, &Fit),
    reference: &Solution<'_>,
) -> Vec<Cell> {
    let layout = Layout(axes);
    let mut walk = Walk {
        follower,
        border: Border::new(&layout, places),
        fit,
        reference: reference.determinant,
        centres: vec![None; layout.cells()],
        cells: vec![Cell::default(); layout.cells()],
        layout,
    };
    walk.run(reference);
    walk.cells
}

struct Walk<'f, 'c, 'a> {
    follower: &'f mut Follower<'c>,
    layout: Layout<'a>,
    border: Border<'a>,
    fit: &'a Fit,
    /// The determinant at the reference.
    reference: f64,
    /// State and determinant at the centres that were reached, also of cells that were refused.
    centres: Vec<Option<(Vec<f64>, f64)>>,
    cells: Vec<Cell>,
}

impl Walk<'_, '_, '_> {
    fn run(&mut self, reference: &Solution<'_>) {
        let mut queue = self.begin(reference);
        while let Some(cell) = queue.pop_front() {
            let Some((state, determinant)) = self.centres[self.layout.number(&cell)].clone() else {
                continue;
            };
            let at = self.layout.centre(&cell);
            let from = Solution {
                at: &at,
                state: &state,
                determinant,
            };
            queue.extend(self.spread(&cell, &from));
        }
    }

    /// The cell of the reference; where its centre is out of reach, those beside it.
    fn begin(&mut self, reference: &Solution<'_>) -> VecDeque<Vec<usize>> {
        let first = self.layout.cell(reference.at);
        let to = self.layout.centre(&first);
        if self.reach(&first, reference, &to) {
            return [first].into();
        }
        // How the state bends at the reference says which sides of the cells are too long.
        let (_, bends) = slopes(self.follower, &self.layout, reference.at, reference.state);
        let number = self.layout.number(&first);
        self.cells[number].bends = bends;
        self.spread(&first, reference).into()
    }

    /// Fills the neighbours of a cell, from a solution in it; those that are filled now.
    fn spread(&mut self, cell: &[usize], from: &Solution<'_>) -> Vec<Vec<usize>> {
        let centre = self.layout.centre(cell);
        let mut filled = Vec::new();
        for axis in 0..self.layout.0.len() {
            for up in [false, true] {
                let Some(next) = self.layout.neighbour(cell, axis, up) else {
                    continue;
                };
                // Across the seam of a full turn the centre is taken where it lies beside this one.
                let to = self.layout.beside(&centre, cell, axis, up);
                if self.reach(&next, from, &to) {
                    filled.push(next);
                }
            }
        }
        filled
    }

    /// Follows the solution to the centre of a cell, and fills the cell from there. False if it is
    /// not filled, or was before.
    fn reach(&mut self, cell: &[usize], from: &Solution<'_>, to: &[f64]) -> bool {
        let number = self.layout.number(cell);
        if matches!(self.cells[number].found, CellState::Filled(_)) {
            return false;
        }
        let mut state = from.state.to_vec();
        let determinants = [from.determinant, self.reference];
        let determinant = match follow(self.follower, from.at, to, &mut state, determinants) {
            PathEnd::Reached(determinant) => determinant,
            ended => {
                let cell = &mut self.cells[number];
                match (ended, &cell.found) {
                    (PathEnd::DeadPoint, CellState::Unseen | CellState::Lost) => {
                        cell.found = CellState::Beyond
                    }
                    (_, CellState::Unseen) => cell.found = CellState::Lost,
                    _ => {}
                }
                return false;
            }
        };
        // From another neighbour it may be another solution; the same one would be refused again.
        let before = self.centres[number].as_ref();
        if before.is_some_and(|(before, _)| agree(before, &state)) {
            return false;
        }
        self.centres[number] = Some((state.clone(), determinant));
        let (slopes, bends) = slopes(self.follower, &self.layout, to, &state);
        let mut node = Node::with_slopes(&state, &slopes, determinant, self.fit.terms());
        self.fit.refine(self.follower, &self.layout, to, &mut node);
        self.cells[number] = Cell {
            bends,
            ..self.checked(cell, to, node)
        };
        matches!(self.cells[number].found, CellState::Filled(_))
    }

    /// The cell with this node: whether evaluators reach the solution wherever it exists on the
    /// border. Refused if it does not continue its neighbours.
    fn checked(&mut self, slots: &[usize], centre: &[f64], mut node: Node) -> Cell {
        let mut cell = Cell::default();
        let mut least = node.floor;
        let mut places = Vec::with_capacity(self.border.places.offsets.len());
        for offsets in &self.border.places.offsets {
            let (border_state, determinant) = self.border_state(centre, &node, offsets);
            match border_state {
                BorderState::Served(_) => cell.served += 1,
                BorderState::Absent => cell.absent += 1,
                BorderState::Missed(_) | BorderState::Unknown => {
                    cell.missed += 1;
                    cell.example.get_or_insert_with(|| offsets.clone());
                }
            }
            if determinant.abs() < least.abs() {
                least = determinant;
            }
            places.push(border_state);
        }
        cell.vanishing = least.abs() < NEAR * self.reference.abs();
        cell.found = match self.border.joint(&self.layout, slots, &places) {
            Joint::Same => {
                self.border.keep(&self.layout, slots, places);
                node.floor = 0.5 * least;
                CellState::Filled(node)
            }
            Joint::Unclear => CellState::Refused,
            Joint::Other => CellState::Other,
        };
        cell
    }

    /// A place on the border of a cell, and the determinant there, as far as it is known.
    fn border_state(&mut self, centre: &[f64], node: &Node, offsets: &[f64]) -> (BorderState, f64) {
        let x = self.layout.moved(centre, offsets);
        let mut state = vec![0.0; node.centre().len()];
        node.state::<false>(offsets, &mut state);
        if let Some(determinant) = served(self.follower, self.fit.terms(), &x, &mut state) {
            return (BorderState::Served(state), determinant);
        }
        state.copy_from_slice(node.centre());
        let determinants = [node.floor, self.reference];
        match follow(self.follower, centre, &x, &mut state, determinants) {
            PathEnd::Reached(determinant) => (BorderState::Missed(state), determinant),
            PathEnd::DeadPoint => (BorderState::Absent, f64::INFINITY),
            PathEnd::Lost => (BorderState::Unknown, f64::INFINITY),
        }
    }
}
