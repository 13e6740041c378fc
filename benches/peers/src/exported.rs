//! The kernels in C, as `linkage-c` prints the mechanisms, with fused multiply-adds if the machine has them.

#![allow(unsafe_code, reason = "calls of C functions")]

use std::ffi::c_int;

/// What a function returns: a struct of doubles, as the call has written it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Numbers<const N: usize>(pub [f64; N]);

/// A mechanism: its dimensions in, a struct for what is assembled, functions from inputs to numbers.
macro_rules! exported {
    (
        $(#[$doc:meta])*
        $Name:ident($dimensions:literal) by $assemble:ident:
        $($method:ident = $function:ident($($input:ident),*) -> $width:literal;)*
    ) => {
        $(#[$doc])*
        #[derive(Clone, Debug)]
        pub struct $Name(Box<[f64; MOST]>);

        unsafe extern "C" {
            fn $assemble(m: *mut f64, dimensions: *const f64) -> c_int;
            $(fn $function(m: *const f64, $($input: f64),*) -> Numbers<$width>;)*
        }

        impl $Name {
            /// What depends on the dimensions alone, these in the order of the mechanism's parameters.
            ///
            /// # Panics
            /// If the loops do not close.
            #[must_use]
            pub fn new(dimensions: [f64; $dimensions]) -> Self {
                let mut m = Box::new([f64::NAN; MOST]);
                // SAFETY: the function reads as many dimensions, and writes a struct of doubles that the build script found to have room.
                let code = unsafe { $assemble(m.as_mut_ptr(), dimensions.as_ptr()) };
                assert_eq!(code, 0, "it is assembled");
                Self(m)
            }

            $(
                /// The function of this name.
                #[inline(always)]
                #[must_use]
                pub fn $method(&self, $($input: f64),*) -> Numbers<$width> {
                    // SAFETY: the function reads the struct and returns so many doubles.
                    unsafe { $function(self.0.as_ptr(), $($input),*) }
                }
            )*
        }
    };
}

/// See the build script.
const MOST: usize = 256;

exported! {
    /// K1, the crank-rocker.
    K1(7) by k1_assemble:
    point = k1_point(phi) -> 2;
    motion = k1_motion(phi) -> 6;
    accuracy = k1_accuracy(phi) -> 16;
}

exported! {
    /// K2, the hook needle.
    K2(12) by k2_assemble:
    point = k2_point(phi) -> 2;
    motion = k2_motion(phi) -> 6;
    accuracy = k2_accuracy(phi) -> 26;
}

exported! {
    /// K3, the RSSR.
    K3(8) by k3_assemble:
    point = k3_point(phi) -> 3;
    motion = k3_motion(phi) -> 11;
    accuracy = k3_accuracy(phi) -> 27;
}

exported! {
    /// K4, the delta robot.
    K4(4) by k4_assemble:
    point = k4_point(first, second, third) -> 3;
    motion = k4_motion(first, second, third) -> 12;
    curvature = k4_curvature(first, second, third) -> 39;
}

/// Sweeps of a mechanism, as `linkage-c` prints it in doubles.
macro_rules! rows {
    (
        $(#[$doc:meta])*
        $Name:ident($dimensions:literal) by $assemble:ident:
        $($method:ident = $function:ident($($input:ident),*) -> $width:literal;)*
    ) => {
        $(#[$doc])*
        #[derive(Clone, Debug)]
        pub struct $Name(Box<[f64; MOST]>);

        unsafe extern "C" {
            fn $assemble(m: *mut f64, dimensions: *const f64) -> c_int;
            $(fn $function(m: *const f64, count: usize, $($input: *const f64,)* rows: *mut f64);)*
        }

        impl $Name {
            /// What depends on the dimensions alone, these in the order of the mechanism's parameters.
            ///
            /// # Panics
            /// If the loops do not close.
            #[must_use]
            pub fn new(dimensions: [f64; $dimensions]) -> Self {
                let mut m = Box::new([f64::NAN; MOST]);
                // SAFETY: as for single calls.
                let code = unsafe { $assemble(m.as_mut_ptr(), dimensions.as_ptr()) };
                assert_eq!(code, 0, "it is assembled");
                Self(m)
            }

            $(
                /// The sweep of this name, into rows.
                ///
                /// # Panics
                /// If an input has another number of positions.
                pub fn $method(&self, $($input: &[f64],)* rows: &mut [[f64; $width]]) {
                    $(assert_eq!($input.len(), rows.len());)*
                    let count = rows.len();
                    // SAFETY: the function reads the struct and the inputs, and writes a row for each.
                    unsafe {
                        $function(self.0.as_ptr(), count, $($input.as_ptr(),)* rows.as_mut_ptr().cast());
                    }
                }
            )*
        }
    };
}

rows! {
    /// Sweeps of K1.
    K1Rows(7) by k1_rows_assemble:
    point = k1_rows_point_sweep(phi) -> 2;
    motion = k1_rows_motion_sweep(phi) -> 6;
    accuracy = k1_rows_accuracy_sweep(phi) -> 16;
}

rows! {
    /// Sweeps of K2.
    K2Rows(12) by k2_rows_assemble:
    point = k2_rows_point_sweep(phi) -> 2;
    motion = k2_rows_motion_sweep(phi) -> 6;
    accuracy = k2_rows_accuracy_sweep(phi) -> 26;
}

rows! {
    /// Sweeps of K3.
    K3Rows(8) by k3_rows_assemble:
    point = k3_rows_point_sweep(phi) -> 3;
    motion = k3_rows_motion_sweep(phi) -> 11;
    accuracy = k3_rows_accuracy_sweep(phi) -> 27;
}

rows! {
    /// Sweeps of K4.
    K4Rows(4) by k4_rows_assemble:
    point = k4_rows_point_sweep(first, second, third) -> 3;
    motion = k4_rows_motion_sweep(first, second, third) -> 12;
    curvature = k4_rows_curvature_sweep(first, second, third) -> 39;
}
