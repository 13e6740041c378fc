//! Planar mechanisms, compiled from their loop equations to specialised machine code.
//!
//! [`mechanism!`] reads a mechanism (dimensions, inputs, unknowns, loops) and the quantities that are
//! wanted of it, and gives back a struct of dimensions, its assembled form, and one function for each
//! set of quantities.
//!
//! # Features
//!
//! | feature | gives |
//! |---|---|
//! | `std` (default) | elementary functions and allocation from the standard library |
//! | `libm` | elementary functions without the standard library; `std` takes precedence |
//! | `alloc` | sweeps and lists of assemblies without the standard library |
//! | `simba` | `Lanes`: SIMD types of simba as scalars |
//! | `num-dual` | `Dual`: dual numbers of num-dual as scalars; needs `std` |
#![no_std]

#[cfg(feature = "alloc")]
pub use linkage_runtime::Columns;
#[cfg(feature = "num-dual")]
pub use linkage_runtime::Dual;
#[cfg(any(feature = "std", feature = "libm"))]
pub use linkage_runtime::Float;
#[cfg(all(feature = "simba", any(feature = "std", feature = "libm")))]
pub use linkage_runtime::Lanes;
pub use linkage_runtime::{
    AssemblyError, AssemblyMode, FunctionInfo, Group, Operations, Parameter, Scalar, Structure,
    Vector2, Vector3, true_acceleration, true_velocity,
};

/// Compiles a planar mechanism.
///
/// The first block holds the dimensions, inputs, unknowns and loops of the mechanism and becomes a
/// struct; the second one lists functions by the quantities that they give, and they come out on
/// the assembled linkage.
#[macro_export]
macro_rules! mechanism {
    ($($tokens:tt)*) => {
        $crate::__private::mechanism! { [$crate] $($tokens)* }
    };
}

/// What generated code names.
#[doc(hidden)]
pub mod __private {
    pub use linkage_macros::mechanism;
    #[cfg(feature = "alloc")]
    pub use linkage_runtime::Columns;
    pub use linkage_runtime::generated::close;
    #[cfg(any(feature = "std", feature = "libm"))]
    pub use linkage_runtime::generated::{Along, Angle, Turns, turns, wind};
    #[cfg(feature = "alloc")]
    pub use linkage_runtime::generated::{Kernel, Vec, assemblies, fill};
    pub use linkage_runtime::{
        AssemblyError, AssemblyMode, FunctionInfo, Group, Operations, Parameter, Scalar, Structure,
        Vector2, Vector3, if_alloc,
    };
}
