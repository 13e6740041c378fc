//! Names of constants and macros, which are in capitals.

use crate::c_names::plain;

/// The end of the macro that lets a file with finite mathematics include the header.
pub(crate) const FINITE_MATH: &str = "finite_math";

/// The end of the macro without which the check is compiled.
pub(crate) const OFF: &str = "without_range_check";

/// The end of the macro before each function of the header.
pub(crate) const API: &str = "api";

/// The end of the macro before each function and table of the source alone.
pub(crate) const LOCAL: &str = "local";

/// The ends of constants and macros that each mechanism has.
pub(super) const CONSTANTS_OF_ALL: [&str; 7] =
    ["ok", "defaults", "h", FINITE_MATH, OFF, API, LOCAL];

/// The name of a constant or a macro of the mechanism whose names begin with `prefix`.
pub(super) fn constant(prefix: &str, name: &str) -> String {
    format!("{prefix}_{}", plain(name)).to_uppercase()
}
