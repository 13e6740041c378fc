//! Names of the check of the declared range.

use super::constant::{API, constant};
use super::declared::Declared;

/// The kinds of findings, in the order of their numbers from 1 on.
pub(crate) const KINDS: [&str; 4] = ["CHANGE_POINT", "DEAD_POINT", "GAP", "UNDEFINED"];

/// The names that users see.
#[derive(Debug)]
pub(crate) struct RangeNames {
    pub(crate) check_range: Declared,
    pub(crate) finding: String,
}

impl RangeNames {
    /// The names of the function and of the type of its findings.
    pub(super) fn new(prefix: &str, check_range: &str, finding: &str) -> Self {
        let parameters = format!("const {prefix} *m, {finding} *findings, int room");
        Self {
            check_range: Declared::new(&constant(prefix, API), "int", check_range, &parameters),
            finding: finding.to_owned(),
        }
    }

    /// All of them, with the kinds of findings.
    pub(super) fn all(&self, prefix: &str) -> Vec<String> {
        let kinds = KINDS.iter().map(|kind| kind_constant(prefix, kind));
        let functions = [self.check_range.name.clone(), self.finding.clone()];
        functions.into_iter().chain(kinds).collect()
    }
}

/// The name of the constant of a kind of finding.
pub(super) fn kind_constant(prefix: &str, kind: &str) -> String {
    constant(prefix, &format!("range_{kind}"))
}
