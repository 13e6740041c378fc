//! The kernels as sweeps (`sweeps.c`), which a C compiler makes vector code of: what can be reached by
//! hand.

#![allow(unsafe_code, reason = "calls of C functions")]

use super::space::{K3, K4};
use super::{K1, K2};

/// Positions are computed in blocks of so many.
pub const LANES: usize = 8;

/// Columns of a sweep.
#[derive(Clone, Debug)]
pub struct Columns {
    data: Vec<f64>,
    width: usize,
    len: usize,
    distance: usize,
}

impl Columns {
    /// `width` columns for `len` positions, a multiple of [`LANES`].
    ///
    /// # Panics
    /// If it is not one.
    #[must_use]
    pub fn new(width: usize, len: usize) -> Self {
        assert!(len.is_multiple_of(LANES), "{len} positions");
        // An odd number of cache lines, lest columns compete for the same place in the cache.
        let distance = len / LANES * LANES
            + if (len / LANES).is_multiple_of(2) {
                LANES
            } else {
                0
            };
        Self {
            data: vec![f64::NAN; width * distance],
            width,
            len,
            distance,
        }
    }

    /// One number.
    #[must_use]
    pub fn get(&self, row: usize, column: usize) -> f64 {
        self.data[column * self.distance..][..self.len][row]
    }
}

/// Whether the machine has what the sweeps are compiled for: without it they are loops over single
/// calls.
#[must_use]
pub fn instruction_set() -> Option<&'static str> {
    #[cfg(vector_sweeps)]
    {
        use std::arch::is_x86_feature_detected as has;
        let more = has!("avx512f") && has!("avx512bw") && has!("avx512dq");
        if more && has!("avx512vl") && has!("avx512cd") {
            return Some("AVX-512");
        }
        if has!("avx2") && has!("fma") && has!("bmi1") && has!("bmi2") {
            return Some("AVX2");
        }
    }
    None
}

macro_rules! sweeps {
    ($($kernel:ident $sweep:ident $single:ident($phi:ident $(, $more:ident)*) $v3:ident $v4:ident $width:literal;)*) => {
        #[cfg(vector_sweeps)]
        unsafe extern "C" {
            $(
                fn $v3(
                    k: *const $kernel,
                    $phi: *const f64,
                    $($more: *const f64,)*
                    n: usize,
                    columns: *mut f64,
                    distance: usize,
                );
                fn $v4(
                    k: *const $kernel,
                    $phi: *const f64,
                    $($more: *const f64,)*
                    n: usize,
                    columns: *mut f64,
                    distance: usize,
                );
            )*
        }

        $(
            impl $kernel {
                /// The sweep.
                ///
                /// # Panics
                /// If the columns are not for these positions.
                pub fn $sweep(&self, $phi: &[f64], $($more: &[f64],)* columns: &mut Columns) {
                    assert_eq!([columns.width, columns.len], [$width, $phi.len()]);
                    $(assert_eq!($more.len(), $phi.len());)*
                    #[cfg(vector_sweeps)]
                    {
                        let n = $phi.len();
                        let ($phi, $($more,)*) = ($phi.as_ptr(), $($more.as_ptr(),)*);
                        let (to, distance) = (columns.data.as_mut_ptr(), columns.distance);
                        // SAFETY: the machine has the instructions; the function reads `n` numbers
                        // of each input, whole blocks of them, and writes as many to each of the columns, which
                        // are there.
                        match instruction_set() {
                            Some("AVX-512") => return unsafe { $v4(self, $phi, $($more,)* n, to, distance) },
                            Some(_) => return unsafe { $v3(self, $phi, $($more,)* n, to, distance) },
                            None => {}
                        }
                    }
                    let mut row = [0.0; $width];
                    for index in 0..columns.len {
                        self.$single($phi[index], $($more[index],)* &mut row);
                        let cells = columns.data[index..].iter_mut().step_by(columns.distance);
                        cells.zip(row).for_each(|(cell, x)| *cell = x);
                    }
                }
            }
        )*
    };
}

sweeps! {
    K1 point_sweep point(phi) k1a_sweep_v3 k1a_sweep_v4 2;
    K1 motion_sweep motion(phi) k1b_sweep_v3 k1b_sweep_v4 6;
    K1 accuracy_sweep accuracy(phi) k1c_sweep_v3 k1c_sweep_v4 16;
    K2 point_sweep point(phi) k2a_sweep_v3 k2a_sweep_v4 2;
    K2 motion_sweep motion(phi) k2b_sweep_v3 k2b_sweep_v4 6;
    K2 accuracy_sweep accuracy(phi) k2c_sweep_v3 k2c_sweep_v4 26;
    K3 point_sweep point(phi) k3a_sweep_v3 k3a_sweep_v4 3;
    K3 motion_sweep motion(phi) k3b_sweep_v3 k3b_sweep_v4 11;
    K3 accuracy_sweep accuracy(phi) k3c_sweep_v3 k3c_sweep_v4 27;
    K4 point_sweep point(x, y, z) k4a_sweep_v3 k4a_sweep_v4 3;
    K4 motion_sweep motion(x, y, z) k4b_sweep_v3 k4b_sweep_v4 12;
    K4 curvature_sweep curvature(x, y, z) k4c_sweep_v3 k4c_sweep_v4 39;
}
