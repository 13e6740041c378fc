//! The kernels in C for the default dimensions, which are folded into constants, and for the machine that compiles them (`folded.c`):
//! the fastest that C can do for one position.

#![allow(unsafe_code, reason = "calls of C functions")]

use crate::{Motion, Position, Sensitivities1, Sensitivities2};

macro_rules! folded {
    ($($(#[$doc:meta])* $type:ident { $($name:ident = $library:ident $own:ident($($input:ident),*) -> $out:ty;)* })*) => {
        unsafe extern "C" {
            $($(
                fn $library($($input: f64,)* out: *mut f64);
                fn $own($($input: f64,)* out: *mut f64);
            )*)*
        }

        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug)]
            pub struct $type<const OWN_SINE: bool>;

            impl<const OWN_SINE: bool> $type<OWN_SINE> {
                $(
                    /// One position, by the project's sine or by that of the C library.
                    #[inline(always)]
                    pub fn $name(&self, $($input: f64,)* out: &mut $out) {
                        let function = if OWN_SINE { $own } else { $library };
                        // SAFETY: the function writes exactly the numbers of the array.
                        unsafe { function($($input,)* out.as_mut_ptr()) }
                    }
                )*
            }
        )*
    };
}

folded! {
    /// The crank-rocker.
    K1 {
        point = k1a_library k1a_own(phi) -> Position;
        motion = k1b_library k1b_own(phi) -> Motion;
        accuracy = k1c_library k1c_own(phi) -> Sensitivities1;
    }
    /// The hook needle.
    K2 {
        point = k2a_library k2a_own(phi) -> Position;
        motion = k2b_library k2b_own(phi) -> Motion;
        accuracy = k2c_library k2c_own(phi) -> Sensitivities2;
    }
    /// RSSR.
    K3 {
        point = k3a_library k3a_own(phi) -> [f64; 3];
        motion = k3b_library k3b_own(phi) -> [f64; 11];
        accuracy = k3c_library k3c_own(phi) -> [f64; 27];
    }
    /// The delta robot.
    K4 {
        point = k4a_library k4a_own(first, second, third) -> [f64; 3];
        motion = k4b_library k4b_own(first, second, third) -> [f64; 12];
        curvature = k4c_library k4c_own(first, second, third) -> [f64; 39];
    }
}
