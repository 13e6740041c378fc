//! Errors of the preprocessor in files that include the header, and in the source; what compilers may
//! take from the source.

use linkage_export::Declarations;

use crate::real::Real;
use crate::surface::{FINITE_MATH, Surface};

/// Finite mathematics, by the macros of GCC and clang, of its older versions, of Microsoft's
/// compiler.
const IS_FINITE: &str = "defined __FAST_MATH__ || (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__) || defined _M_FP_FAST";

/// The checks of the header, which also hold for the files of its users.
pub(crate) fn of_header(surface: &Surface) -> String {
    let Surface {
        declarations: Declarations { name: prefix, .. },
        real,
        ok,
        constants,
        ..
    } = surface;
    let waiver = surface.constant(FINITE_MATH);
    let finite = format!(
        "#if ({IS_FINITE}) && !defined {waiver}\n\
         #error \"-ffast-math and -ffinite-math-only drop tests for NaN, which says that a position does not exist. Compile without them, or test \
         results by {}() alone and define {waiver} before this header.\"\n#endif\n",
        ok.name
    );
    let (type_digits, digits) = match real {
        Real::Double | Real::Fused => ("DBL_MANT_DIG", 53),
        Real::Single => ("FLT_MANT_DIG", 24),
    };
    let number = real.name();
    let advice = match real {
        Real::Double | Real::Fused => {
            "This file needs 53, and a double has fewer on AVR, for one: write it by linkage c --scalar float."
        }
        Real::Single => "This file needs 24.",
    };
    let exact = match real {
        // A number of 25 digits.
        Real::Double | Real::Fused => format!(
            "#else\n/* A constant that a float does not hold. */\n\
             typedef char {constants}[(long)16777217.0 == 16777217L ? 1 : -1];\n"
        ),
        Real::Single => String::new(),
    };
    format!(
        "{finite}#if FLT_RADIX != 2 || {type_digits} != {digits}\n\
         #error \"{prefix}: a {number} has another number of binary digits here. {advice}\"\n{exact}#endif\n\n"
    )
}

/// The checks of the source.
pub(crate) fn of_source(real: Real) -> String {
    let format = match real {
        Real::Double | Real::Fused => {
            "#if defined FLT_EVAL_METHOD && (FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2)\n\
             #error \"Doubles must not be computed with more digits than they have: for an x86 of 32 bits, say -msse2 -mfpmath=sse.\"\n#endif\n"
        }
        Real::Single => {
            "#if defined FLT_EVAL_METHOD && FLT_EVAL_METHOD == 1\n\
             #error \"Floats must not be computed as doubles: for s390x, say -fexcess-precision=fast or -std=gnu99.\"\n\
             #elif defined FLT_EVAL_METHOD && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16 && FLT_EVAL_METHOD != 32\n\
             #error \"Floats must not be computed with more digits than they have: for an x86 of 32 bits, say -msse2 -mfpmath=sse.\"\n#endif\n"
        }
    };
    let fused = match real {
        Real::Fused => {
            "#if !(defined __FP_FAST_FMA || defined __FMA__ || defined __ARM_FEATURE_FMA)\n\
             #error \"The sines of this file need fused multiply-adds: compile for a processor that has them, as by -mfma, or export with --scalar double.\"\n#endif\n"
        }
        Real::Double | Real::Single => "",
    };
    format!(
        "#if {IS_FINITE}\n\
         #error \"NaN says that a position does not exist, and -ffast-math and -ffinite-math-only take it that there is none. Compile this file without them; only files that include its header may have them.\"\n#endif\n\
         #ifdef __ASSOCIATIVE_MATH__\n\
         #error \"Sums must be computed in their order: compile without -funsafe-math-optimizations and -fassociative-math.\"\n#endif\n\
         {fused}{format}\n"
    )
}

/// Lines that let compilers compute several rows of a sweep at once, without a flag for it. A root
/// sets no error number, and the functions that a sweep calls are a part of it.
pub(crate) fn of_rows(surface: &Surface) -> String {
    let Surface {
        declarations: Declarations { private, .. },
        real,
        ..
    } = surface;
    let number = real.name();
    let root = match real {
        Real::Double | Real::Fused => "sqrt",
        Real::Single => "sqrtf",
    };
    format!(
        "#if defined __GNUC__ && !defined __cplusplus\n\
         /* A root sets no error number, so that it is one instruction, and rows of a sweep are computed together. */\n\
         #pragma GCC diagnostic push\n#pragma GCC diagnostic ignored \"-Wredundant-decls\"\n\
         extern {number} ({root})({number}) __attribute__((const));\n\
         #pragma GCC diagnostic pop\n#endif\n\
         #if defined __GNUC__ && defined __OPTIMIZE__ && !defined __OPTIMIZE_SIZE__\n\
         #define {private}rows __attribute__((flatten))\n\
         #else\n#define {private}rows\n#endif\n\n"
    )
}
