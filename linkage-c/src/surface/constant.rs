//! Names of constants and macros, which are in capitals.

use crate::c_names::plain;

/// The name of a constant or a macro of the mechanism whose names begin with `prefix`.
pub(super) fn constant(prefix: &str, name: &str) -> String {
    format!("{prefix}_{}", plain(name)).to_uppercase()
}
