//! Many positions: a generated kernel over slices of inputs, into columns.

use crate::{Columns, Scalar};

/// A generated function as the sweeps see it: `I` inputs to `W` numbers, without a branch.
pub trait Kernel<T, const I: usize, const W: usize> {
    /// All numbers at one position.
    fn evaluate(&self, inputs: [T; I]) -> [T; W];
}

/// Positions evaluated together.
const BLOCK: usize = 8;

/// Evaluates `kernel` at all positions. `title` and `names` are the function and its arguments, for the panic.
///
/// # Panics
///
/// Panics if the slices differ in length.
pub fn fill<T: Scalar, const I: usize, const W: usize>(
    title: &str,
    names: [&str; I],
    inputs: [&[T]; I],
    kernel: &impl Kernel<T, I, W>,
    columns: &mut Columns<T>,
) {
    let len = inputs.first().map_or(0, |first| first.len());
    for (name, slice) in names.iter().zip(&inputs) {
        assert!(
            slice.len() == len,
            "{title}: `{}` has {len} elements, `{name}` has {}",
            names[0],
            slice.len()
        );
    }
    columns.resize(len);
    let whole = len - len % BLOCK;
    for start in (0..whole).step_by(BLOCK) {
        let arguments =
            inputs.map(|slice| core::array::from_fn(|lane| slice[start..start + BLOCK][lane]));
        let block = evaluate_block(kernel, &arguments);
        for (index, column) in block.iter().enumerate() {
            columns.column_mut(index)[start..start + BLOCK].copy_from_slice(column);
        }
    }
    for row in whole..len {
        columns.set_row(row, kernel.evaluate(inputs.map(|slice| slice[row])));
    }
}

/// The loop that becomes vector code.
#[inline(always)]
fn evaluate_block<T: Scalar, const I: usize, const W: usize>(
    kernel: &impl Kernel<T, I, W>,
    arguments: &[[T; BLOCK]; I],
) -> [[T; BLOCK]; W] {
    let mut block = [[T::from_f64(0.0); BLOCK]; W];
    for lane in 0..BLOCK {
        let row = kernel.evaluate(core::array::from_fn(|input| arguments[input][lane]));
        for (column, value) in block.iter_mut().zip(row) {
            column[lane] = value;
        }
    }
    block
}
