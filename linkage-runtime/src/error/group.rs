//! A group as errors name it.

use crate::structure::Group;
use core::fmt;
use linkage_core::format::{join, numbers, printed};

/// A group of a mechanism, as errors name it.
///
/// Printed, it is `CrankRocker: loop 1 (theta, psi; RRR)`; a group without loops is named by its
/// number, and a group of joints and links by these.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GroupRef {
    /// Name of the mechanism.
    pub mechanism: &'static str,
    /// Index of the group in `STRUCTURE`.
    pub index: usize,
    /// Its kind, such as `RRR`.
    pub kind: &'static str,
    /// Its loops, the first loop of the mechanism being 1.
    pub loops: &'static [usize],
    /// The joints and links that its loops stand for, empty for loops as they are written.
    pub joints: &'static str,
    /// Its unknowns.
    pub unknowns: &'static [&'static str],
}

impl GroupRef {
    /// The group with this index in the structure of a mechanism.
    pub(crate) fn new(mechanism: &'static str, index: usize, group: &'static Group) -> Self {
        Self {
            mechanism,
            index,
            kind: group.kind,
            loops: group.loops,
            joints: group.joints,
            unknowns: group.unknowns,
        }
    }
}

impl GroupRef {
    /// The group without its mechanism: `loop 1 (theta, psi; RRR)`.
    pub(crate) fn alone(&self) -> impl fmt::Display {
        let group = *self;
        printed(move |f| group.write_alone(f))
    }

    fn write_alone(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            mechanism: _,
            index,
            kind,
            loops,
            joints,
            unknowns,
        } = self;
        match (*joints, loops) {
            ("", []) => write!(f, "group {}", index + 1)?,
            ("", [only]) => write!(f, "loop {only}")?,
            ("", [first @ .., last]) => write!(f, "loops {} and {last}", numbers(first, ", "))?,
            (joints, _) => f.write_str(joints)?,
        }
        let separator = if unknowns.is_empty() || kind.is_empty() {
            ""
        } else {
            "; "
        };
        match (unknowns, *kind) {
            ([], "") => Ok(()),
            _ => write!(f, " ({}{separator}{kind})", join(unknowns, ", ")),
        }
    }
}

impl fmt::Display for GroupRef {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.mechanism, self.alone())
    }
}
