//! Perpendicular columns for the effects, so that the size of the masses and the likeness of their
//! effects do no harm.

use alloc::vec::Vec;

use super::BalanceError;
use super::rows::{ForceRow, add, dot};
use crate::components::norm;

/// The effects as a product: columns of length 1 that are perpendicular to each other, times a
/// triangular matrix.
pub(super) struct Basis<const N: usize> {
    columns: Vec<[[f64; 3]; N]>,
    /// Column `j` of the scaled effects is the sum of `triangle[i][j]` times column `i` of the
    /// basis.
    triangle: [[f64; N]; N],
    scales: [f64; N],
}

/// A column of which less than this is not a combination of those before it counts as one.
const DEPENDENT: f64 = 1e-12;

impl<const N: usize> Basis<N> {
    /// Orthogonalises by the modified process of Gram and Schmidt, with every projection made
    /// twice: then the columns are perpendicular to rounding.
    pub(super) fn new(rows: &[ForceRow<N>]) -> Result<Self, BalanceError> {
        let mut columns: Vec<[[f64; 3]; N]> = rows.iter().map(|row| row.effects).collect();
        let mut triangle = [[0.0; N]; N];
        let mut scales = [0.0; N];
        for j in 0..N {
            scales[j] = length(&columns, j);
            if scales[j] == 0.0 {
                return Err(BalanceError::NoEffect { effect: j });
            }
            divide(&mut columns, j, scales[j]);
            for i in [0, 1].into_iter().flat_map(|_| 0..j) {
                let along: f64 = columns.iter().map(|row| dot(&row[i], &row[j])).sum();
                for row in &mut columns {
                    let unit = row[i];
                    add(&mut row[j], -along, &unit);
                }
                triangle[i][j] += along;
            }
            let rest = length(&columns, j);
            if rest < DEPENDENT {
                return Err(BalanceError::Dependent { effect: j });
            }
            divide(&mut columns, j, rest);
            triangle[j][j] = rest;
        }
        Ok(Self {
            columns,
            triangle,
            scales,
        })
    }

    /// The columns, row by row.
    pub(super) fn columns(&self) -> &[[[f64; 3]; N]] {
        &self.columns
    }

    /// The coordinates that take most away from the forces, and the remainder of these,
    /// perpendicular to all columns.
    pub(super) fn project(&self, rows: &[ForceRow<N>]) -> ([f64; N], Vec<[f64; 3]>) {
        let mut rest: Vec<[f64; 3]> = rows.iter().map(|row| row.force).collect();
        let mut coordinates = [0.0; N];
        for j in [0, 1].into_iter().flat_map(|_| 0..N) {
            let pairs = self.columns.iter().zip(&rest);
            let along: f64 = pairs.map(|(row, force)| dot(&row[j], force)).sum();
            for (row, force) in self.columns.iter().zip(&mut rest) {
                add(force, -along, &row[j]);
            }
            coordinates[j] -= along;
        }
        (coordinates, rest)
    }

    /// The masses with these coordinates.
    pub(super) fn values(&self, coordinates: &[f64; N]) -> [f64; N] {
        let mut values = *coordinates;
        for j in (0..N).rev() {
            values[j] /= self.triangle[j][j];
            for i in 0..j {
                values[i] -= self.triangle[i][j] * values[j];
            }
        }
        core::array::from_fn(|j| values[j] / self.scales[j])
    }
}

fn length<const N: usize>(columns: &[[[f64; 3]; N]], j: usize) -> f64 {
    let lengths: Vec<f64> = columns.iter().map(|row| norm(&row[j])).collect();
    norm(&lengths)
}

fn divide<const N: usize>(columns: &mut [[[f64; 3]; N]], j: usize, divisor: f64) {
    for row in columns {
        row[j] = row[j].map(|x| x / divisor);
    }
}
