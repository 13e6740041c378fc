//! Derivatives of the loops at a position, by differences.

use linkage_core::numeric::least_squares::STEP;

use crate::mobility::loops::Loops;
use crate::mobility::position::{LoopRows, Position};

/// The derivatives of all loops that can be evaluated, by all that is known to be somewhere.
pub(crate) fn rows(position: &Position<'_, '_>, loops: &Loops) -> Option<LoopRows> {
    let at = |values: &[Vec<f64>]| loops.missed(position, values);
    let here = at(&position.values);
    let kept: Vec<usize> = (0..here.len()).filter(|&k| here[k].is_finite()).collect();
    let columns = position.columns();
    let mut matrix = vec![vec![0.0; columns.len()]; kept.len()];
    for (index, &column) in columns.iter().enumerate() {
        let [before, after] = [-STEP, STEP].map(|step| at(&position.moved(column, step)));
        for (row, &k) in matrix.iter_mut().zip(&kept) {
            row[index] = (after[k] - before[k]) / (2.0 * STEP);
        }
    }
    let finite = matrix.iter().flatten().all(|x| x.is_finite());
    let loops = kept.iter().map(|&k| loops.of_row(k)).collect();
    finite.then(|| LoopRows {
        loops,
        missed: kept.iter().map(|&k| here[k]).collect(),
        kept,
        columns,
        matrix,
    })
}
