//! Functions of C that programs call: operations that C's library does not have, or not with these
//! results.
//!
//! Each mechanism has a copy of those that it needs, and nothing else. In `templates/helpers.c` the
//! function of an operation has the name of its row in `linkage-symbolic`.

use std::sync::OnceLock;

use linkage_export::{HelperLibrary, Helpers};

use crate::real::Real;
use crate::template::fill;

/// All helpers, in the order in which they are printed.
fn library() -> &'static HelperLibrary {
    static LIBRARY: OnceLock<HelperLibrary> = OnceLock::new();
    LIBRARY.get_or_init(|| HelperLibrary::new(include_str!("../templates/helpers.c"), "/* ", " */"))
}

/// Returns the name of a type of numbers among the helpers.
fn variant(real: Real) -> &'static str {
    match real {
        Real::Double => "double",
        Real::Fused => "fused",
        Real::Single => "single",
    }
}

/// Returns no helpers, for numbers of this type.
pub(crate) fn helpers(real: Real) -> Helpers<'static> {
    Helpers::new(library(), variant(real))
}

/// Returns all needed helpers as C.
pub(crate) fn helper_text(helpers: &Helpers, real: Real, private: &str) -> String {
    let word = |word: &str| (word == "DIRECTIONS").then(|| directions(real));
    let texts = helpers.texts().map(|text| fill(text, real, private, word));
    texts.collect::<Vec<_>>().join("\n")
}

/// The table of directions, as the rows of an array.
fn directions(real: Real) -> String {
    let rows = linkage_core::directions().iter().map(|row| {
        let row = row.map(|x| real.literal(x)).join(", ");
        format!("    {{ {row} }}")
    });
    rows.collect::<Vec<_>>().join(",\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn helpers_stand_after_those_that_they_call() {
        for real in [Real::Double, Real::Fused, Real::Single] {
            let mut before = Vec::new();
            for name in library().names(variant(real)) {
                before.push(name);
                let mut needed = helpers(real);
                needed.need(name);
                let all = library().names(variant(real));
                let called: Vec<&str> = all.filter(|other| needed.has(other)).collect();
                assert!(
                    called.iter().all(|other| before.contains(other)),
                    "{name}: {called:?}"
                );
            }
        }
    }
}
