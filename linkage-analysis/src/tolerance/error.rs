//! Errors in the numbers of an analysis.

use alloc::vec::Vec;
use core::fmt;

use linkage_core::format::{join, rounded};

/// Why a tolerance analysis cannot be made.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ToleranceError {
    /// A list has not as many entries as there are sensitivities.
    Count {
        /// Name of the list.
        what: &'static str,
        /// The required number.
        expected: usize,
        /// The given number.
        found: usize,
    },
    /// A tolerance is negative, infinite or NaN.
    Invalid {
        /// The parameter.
        name: &'static str,
        /// Its tolerance.
        tolerance: f64,
    },
    /// Limits of a dimension that are not in order, infinite or NaN.
    Limits {
        /// The parameter.
        name: &'static str,
        /// The lower limit.
        lower: f64,
        /// The upper limit.
        upper: f64,
    },
    /// A standard uncertainty that is negative, infinite or NaN.
    Uncertainty {
        /// The parameter.
        name: &'static str,
        /// Its standard uncertainty.
        standard: f64,
    },
    /// Degrees of freedom that are not at least 1.
    DegreesOfFreedom {
        /// The parameter.
        name: &'static str,
        /// Its degrees of freedom.
        degrees: f64,
    },
    /// A correlation of a parameter with itself, or one that is not between -1 and 1.
    Correlation {
        /// The parameters.
        names: [&'static str; 2],
        /// The coefficient.
        coefficient: f64,
    },
    /// A matrix of covariances that is not symmetric.
    NotSymmetric {
        /// The parameters.
        names: [&'static str; 2],
        /// The covariance on one side and on the other.
        found: [f64; 2],
    },
    /// Correlations that no quantities have together.
    Contradiction {
        /// The first parameter whose correlations contradict those of the parameters before it.
        name: &'static str,
        /// The part of its variance that these leave to it, which is negative; or by how much a
        /// correlation is off that follows from them, if they leave nothing.
        left: f64,
    },
    /// A dimension that is correlated and whose distribution is not normal.
    NotNormal {
        /// The parameter.
        name: &'static str,
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
        /// The number of parameters.
        count: usize,
    },
    /// There is nothing to analyse: no position, no sample, an empty or infinite range.
    Nothing {
        /// Name of the empty list.
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
    /// A measured deviation that is not finite.
    Measurement {
        /// Index of the parameter.
        index: usize,
        /// The measurement, counted from 0.
        number: usize,
        /// The deviation.
        deviation: f64,
    },
    /// A part of a study that is not there.
    NoSuchPart {
        /// The part, counted from 0.
        part: u64,
        /// The number of parts.
        of: u64,
    },
    /// Results of two studies that are not parts of one.
    OtherStudy,
    /// Results of the same mechanisms twice.
    Repeated,
    /// Bytes that are no results of a study, or not all of them.
    NoResults,
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
            Self::Limits { name, lower, upper } => write!(
                f,
                "the limits of {name} are {lower} and {upper}: they must be finite, the lower one first"
            ),
            Self::Uncertainty { name, standard } => write!(
                f,
                "the standard uncertainty of {name} is {standard}: it must be finite and not negative"
            ),
            Self::DegreesOfFreedom { name, degrees } => write!(
                f,
                "{name} has {degrees} degrees of freedom: one at least, or infinity"
            ),
            Self::Correlation {
                names: [a, b],
                coefficient,
            } if a == b => write!(f, "a correlation of {a} with itself, {coefficient}"),
            Self::Correlation {
                names: [a, b],
                coefficient,
            } => write!(
                f,
                "the correlation of {a} and {b} is {coefficient}: it must be between -1 and 1"
            ),
            Self::NotSymmetric {
                names: [a, b],
                found: [ab, ba],
            } => write!(
                f,
                "the covariance of {a} and {b} is {ab}, that of {b} and {a} is {ba}"
            ),
            Self::Contradiction { name, left } => write!(
                f,
                "the correlations of {name} contradict those of the parameters before it: they leave {} of its \
                 variance, and no variance is negative",
                rounded(*left)
            ),
            Self::NotNormal { name } => write!(
                f,
                "{name} is correlated and not normally distributed: its joint distribution is not known. Random \
                 sampling of correlated dimensions is for normal ones, which is our limit"
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
                "the figure is NaN at every position: the mechanism cannot be assembled there, or stands at a dead point or a change point",
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
            Self::Measurement {
                index,
                number,
                deviation,
            } => write!(
                f,
                "measurement {number} of parameter {index} deviates by {deviation}: it must be finite"
            ),
            Self::NoSuchPart { part, of } => write!(
                f,
                "there is no part {part} of {of}: parts are counted from 0, and there is one at least"
            ),
            Self::OtherStudy => f.write_str(
                "these results are of another study: seed, number, dimensions, tolerances, distributions and what \
                 is evaluated must be the same for all parts",
            ),
            Self::Repeated => f.write_str(
                "both results have the same mechanisms: each part of a study is merged once",
            ),
            Self::NoResults => f.write_str(
                "these bytes are no results of a study, or not all of them: they are what `Stream::to_bytes` wrote",
            ),
        }
    }
}

impl core::error::Error for ToleranceError {}
