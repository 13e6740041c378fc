//! Scopes: the parts of a mechanism that are analysed.

use crate::model::Mechanism;

/// Derived quantities, loops and unknowns, by their numbers: all of them, or those that a function
/// is made of. An unknown comes with the loops that determine it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Scope {
    pub(crate) lets: Vec<bool>,
    pub(crate) loops: Vec<bool>,
    pub(crate) unknowns: Vec<bool>,
}

impl Scope {
    pub(crate) fn all(mechanism: &Mechanism) -> Self {
        Self::each(mechanism, true)
    }

    pub(crate) fn nothing(mechanism: &Mechanism) -> Self {
        Self::each(mechanism, false)
    }

    fn each(mechanism: &Mechanism, is_in: bool) -> Self {
        Self {
            lets: vec![is_in; mechanism.lets.len()],
            loops: vec![is_in; mechanism.loops.len()],
            unknowns: vec![is_in; mechanism.unknowns.len()],
        }
    }
}
