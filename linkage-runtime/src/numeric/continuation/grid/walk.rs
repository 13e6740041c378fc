//! The cells of a grid, reached one from the other.

use super::super::Correction;
use super::super::follow::Follower;
use super::super::scale::Scale;
use super::layout::{Layout, places};
use super::node::Node;
use alloc::collections::VecDeque;
use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;

/// A step to another cell is halved so many times, at most.
const HALVINGS: u32 = 5;

/// Slopes are taken over this part of a cell, to both sides.
const PART: f64 = 1.0 / 16.0;

/// Newton steps that evaluators make from a cell's state.
const STEPS: usize = 4;

/// Two cells that agree this well at a corner are on one solution.
const AGREEMENT: f64 = 1e-6;

/// The cells of a grid.
pub(super) struct Filled {
    pub(super) nodes: Vec<Option<Node>>,
    /// How many places on the borders of cells were tested.
    pub(super) tested: usize,
    /// At how many of these the solution exists, but four steps do not reach it.
    pub(super) missed: usize,
    /// At how many it does not exist.
    pub(super) absent: usize,
    /// How much the state bends along the cells, input by input.
    pub(super) bends: Vec<f64>,
}

/// Fills the grid from a known solution.
pub(super) fn fill<C: Correction>(
    follower: &mut Follower<'_, C>,
    axes: &[Scale],
    at: &[f64],
    state: &[f64],
) -> Filled {
    let layout = Layout(axes);
    let mut walk = Walk {
        follower,
        places: places(axes.len()).into(),
        corners: vec![None; layout.corners()],
        reached: vec![Vec::new(); layout.cells()],
        filled: Filled {
            nodes: vec![None; layout.cells()],
            tested: 0,
            missed: 0,
            absent: 0,
            bends: vec![0.0; axes.len()],
        },
        layout,
    };
    walk.run(at, state);
    walk.filled
}

struct Walk<'f, 'c, 'a, C> {
    follower: &'f mut Follower<'c, C>,
    layout: Layout<'a>,
    /// The places on the border of a cell that are tested.
    places: Rc<[Vec<f64>]>,
    /// The solution at the corners of the cells.
    corners: Vec<Option<Vec<f64>>>,
    /// The solution at the places of the cells that are filled.
    reached: Vec<Vec<Option<Vec<f64>>>>,
    filled: Filled,
}

