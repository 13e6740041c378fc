//! The results of `assemble`, and the texts for them.

use linkage_export::{Refusal, RefusalCause};

use super::constant::constant;
use crate::c_names::plain;

/// A number that `assemble` may return.
#[derive(Clone, Debug)]
pub(crate) struct Code {
    pub(crate) why: Why,
    /// The name of the constant.
    pub(crate) name: String,
    pub(crate) text: String,
}

/// The reason for which a mechanism is not assembled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Why {
    /// Its dimensions.
    Mechanism(RefusalCause),
    /// Numbers are not rounded to nearest.
    Rounding,
    /// Numbers have more or fewer digits than their type.
    Digits,
    /// Sums are computed in another order.
    Reordered,
}

impl From<RefusalCause> for Why {
    fn from(cause: RefusalCause) -> Self {
        Self::Mechanism(cause)
    }
}

impl Why {
    /// Returns true for findings of the test of the arithmetic.
    pub(crate) fn is_of_arithmetic(self) -> bool {
        OF_ARITHMETIC.iter().any(|(why, ..)| *why == self)
    }
}

/// The findings of the test of the arithmetic.
const OF_ARITHMETIC: [(Why, &str, &str); 3] = [
    (
        Why::Rounding,
        "rounding",
        "numbers are not rounded to nearest here: call fesetround(FE_TONEAREST) before assembling, and leave it so while functions are called",
    ),
    (
        Why::Digits,
        "digits",
        "numbers are computed with more or fewer digits than their type has: compile without -fsingle-precision-constant, for an x86 of 32 bits \
         with -msse2 -mfpmath=sse; where a double has 32 bits, export with --scalar float",
    ),
    (
        Why::Reordered,
        "reordered",
        "the compiler computes sums in another order, which makes positions wrong: compile without -funsafe-math-optimizations, \
         -fassociative-math and -ffast-math",
    ),
];

/// Returns all numbers that `assemble` of a mechanism may return, in their order.
pub(super) fn codes(prefix: &str, title: &str, refusals: &[Refusal]) -> Vec<Code> {
    let of_mechanism = refusals.iter().map(|refusal| {
        let why = Why::Mechanism(refusal.cause);
        (why, &refusal.name[..], &refusal.text[..])
    });
    let mut codes: Vec<Code> = Vec::new();
    for (why, name, text) in of_mechanism.chain(OF_ARITHMETIC) {
        let name = constant(prefix, &name.replace('.', "_"));
        let taken = codes.iter().any(|code| code.name == name);
        codes.push(Code {
            why,
            // Names that differ in the case of letters only.
            name: if taken {
                format!("{name}_{}", codes.len() + 1)
            } else {
                name
            },
            text: format!("{}: {text}", plain(title)),
        });
    }
    codes
}
