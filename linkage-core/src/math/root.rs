//! Square roots without the standard library: by an instruction where stable Rust tells that the
//! target has it. `core` offers none, and those of `libm` are calls, in software on most targets.

#[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
pub(super) use aarch64::{double, single};
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
pub(super) use {arm::single, libm::sqrt as double};
#[cfg(not(any(
    all(target_arch = "aarch64", target_feature = "neon"),
    all(target_arch = "arm", target_abi = "eabihf")
)))]
pub(super) use {libm::sqrt as double, libm::sqrtf as single};

/// Every ARM target with floating-point registers in its calling convention has the root of an
/// `f32`; that of an `f64` not all.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
mod arm {
    #[inline(always)]
    #[allow(unsafe_code, reason = "instructions")]
    pub(in crate::math) fn single(x: f32) -> f32 {
        let mut bits = x.to_bits();
        // In general registers: for others the compiler wants double precision, which a Cortex-M4
        // lacks. The callers need bits anyway.
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
}

#[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
mod aarch64 {
    #[inline(always)]
    #[allow(unsafe_code, reason = "one instruction")]
    pub(in crate::math) fn single(mut x: f32) -> f32 {
        // SAFETY: the instruction works on this register alone.
        unsafe {
            core::arch::asm!(
                "fsqrt {x:s}, {x:s}",
                x = inout(vreg) x,
                options(pure, nomem, nostack, preserves_flags),
            );
        }
        x
    }

    #[inline(always)]
    #[allow(unsafe_code, reason = "one instruction")]
    pub(in crate::math) fn double(mut x: f64) -> f64 {
        // SAFETY: the instruction works on this register alone.
        unsafe {
            core::arch::asm!(
                "fsqrt {x:d}, {x:d}",
                x = inout(vreg) x,
                options(pure, nomem, nostack, preserves_flags),
            );
        }
        x
    }
}
