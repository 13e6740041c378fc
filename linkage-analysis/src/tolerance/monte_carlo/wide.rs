//! Loops over blocks of numbers, for the best instruction set that the running machine has.

/// A loop over numbers that is compiled for several instruction sets. It uses no fused
/// multiply-add, so that its results are the same on all of them.
pub(super) trait Loop {
    /// What the loop computes.
    type Result;

    /// Runs it; implementations are `#[inline(always)]`, so that they are compiled for the
    /// instruction set of the caller.
    fn run(self) -> Self::Result;
}

/// Runs the loop.
pub(super) fn run<L: Loop>(task: L) -> L::Result {
    #[cfg(target_arch = "x86_64")]
    #[allow(unsafe_code, reason = "the instruction set has been asked for")]
    {
        macro_rules! try_set {
            ($set:ident, $($feature:tt)*) => {
                if true $(&& std::arch::is_x86_feature_detected!($feature))* {
                    // SAFETY: the machine has the instruction set.
                    return unsafe { $set(task) };
                }
            };
        }
        try_set!(avx512, "avx512f" "avx512dq" "avx512vl" "avx512bw");
        try_set!(avx2, "avx2");
    }
    task.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx512bw")]
fn avx512<L: Loop>(task: L) -> L::Result {
    task.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2<L: Loop>(task: L) -> L::Result {
    task.run()
}
