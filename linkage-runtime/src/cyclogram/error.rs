//! What keeps an organ from having a cyclogram.

use super::Band;
use crate::words::rounded;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

/// Why there is no cyclogram: for one organ all that is wrong with it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CyclogramError {
    /// The range is no cycle of the organ: after it the quantity or a derivative is not what it was before.
    NoCycle {
        /// The organ.
        organ: String,
        /// The range of the shaft's angle.
        range: (f64, f64),
        /// The quantity at both ends.
        values: [f64; 2],
    },
    /// The organ is not assembled over the whole cycle.
    Gap {
        /// The organ.
        organ: String,
        /// Where it is assembled.
        parts: Vec<(f64, f64)>,
    },
    /// Its bands do not fit its motion.
    Bands {
        /// The organ.
        organ: String,
        /// The unit of the quantity; empty if it was not said.
        unit: String,
        /// The lowest and the highest position.
        limits: [f64; 2],
        /// What is wrong, band by band.
        mistakes: Vec<BandMistake>,
    },
    /// Two organs have not the same range of the shaft's angle.
    Ranges {
        /// The organs.
        organs: [String; 2],
        /// Their ranges.
        ranges: [(f64, f64); 2],
    },
    /// The tolerances are those of another number of parameters than the sensitivities.
    Parameters {
        /// The organ.
        organ: String,
        /// How many tolerances there are.
        tolerances: usize,
        /// How many parameters the sensitivities are by; `None` if there are none.
        sensitivities: Option<usize>,
    },
}

/// What is wrong with a band.
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
        /// By how much.
        by: f64,
    },
}

impl fmt::Display for CyclogramError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let degrees = |(from, to): (f64, f64)| [from, to].map(|x| rounded(x.to_degrees()));
        match self {
            Self::NoCycle {
                organ,
                range,
                values: [first, last],
            } => {
                let ([from, to], [first, last]) =
                    (degrees(*range), [first, last].map(|x| rounded(*x)));
                write!(
                    f,
                    "`{organ}` does not repeat itself from {from} to {to} deg: there it is {first} and {last}, or a \
                     derivative differs\nhelp: give the range of a whole cycle, one or several turns"
                )
            }
            Self::Gap { organ, parts } => {
                write!(
                    f,
                    "`{organ}` cannot be assembled over the whole cycle, only"
                )?;
                for (index, part) in parts.iter().enumerate() {
                    let [from, to] = degrees(*part);
                    let and = if index == 0 { "" } else { " and" };
                    write!(f, "{and} from {from} to {to} deg")?;
                }
                Ok(())
            }
            Self::Bands {
                organ,
                unit,
                limits,
                mistakes,
            } => {
                for (index, mistake) in mistakes.iter().enumerate() {
                    let line = if index == 0 { "" } else { "\n" };
                    write!(f, "{line}`{organ}`: ")?;
                    mistake.print(f, unit, *limits)?;
                }
                Ok(())
            }
            Self::Ranges { organs, ranges } => {
                let [a, b] = organs;
                let [[from, to], [other_from, other_to]] = ranges.map(degrees);
                write!(
                    f,
                    "`{a}` has a cycle from {from} to {to} deg, `{b}` one from {other_from} to {other_to} deg\n\
                     help: follow all organs over the same range of the main shaft's angle"
                )
            }
            Self::Parameters {
                organ,
                tolerances,
                sensitivities: Some(parameters),
            } => write!(
                f,
                "`{organ}` has sensitivities to {parameters} parameters, and there are {tolerances} tolerances"
            ),
            Self::Parameters { organ, .. } => write!(
                f,
                "`{organ}` has no sensitivities that tolerances could be multiplied by\nhelp: call `sensitivities` first"
            ),
        }
    }
}

impl BandMistake {
    fn print(self, f: &mut fmt::Formatter<'_>, unit: &str, limits: [f64; 2]) -> fmt::Result {
        let [lowest, highest] = limits.map(rounded);
        let unit = crate::words::printed(|f| match unit {
            "" => Ok(()),
            unit => write!(f, " {unit}"),
        });
        match self {
            Self::Width { band } => {
                write!(f, "the band {band}{unit} has no positive width")
            }
            Self::Unreached { band } => write!(
                f,
                "nothing reaches the band {band}{unit}: the motion is from {lowest} to {highest}{unit}"
            ),
            Self::Whole { band } => write!(
                f,
                "the whole motion, from {lowest} to {highest}{unit}, is in the band {band}{unit}: there is nothing but a dwell"
            ),
            Self::Overlap { bands: [a, b], by } => {
                let by = rounded(by);
                write!(
                    f,
                    "the bands {a}{unit} and {b}{unit} overlap by {by}{unit}: the motion is from {lowest} to {highest}{unit}"
                )
            }
        }
    }
}

impl core::error::Error for CyclogramError {}
