//! Where the cells of a grid are.

use super::super::scale::Scale;
use alloc::vec::Vec;

/// The cells along each input; a cell is named by its slots.
pub(super) struct Layout<'a>(pub(super) &'a [Scale]);

impl Layout<'_> {
    /// How many cells there are.
    pub(super) fn cells(&self) -> usize {
        self.0.iter().map(Scale::slots).product()
    }

    /// How many corners of cells there are.
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

/// Places on the border of a cell, as offsets from its centre in cells: all corners, then, if they are not too many, the
/// middles of edges and faces.
pub(super) fn places(axes: usize) -> Vec<Vec<f64>> {
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
