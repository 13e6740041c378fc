//! The prepared numbers that a function over mechanisms uses.

use crate::support::assembling::{Compiled, RevolutionsOf};
use crate::support::stages::{Memory, RowNumbersMut};

/// A function over mechanisms: the prepared numbers of each mechanism that the function uses.
///
/// A row has `P` dimensions: `Q` numbers with the arguments of the function after them, and `R`
/// with those of its program.
pub trait SetStages<M: Compiled, const P: usize, const Q: usize, const R: usize> {
    /// The prepared numbers of `B` rows.
    type Prepared<const B: usize>: Memory<M::Scalar>;

    /// The column of each prepared number of the mechanism by [`columns_of`] those that the
    /// function uses.
    const COLUMNS: &'static [usize];

    /// Prepares the mechanism of a row: the numbers that the function uses, or all.
    #[inline(always)]
    fn prepare<const FUSED: bool>(
        mechanism: &M,
        modes: &M::Modes,
        revolutions: &RevolutionsOf<M>,
        slots: &mut impl RowNumbersMut<M::Scalar>,
    ) {
        mechanism.prepare::<FUSED>(modes, revolutions, slots);
    }
}

/// No column.
pub(super) const UNUSED: usize = usize::MAX;

/// The columns of `N` numbers, of which `used` have one, in this order.
#[must_use]
pub const fn columns_of<const N: usize>(used: &[usize]) -> [usize; N] {
    let mut columns = [UNUSED; N];
    let mut column = 0;
    while column < used.len() {
        columns[used[column]] = column;
        column += 1;
    }
    columns
}
