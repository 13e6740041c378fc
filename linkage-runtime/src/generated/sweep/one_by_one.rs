//! Rows as single calls compute them, where none stand side by side.

use super::{Arguments, Kernel};
use crate::{FUSED, Scalar};

/// Up to so many rows take less time one by one than side by side.
pub(super) const FEW: usize = 2;

/// Evaluates the rows from `start` on, as many as the columns are long. Behind a call: what is side by side is nothing but vector code.
#[inline(never)]
pub(super) fn run<T, K, A, const I: usize, const W: usize>(
    kernel: &K,
    arguments: &A,
    start: usize,
    columns: [&mut [T]; W],
) where
    T: Scalar,
    K: Kernel<T, I, W>,
    A: Arguments<T, I>,
{
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    if !FUSED
        && std::arch::is_x86_feature_detected!("avx2")
        && std::arch::is_x86_feature_detected!("fma")
    {
        #[allow(unsafe_code, reason = "the instruction set has been asked for")]
        // SAFETY: the machine has the instruction set.
        return unsafe { with_avx2(kernel, arguments, start, columns) };
    }
    kernel.evaluate::<FUSED, 1, 1>(arguments, start, columns);
}

#[cfg(all(target_arch = "x86_64", feature = "std"))]
#[target_feature(enable = "avx2,fma")]
fn with_avx2<T, K, A, const I: usize, const W: usize>(
    kernel: &K,
    arguments: &A,
    start: usize,
    columns: [&mut [T]; W],
) where
    T: Scalar,
    K: Kernel<T, I, W>,
    A: Arguments<T, I>,
{
    kernel.evaluate::<true, 1, 1>(arguments, start, columns);
}
