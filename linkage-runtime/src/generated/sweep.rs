//! Many positions: a generated kernel over rows of arguments, into columns.

mod arguments;
mod blocks;
#[cfg(any(feature = "std", feature = "libm"))]
mod extended;
#[cfg(any(feature = "std", feature = "libm"))]
mod followed;
mod instruction_set;

pub use arguments::{Arguments, Inputs, Sets};
pub use blocks::{Block, next_vectors, rows};
#[cfg(any(feature = "std", feature = "libm"))]
pub use extended::{Extended, States};
#[cfg(feature = "rayon")]
pub use followed::fill_followed_parallel;
#[cfg(any(feature = "std", feature = "libm"))]
pub use followed::{Followed, Moving, fill_followed};

use crate::columns::Columns;
use linkage_core::Scalar;

/// A generated function as the sweeps see it: `I` arguments to `W` numbers, without a branch.
pub trait Kernel<T, const I: usize, const W: usize> {
    /// Whether there is code for AVX-512, too: generated code says so unless it is built for debugging. That is no faster by it, its
    /// results are the same, and its build takes a tenth longer.
    const WIDE: bool;

    /// Evaluates the rows of arguments from `start` on, as many as the columns are long, in blocks of up to `B`, `V` of them
    /// side by side. There are at least `V`. The last `V` begin earlier if rows are missing: some rows are then computed
    /// twice, every one in the same way. With `FUSED` only on machines with fused multiply-add.
    fn evaluate<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        arguments: &impl Arguments<T, I>,
        start: usize,
        columns: [&mut [T]; W],
    );
}

/// Evaluates `kernel` at all positions, into columns of that length.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub fn fill<T: Scalar, const I: usize, const W: usize>(
    kernel: &impl Kernel<T, I, W>,
    arguments: &impl Arguments<T, I>,
    columns: &mut Columns<T>,
) {
    let rows = arguments.check();
    columns.resize(rows);
    // Fewer rows than stand side by side are a vector, too, which is written as a whole.
    let columns = match rows {
        0 => columns.all_mut(),
        _ => columns.all_with_room(instruction_set::lanes::<T>()),
    };
    instruction_set::run(kernel, arguments, 0, columns);
}

/// So many positions take less time as calls than as a vector, which takes that of three to five calls.
const CALLS: usize = 3;

/// As [`fill`], but a few positions by `one`, the function as it is called, row by row, if that gives something.
///
/// # Panics
///
/// Panics if the arguments differ in length.
#[inline(always)]
pub fn fill_or_call<T: Scalar, const I: usize, const W: usize>(
    kernel: &impl Kernel<T, I, W>,
    arguments: &impl Arguments<T, I>,
    columns: &mut Columns<T>,
    one: impl Fn(usize) -> Option<[T; W]>,
) {
    let rows = arguments.check();
    if const { T::VECTORISES } && rows <= CALLS {
        columns.resize(rows);
        let mut called = (0..rows).map(|row| one(row).map(|numbers| columns.set(row, numbers)));
        if called.all(|called| called.is_some()) {
            return;
        }
    }
    fill(kernel, arguments, columns);
}

/// The value of an input in a row: one that is alone is that of all rows.
#[inline(always)]
pub fn in_row<T: Copy>(values: &[T], row: usize) -> T {
    match values {
        [value] => *value,
        _ => values[row],
    }
}

/// Evaluates `kernel` at all positions, into slices of that length. `title` is the function, for the panic.
///
/// # Panics
///
/// Panics if the arguments or slices differ in length.
pub fn fill_slices<T: Scalar, const I: usize, const W: usize>(
    title: &str,
    kernel: &impl Kernel<T, I, W>,
    arguments: &impl Arguments<T, I>,
    slices: [&mut [T]; W],
) {
    let len = arguments.check();
    for (index, slice) in slices.iter().enumerate() {
        assert!(
            slice.len() == len,
            "{title}: there are {len} positions, but slice {index} has {} elements",
            slice.len()
        );
    }
    instruction_set::run(kernel, arguments, 0, slices);
}

/// As [`fill`], on all threads of rayon's current pool.
///
/// # Panics
///
/// Panics if the arguments differ in length.
#[cfg(feature = "rayon")]
pub fn fill_parallel<T: Scalar + Send + Sync, const I: usize, const W: usize>(
    kernel: &(impl Kernel<T, I, W> + Sync),
    arguments: &(impl Arguments<T, I> + Sync),
    columns: &mut Columns<T>,
) {
    columns.resize(arguments.check());
    split(0, columns.all_mut(), &|start, columns| {
        instruction_set::run(kernel, arguments, start, columns);
    });
}

/// Positions that are worth a task of their own, some ten microseconds of work.
#[cfg(feature = "rayon")]
const TASK: usize = 2048;

/// Has `evaluate` fill the rows from `start` on, in tasks.
#[cfg(feature = "rayon")]
fn split<T: Send, const W: usize>(
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
