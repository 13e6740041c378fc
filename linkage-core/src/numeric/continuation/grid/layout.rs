//! The positions of the cells of a grid.

use super::super::scale::Scale;
use alloc::vec::Vec;

/// The cells along each input; a cell is named by its slots.
pub(super) struct Layout<'a>(pub(super) &'a [Scale]);

impl Layout<'_> {
    /// Returns the number of cells.
    pub(super) fn cells(&self) -> usize {
        self.0.iter().map(Scale::slots).product()
    }

    /// Returns the number of corners of cells.
    pub(super) fn corners(&self) -> usize {
        self.0.iter().map(Scale::corners).product()
    }

    /// The cell of a place.
    pub(super) fn cell(&self, x: &[f64]) -> Vec<usize> {
        let pairs = self.0.iter().zip(x);
        pairs.map(|(axis, &x)| axis.cell(x).0).collect()
    }

    /// A place at these offsets from another one, in cells.
    pub(super) fn moved(&self, from: &[f64], offsets: &[f64]) -> Vec<f64> {
        let mut x = from.to_vec();
        for ((x, scale), offset) in x.iter_mut().zip(self.0).zip(offsets) {
            *x += offset * scale.spacing();
        }
        x
    }

    /// The centre of a cell.
    pub(super) fn centre(&self, cell: &[usize]) -> Vec<f64> {
        self.0
            .iter()
            .zip(cell)
            .map(|(axis, &slot)| axis.centre(slot))
            .collect()
    }

    /// The number of a cell.
    pub(super) fn number(&self, cell: &[usize]) -> usize {
        let pairs = self.0.iter().zip(cell);
        pairs.fold(0, |number, (axis, &slot)| number * axis.slots() + slot)
    }

    /// The cell of a number.
    pub(super) fn slots(&self, number: usize) -> Vec<usize> {
        let mut rest = number;
        let mut cell: Vec<usize> = Vec::with_capacity(self.0.len());
        for axis in self.0.iter().rev() {
            cell.push(rest % axis.slots());
            rest /= axis.slots();
        }
        cell.reverse();
        cell
    }

    /// The number of a corner.
    pub(super) fn corner(&self, cell: &[usize], offsets: &[f64]) -> usize {
        let mut number = 0;
        for ((axis, &slot), &offset) in self.0.iter().zip(cell).zip(offsets) {
            let border = slot + usize::from(offset > 0.0);
            number = number * axis.corners() + border % axis.corners();
        }
        number
    }

    /// The next cell along an input, if there is one.
    pub(super) fn neighbour(&self, cell: &[usize], axis: usize, up: bool) -> Option<Vec<usize>> {
        let mut next = cell.to_vec();
        next[axis] = self.0[axis].neighbour(cell[axis], up)?;
        Some(next)
    }

    /// The centre of the neighbouring cell, where it lies beside this one.
    pub(super) fn beside(&self, from: &[f64], cell: &[usize], axis: usize, up: bool) -> Vec<f64> {
        let mut to = from.to_vec();
        let spacing = self.0[axis].spacing();
        let slot = cell[axis];
        let inside = if up {
            slot + 1 < self.0[axis].slots()
        } else {
            slot > 0
        };
        to[axis] = match (inside, up) {
            (true, true) => self.0[axis].centre(slot + 1),
            (true, false) => self.0[axis].centre(slot - 1),
            (false, true) => from[axis] + spacing,
            (false, false) => from[axis] - spacing,
        };
        to
    }
}

/// Places on the border of a cell: all corners, then, if they are not too many, the middles of
/// edges and faces.
pub(super) struct Places {
    /// Offsets from the centre of the cell, in cells.
    pub(super) offsets: Vec<Vec<f64>>,
    /// The number of corners among them.
    pub(super) corners: usize,
    /// The number of the place on the other side of the cell, axis by axis.
    pub(super) opposite: Vec<Vec<usize>>,
}

impl Places {
    pub(super) fn new(axes: usize) -> Self {
        let corner = |number: usize| {
            let side = |axis: usize| if number >> axis & 1 == 1 { 0.5 } else { -0.5 };
            (0..axes).map(side).collect()
        };
        let middle = |number: usize| {
            let side = |axis: usize| [0.0, -0.5, 0.5][number / 3_usize.pow(axis as u32) % 3];
            (0..axes).map(side).collect()
        };
        let corners = 1 << axes;
        let mut offsets: Vec<Vec<f64>> = (0..corners).map(corner).collect();
        if axes <= 4 {
            let middles = (1..3_usize.pow(axes as u32)).map(middle);
            offsets.extend(middles.filter(|offsets: &Vec<f64>| offsets.contains(&0.0)));
        }
        let across = |axis: usize| {
            let other = |offset: &Vec<f64>| {
                let mut other = offset.clone();
                other[axis] = -other[axis];
                offsets.iter().position(|offset| *offset == other)
            };
            offsets.iter().filter_map(other).collect()
        };
        Self {
            corners,
            opposite: (0..axes).map(across).collect(),
            offsets,
        }
    }
}
