//! Names of constants and macros, which are in capitals.

use crate::c_names::plain;

/// The end of the macro that lets a file with finite mathematics include the header.
pub(crate) const FINITE_MATH: &str = "finite_math";

/// The end of the macro without which the check is compiled.
pub(crate) const OFF: &str = "without_range_check";

/// The ends of constants and macros that each mechanism has.
pub(super) const CONSTANTS_OF_ALL: [&str; 5] = ["ok", "defaults", "h", FINITE_MATH, OFF];

/// The name of a constant or a macro of the mechanism whose names begin with `prefix`.
pub(super) fn constant(prefix: &str, name: &str) -> String {
    format!("{prefix}_{}", plain(name)).to_uppercase()
}
