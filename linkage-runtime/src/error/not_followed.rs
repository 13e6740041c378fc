//! Why a follower stays where it is.

use super::group::GroupRef;
use crate::structure::Group;
use core::fmt;
use linkage_core::format::rounded;

/// Why a follower of an assembly did not reach the inputs that it was to go to. It stays where it
/// was.
///
/// ```
/// use linkage_runtime::{GroupRef, Halt, NotFollowed};
///
/// let error = NotFollowed {
///     group: GroupRef {
///         mechanism: "Hexapod",
///         index: 0,
///         kind: "9 loops in space",
///         loops: &[1, 2, 3],
///         joints: "",
///         unknowns: &["p", "x", "y"],
///     },
///     share: 0.25,
///     why: Halt::DeadPoint,
/// };
/// assert_eq!(
///     error.to_string(),
///     "Hexapod: loops 1, 2 and 3 (p, x, y; 9 loops in space) cannot be followed beyond 25 % of \
///      the straight way to these inputs: \
///      a dead point is there"
/// );
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotFollowed {
    /// The group that cannot be followed any further.
    pub group: GroupRef,
    /// The possible part of the path: 0 at the position of the follower, 1 at the wanted inputs.
    pub share: f64,
    /// The reason for its end.
    pub why: Halt,
}

/// The reason for the end of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Halt {
    /// A dead point is there: the determinant of the loops is less than a hundredth of its value at
    /// the beginning of the path.
    DeadPoint,
    /// No step is certain to stay on the assembly: a dead point is near, but not much nearer than
    /// where the way began, or another assembly; or the equations are eliminated in an order,
    /// chosen at the reference, in which a pivot becomes too small here, which is a limit of
    /// linkage.
    Uncertain,
    /// There is no correction: an input is no number, or a pivot of that order is zero.
    NoNumber,
}

impl NotFollowed {
    /// Builds the error of a group that cannot be followed any further.
    #[doc(hidden)]
    #[must_use]
    pub fn new(
        mechanism: &'static str,
        index: usize,
        group: &'static Group,
        share: f64,
        why: Halt,
    ) -> Self {
        Self {
            group: GroupRef::new(mechanism, index, group),
            share,
            why,
        }
    }
}

impl fmt::Display for NotFollowed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { group, share, why } = *self;
        let share = rounded(100.0 * share);
        write!(
            f,
            "{group} cannot be followed beyond {share} % of the straight way to these inputs: {why}"
        )
    }
}

/// Continues a sentence about the end of a path.
impl fmt::Display for Halt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::DeadPoint => "a dead point is there",
            Self::Uncertain => {
                "no step from there is certain to stay on the assembly, as beside a dead point or another assembly, or where a pivot of the \
                 elimination becomes small, whose order is chosen at the reference: that is a limit of linkage"
            }
            Self::NoNumber => {
                "there is no correction from there, as where an input is no number, or where a pivot of the elimination is zero, whose order is \
                 chosen at the reference: that is a limit of linkage"
            }
        })
    }
}

impl core::error::Error for NotFollowed {}
