//! A kernel over rows of arguments, on several threads.

use super::arguments::Arguments;
use super::instruction_set;
use super::kernel::Kernel;
use crate::result_columns::ResultColumns;
use linkage_core::Scalar;

/// Works as [`fill`](crate::support::fill), on all threads of rayon's current pool.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub(super) fn fill_parallel<T: Scalar + Send + Sync, R, const I: usize, const W: usize>(
    kernel: &(impl Kernel<T, I, W> + Sync),
    arguments: &(impl Arguments<T, I> + Sync),
    columns: &mut ResultColumns<T, R, W>,
) {
    let columns = columns.columns_mut();
    columns.resize(arguments.check());
    split(0, columns.all_mut(), &|start, columns| {
        instruction_set::run(kernel, arguments, start, columns);
    });
}

/// Positions that are worth a task of their own, some ten microseconds of work.
const TASK: usize = 2048;

/// Has `evaluate` fill the rows from `start` on, in tasks.
pub(super) fn split<T: Send, const W: usize>(
    start: usize,
    columns: [&mut [T]; W],
    evaluate: &(impl Fn(usize, [&mut [T]; W]) + Sync),
) {
    let len = columns.first().map_or(0, |column| column.len());
    if len <= TASK {
        return evaluate(start, columns);
    }
    // Halves that begin where a block of positions begins.
    let half = (len / 2).next_multiple_of(TASK / 2);
    let mut tails = [const { None }; W];
    let mut tail = tails.iter_mut();
    let heads = columns.map(|column| {
        let (head, rest) = column.split_at_mut(half);
        if let Some(tail) = tail.next() {
            *tail = Some(rest);
        }
        head
    });
    let tails = tails.map(Option::unwrap_or_default);
    rayon::join(
        || split(start, heads, evaluate),
        || split(start + half, tails, evaluate),
    );
}