impl<C: Correction> Walk<'_, '_, '_, C> {
    fn run(&mut self, at: &[f64], state: &[f64]) {
        let first = self.layout.cell(at);
        let mut queue = VecDeque::new();
        let mut seen = vec![false; self.filled.nodes.len()];
        seen[self.layout.number(&first)] = true;
        match self.reach(&first, at, state) {
            Some(()) => queue.push_back(first),
            // Its centre is out of reach: smaller cells may help.
            None => {
                self.filled.missed += 1;
                self.filled.bends.fill(1.0);
            }
        }
        while let Some(cell) = queue.pop_front() {
            let Some(node) = self.filled.nodes[self.layout.number(&cell)].clone() else {
                continue;
            };
            let from = self.layout.centre(&cell);
            for axis in 0..self.layout.0.len() {
                for up in [false, true] {
                    let Some(next) = self.layout.neighbour(&cell, axis, up) else {
                        continue;
                    };
                    let number = self.layout.number(&next);
                    if seen[number] {
                        continue;
                    }
                    // Across the seam of a full turn the centre is taken where it lies beside this one.
                    let to = self.layout.beside(&from, &cell, axis, up);
                    if self.reach_at(&next, &from, &node.state, &to).is_some() {
                        seen[number] = true;
                        queue.push_back(next);
                    }
                }
            }
        }
    }

    /// Follows the solution from `from` to the centre of a cell.
    fn reach(&mut self, cell: &[usize], from: &[f64], state: &[f64]) -> Option<()> {
        let to = self.layout.centre(cell);
        self.reach_at(cell, from, state, &to)
    }

    fn reach_at(&mut self, cell: &[usize], from: &[f64], state: &[f64], to: &[f64]) -> Option<()> {
        let mut state = state.to_vec();
        let determinant = self.follow(from, to, &mut state, HALVINGS)?;
        let slopes = self.slopes(to, &state);
        let mut node = Node {
            state,
            slopes,
            floor: determinant,
        };
        self.check(cell, to, &mut node)?;
        let number = self.layout.number(cell);
        self.filled.nodes[number] = Some(node);
        Some(())
    }

    /// Brings a solution from one place to another, in smaller steps if need be.
    fn follow(
        &mut self,
        from: &[f64],
        to: &[f64],
        state: &mut [f64],
        halvings: u32,
    ) -> Option<f64> {
        let mut moved = state.to_vec();
        if let Some(determinant) = self.follower.settle(to, &mut moved) {
            state.copy_from_slice(&moved);
            return Some(determinant);
        }
        let halvings = halvings.checked_sub(1)?;
        let middle: Vec<f64> = from
            .iter()
            .zip(to)
            .map(|(a, b)| a + 0.5 * (b - a))
            .collect();
        self.follow(from, &middle, state, halvings)?;
        self.follow(&middle, to, state, halvings)
    }

    /// The changes of the state along the cell, input by input.
    fn slopes(&mut self, centre: &[f64], state: &[f64]) -> Vec<f64> {
        let mut slopes = Vec::with_capacity(centre.len() * state.len());
        for (axis, scale) in self.layout.0.iter().enumerate() {
            let mut side = |part: f64| {
                let mut x = centre.to_vec();
                x[axis] += part * scale.spacing();
                let mut moved = state.to_vec();
                self.follower.settle(&x, &mut moved).map(|_| moved)
            };
            let empty = scale.spacing() == 0.0;
            let (below, above) = if empty {
                (None, None)
            } else {
                (side(-PART), side(PART))
            };
            for (index, &here) in state.iter().enumerate() {
                let [down, up] = [&below, &above]
                    .map(|side| side.as_ref().map(|side| (side[index] - here) / PART));
                slopes.push(match (down, up) {
                    (Some(down), Some(up)) => {
                        self.filled.bends[axis] += (up + down).abs();
                        0.5 * (up - down)
                    }
                    (Some(down), None) => -down,
                    (None, Some(up)) => up,
                    (None, None) => 0.0,
                });
            }
        }
        slopes
    }

    /// Whether the steps reach the solution wherever it exists on the border of the cell. `None` if another cell has
    /// reached another solution at a common corner.
    fn check(&mut self, cell: &[usize], centre: &[f64], node: &mut Node) -> Option<()> {
        let mut least = node.floor;
        let mut state = vec![0.0; node.state.len()];
        let mut reached = Vec::new();
        let mut places = vec![None; self.places.len()];
        for (place, offsets) in self.places.clone().iter().enumerate() {
            let x = self.layout.moved(centre, offsets);
            node.state(offsets, &mut state);
            self.filled.tested += 1;
            let Some(determinant) = self.follower.settle_within(&x, &mut state, STEPS) else {
                let mut there = node.state.clone();
                let exists = self.follow(centre, &x, &mut there, HALVINGS).is_some();
                self.filled.missed += usize::from(exists);
                self.filled.absent += usize::from(!exists);
                continue;
            };
            places[place] = Some(state.clone());
            if determinant.abs() < least.abs() {
                least = determinant;
            }
            if place >> self.layout.0.len() == 0 {
                let number = self.layout.corner(cell, offsets);
                match &self.corners[number] {
                    Some(other) if !agree(other, &state) => return None,
                    Some(_) => {}
                    None => reached.push((number, state.clone())),
                }
            }
        }
        if !self.joins(cell, &places) {
            return None;
        }
        self.reached[self.layout.number(cell)] = places;
        for (number, state) in reached {
            self.corners[number] = Some(state);
        }
        node.floor = 0.5 * least;
        Some(())
    }

    /// Whether a cell has the same solution as every neighbour on the whole face between them. Where only one of them reaches it, as
    /// around a cusp, they may hold different assemblies.
    fn joins(&self, cell: &[usize], places: &[Option<Vec<f64>>]) -> bool {
        (0..cell.len()).all(|axis| {
            [false, true].into_iter().all(|up| {
                let next = self.layout.neighbour(cell, axis, up);
                next.is_none_or(|next| {
                    let other = &self.reached[self.layout.number(&next)];
                    next == cell || other.is_empty() || self.same_on_face(axis, up, places, other)
                })
            })
        })
    }

    /// Whether two cells reach the same solutions on the face that is the upper or lower one of the first.
    fn same_on_face(
        &self,
        axis: usize,
        up: bool,
        places: &[Option<Vec<f64>>],
        other: &[Option<Vec<f64>>],
    ) -> bool {
        let side = if up { 0.5 } else { -0.5 };
        let on_face = self.places.iter().zip(places);
        let mut on_face = on_face.filter(|(offsets, _)| offsets[axis] == side);
        on_face.all(|(offsets, here)| {
            let mut opposite = offsets.clone();
            opposite[axis] = -side;
            let there = self.places.iter().position(|place| *place == opposite);
            match (here, there.and_then(|there| other[there].as_ref())) {
                (Some(one), Some(two)) => agree(one, two),
                (None, None) => true,
                _ => false,
            }
        })
    }
}

fn agree(one: &[f64], other: &[f64]) -> bool {
    one.iter()
        .zip(other)
        .all(|(a, b)| (a - b).abs() <= AGREEMENT)
}
