//! What is wrong with the numbers of an analysis.

use alloc::vec::Vec;
use core::fmt;

use crate::words::{join, rounded};

/// Why a tolerance analysis cannot be made.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ToleranceError {
    /// A list has not as many entries as there are sensitivities.
    Count {
        /// What is listed.
        what: &'static str,
        /// How many there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A tolerance is negative, infinite or NaN.
    Invalid {
        /// The parameter.
        name: &'static str,
        /// Its tolerance.
        tolerance: f64,
    },
    /// Parameters without a tolerance where all must have one.
    Missing {
        /// Their names.
        names: Vec<&'static str>,
    },
    /// An index beyond the parameters.
    NoSuchParameter {
        /// The index.
        index: usize,
        /// How many parameters there are.
        count: usize,
    },
    /// There is nothing to analyse: no position, no sample, an empty or infinite range.
    Nothing {
        /// What is empty.
        what: &'static str,
    },
    /// The figure is NaN at all positions: the mechanism cannot be assembled there.
    NotAssembled,
    /// The sensitivities of a position are not finite.
    NotFinite {
        /// The position, counted from 0.
        position: usize,
        /// The first parameter with such a sensitivity, counted from 0.
        parameter: usize,
    },
    /// The allowed error is not positive and finite.
    Limit {
        /// The allowed error.
        limit: f64,
    },
    /// A parameter has no effect at any position, so that nothing limits its tolerance.
    NoEffect {
        /// The parameter.
        name: &'static str,
    },
    /// The rule needs a size in mm for each parameter; an angle or a number has none by itself.
    NoSize {
        /// The parameter.
        name: &'static str,
    },
    /// A size for which ISO 286 has no standard tolerances.
    SizeOutOfRange {
        /// The parameter.
        name: &'static str,
        /// The size in mm.
        size: f64,
    },
    /// Even the finest standard grade exceeds the allowed error.
    NoGrade {
        /// The error that the finest grade gives.
        finest: f64,
        /// The allowed error.
        limit: f64,
    },
    /// A cost or an exponent is not positive and finite.
    Cost {
        /// The parameter.
        name: &'static str,
        /// The cost at tolerance 1.
        cost: f64,
        /// The exponent.
        exponent: f64,
    },
}

impl fmt::Display for ToleranceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count {
                what,
                expected,
                found,
            } => {
                write!(f, "{found} {what} for {expected} parameters")
            }
            Self::Invalid { name, tolerance } => write!(
                f,
                "the tolerance of {name} is {tolerance}: it must be finite and not negative"
            ),
            Self::Missing { names } => write!(f, "no tolerance is given for {}", join(names, ", ")),
            Self::NoSuchParameter { index, count } => {
                write!(
                    f,
                    "there is no parameter {index}: there are {count}, counted from 0"
                )
            }
            Self::Nothing { what } => write!(f, "nothing to analyse: {what}"),
            Self::NotAssembled => f.write_str(
                "the figure is NaN at every position: the mechanism cannot be assembled there",
            ),
            Self::NotFinite {
                position,
                parameter,
            } => write!(
                f,
                "position {position}: the sensitivity to parameter {parameter} is not finite: the \
                 mechanism cannot be assembled there or stands at a dead point"
            ),
            Self::Limit { limit } => write!(
                f,
                "the allowed error is {limit}: it must be positive and finite"
            ),
            Self::NoEffect { name } => write!(
                f,
                "{name} has no effect at any position, so that nothing limits its tolerance: leave \
                 it out of the list of sensitivities"
            ),
            Self::NoSize { name } => write!(
                f,
                "{name} is no length: say with Sizes::lever at which length it acts"
            ),
            Self::SizeOutOfRange { name, size } => write!(
                f,
                "{name}: ISO 286 has standard tolerances up to 3150 mm, not for {} mm",
                rounded(*size)
            ),
            Self::NoGrade { finest, limit } => write!(
                f,
                "no standard grade keeps the error within {}: the finest gives {}",
                rounded(*limit),
                rounded(*finest)
            ),
            Self::Cost {
                name,
                cost,
                exponent,
            } => write!(
                f,
                "the cost of {name} is {cost} / t^{exponent}: both numbers must be positive and finite"
            ),
        }
    }
}

impl core::error::Error for ToleranceError {}
