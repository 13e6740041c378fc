//! Why there is no cam.

use core::fmt;

use super::follower::Follower;
use super::undercut::Undercut;
use linkage_core::format::rounded;

/// Why a cam cannot be made.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CamError {
    /// A number that makes no sense.
    Invalid {
        /// Name of the number.
        what: &'static str,
        /// The number.
        value: f64,
        /// The range that is required.
        expected: &'static str,
    },
    /// The motion is NaN or infinite.
    NotFinite {
        /// The first such angle that was met.
        angle: f64,
    },
    /// The motion ends elsewhere than it began: the profile would have a step.
    Open {
        /// Its value at a turn less that at 0.
        gap: f64,
    },
    /// The profile cuts itself off: the follower could not reach the position of its motion.
    Undercut {
        /// The intervals, with the missing radius.
        undercut: Undercut,
        /// The follower of this cam.
        follower: Follower,
    },
}

impl fmt::Display for CamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Invalid {
                what,
                value,
                expected,
            } => {
                write!(
                    f,
                    "the {what} is {}, and must be {expected}",
                    rounded(*value)
                )
            }
            Self::NotFinite { angle } => write!(
                f,
                "the motion is no number at {} deg: give a value and three derivatives over the whole turn",
                rounded(angle.to_degrees())
            ),
            Self::Open { gap } => write!(
                f,
                "the motion ends a turn {} from where it began: a cam needs a motion that comes back",
                rounded(*gap)
            ),
            Self::Undercut { undercut, follower } => {
                let (at, radius, limit) =
                    (undercut.at.to_degrees(), undercut.radius, undercut.limit);
                write!(f, "the profile is undercut")?;
                for (index, interval) in undercut.intervals.iter().enumerate() {
                    let and = if index == 0 { "" } else { " and" };
                    let [from, to] = [interval.from, interval.to].map(|x| rounded(x.to_degrees()));
                    write!(f, "{and} from {from} deg to {to} deg")?;
                }
                f.write_str(": ")?;
                match follower {
                    Follower::Flat { base } => write!(
                        f,
                        "at {} deg its radius of curvature is {} where the face begins {} from the centre; begin more than {} from \
                         it, or take a slower motion",
                        rounded(at),
                        rounded(radius),
                        rounded(*base),
                        rounded(limit)
                    ),
                    Follower::Roller { radius: roller, .. }
                    | Follower::Swinging { radius: roller, .. } => write!(
                        f,
                        "at {} deg the pitch curve has a radius of {}, and the roller one of {}; take a roller of less than \
                         that, a larger cam or a slower motion",
                        rounded(at),
                        rounded(limit),
                        rounded(*roller)
                    ),
                }
            }
        }
    }
}

impl core::error::Error for CamError {}
