//! Elementary functions of plain numbers, from the standard library or from `libm`: the only
//! place that knows which.

macro_rules! functions {
    ($module:ident, $float:ty, $sqrt:ident, $sincos:ident, $tan:ident, $asin:ident, $acos:ident,
     $atan:ident, $atan2:ident) => {
        pub(crate) mod $module {
            functions!(@one $float, sqrt, $sqrt);
            functions!(@one $float, tan, $tan);
            functions!(@one $float, asin, $asin);
            functions!(@one $float, acos, $acos);
            functions!(@one $float, atan, $atan);

            #[inline(always)]
            pub(crate) fn sin_cos(x: $float) -> ($float, $float) {
                #[cfg(feature = "std")]
                return x.sin_cos();
                #[cfg(not(feature = "std"))]
                return libm::$sincos(x);
            }

            #[inline(always)]
            pub(crate) fn atan2(y: $float, x: $float) -> $float {
                #[cfg(feature = "std")]
                return y.atan2(x);
                #[cfg(not(feature = "std"))]
                return libm::$atan2(y, x);
            }
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

functions!(double, f64, sqrt, sincos, tan, asin, acos, atan, atan2);
functions!(
    single, f32, sqrtf, sincosf, tanf, asinf, acosf, atanf, atan2f
);
