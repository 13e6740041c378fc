//! The criteria and the words of the check of a range: one place for the compiler, which checks the
//! default dimensions, and for assembled mechanisms, which check others.

mod checked;
mod message;
mod numbers;

pub use checked::{Driven, Unchecked, checked};

pub use message::{
    Comes, PASSES_HELP, Reaches, joints_or_loops, listed, loop_list, not_finite, passes,
    with_apostrophes,
};
pub use numbers::{
    length_as_written, position_as_written, rounded_inwards, rounded_to, significant,
};

/// Samples for each turn of an input angle, or for a whole range of lengths. A search for dips
/// covers the gaps between two of them.
pub const SAMPLES: f64 = 180.0;

/// A slack this small inside a range is a dead point: beyond it the mechanism may run on in its
/// mirror image, even where the slack only touches zero (a parallelogram stretched out). The search
/// takes -1e-12 for rounding.
pub const DEAD: f64 = 2e-12;

/// The share of a range at its ends where a dead point is allowed: a range may end at one.
pub const END: f64 = 1e-9;

/// A slack that is negative by less is 0, apart from rounding.
pub const ROUNDING: f64 = 1e-12;

/// The distance, in radians, at which [`DEAD`] is reached where a slack touches zero as a square
/// does: the limit of resolution.
pub const FOUND: f64 = 2e-6;

/// A dead point that is nearer to an end of its range than this share of it is at the end.
pub const AT_END: f64 = 1e-6;

/// Smallest number of samples of a range of an angle.
pub const LEAST_SAMPLES: f64 = 64.0;
/// Largest number of samples of a range of an angle.
pub const MOST_SAMPLES: f64 = 4000.0;

/// The number of samples of a stretch of an input.
#[must_use]
pub fn samples(length: f64, angle: bool) -> usize {
    let samples = match angle {
        true => (SAMPLES * length / core::f64::consts::TAU).clamp(LEAST_SAMPLES, MOST_SAMPLES),
        false => SAMPLES,
    };
    samples as usize
}

/// The kind of slack of a group: positive where the group can be assembled, zero at a dead point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slack {
    /// A number of about 1, of a group with two assemblies.
    Number,
    /// To be compared with its largest value, of a group with two assemblies.
    Relative,
    /// To be compared with its largest value. It changes its sign at a dead point of a group with
    /// one assembly.
    Signed,
    /// No slack: the prepared states of the group end before a dead point.
    Prepared,
}
