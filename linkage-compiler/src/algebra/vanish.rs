//! Expressions that vanish wherever they are evaluated.

use linkage_symbolic::{Ex, numerically_equal_within};

/// The rest that rounding may leave of a product that is zero.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// True if an expression is zero wherever it is evaluated.
pub(crate) fn vanishes(x: Ex) -> bool {
    numerically_equal_within(x, x.number(0.0), ROUNDING)
}
