//! Elementary functions of plain numbers, from the standard library or from `libm`: the only
//! place that knows which.

macro_rules! functions {
    ($module:ident, $float:ty, $sqrt:ident, $tan:ident, $asin:ident, $acos:ident,
     $atan:ident) => {
        pub(crate) mod $module {
            functions!(@one $float, sqrt, $sqrt);
            functions!(@one $float, tan, $tan);
            functions!(@one $float, asin, $asin);
            functions!(@one $float, acos, $acos);
            functions!(@one $float, atan, $atan);
        }
    };
    (@one $float:ty, $name:ident, $libm:ident) => {
        #[inline(always)]
        pub(crate) fn $name(x: $float) -> $float {
            #[cfg(feature = "std")]
            return x.$name();
            #[cfg(not(feature = "std"))]
            return libm::$libm(x);
        }
    };
}

/// Cube root.
#[inline(always)]
pub(crate) fn cube_root(x: f64) -> f64 {
    #[cfg(feature = "std")]
    return x.cbrt();
    #[cfg(not(feature = "std"))]
    return libm::cbrt(x);
}

functions!(double, f64, sqrt, tan, asin, acos, atan);
functions!(single, f32, sqrtf, tanf, asinf, acosf, atanf);
