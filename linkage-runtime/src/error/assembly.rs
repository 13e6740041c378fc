//! Why `assemble()` found no assembly.

use super::group::GroupRef;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
use super::unprepared::CoupledCause;
#[cfg(feature = "alloc")]
use super::unprepared::CoupledError;
#[cfg(feature = "alloc")]
use alloc::boxed::Box;
use core::fmt;
use linkage_core::format::rounded;

/// Squares of larger numbers overflow.
pub(crate) const LARGEST: f64 = 1e154;

/// Why `assemble()` found no assembly.
///
/// ```
/// use linkage_runtime::{AssemblyError, GroupRef};
///
/// let error = AssemblyError::CannotClose {
///     group: GroupRef {
///         mechanism: "CrankRocker",
///         index: 0,
///         kind: "RRR",
///         loops: &[1],
///         joints: "",
///         unknowns: &["theta", "psi"],
///     },
///     miss: 12.5,
///     unit: "mm",
/// };
/// assert_eq!(
///     error.to_string(),
///     "CrankRocker: loop 1 (theta, psi; RRR) cannot close at the reference input: \
///      it misses by 12.5 mm"
/// );
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum AssemblyError {
    /// The links of a group do not reach each other at the reference input.
    CannotClose {
        /// The group.
        group: GroupRef,
        /// The amount by which it misses.
        miss: f64,
        /// Unit of `miss`; empty for a number.
        unit: &'static str,
    },
    /// A dimension is NaN or infinite.
    NotFinite {
        /// Name of the mechanism.
        mechanism: &'static str,
        /// Name of the dimension.
        dimension: &'static str,
        /// Its value.
        value: f64,
    },
    /// A dimension is so large that a result is beyond the largest number.
    Overflow {
        /// Name of the mechanism.
        mechanism: &'static str,
        /// Name of the largest dimension.
        dimension: &'static str,
        /// Its value.
        value: f64,
        /// Its unit; empty for a number.
        unit: &'static str,
    },
    /// The equations of a group have no value at the reference input although all dimensions are
    /// finite: a root or an arc function is out of its range, something is divided by zero, or the
    /// position is singular.
    Undefined {
        /// The group.
        group: GroupRef,
    },
    /// An angle could not be followed through the range of the input, so that its turns cannot be
    /// counted.
    NoWinding {
        /// Name of the mechanism.
        mechanism: &'static str,
        /// The unknown angle.
        unknown: &'static str,
    },
    /// The groups have too many assembly modes to list every assembly.
    TooManyAssemblies {
        /// Name of the mechanism.
        mechanism: &'static str,
        /// Number of groups with two modes.
        modes: usize,
    },
    /// On the straight way to other dimensions an assembly ends.
    Blocked {
        /// The group.
        group: GroupRef,
        /// The possible part of the path: 0 with the first dimensions, 1 with the last ones.
        share: f64,
    },
    /// A group that has no closed form was not assembled.
    #[cfg(feature = "alloc")]
    Coupled(
        /// Why.
        Box<CoupledError>,
    ),
}

impl AssemblyError {
    /// True if there is simply no such assembly: its links do not reach each other.
    #[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
    pub(crate) fn is_a_miss(&self) -> bool {
        match self {
            Self::CannotClose { .. } => true,
            Self::Coupled(error) => matches!(
                error.cause,
                CoupledCause::NoneReal { .. } | CoupledCause::NotReached { .. }
            ),
            _ => false,
        }
    }
}

impl fmt::Display for AssemblyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::CannotClose { group, miss, unit } => {
                write!(f, "{group}")?;
                let (miss, gap) = (rounded(miss), if unit.is_empty() { "" } else { " " });
                write!(
                    f,
                    " cannot close at the reference input: it misses by {miss}{gap}{unit}"
                )
            }
            Self::NotFinite {
                mechanism,
                dimension,
                value,
            } => write!(
                f,
                "{mechanism}: the dimension {dimension} is {value}, which is no finite number"
            ),
            Self::Overflow {
                mechanism,
                dimension,
                value,
                unit,
            } => {
                let gap = if unit.is_empty() { "" } else { " " };
                write!(
                    f,
                    "{mechanism}: the dimension {dimension} is too large to be computed with: {value:e}{gap}{unit}, and \
                     the square of a number above {LARGEST:e} is beyond the largest one"
                )
            }
            Self::Undefined { group } => {
                write!(f, "{group}")?;
                f.write_str(
                    " has no solution at the reference input: with these dimensions a root or an arc function is out of \
                     its range, a length is negative, something is divided by zero, or joints or guides coincide",
                )
            }
            Self::NoWinding { mechanism, unknown } => write!(
                f,
                "{mechanism}: the turns of {unknown} cannot be counted over the range of the input"
            ),
            Self::TooManyAssemblies { mechanism, modes } => write!(
                f,
                "{mechanism}: {modes} groups with two assembly modes each give too many \
                 assemblies to list"
            ),
            Self::Blocked { group, share } => {
                write!(f, "{group}")?;
                let share = rounded(100.0 * share);
                write!(
                    f,
                    " meets a dead point after {share} % of the straight way to these dimensions: \
                     the assembly ends there"
                )
            }
            #[cfg(feature = "alloc")]
            Self::Coupled(ref error) => write!(f, "{error}"),
        }
    }
}

impl core::error::Error for AssemblyError {}
