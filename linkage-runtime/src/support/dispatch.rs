//! One position: generated code for the instruction set of the running machine.

/// The function of an assembly that returns `R`: `I` arguments to its result, without a branch.
///
/// As a method of a trait it can be inlined always, into code for any instruction set; a closure
/// would be called.
pub trait Dispatch<T, R, const I: usize> {
    /// Its value at one position. With `FUSED` only on machines with fused multiply-add.
    fn at<const FUSED: bool>(&self, x: [T; I]) -> R;
}

/// The function's value, with fused multiply-add where the machine has it.
///
/// A build for machines that all have it inlines that code. Any other for x86-64 tests a flag that
/// is set once, and jumps into code that was compiled for AVX2 with FMA; all that the flag leaves
/// to be done is in a function of its own, so that it takes no room and no registers here. Without
/// the standard library the features of the machine are unknown.
#[inline(always)]
pub fn dispatch<A, T, R, const I: usize>(assembly: &A, x: [T; I]) -> R
where
    A: Dispatch<T, R, I>,
    T: Copy,
{
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    if !linkage_core::FUSED {
        return if choice::found() {
            choice::avx2(assembly, x)
        } else {
            choice::other(assembly, x)
        };
    }
    inlined(assembly, x)
}

/// The function's value as sweeps compute it except for the rounding of sines, by code that
/// [`dispatch`] has, too. `None` on machines without fused multiply-add, unless the build has code
/// for them alone.
#[inline(always)]
pub fn as_in_sweeps<A, T, R, const I: usize>(assembly: &A, x: [T; I]) -> Option<R>
where
    A: Dispatch<T, R, I>,
    T: Copy,
{
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    if !linkage_core::FUSED {
        return if choice::found() || choice::detect() {
            Some(choice::avx2(assembly, x))
        } else {
            None
        };
    }
    Some(inlined(assembly, x))
}

/// The function's value by code for the build's own instruction set, for functions that are shorter
/// than a call.
#[inline(always)]
pub fn inlined<A, T, R, const I: usize>(assembly: &A, x: [T; I]) -> R
where
    A: Dispatch<T, R, I>,
{
    assembly.at::<{ linkage_core::FUSED }>(x)
}

/// Choice of the code for this machine.
#[cfg(all(target_arch = "x86_64", feature = "std"))]
mod choice {
    use core::sync::atomic::{AtomicU8, Ordering};

    use super::{Dispatch, inlined};

    /// The known features of the machine: one load and one comparison for each call. (The standard
    /// library's own flags are tested one by one.)
    static FOUND: AtomicU8 = AtomicU8::new(UNKNOWN);
    const UNKNOWN: u8 = 0;
    const MISSING: u8 = 1;
    const THERE: u8 = 2;

    /// Returns true if AVX2 and FMA have been found.
    #[inline(always)]
    pub(super) fn found() -> bool {
        FOUND.load(Ordering::Relaxed) == THERE
    }

    /// Returns true if the machine has AVX2 and FMA, and stores that for [`found`].
    #[cold]
    pub(super) fn detect() -> bool {
        if FOUND.load(Ordering::Relaxed) == UNKNOWN {
            let there = std::arch::is_x86_feature_detected!("avx2")
                && std::arch::is_x86_feature_detected!("fma");
            FOUND.store(if there { THERE } else { MISSING }, Ordering::Relaxed);
        }
        found()
    }

    /// A call by the number of arguments, a constant: of the others no code is made. Up to three
    /// numbers are handed over in registers: an array would go through memory or registers for
    /// integers.
    macro_rules! by_number {
        ($calls:ident, $assembly:ident, $x:ident) => {
            if const { I == 1 } {
                $calls::one($assembly, $x[0])
            } else if const { I == 2 } {
                $calls::two($assembly, $x[0], $x[1])
            } else if const { I == 3 } {
                $calls::three($assembly, $x[0], $x[1], $x[2])
            } else {
                $calls::many($assembly, &$x)
            }
        };
    }

    /// The value by code for AVX2 with FMA, which have been found.
    #[allow(unsafe_code, reason = "the instruction set has been asked for")]
    #[inline(always)]
    pub(super) fn avx2<A: Dispatch<T, R, I>, T: Copy, R, const I: usize>(
        assembly: &A,
        x: [T; I],
    ) -> R {
        // SAFETY: the machine has the instruction set.
        unsafe { by_number!(fused, assembly, x) }
    }

    /// The value where they have not been found: for the first time, or on a machine without.
    #[inline(always)]
    pub(super) fn other<A: Dispatch<T, R, I>, T: Copy, R, const I: usize>(
        assembly: &A,
        x: [T; I],
    ) -> R {
        by_number!(rare, assembly, x)
    }

    /// The rare part of [`other`].
    #[inline(always)]
    fn detected<A: Dispatch<T, R, I>, T: Copy, R, const I: usize>(assembly: &A, x: [T; I]) -> R {
        if detect() {
            avx2(assembly, x)
        } else {
            inlined(assembly, x)
        }
    }

    /// Functions of one, two, three and many arguments.
    macro_rules! calls {
        ($calls:ident, #[$how:meta], $value:expr) => {
            mod $calls {
                use super::Dispatch;

                #[$how]
                pub(super) fn one<A: Dispatch<T, R, I>, T: Copy, R, const I: usize>(
                    assembly: &A,
                    a: T,
                ) -> R {
                    $value(assembly, [a; I])
                }

                #[$how]
                pub(super) fn two<A: Dispatch<T, R, I>, T: Copy, R, const I: usize>(
                    assembly: &A,
                    a: T,
                    b: T,
                ) -> R {
                    let mut x = [a; I];
                    x[1] = b;
                    $value(assembly, x)
                }

                #[$how]
                pub(super) fn three<A: Dispatch<T, R, I>, T: Copy, R, const I: usize>(
                    assembly: &A,
                    a: T,
                    b: T,
                    c: T,
                ) -> R {
                    let mut x = [a; I];
                    (x[1], x[2]) = (b, c);
                    $value(assembly, x)
                }

                #[$how]
                pub(super) fn many<A: Dispatch<T, R, I>, T: Copy, R, const I: usize>(
                    assembly: &A,
                    x: &[T; I],
                ) -> R {
                    $value(assembly, *x)
                }
            }
        };
    }
    calls!(fused, #[target_feature(enable = "avx2,fma")], A::at::<true>);
    calls!(rare, #[cold], super::detected);
}
