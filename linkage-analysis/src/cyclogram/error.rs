//! A reason why a member has no cyclogram.

use super::Band;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;
use linkage_core::format::rounded;

/// A cause why there is no cyclogram: for one member all its mistakes.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CyclogramError {
    /// The range is no cycle of the member: the quantity or a derivative differs at its ends.
    NoCycle {
        /// The member.
        member: String,
        /// The range of the shaft's angle.
        range: (f64, f64),
        /// The quantity at both ends.
        values: [f64; 2],
    },
    /// The member is not assembled over the whole cycle.
    Gap {
        /// The member.
        member: String,
        /// The assembled parts.
        parts: Vec<(f64, f64)>,
    },
    /// It rests over the whole cycle.
    Still {
        /// The member.
        member: String,
        /// The angle.
        value: f64,
    },
    /// Its bands do not fit its motion.
    Bands {
        /// The member.
        member: String,
        /// The lowest and the highest position.
        limits: [f64; 2],
        /// The mistakes of the bands.
        mistakes: Vec<BandMistake>,
    },
    /// Two members have not the same range of the shaft's angle.
    Ranges {
        /// The members.
        members: [String; 2],
        /// Their ranges.
        ranges: [(f64, f64); 2],
    },
    /// The tolerances are those of another number of parameters than the sensitivities.
    Parameters {
        /// The member.
        member: String,
        /// The number of tolerances.
        tolerances: usize,
        /// The number of parameters of the sensitivities; `None` if there are none.
        sensitivities: Option<usize>,
    },
}

/// A mistake of a band.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BandMistake {
    /// Its width is not positive and finite.
    Width {
        /// The band.
        band: Band,
    },
    /// The motion does not reach it.
    Unreached {
        /// The band.
        band: Band,
    },
    /// The whole motion is in it.
    Whole {
        /// The band.
        band: Band,
    },
    /// Two bands overlap.
    Overlap {
        /// The bands.
        bands: [Band; 2],
        /// The difference.
        by: f64,
    },
}

impl fmt::Display for CyclogramError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let degrees = |(from, to): (f64, f64)| [from, to].map(|x| rounded(x.to_degrees()));
        match self {
            Self::NoCycle {
                member,
                range,
                values: [first, last],
            } => {
                let ([from, to], [first, last]) =
                    (degrees(*range), [first, last].map(|x| rounded(*x)));
                write!(
                    f,
                    "`{member}` does not repeat itself from {from} to {to} deg: there it is {first} and {last}, or a \
                     derivative differs\nhelp: give the range of a whole cycle, one or several turns"
                )
            }
            Self::Gap { member, parts } => {
                write!(
                    f,
                    "`{member}` cannot be assembled over the whole cycle, only"
                )?;
                for (index, part) in parts.iter().enumerate() {
                    let [from, to] = degrees(*part);
                    let and = if index == 0 { "" } else { " and" };
                    write!(f, "{and} from {from} to {to} deg")?;
                }
                Ok(())
            }
            Self::Still { member, value } => write!(
                f,
                "`{member}` stands still at {} over the whole cycle",
                rounded(*value)
            ),
            Self::Bands {
                member,
                limits,
                mistakes,
            } => {
                for (index, mistake) in mistakes.iter().enumerate() {
                    let line = if index == 0 { "" } else { "\n" };
                    write!(f, "{line}`{member}`: ")?;
                    mistake.print(f, *limits)?;
                }
                Ok(())
            }
            Self::Ranges { members, ranges } => {
                let [a, b] = members;
                let [[from, to], [other_from, other_to]] = ranges.map(degrees);
                write!(
                    f,
                    "`{a}` has a cycle from {from} to {to} deg, `{b}` one from {other_from} to {other_to} deg\n\
                     help: follow all organs over the same range of the main shaft's angle"
                )
            }
            Self::Parameters {
                member,
                tolerances,
                sensitivities: Some(parameters),
            } => write!(
                f,
                "`{member}` has sensitivities to {parameters} parameters, and there are {tolerances} tolerances"
            ),
            Self::Parameters { member, .. } => write!(
                f,
                "`{member}` has no sensitivities that tolerances could be multiplied by\nhelp: call `sensitivities` first"
            ),
        }
    }
}

impl BandMistake {
    fn print(self, f: &mut fmt::Formatter<'_>, limits: [f64; 2]) -> fmt::Result {
        let [lowest, highest] = limits.map(rounded);
        match self {
            Self::Width { band } => {
                write!(f, "the band {band} has no positive width")
            }
            Self::Unreached { band } => write!(
                f,
                "nothing reaches the band {band}: the motion is from {lowest} to {highest}"
            ),
            Self::Whole { band } => write!(
                f,
                "the whole motion, from {lowest} to {highest}, is in the band {band}: there is nothing but a dwell"
            ),
            Self::Overlap { bands: [a, b], by } => {
                let by = rounded(by);
                write!(
                    f,
                    "the bands {a} and {b} overlap by {by}: the motion is from {lowest} to {highest}"
                )
            }
        }
    }
}

impl core::error::Error for CyclogramError {}
