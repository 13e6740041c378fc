//! Why a synthesis cannot be done.

use core::error::Error;
use core::fmt;
use linkage_design::DesignError;

/// Why a synthesis has no listing of its solutions.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Unsolved {
    /// A coordinate or an angle is NaN or infinite.
    NotFinite {
        /// Index of the condition.
        index: usize,
    },
    /// Two conditions are one: there is one condition less than dimensions, and infinitely many
    /// mechanisms meet them.
    Equal {
        /// Indices of the conditions.
        indices: [usize; 2],
    },
    /// The conditions depend on each other, so that infinitely many mechanisms meet them, or
    /// rounding decides how many.
    Dependent {
        /// The smallest singular value of their equations as a part of the largest one.
        rank: f64,
        /// Below which we take them for dependent.
        least: f64,
    },
    /// Too many points are on a circle, which then would be a part of the coupler curve: infinitely
    /// many four-bars pass them, or none.
    OnCircle {
        /// The number of points on it.
        count: usize,
        /// Its centre.
        centre: [f64; 2],
        /// Its radius.
        radius: f64,
        /// The largest distance of these points from it.
        off: f64,
    },
    /// Too many points are on a line, which then would be a part of the coupler curve, which has
    /// none.
    OnLine {
        /// The number of points on it.
        count: usize,
        /// The largest distance of these points from it.
        off: f64,
    },
    /// The result is at infinity, as the pole of poses that are only shifted against each other.
    AtInfinity,
    /// The receiver of the progress stopped the search.
    Stopped {
        /// Paths that had been followed.
        done: usize,
        /// All paths.
        count: usize,
    },
    /// Equations that are singular everywhere: they depend on each other, or not on all unknowns.
    Singular,
    /// More solutions than we follow.
    TooMany {
        /// The number that is followed.
        most: usize,
    },
    /// A part of a search that there is not.
    Part {
        /// The part, counted from 0.
        part: usize,
        /// The number of parts.
        of: usize,
    },
    /// Paths of other points.
    OtherProblem,
    /// The same paths twice.
    Repeated,
    /// Bytes that are no part of a search, or damaged.
    NoPart,
    /// Equations whose solutions cannot be listed.
    Unlisted(linkage_core::numeric::roots::Unlisted),
}

impl fmt::Display for Unsolved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { index } => {
                write!(f, "condition {index} has a number that is not finite")
            }
            Self::Equal { indices: [a, b] } => write!(
                f,
                "conditions {a} and {b} are equal, which leaves infinitely many mechanisms; ask for another \
                 one, or use fewer conditions and choose"
            ),
            Self::Dependent { rank, least } => write!(
                f,
                "the conditions depend on each other (smallest singular value {rank:.1e} of the largest, \
                 below our limit of {least:.0e}), which leaves infinitely many mechanisms; move one of them"
            ),
            Self::OnCircle {
                count,
                centre,
                radius,
                off,
            } => write!(
                f,
                "{count} points are on a circle about ({}, {}) with radius {} (off it by {off:.0e} at most); a \
                 coupler curve meets a circle in six points at most unless it contains the circle, so that infinitely \
                 many mechanisms meet these points, or none; use a crank of that radius about that centre, or move \
                 all but six points off the circle",
                rounded(centre[0], radius),
                rounded(centre[1], radius),
                rounded(radius, radius)
            ),
            Self::OnLine { count, off } => write!(
                f,
                "{count} points are on a line (off it by {off:.0e} at most); a coupler curve meets a line in six points \
                 at most, so that no four-bar meets these points exactly; use a slider, search an approximate line with \
                 `linkage::design`, or move all but six points off the line"
            ),
            Self::AtInfinity => f.write_str(
                "what is asked for is at infinity, as for poses that are only shifted against each other; turn \
                 a pose, or move the joint",
            ),
            Self::Stopped { done, count } => {
                write!(f, "stopped as asked, after {done} of {count} paths")
            }
            Self::Singular => f.write_str(
                "the equations are singular at random places: they depend on each other, or not on all \
                 unknowns; leave out what repeats others, and give what is free",
            ),
            Self::TooMany { most } => write!(
                f,
                "the equations have more than {most} solutions, complex ones counted; that is our limit: \
                 use fewer or simpler equations"
            ),
            Self::Part { part, of } => write!(f, "{}", DesignError::Part { part, of }),
            Self::OtherProblem => f.write_str(
                "these paths are of another problem: the points must be the same for all parts",
            ),
            Self::Repeated => f.write_str(
                "both parts have the same paths: each part of a search is merged once",
            ),
            Self::NoPart => write!(f, "{}", DesignError::NoPart),
            Self::Unlisted(unlisted) => write!(f, "{unlisted}"),
        }
    }
}

impl Error for Unsolved {}

/// A coordinate to a millionth of a length.
fn rounded(x: f64, length: f64) -> f64 {
    let digit = (length.abs().log10().floor() - 6.0) as i32;
    match digit < 0 {
        true => {
            let scale = 10_f64.powi(-digit);
            (x * scale).round() / scale + 0.0
        }
        false => {
            let unit = 10_f64.powi(digit);
            (x / unit).round() * unit + 0.0
        }
    }
}

/// All numbers are finite, no two conditions are equal.
pub(super) fn check<const K: usize>(conditions: &[[f64; K]]) -> Result<(), Unsolved> {
    for (index, condition) in conditions.iter().enumerate() {
        if condition.iter().any(|number| !number.is_finite()) {
            return Err(Unsolved::NotFinite { index });
        }
        let before = &conditions[..index];
        if let Some(equal) = before.iter().position(|other| other == condition) {
            let indices = [equal, index];
            return Err(Unsolved::Equal { indices });
        }
    }
    Ok(())
}
