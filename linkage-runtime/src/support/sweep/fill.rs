//! A kernel over rows of arguments, into columns or slices.

use super::arguments::Arguments;
use super::instruction_set;
use super::kernel::Kernel;
use crate::columns::Columns;
use crate::result_columns::ResultColumns;
use crate::result_row::ResultRow;
use linkage_core::Scalar;

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
    // Fewer rows than a vector has are computed as a vector, too, which is written as a whole.
    let columns = match rows {
        0 => columns.all_mut(),
        _ => columns.all_with_room(instruction_set::lanes::<T>()),
    };
    instruction_set::run(kernel, arguments, 0, columns);
}

/// Number of positions below which calls take less time than a vector, which takes as long as three
/// to five calls.
const CALLS: usize = 3;

/// Works as [`fill`], but evaluates a few positions by `one`, the function for calls, row by row,
/// if that returns something.
///
/// # Panics
///
/// Panics if the arguments differ in length.
#[inline(always)]
pub(super) fn fill_or_call<T: Scalar, R: ResultRow<T, W>, const I: usize, const W: usize>(
    kernel: &impl Kernel<T, I, W>,
    arguments: &impl Arguments<T, I>,
    columns: &mut ResultColumns<T, R, W>,
    one: impl Fn(usize) -> Option<R>,
) {
    let columns = columns.columns_mut();
    let rows = arguments.check();
    if const { T::VECTORISES } && rows <= CALLS {
        columns.resize(rows);
        let mut called =
            (0..rows).map(|row| one(row).map(|result| columns.set(row, result.to_row())));
        if called.all(|called| called.is_some()) {
            return;
        }
    }
    fill(kernel, arguments, columns);
}

/// Works as [`fill`], into the columns of a function.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub(super) fn fill_results<T: Scalar, R, const I: usize, const W: usize>(
    kernel: &impl Kernel<T, I, W>,
    arguments: &impl Arguments<T, I>,
    columns: &mut ResultColumns<T, R, W>,
) {
    fill(kernel, arguments, columns.columns_mut());
}

/// The values of the arguments in a row: one that is alone is that of all rows.
#[inline(always)]
pub(super) fn row_of<T: Scalar, const I: usize>(slices: &[&[T]; I], row: usize) -> [T; I] {
    let mut values = [T::from_f64(0.0); I];
    // A loop: closures over arrays are not always inlined.
    for (value, slice) in values.iter_mut().zip(slices) {
        *value = match slice {
            [one] => *one,
            _ => slice[row],
        };
    }
    values
}

/// Evaluates `kernel` at all positions, into slices of that length. `function` is its name, for
/// the panic.
///
/// # Panics
///
/// Panics if the arguments or slices differ in length.
pub(super) fn fill_slices<T: Scalar, const I: usize, const W: usize>(
    function: &str,
    kernel: &impl Kernel<T, I, W>,
    arguments: &impl Arguments<T, I>,
    slices: [&mut [T]; W],
) {
    let len = arguments.check();
    for (index, slice) in slices.iter().enumerate() {
        assert!(
            slice.len() == len,
            "{function}_sweep_slices: there are {len} positions, but slice {index} has {} elements",
            slice.len()
        );
    }
    instruction_set::run(kernel, arguments, 0, slices);
}
