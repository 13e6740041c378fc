//! Product and sum with one rounding or two.

/// Returns whether `FUSED` code rounds once: `core` alone has no fused multiply-add.
pub(super) const fn one_rounding<const FUSED: bool>() -> bool {
    FUSED && cfg!(feature = "std")
}

macro_rules! mul_add {
    ($name:ident, $float:ident) => {
        /// `a * b + c`, with one rounding if `FUSED` and the standard library is there.
        #[inline(always)]
        pub(crate) fn $name<const FUSED: bool>(a: $float, b: $float, c: $float) -> $float {
            #[cfg(feature = "std")]
            if one_rounding::<FUSED>() {
                return a.mul_add(b, c);
            }
            a * b + c
        }
    };
}

mul_add!(double, f64);
mul_add!(single, f32);
