//! The best instruction set that the running machine has.

use super::arguments::Arguments;
use super::blocks;
use super::kernel::Kernel;
use linkage_core::FUSED;
use linkage_core::Scalar;

/// The number of rows side by side.
pub(super) const fn lanes<T: Scalar>() -> usize {
    match (T::VECTORISES, size_of::<T>()) {
        (false, _) => 1,
        (true, 4) => 16,
        (true, _) => 8,
    }
}

/// Evaluates the rows from `start` on, as many as the columns are long.
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
    if blocks::rows(&columns) == 0 {
        return;
    }
    // Constants, which are known before code is made: code exists for the chosen one only.
    if const { !T::VECTORISES } {
        kernel.evaluate::<FUSED, 1, 1>(arguments, start, columns);
    } else if const { size_of::<T>() == 4 } {
        vectors::<T, K, A, 16, 64, I, W>(kernel, arguments, start, columns);
    } else {
        vectors::<T, K, A, 8, 32, I, W>(kernel, arguments, start, columns);
    }
}

/// `V` rows side by side, in blocks of `B`.
fn vectors<T, K, A, const V: usize, const B: usize, const I: usize, const W: usize>(
    kernel: &K,
    arguments: &A,
    start: usize,
    columns: [&mut [T]; W],
) where
    T: Scalar,
    K: Kernel<T, I, W>,
    A: Arguments<T, I>,
{
    if blocks::rows(&columns) < V {
        return blocks::few::<T, V, W>(columns, |block| {
            vectors::<T, K, A, V, B, I, W>(kernel, arguments, start, block);
        });
    }
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    let columns = {
        let rest = if const { K::WIDE } {
            avx512::run::<T, K, A, V, B, I, W>(kernel, arguments, start, columns)
        } else {
            Some(columns)
        };
        let rest = rest.and_then(|columns| {
            avx2::run::<T, K, A, V, B, I, W>(kernel, arguments, start, columns)
        });
        match rest {
            Some(columns) => columns,
            None => return,
        }
    };
    kernel.evaluate::<FUSED, V, B>(arguments, start, columns);
}

/// A module with `run(..)` for an instruction set with fused multiply-add.
#[cfg(all(target_arch = "x86_64", feature = "std"))]
macro_rules! instruction_set {
    ($name:ident, $($feature:tt)*) => {
        mod $name {
            use super::*;

            /// Gives the columns back if the machine has not got the instruction set.
            #[allow(unsafe_code, reason = "the instruction set has been asked for")]
            #[inline(always)]
            pub(super) fn run<'a, T, K, A, const V: usize, const B: usize, const I: usize, const W: usize>(
                kernel: &K,
                arguments: &A,
                start: usize,
                columns: [&'a mut [T]; W],
            ) -> Option<[&'a mut [T]; W]>
            where
                T: Scalar,
                K: Kernel<T, I, W>,
                A: Arguments<T, I>,
            {
                if !(true $(&& std::arch::is_x86_feature_detected!($feature))*) {
                    return Some(columns);
                }
                // SAFETY: the machine has the instruction set.
                unsafe { compiled::<T, K, A, V, B, I, W>(kernel, arguments, start, columns) };
                None
            }

            $(#[target_feature(enable = $feature)])*
            fn compiled<T, K, A, const V: usize, const B: usize, const I: usize, const W: usize>(
                kernel: &K,
                arguments: &A,
                start: usize,
                columns: [&mut [T]; W],
            ) where
                T: Scalar,
                K: Kernel<T, I, W>,
                A: Arguments<T, I>,
            {
                kernel.evaluate::<true, V, B>(arguments, start, columns);
            }
        }
    };
}

#[cfg(all(target_arch = "x86_64", feature = "std"))]
instruction_set!(avx2, "avx2" "fma");
#[cfg(all(target_arch = "x86_64", feature = "std"))]
instruction_set!(avx512, "avx512f" "avx512dq" "avx512vl" "avx512bw" "fma");
