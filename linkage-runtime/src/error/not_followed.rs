//! Why a follower stays where it is.

use super::place;
use crate::Group;
use crate::words::rounded;
use core::fmt;

/// Why a follower of an assembly did not reach the inputs that it was to go to. It stays where it was.
///
/// ```
/// use linkage_runtime::NotFollowed;
///
/// let error = NotFollowed {
///     mechanism: "Hexapod",
///     group: 0,
///     kind: "9 loops in space",
///     loops: &[1, 2, 3],
///     unknowns: &["p", "x", "y"],
///     share: 0.25,
/// };
/// assert_eq!(
///     error.to_string(),
///     "Hexapod: loops 1, 2 and 3 (p, x, y; 9 loops in space) cannot be followed beyond 25 % of the straight way to these inputs: \
///      a dead point is there, or so near that no step is certain to stay on the assembly"
/// );
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotFollowed {
    /// Name of the mechanism.
    pub mechanism: &'static str,
    /// Index of the group in `STRUCTURE` that cannot be followed any further.
    pub group: usize,
    /// Its kind, such as `RR-RR-RR`.
    pub kind: &'static str,
    /// Its loops, the first loop of the mechanism being 1.
    pub loops: &'static [usize],
    /// Its unknowns.
    pub unknowns: &'static [&'static str],
    /// How far the way goes: 0 where the follower stands, 1 at the inputs that it was to go to.
    pub share: f64,
}

impl NotFollowed {
    /// What is known of a group and its way.
    #[doc(hidden)]
    #[must_use]
    pub fn new(mechanism: &'static str, group: usize, own: &'static Group, share: f64) -> Self {
        Self {
            mechanism,
            group,
            kind: own.kind,
            loops: own.loops,
            unknowns: own.unknowns,
            share,
        }
    }
}

impl fmt::Display for NotFollowed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            mechanism,
            group,
            kind,
            loops,
            unknowns,
            share,
        } = *self;
        write!(f, "{mechanism}: ")?;
        place(f, group, kind, loops, unknowns)?;
        let share = rounded(100.0 * share);
        write!(
            f,
            " cannot be followed beyond {share} % of the straight way to these inputs: a dead point is there, or so near that no step \
             is certain to stay on the assembly"
        )
    }
}

impl core::error::Error for NotFollowed {}
