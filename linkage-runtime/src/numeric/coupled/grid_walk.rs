//! The cells of a grid, reached one from the other.

use super::Correction;
use super::follow::Follower;
use super::scale::Scale;
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

/// The state in a cell.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    /// At its centre.
    pub(super) state: Vec<f64>,
    /// How the state changes along the cell, input by input.
    pub(super) slopes: Vec<f64>,
    /// Half of the smallest determinant, with its sign.
    pub(super) floor: f64,
}

impl Node {
    /// The state at these offsets from the centre, in cells; the floor.
    pub(super) fn state(&self, offsets: &[f64], state: &mut [f64]) -> f64 {
        state.copy_from_slice(&self.state);
        let mut guard = 0.0;
        for (slopes, &offset) in self.slopes.chunks_exact(state.len()).zip(offsets) {
            guard += super::grid_lookup::guard(offset);
            for (number, slope) in state.iter_mut().zip(slopes) {
                *number += slope * offset;
            }
        }
        state.iter_mut().for_each(|number| *number += guard);
        self.floor + guard
    }
}

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
    let mut walk = Walk {
        follower,
        axes,
        places: places(axes.len()).into(),
        corners: vec![None; axes.iter().map(Scale::corners).product()],
        filled: Filled {
            nodes: vec![None; axes.iter().map(Scale::slots).product()],
            tested: 0,
            missed: 0,
            absent: 0,
            bends: vec![0.0; axes.len()],
        },
    };
    walk.run(at, state);
    walk.filled
}

struct Walk<'f, 'c, 'a, C> {
    follower: &'f mut Follower<'c, C>,
    axes: &'a [Scale],
    /// The places on the border of a cell that are tested.
    places: Rc<[Vec<f64>]>,
    /// The solution at the corners of the cells.
    corners: Vec<Option<Vec<f64>>>,
    filled: Filled,
}

impl<C: Correction> Walk<'_, '_, '_, C> {
    fn run(&mut self, at: &[f64], state: &[f64]) {
        let first: Vec<usize> = self
            .axes
            .iter()
            .zip(at)
            .map(|(axis, &x)| axis.cell(x).0)
            .collect();
        let mut queue = VecDeque::new();
        let mut seen = vec![false; self.filled.nodes.len()];
        seen[self.number(&first)] = true;
        match self.reach(&first, at, state) {
            Some(()) => queue.push_back(first),
            // Its centre is out of reach: smaller cells may help.
            None => {
                self.filled.missed += 1;
                self.filled.bends.fill(1.0);
            }
        }
        while let Some(cell) = queue.pop_front() {
            let Some(node) = self.filled.nodes[self.number(&cell)].clone() else {
                continue;
            };
            let from = self.centre(&cell);
            for axis in 0..self.axes.len() {
                for up in [false, true] {
                    let Some(next) = self.neighbour(&cell, axis, up) else {
                        continue;
                    };
                    let number = self.number(&next);
                    if seen[number] {
                        continue;
                    }
                    // Across the seam of a full turn the centre is taken where it lies beside this one.
                    let to = self.beside(&from, &cell, axis, up);
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
        let to = self.centre(cell);
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
        let number = self.number(cell);
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
        for (axis, scale) in self.axes.iter().enumerate() {
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
        for (place, offsets) in self.places.clone().iter().enumerate() {
            let mut x = centre.to_vec();
            for ((x, scale), offset) in x.iter_mut().zip(self.axes).zip(offsets) {
                *x += offset * scale.spacing();
            }
            node.state(offsets, &mut state);
            self.filled.tested += 1;
            let Some(determinant) = self.follower.settle_within(&x, &mut state, STEPS) else {
                let mut there = node.state.clone();
                let exists = self.follow(centre, &x, &mut there, HALVINGS).is_some();
                self.filled.missed += usize::from(exists);
                self.filled.absent += usize::from(!exists);
                continue;
            };
            if determinant.abs() < least.abs() {
                least = determinant;
            }
            if place >> self.axes.len() == 0 {
                let number = self.corner(cell, offsets);
                match &self.corners[number] {
                    Some(other) if !agree(other, &state) => return None,
                    Some(_) => {}
                    None => reached.push((number, state.clone())),
                }
            }
        }
        for (number, state) in reached {
            self.corners[number] = Some(state);
        }
        node.floor = 0.5 * least;
        Some(())
    }

    fn centre(&self, cell: &[usize]) -> Vec<f64> {
        self.axes
            .iter()
            .zip(cell)
            .map(|(axis, &slot)| axis.centre(slot))
            .collect()
    }

    fn number(&self, cell: &[usize]) -> usize {
        let pairs = self.axes.iter().zip(cell);
        pairs.fold(0, |number, (axis, &slot)| number * axis.slots() + slot)
    }

    /// The number of a corner.
    fn corner(&self, cell: &[usize], offsets: &[f64]) -> usize {
        let mut number = 0;
        for ((axis, &slot), &offset) in self.axes.iter().zip(cell).zip(offsets) {
            let border = slot + usize::from(offset > 0.0);
            number = number * axis.corners() + border % axis.corners();
        }
        number
    }

    fn neighbour(&self, cell: &[usize], axis: usize, up: bool) -> Option<Vec<usize>> {
        let mut next = cell.to_vec();
        next[axis] = self.axes[axis].neighbour(cell[axis], up)?;
        Some(next)
    }

    /// The centre of the neighbouring cell, where it lies beside this one.
    fn beside(&self, from: &[f64], cell: &[usize], axis: usize, up: bool) -> Vec<f64> {
        let mut to = from.to_vec();
        let spacing = self.axes[axis].spacing();
        let slot = cell[axis];
        let inside = if up {
            slot + 1 < self.axes[axis].slots()
        } else {
            slot > 0
        };
        to[axis] = match (inside, up) {
            (true, true) => self.axes[axis].centre(slot + 1),
            (true, false) => self.axes[axis].centre(slot - 1),
            (false, true) => from[axis] + spacing,
            (false, false) => from[axis] - spacing,
        };
        to
    }
}

/// Places on the border of a cell, as offsets from its centre in cells: all corners, then, if they are not too many, the
/// middles of edges and faces.
fn places(axes: usize) -> Vec<Vec<f64>> {
    let corner = |number: usize| {
        let side = |axis: usize| if number >> axis & 1 == 1 { 0.5 } else { -0.5 };
        (0..axes).map(side).collect()
    };
    let middle = |number: usize| {
        let side = |axis: usize| [0.0, -0.5, 0.5][number / 3_usize.pow(axis as u32) % 3];
        (0..axes).map(side).collect()
    };
    let mut places: Vec<Vec<f64>> = (0..1 << axes).map(corner).collect();
    if axes <= 4 {
        let middles = (1..3_usize.pow(axes as u32)).map(middle);
        places.extend(middles.filter(|offsets: &Vec<f64>| offsets.contains(&0.0)));
    }
    places
}

fn agree(one: &[f64], other: &[f64]) -> bool {
    one.iter()
        .zip(other)
        .all(|(a, b)| (a - b).abs() <= AGREEMENT)
}
