//! Elementary functions of plain numbers, from the standard library or from `libm`: the only
//! place that knows which.

#[cfg(not(feature = "std"))]
mod root;

macro_rules! functions {
    ($module:ident, $float:ty, $root:path, $tan:ident, $asin:ident, $acos:ident,
     $atan:ident) => {
        pub mod $module {
            functions!(@one $float, sqrt, $root);
            functions!(@one $float, tan, libm::$tan);
            functions!(@one $float, asin, libm::$asin);
            functions!(@one $float, acos, libm::$acos);
            functions!(@one $float, atan, libm::$atan);
        }
    };
    (@one $float:ty, $name:ident, $without:path) => {
        #[inline(always)]
        pub fn $name(x: $float) -> $float {
            #[cfg(feature = "std")]
            return x.$name();
            #[cfg(not(feature = "std"))]
            return $without(x);
        }
    };
}

/// Cube root.
#[inline(always)]
pub fn cube_root(x: f64) -> f64 {
    #[cfg(feature = "std")]
    return x.cbrt();
    #[cfg(not(feature = "std"))]
    return libm::cbrt(x);
}

functions!(double, f64, super::root::double, tan, asin, acos, atan);
functions!(single, f32, super::root::single, tanf, asinf, acosf, atanf);
