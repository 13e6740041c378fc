//! One position: generated code for the instruction set of the running machine.

/// The function of an assembly that returns `R`: `I` arguments to its result, without a branch.
///
/// As a method of a trait it can be inlined always, into code for any instruction set; a closure
/// would be called.
pub trait Dispatch<T, R, const I: usize> {
    /// Its value at one position. With `FUSED` only on machines with fused multiply-add.
    fn at<const FUSED: bool>(&self, x: [T; I]) -> R;
}

/// One of the functions of the data `A`, as [`Dispatch`].
pub(super) trait DataFunction<A, T, R, const I: usize> {
    /// Its value at one position. With `FUSED` only on machines with fused multiply-add.
    fn value<const FUSED: bool>(data: &A, x: [T; I]) -> R;
}

/// The function that data have by [`Dispatch`].
enum Dispatched {}

impl<A: Dispatch<T, R, I>, T, R, const I: usize> DataFunction<A, T, R, I> for Dispatched {
    #[inline(always)]
    fn value<const FUSED: bool>(data: &A, x: [T; I]) -> R {
        data.at::<FUSED>(x)
    }
}

/// The function's value, with fused multiply-add where the machine has it.
#[inline(always)]
pub fn dispatch<A, T, R, const I: usize>(assembly: &A, x: [T; I]) -> R
where
    A: Dispatch<T, R, I>,
    T: Copy,
{
    dispatch_function::<Dispatched, A, T, R, I>(assembly, x)
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

/// The function's value, with fused multiply-add where the machine has it.
///
/// A build for machines that all have it inlines that code. Any other for x86-64 tests a flag that
/// is set once, and jumps into code that was compiled for AVX2 with FMA; all that the flag leaves
/// to be done is in a function of its own, so that it takes no room and no registers here. Without
/// the standard library the features of the machine are unknown.
#[inline(always)]
pub(super) fn dispatch_function<F, A, T, R, const I: usize>(data: &A, x: [T; I]) -> R
where
    F: DataFunction<A, T, R, I>,
    T: Copy,
{
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    if !linkage_core::FUSED {
        return if choice::found() {
            choice::avx2::<F, A, T, R, I>(data, x)
        } else {
            choice::other::<F, A, T, R, I>(data, x)
        };
    }
    inlined_function::<F, A, T, R, I>(data, x)
}

/// The function's value as sweeps compute it except for the rounding of sines, by code that
/// [`dispatch_function`] has, too. `None` on machines without fused multiply-add, unless the build has code
/// for them alone.
#[cfg(feature = "alloc")]
#[inline(always)]
pub(super) fn as_in_sweeps<F, A, T, R, const I: usize>(data: &A, x: [T; I]) -> Option<R>
where
    F: DataFunction<A, T, R, I>,
    T: Copy,
{
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    if !linkage_core::FUSED {
        return if choice::found() || choice::detect() {
            Some(choice::avx2::<F, A, T, R, I>(data, x))
        } else {
            None
        };
    }
    Some(inlined_function::<F, A, T, R, I>(data, x))
}

/// The function's value by code for the build's own instruction set, for functions that are shorter
/// than a call.
#[inline(always)]
pub(super) fn inlined_function<F, A, T, R, const I: usize>(data: &A, x: [T; I]) -> R
where
    F: DataFunction<A, T, R, I>,
{
    F::value::<{ linkage_core::FUSED }>(data, x)
}

/// Choice of the code for this machine.
#[cfg(all(target_arch = "x86_64", feature = "std"))]
mod choice {
    use core::sync::atomic::{AtomicU8, Ordering};

    use super::{DataFunction, inlined_function};

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
        ($calls:ident, $data:ident, $x:ident) => {
            if const { I == 1 } {
                $calls::one::<F, A, T, R, I>($data, $x[0])
            } else if const { I == 2 } {
                $calls::two::<F, A, T, R, I>($data, $x[0], $x[1])
            } else if const { I == 3 } {
                $calls::three::<F, A, T, R, I>($data, $x[0], $x[1], $x[2])
            } else {
                $calls::many::<F, A, T, R, I>($data, &$x)
            }
        };
    }

    /// The value by code for AVX2 with FMA, which have been found.
    #[allow(unsafe_code, reason = "the instruction set has been asked for")]
    #[inline(always)]
    pub(super) fn avx2<F: DataFunction<A, T, R, I>, A, T: Copy, R, const I: usize>(
        data: &A,
        x: [T; I],
    ) -> R {
        // SAFETY: the machine has the instruction set.
        unsafe { by_number!(fused, data, x) }
    }

    /// The value where they have not been found: for the first time, or on a machine without.
    #[inline(always)]
    pub(super) fn other<F: DataFunction<A, T, R, I>, A, T: Copy, R, const I: usize>(
        data: &A,
        x: [T; I],
    ) -> R {
        by_number!(rare, data, x)
    }

    /// The rare part of [`other`].
    #[inline(always)]
    fn detected<F: DataFunction<A, T, R, I>, A, T: Copy, R, const I: usize>(
        data: &A,
        x: [T; I],
    ) -> R {
        if detect() {
            avx2::<F, A, T, R, I>(data, x)
        } else {
            inlined_function::<F, A, T, R, I>(data, x)
        }
    }

    /// Functions of one, two, three and many arguments.
    macro_rules! calls {
        ($calls:ident, #[$how:meta], $value:expr) => {
            mod $calls {
                use super::DataFunction;

                #[$how]
                pub(super) fn one<F: DataFunction<A, T, R, I>, A, T: Copy, R, const I: usize>(
                    data: &A,
                    a: T,
                ) -> R {
                    $value(data, [a; I])
                }

                #[$how]
                pub(super) fn two<F: DataFunction<A, T, R, I>, A, T: Copy, R, const I: usize>(
                    data: &A,
                    a: T,
                    b: T,
                ) -> R {
                    let mut x = [a; I];
                    x[1] = b;
                    $value(data, x)
                }

                #[$how]
                pub(super) fn three<F: DataFunction<A, T, R, I>, A, T: Copy, R, const I: usize>(
                    data: &A,
                    a: T,
                    b: T,
                    c: T,
                ) -> R {
                    let mut x = [a; I];
                    (x[1], x[2]) = (b, c);
                    $value(data, x)
                }

                #[$how]
                pub(super) fn many<F: DataFunction<A, T, R, I>, A, T: Copy, R, const I: usize>(
                    data: &A,
                    x: &[T; I],
                ) -> R {
                    $value(data, *x)
                }
            }
        };
    }
    calls!(fused, #[target_feature(enable = "avx2,fma")], F::value::<true>);
    calls!(rare, #[cold], super::detected::<F, A, T, R, I>);
}
