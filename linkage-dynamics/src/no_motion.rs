//! Reasons why a conservative mechanism does not reach an input or a time.

use std::error::Error;
use std::fmt;

/// The reason why a conservative mechanism does not reach an input or a time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum NoMotion {
    /// The input is opposite to the motion.
    Behind {
        /// The wished input.
        input: f64,
    },
    /// The mechanism is at rest in an equilibrium.
    AtRest {
        /// The input of the start.
        input: f64,
    },
    /// The motion ends at an input: the energy is exhausted, or there is no position beyond.
    Ends {
        /// The last input.
        input: f64,
    },
    /// The time is negative or not finite.
    BadTime(f64),
}

impl fmt::Display for NoMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Behind { input } => {
                write!(
                    f,
                    "the motion does not lead to the input {input}\nhelp: it is behind the start"
                )
            }
            Self::AtRest { input } => write!(
                f,
                "the mechanism is in equilibrium at the input {input}\nhelp: give it a speed, or another start"
            ),
            Self::Ends { input } => write!(
                f,
                "the motion ends at the input {input}\nhelp: the energy is exhausted there, or the mechanism has no \
                 position beyond"
            ),
            Self::BadTime(time) => write!(f, "the time {time} s is negative or not finite"),
        }
    }
}

impl Error for NoMotion {}
