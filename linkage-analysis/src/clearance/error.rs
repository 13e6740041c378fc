//! A reason why phases cannot be compared.

use crate::summary::SummaryError;
use core::fmt;
use linkage_core::format::rounded;

/// Why there is no best phase.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PhaseError {
    /// One of the members cannot be followed.
    Curve(SummaryError),
    /// The range is no cycle of a member.
    NoCycle {
        /// True for the second member.
        second: bool,
        /// The range of the shaft's angle.
        range: (f64, f64),
        /// The difference of a point, its first or its second derivative between both ends.
        off: f64,
    },
    /// A member cannot be assembled at some of the positions.
    Gap {
        /// True for the second member.
        second: bool,
        /// The first angle at which it is missing.
        at: f64,
        /// At how many positions.
        missing: usize,
    },
    /// The range of phases is empty, infinite, or more than a cycle.
    Phases {
        /// Its beginning.
        from: f64,
        /// Its end.
        to: f64,
    },
    /// No pair of members is given.
    NoPairs,
    /// A step is not positive and finite, or there is none in the range.
    Step {
        /// The step.
        step: f64,
        /// The range of phases.
        range: (f64, f64),
    },
}

impl fmt::Display for PhaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let which = |second: bool| if second { "second" } else { "first" };
        let degrees = |x: f64| rounded(x.to_degrees());
        match *self {
            Self::Curve(error) => error.fmt(f),
            Self::NoCycle {
                second,
                range: (from, to),
                off,
            } => write!(
                f,
                "the {} organ does not repeat itself from {} to {} deg: its points or their derivatives differ by {}\n\
                 help: give the range of a whole cycle",
                which(second),
                degrees(from),
                degrees(to),
                rounded(off)
            ),
            Self::Gap {
                second,
                at,
                missing,
            } => write!(
                f,
                "the {} organ cannot be assembled at {missing} of the positions, first at {} deg: a phase would turn the \
                 other organ past them",
                which(second),
                degrees(at)
            ),
            Self::NoPairs => f.write_str(
                "there are no organs to keep apart\nhelp: add pairs of organs with `pair`",
            ),
            Self::Phases { from, to } => write!(
                f,
                "the phases from {} to {} deg are none, infinite, or more than a cycle: give the lower one first",
                degrees(from),
                degrees(to)
            ),
            Self::Step {
                step,
                range: (from, to),
            } => write!(
                f,
                "no whole number of steps of {} deg lies from {} to {} deg",
                degrees(step),
                degrees(from),
                degrees(to)
            ),
        }
    }
}

impl core::error::Error for PhaseError {}

impl From<SummaryError> for PhaseError {
    fn from(error: SummaryError) -> Self {
        Self::Curve(error)
    }
}
