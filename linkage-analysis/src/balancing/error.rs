//! Errors of the numbers of a balance.

use core::fmt;

/// Why masses cannot be found.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BalanceError {
    /// There is nothing to balance.
    Nothing {
        /// The missing part.
        what: &'static str,
    },
    /// There are not as many rows of effects as forces.
    Count {
        /// The quantity, counted from 0: the forces, then the added ones.
        group: usize,
        /// The number of forces.
        forces: usize,
        /// The number of rows of effects.
        effects: usize,
    },
    /// A force or an effect is NaN or infinite.
    NotFinite {
        /// The quantity, counted from 0: the forces, then the added ones.
        group: usize,
        /// The position, counted from 0.
        position: usize,
        /// The mass with such an effect, counted from 0; `None` if it is the force.
        effect: Option<usize>,
    },
    /// The length that a quantity is divided by is not positive and finite.
    Length {
        /// The length.
        length: f64,
    },
    /// A mass has no effect at any position.
    NoEffect {
        /// The mass, counted from 0.
        effect: usize,
    },
    /// A mass has the effects of some combination of those before it, so that there are many
    /// solutions.
    Dependent {
        /// The mass, counted from 0.
        effect: usize,
    },
    /// The numbers are so large or so small that a result is beyond the range of floating point
    /// numbers.
    OutOfRange,
    /// A number that no counterweight can be made of.
    Counterweight {
        /// The name of the quantity.
        what: &'static str,
        /// The number.
        value: f64,
        /// The condition for the value.
        expected: &'static str,
    },
}

impl fmt::Display for BalanceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nothing { what } => write!(f, "nothing to balance: {what}"),
            Self::Count {
                group,
                forces,
                effects,
            } => {
                write!(f, "{effects} rows of effects for {forces} forces")?;
                write_group(f, *group)
            }
            Self::NotFinite {
                group,
                position,
                effect,
            } => {
                write!(f, "position {position}")?;
                write_group(f, *group)?;
                match effect {
                    Some(effect) => write!(f, ": the effect of mass {effect} is not finite")?,
                    None => f.write_str(": the force is not finite")?,
                }
                f.write_str(": the mechanism cannot be assembled there or stands at a dead point")
            }
            Self::Length { length } => write!(
                f,
                "the length that moments are divided by is {length}: it must be positive and finite"
            ),
            Self::NoEffect { effect } => write!(
                f,
                "mass {effect} has no effect at any position: leave it out"
            ),
            Self::Dependent { effect } => write!(
                f,
                "the effects of mass {effect} are a combination of those of the masses before it: \
                 leave one of them out"
            ),
            Self::OutOfRange => {
                f.write_str("the numbers are too large or too small to compute with")
            }
            Self::Counterweight {
                what,
                value,
                expected,
            } => write!(f, "{what} is {value}: it must be {expected}"),
        }
    }
}

/// ` of quantity 1`; the first one is the only one as a rule, and is not named.
fn write_group(f: &mut fmt::Formatter<'_>, group: usize) -> fmt::Result {
    match group {
        0 => Ok(()),
        _ => write!(f, " of quantity {group}"),
    }
}

impl core::error::Error for BalanceError {}
