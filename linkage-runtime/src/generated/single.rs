//! One position: generated code for the instruction set of the running machine.

/// The function of an assembly that returns `R`: `I` arguments to its result, without a branch.
///
/// As a method of a trait it can be inlined always, into code for any instruction set; a closure would be called.
pub trait Single<T, R, const I: usize> {
    /// Its value at one position. With `FUSED` only on machines with fused multiply-add.
    fn at<const FUSED: bool>(&self, x: [T; I]) -> R;
}

/// The function's value, with fused multiply-add where the machine has it.
///
/// A build for machines that all have it inlines that code. Any other for x86-64 asks a flag that is set once, and calls code
/// that was compiled for AVX2 with FMA. Without the standard library nothing can be asked.
#[inline(always)]
pub fn single<A, T, R, const I: usize>(assembly: &A, x: [T; I]) -> R
where
    A: Single<T, R, I>,
    T: Copy,
{
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    if !crate::FUSED && avx2::detected() {
        return avx2::at(assembly, x);
    }
    inlined(assembly, x)
}

/// The function's value to the last bit as sweeps compute it, by code that [`single`] has, too; none on machines without fused
/// multiply-add, unless the build has code for them alone.
#[inline(always)]
pub fn as_in_sweeps<A, T, R, const I: usize>(assembly: &A, x: [T; I]) -> Option<R>
where
    A: Single<T, R, I>,
    T: Copy,
{
    #[cfg(all(target_arch = "x86_64", feature = "std"))]
    if !crate::FUSED {
        return match avx2::detected() {
            true => Some(avx2::at(assembly, x)),
            false => None,
        };
    }
    Some(inlined(assembly, x))
}

/// The function's value by code for the build's own instruction set: for what is less than a call.
#[inline(always)]
pub fn inlined<A, T, R, const I: usize>(assembly: &A, x: [T; I]) -> R
where
    A: Single<T, R, I>,
{
    assembly.at::<{ crate::FUSED }>(x)
}

#[cfg(all(target_arch = "x86_64", feature = "std"))]
mod avx2 {
    use core::sync::atomic::{AtomicU8, Ordering};

    use super::Single;

    /// What has been found of the machine: one load and one comparison for each call. (The standard library's own flags are tested one by one.)
    static FOUND: AtomicU8 = AtomicU8::new(UNKNOWN);
    const UNKNOWN: u8 = 0;
    const MISSING: u8 = 1;
    const THERE: u8 = 2;

    /// Whether the machine has AVX2 and FMA.
    #[inline(always)]
    pub(super) fn detected() -> bool {
        match FOUND.load(Ordering::Relaxed) {
            THERE => true,
            MISSING => false,
            _ => detect(),
        }
    }

    #[cold]
    fn detect() -> bool {
        let found = std::arch::is_x86_feature_detected!("avx2")
            && std::arch::is_x86_feature_detected!("fma");
        FOUND.store(if found { THERE } else { MISSING }, Ordering::Relaxed);
        found
    }

    /// The value by code for AVX2 with FMA, which [`detected`] has found. Up to three numbers are handed over in registers: an array
    /// would go through memory or registers for integers.
    #[allow(unsafe_code, reason = "the instruction set has been asked for")]
    #[inline(always)]
    pub(super) fn at<A: Single<T, R, I>, T: Copy, R, const I: usize>(assembly: &A, x: [T; I]) -> R {
        // SAFETY: the machine has the instruction set.
        unsafe {
            // Constants: of the others no code is made.
            if const { I == 1 } {
                one(assembly, x[0])
            } else if const { I == 2 } {
                two(assembly, x[0], x[1])
            } else if const { I == 3 } {
                three(assembly, x[0], x[1], x[2])
            } else {
                many(assembly, &x)
            }
        }
    }

    #[target_feature(enable = "avx2,fma")]
    fn one<A: Single<T, R, I>, T: Copy, R, const I: usize>(assembly: &A, a: T) -> R {
        assembly.at::<true>([a; I])
    }

    #[target_feature(enable = "avx2,fma")]
    fn two<A: Single<T, R, I>, T: Copy, R, const I: usize>(assembly: &A, a: T, b: T) -> R {
        let mut x = [a; I];
        x[1] = b;
        assembly.at::<true>(x)
    }

    #[target_feature(enable = "avx2,fma")]
    fn three<A: Single<T, R, I>, T: Copy, R, const I: usize>(assembly: &A, a: T, b: T, c: T) -> R {
        let mut x = [a; I];
        (x[1], x[2]) = (b, c);
        assembly.at::<true>(x)
    }

    #[target_feature(enable = "avx2,fma")]
    fn many<A: Single<T, R, I>, T: Copy, R, const I: usize>(assembly: &A, x: &[T; I]) -> R {
        assembly.at::<true>(*x)
    }
}
