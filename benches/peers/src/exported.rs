//! The kernels in C, as `linkage-c` prints the mechanisms, with fused multiply-adds if the machine has them.

#![allow(unsafe_code, reason = "calls of C functions")]

use std::ffi::c_int;

/// What a function returns: a struct of doubles, as the call has written it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Numbers<const N: usize>(pub [f64; N]);

/// A mechanism as single calls and as sweeps: its dimensions in, structs for what is assembled, functions from inputs to
/// numbers. Sweeps are those of the doubles that `linkage-c` prints under another name.
macro_rules! exported {
    (
        $(#[$doc:meta])*
        $Name:ident($dimensions:literal) by $assemble:ident, $assemble_rows:ident:
        $($method:ident, $sweep:ident = $function:ident, $rows:ident($($input:ident),*) -> $width:literal;)*
    ) => {
        $(#[$doc])*
        #[derive(Clone, Debug)]
        pub struct $Name {
            single: Box<[f64; MOST]>,
            rows: Box<[f64; MOST]>,
        }

        unsafe extern "C" {
            fn $assemble(m: *mut f64, dimensions: *const f64) -> c_int;
            fn $assemble_rows(m: *mut f64, dimensions: *const f64) -> c_int;
            $(
                fn $function(m: *const f64, $($input: f64),*) -> Numbers<$width>;
                fn $rows(m: *const f64, count: usize, $($input: *const f64,)* rows: *mut f64);
            )*
        }

        impl $Name {
            /// What depends on the dimensions alone, these in the order of the mechanism's parameters.
            ///
            /// # Panics
            /// If the loops do not close.
            #[must_use]
            pub fn new(dimensions: [f64; $dimensions]) -> Self {
                let assembled = |assemble: unsafe extern "C" fn(*mut f64, *const f64) -> c_int| {
                    let mut m = Box::new([f64::NAN; MOST]);
                    // SAFETY: the function reads as many dimensions, and writes a struct of doubles that the build script found to have room.
                    let code = unsafe { assemble(m.as_mut_ptr(), dimensions.as_ptr()) };
                    assert_eq!(code, 0, "it is assembled");
                    m
                };
                Self {
                    single: assembled($assemble),
                    rows: assembled($assemble_rows),
                }
            }

            $(
                /// The function of this name.
                #[inline(always)]
                #[must_use]
                pub fn $method(&self, $($input: f64),*) -> Numbers<$width> {
                    // SAFETY: the function reads the struct and returns so many doubles.
                    unsafe { $function(self.single.as_ptr(), $($input),*) }
                }

                /// The sweep of this name, into rows.
                ///
                /// # Panics
                /// If an input has another number of positions.
                pub fn $sweep(&self, $($input: &[f64],)* rows: &mut [[f64; $width]]) {
                    $(assert_eq!($input.len(), rows.len());)*
                    let count = rows.len();
                    // SAFETY: the function reads the struct and the inputs, and writes a row for each.
                    unsafe {
                        $rows(self.rows.as_ptr(), count, $($input.as_ptr(),)* rows.as_mut_ptr().cast());
                    }
                }
            )*
        }
    };
}

/// See the build script.
const MOST: usize = 256;

exported! {
    /// K1, the crank-rocker.
    K1(7) by k1_assemble, k1_rows_assemble:
    point, point_sweep = k1_point, k1_rows_point_sweep(phi) -> 2;
    motion, motion_sweep = k1_motion, k1_rows_motion_sweep(phi) -> 6;
    accuracy, accuracy_sweep = k1_accuracy, k1_rows_accuracy_sweep(phi) -> 16;
}

exported! {
    /// K2, the hook needle.
    K2(12) by k2_assemble, k2_rows_assemble:
    point, point_sweep = k2_point, k2_rows_point_sweep(phi) -> 2;
    motion, motion_sweep = k2_motion, k2_rows_motion_sweep(phi) -> 6;
    accuracy, accuracy_sweep = k2_accuracy, k2_rows_accuracy_sweep(phi) -> 26;
}

exported! {
    /// K3, the RSSR.
    K3(8) by k3_assemble, k3_rows_assemble:
    point, point_sweep = k3_point, k3_rows_point_sweep(phi) -> 3;
    motion, motion_sweep = k3_motion, k3_rows_motion_sweep(phi) -> 11;
    accuracy, accuracy_sweep = k3_accuracy, k3_rows_accuracy_sweep(phi) -> 27;
}

exported! {
    /// K4, the delta robot.
    K4(4) by k4_assemble, k4_rows_assemble:
    point, point_sweep = k4_point, k4_rows_point_sweep(first, second, third) -> 3;
    motion, motion_sweep = k4_motion, k4_rows_motion_sweep(first, second, third) -> 12;
    curvature, curvature_sweep = k4_curvature, k4_rows_curvature_sweep(first, second, third) -> 39;
}
