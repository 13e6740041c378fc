//! A generated function as the loops of sweeps call it.

use super::arguments::Arguments;

/// A generated function as the sweeps see it: `I` arguments to `W` numbers, without a branch.
pub trait Kernel<T, const I: usize, const W: usize> {
    /// True if there is code for AVX-512, too: generated code sets it unless it is built for
    /// debugging. It is no faster without, its results are the same, and its build takes a tenth
    /// longer.
    const WIDE: bool;

    /// Evaluates the rows of arguments from `start` on, as many as the columns are long, in blocks
    /// of up to `B`, `V` of them side by side. There are at least `V`. The last `V` begin earlier
    /// if rows are missing: some rows are then computed twice, every one in the same way. With
    /// `FUSED` only on machines with fused multiply-add.
    fn evaluate<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        arguments: &impl Arguments<T, I>,
        start: usize,
        columns: [&mut [T]; W],
    );
}
