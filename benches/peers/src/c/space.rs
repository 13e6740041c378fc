//! The kernels in space (`space.c`).

use std::mem::MaybeUninit;

/// `struct k3`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct K3([f64; 28]);

/// `struct k4`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct K4([f64; 3]);

unsafe extern "C" {
    #[rustfmt::skip]
    fn k3_prepare(k: *mut K3, a: f64, l: f64, r: f64, px: f64, py: f64, pz: f64, t: f64, z: f64);
    fn k3a(k: *const K3, phi: f64, out: *mut f64);
    fn k3b(k: *const K3, phi: f64, out: *mut f64);
    fn k3c(k: *const K3, phi: f64, out: *mut f64);
    fn k4_prepare(k: *mut K4, base: f64, arm: f64, forearm: f64, platform: f64);
    fn k4a(k: *const K4, phi1: f64, phi2: f64, phi3: f64, out: *mut f64);
    fn k4b(k: *const K4, phi1: f64, phi2: f64, phi3: f64, out: *mut f64);
    fn k4c(k: *const K4, phi1: f64, phi2: f64, phi3: f64, out: *mut f64);
}

impl K3 {
    /// What depends on the dimensions alone, these in the order of the mechanism's parameters.
    #[must_use]
    pub fn new([a, l, r, px, py, pz, t, z]: [f64; 8]) -> Self {
        let mut k = MaybeUninit::uninit();
        // SAFETY: the function writes every member of the struct.
        unsafe {
            k3_prepare(k.as_mut_ptr(), a, l, r, px, py, pz, t, z);
            k.assume_init()
        }
    }

    kernel!(
        /// K3a.
        point = k3a(phi) -> [f64; 3]
    );
    kernel!(
        /// K3b.
        motion = k3b(phi) -> [f64; 11]
    );
    kernel!(
        /// K3c.
        accuracy = k3c(phi) -> [f64; 27]
    );
}

impl K4 {
    /// What depends on the dimensions alone, these in the order of the mechanism's parameters.
    #[must_use]
    pub fn new([base, arm, forearm, platform]: [f64; 4]) -> Self {
        let mut k = MaybeUninit::uninit();
        // SAFETY: the function writes every member of the struct.
        unsafe {
            k4_prepare(k.as_mut_ptr(), base, arm, forearm, platform);
            k.assume_init()
        }
    }

    kernel!(
        /// K4a.
        point = k4a(first, second, third) -> [f64; 3]
    );
    kernel!(
        /// K4b.
        motion = k4b(first, second, third) -> [f64; 12]
    );
    kernel!(
        /// K4c.
        curvature = k4c(first, second, third) -> [f64; 39]
    );
}
