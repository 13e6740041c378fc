//! Sources of the arguments of a sweep.

use crate::support::assembling::Compiled;
use crate::support::evaluation::FunctionNames;
use linkage_core::Scalar;

/// Rows of `I` arguments.
pub trait Arguments<T, const I: usize> {
    /// The number of rows.
    ///
    /// # Panics
    ///
    /// Panics if they are not complete.
    fn check(&self) -> usize;

    /// Fills the first `rows` of a block from `start`, argument by argument, `V` at a time: there
    /// may be more, but no fewer. Rows after the last repeat the last. With `FUSED` only on
    /// machines with fused multiply-add.
    fn block<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        start: usize,
        rows: usize,
        block: &mut [[T; B]; I],
    );
}

/// One slice for each input or argument. A slice with a single element has that value in all rows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inputs<'a, T, const I: usize> {
    /// Names for the panic.
    pub names: &'static FunctionNames<I>,
    /// The end of the name of the sweep, for the panic.
    pub sweep: &'static str,
    /// The slices.
    pub slices: [&'a [T]; I],
}

impl<T: Scalar, const I: usize> Arguments<T, I> for Inputs<'_, T, I> {
    fn check(&self) -> usize {
        let Self {
            names:
                FunctionNames {
                    function,
                    arguments,
                },
            sweep,
            slices,
        } = self;
        // The first slice with other than one element determines the number of rows.
        let lengths = slices.iter().map(|slice| slice.len());
        let (first, len) = lengths
            .enumerate()
            .find(|(_, len)| *len != 1)
            .unwrap_or((0, usize::from(I > 0)));
        for (name, slice) in arguments.iter().zip(slices) {
            assert!(
                slice.len() == len || slice.len() == 1,
                "{function}{sweep}: `{}` has {len} elements, `{name}` has {}",
                arguments[first],
                slice.len()
            );
        }
        len
    }

    #[inline(always)]
    fn block<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        start: usize,
        rows: usize,
        block: &mut [[T; B]; I],
    ) {
        // A loop over references: closures over arrays are not always inlined.
        for (column, slice) in block.iter_mut().zip(&self.slices) {
            match slice.get(start..).and_then(|rest| rest.first_chunk()) {
                Some(values) => *column = *values,
                None => last_rows(&mut column[..rows.min(B)], slice, start),
            }
        }
    }
}

/// The last rows, fewer than a block: rare, and so in a function of its own.
#[inline(never)]
fn last_rows<T: Copy>(column: &mut [T], slice: &[T], start: usize) {
    if let [value] = slice {
        return column.fill(*value);
    }
    match slice.get(start..start + column.len()) {
        Some(values) => column.copy_from_slice(values),
        None => repeat_last(column, slice, start),
    }
}

fn repeat_last<T: Copy>(column: &mut [T], slice: &[T], start: usize) {
    for (lane, value) in column.iter_mut().enumerate() {
        *value = slice[(start + lane).min(slice.len() - 1)];
    }
}

/// Many mechanisms: the dimensions of each, and one slice for each input with an element for each
/// mechanism, or a single element for all. A row is the `P` scalars of the dimensions, then the
/// inputs: `I` numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sets<'a, M, T, const P: usize, const N: usize, const I: usize> {
    /// Names for the panic.
    pub names: &'static FunctionNames<N>,
    /// The end of the name of the sweep, for the panic.
    pub sweep: &'static str,
    /// The mechanisms.
    pub sets: &'a [M],
    /// The inputs.
    pub slices: [&'a [T]; N],
}

impl<M, T, const P: usize, const N: usize, const I: usize> Arguments<T, I>
    for Sets<'_, M, T, P, N, I>
where
    T: Scalar,
    M: Compiled<Scalar = T>,
{
    fn check(&self) -> usize {
        const { assert!(I == P + N, "dimensions and inputs") };
        let len = self.sets.len();
        for (name, slice) in self.names.arguments.iter().zip(self.slices) {
            assert!(
                slice.len() == len || slice.len() == 1,
                "{}{}: there are {len} mechanisms, but `{name}` has {} elements; give it {len} or 1",
                self.names.function,
                self.sweep,
                slice.len()
            );
        }
        len
    }

    #[inline(always)]
    fn block<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        start: usize,
        rows: usize,
        block: &mut [[T; B]; I],
    ) {
        for lane in 0..rows.min(B) {
            let index = (start + lane).min(self.sets.len() - 1);
            let dimensions = self.sets[index].dimensions();
            for (column, value) in block.iter_mut().zip(dimensions.as_ref()) {
                column[lane] = *value;
            }
            for (column, slice) in block[P..].iter_mut().zip(&self.slices) {
                column[lane] = slice[index.min(slice.len() - 1)];
            }
        }
    }
}
