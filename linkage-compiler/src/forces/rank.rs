//! Whether equations that are solved together tell their unknowns, by numbers: matching sees only which unknowns an equation contains.

use linkage_symbolic::NodeId;

use crate::formulate::Reference;

use super::Mechanics;
use super::system::System;

/// Equations that are independent by less are not.
const INDEPENDENT: f64 = 1e-9;

impl Mechanics<'_, '_> {
    /// True if the equations of a block repeat each other at all places where the mechanism closes.
    pub(super) fn repeats(
        &self,
        system: &System,
        block: &[usize],
        reference: &Reference,
        places: &[Vec<f64>],
    ) -> bool {
        let unknowns = block
            .iter()
            .flat_map(|&e| &system.matching.coordinates_of[e]);
        let unknowns: Vec<usize> = unknowns.copied().collect();
        let entries = block
            .iter()
            .flat_map(|&e| unknowns.iter().map(move |&k| system.matrix[e][k]));
        let entries: Vec<NodeId> = entries.collect();
        let values = self.values(&entries, reference, places);
        !values.is_empty()
            && values.into_iter().all(|values| {
                let rows = values.chunks(unknowns.len()).map(<[f64]>::to_vec);
                is_singular(rows.collect())
            })
    }
}

/// By Gauss elimination, rows and columns brought to size 1.
fn is_singular(mut rows: Vec<Vec<f64>>) -> bool {
    let count = rows.len();
    for k in 0..count {
        let column = rows
            .iter()
            .fold(0.0, |size: f64, row| size.max(row[k].abs()));
        rows.iter_mut().for_each(|row| row[k] /= column);
    }
    for row in &mut rows {
        let size = row.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        row.iter_mut().for_each(|x| *x /= size);
    }
    for k in 0..count {
        let places = (k..count).flat_map(|i| (k..count).map(move |j| (i, j)));
        let largest = places.fold((k, k), |(a, b), (i, j)| {
            match rows[i][j].abs() > rows[a][b].abs() {
                true => (i, j),
                false => (a, b),
            }
        });
        let pivot = rows[largest.0][largest.1];
        // A column of zeros has become NaN.
        if pivot.is_nan() || pivot.abs() < INDEPENDENT {
            return true;
        }
        rows.swap(k, largest.0);
        rows.iter_mut().for_each(|row| row.swap(k, largest.1));
        let (head, rest) = rows.split_at_mut(k + 1);
        for row in rest {
            let factor = row[k] / pivot;
            let own = row.iter_mut().zip(&head[k]);
            own.for_each(|(x, y)| *x -= factor * y);
        }
    }
    false
}
