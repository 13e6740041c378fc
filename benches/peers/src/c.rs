//! The kernels in C (`kernels.c`, `space.c`), hand-derived, with the sine and cosine of the C library.

#![allow(unsafe_code, reason = "calls of C functions")]

/// A kernel: constants and inputs in, numbers out.
macro_rules! kernel {
    ($(#[$doc:meta])* $name:ident = $function:ident($($input:ident),*) -> $out:ty) => {
        $(#[$doc])*
        #[inline(always)]
        pub fn $name(&self, $($input: f64,)* out: &mut $out) {
            // SAFETY: the function reads `struct` at the first pointer and writes exactly the
            // numbers of the array at the last one.
            unsafe { $function(self, $($input,)* out.as_mut_ptr()) }
        }
    };
}

pub mod folded;
pub mod space;
pub mod sweep;

use crate::{Motion, Position, Sensitivities1, Sensitivities2};
use std::mem::MaybeUninit;

/// `struct k1`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct K1([f64; 13]);

/// `struct k2`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct K2([f64; 21]);

unsafe extern "C" {
    fn k1_prepare(k: *mut K1, a: f64, b: f64, c: f64, dx: f64, dy: f64, p: f64, u: f64);
    fn k1a(k: *const K1, phi: f64, out: *mut f64);
    fn k1b(k: *const K1, phi: f64, out: *mut f64);
    fn k1c(k: *const K1, phi: f64, out: *mut f64);
    #[rustfmt::skip]
    fn k2_prepare(
        k: *mut K2,
        p4x: f64,
        p4y: f64,
        p7x: f64,
        p7y: f64,
        l12: f64,
        l23: f64,
        l34: f64,
        l45: f64,
        l78: f64,
        l89: f64,
        l910: f64,
        angle_345: f64,
    );
    fn k2a(k: *const K2, phi: f64, out: *mut f64);
    fn k2b(k: *const K2, phi: f64, out: *mut f64);
    fn k2c(k: *const K2, phi: f64, out: *mut f64);
}

impl K1 {
    /// What depends on the dimensions alone, these in the order of the mechanism's parameters.
    #[must_use]
    pub fn new([a, b, c, dx, dy, p, u]: [f64; 7]) -> Self {
        let mut k = MaybeUninit::uninit();
        // SAFETY: the function writes every member of the struct.
        unsafe {
            k1_prepare(k.as_mut_ptr(), a, b, c, dx, dy, p, u);
            k.assume_init()
        }
    }

    kernel!(
        /// K1a.
        point = k1a(phi) -> Position
    );
    kernel!(
        /// K1b.
        motion = k1b(phi) -> Motion
    );
    kernel!(
        /// K1c.
        accuracy = k1c(phi) -> Sensitivities1
    );
}

impl K2 {
    /// What depends on the dimensions alone, these in the order of the mechanism's parameters.
    #[must_use]
    pub fn new(d: [f64; 12]) -> Self {
        let mut k = MaybeUninit::uninit();
        // SAFETY: the function writes every member of the struct.
        unsafe {
            k2_prepare(
                k.as_mut_ptr(),
                d[0],
                d[1],
                d[2],
                d[3],
                d[4],
                d[5],
                d[6],
                d[7],
                d[8],
                d[9],
                d[10],
                d[11],
            );
            k.assume_init()
        }
    }

    kernel!(
        /// K2a.
        point = k2a(phi) -> Position
    );
    kernel!(
        /// K2b.
        motion = k2b(phi) -> Motion
    );
    kernel!(
        /// K2c.
        accuracy = k2c(phi) -> Sensitivities2
    );
}
