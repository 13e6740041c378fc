//! Functions of C that programs call: operations that C's library does not have, or not with these
//! results.
//!
//! Each mechanism has a copy of those that it needs, and nothing else. In `templates/helpers.c` the
//! function of an operation has the name of its row in `linkage-symbolic`, a line `HELPER` begins
//! each function, and functions stand after those that they call.

use std::collections::BTreeSet;
use std::sync::OnceLock;

use crate::real::Real;
use crate::template::fill;

/// A function or a type of `templates/helpers.c`.
#[derive(Debug)]
struct Helper {
    /// All names that it defines, its own first.
    names: Vec<&'static str>,
    /// The type of numbers that it is for, if there is another one for the other type.
    real: Option<Real>,
    text: &'static str,
}

/// Begins the line above each function.
const MARK: &str = "/* HELPER ";

/// All helpers, in the order in which they are printed.
fn helpers() -> &'static [Helper] {
    static HELPERS: OnceLock<Vec<Helper>> = OnceLock::new();
    HELPERS.get_or_init(|| {
        let parts = include_str!("../templates/helpers.c").split(MARK).skip(1);
        parts.map(parsed).collect()
    })
}

/// Parses a helper: `name (double): other, names */`, where the type and the other names may be
/// left out, then its text.
fn parsed(part: &'static str) -> Helper {
    let (head, text) = part.split_once(" */\n").unwrap_or((part, ""));
    let words = head.split([' ', ',', ':']).filter(|word| !word.is_empty());
    let (kinds, names): (Vec<&str>, Vec<&str>) = words.partition(|word| word.starts_with('('));
    Helper {
        names,
        real: kinds.first().map(|kind| match *kind {
            "(single)" => Real::Single,
            _ => Real::Double,
        }),
        text,
    }
}

/// The helper that defines a name, by its index.
fn find(name: &str, real: Real) -> Option<usize> {
    helpers().iter().position(|helper| {
        helper.names.contains(&name) && helper.real.is_none_or(|other| other == real)
    })
}

/// The helpers that a mechanism needs.
#[derive(Clone, Debug)]
pub(crate) struct Helpers {
    real: Real,
    needed: BTreeSet<usize>,
}

impl Helpers {
    /// Returns no helpers, for numbers of this type.
    pub(crate) fn new(real: Real) -> Self {
        Self {
            real,
            needed: BTreeSet::new(),
        }
    }

    /// Adds the helper of this name, and those that it calls.
    pub(crate) fn need(&mut self, name: &str) {
        let Some(index) = find(name, self.real) else {
            unreachable!("`{name}` is not in templates/helpers.c");
        };
        if self.needed.insert(index) {
            let calls = helpers()[index].text.split("own_").skip(1);
            let names = calls.map(|rest| {
                let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
                &rest[..end.unwrap_or(rest.len())]
            });
            names.for_each(|name| self.need(name));
        }
    }

    /// Returns true if the helper of this name is needed.
    pub(crate) fn has(&self, name: &str) -> bool {
        find(name, self.real).is_some_and(|index| self.needed.contains(&index))
    }

    /// Returns all needed helpers as C.
    pub(crate) fn text(&self, private: &str) -> String {
        let needed = self.needed.iter().map(|&index| helpers()[index].text);
        let texts = needed.map(|text| fill(text, self.real, private, |_| None));
        texts.collect::<Vec<_>>().join("\n")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn helpers_stand_after_those_that_they_call() {
        for real in [Real::Double, Real::Single] {
            for (index, helper) in helpers().iter().enumerate() {
                if helper.real.is_some_and(|other| other != real) {
                    continue;
                }
                let mut needed = Helpers::new(real);
                needed.need(helper.names[0]);
                assert_eq!(needed.needed.last(), Some(&index), "{helper:?}");
            }
        }
    }
}
