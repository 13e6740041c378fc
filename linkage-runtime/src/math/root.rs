//! The square root of an `f32` without the standard library.

/// By the instruction that every ARM target with floating-point registers in its calling convention has. `libm` computes it in
/// software there, and `core` offers none.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline(always)]
#[allow(unsafe_code, reason = "one instruction")]
pub(super) fn single(x: f32) -> f32 {
    let mut bits = x.to_bits();
    // In general registers: for others the compiler wants double precision, which a Cortex-M4 lacks. The callers need bits anyway.
    // SAFETY: the instructions work on these two registers alone.
    unsafe {
        core::arch::asm!(
            "vmov s0, {bits}",
            "vsqrt.f32 s0, s0",
            "vmov {bits}, s0",
            bits = inout(reg) bits,
            out("s0") _,
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    f32::from_bits(bits)
}

#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
pub(super) use libm::sqrtf as single;
