//! Why a group without a closed form has no assembly.

use super::closest_approach::ClosestApproach;
use super::group::GroupRef;
use alloc::vec::Vec;
use core::fmt;
use linkage_core::format::rounded;
use linkage_core::numeric::roots::Unlisted;

/// Why a group that has no closed form (class III and higher) was not assembled.
///
/// ```
/// use linkage_runtime::{CoupledCause, CoupledError, GroupRef};
///
/// let error = CoupledError {
///     group: GroupRef {
///         mechanism: "Platform",
///         index: 0,
///         kind: "RR-RR-RR",
///         loops: &[1, 2],
///         joints: "",
///         unknowns: &["alpha", "beta"],
///     },
///     cause: CoupledCause::NoneReal { complex: 6 },
/// };
/// assert_eq!(
///     error.to_string(),
///     "Platform: loops 1 and 2 (alpha, beta; RR-RR-RR) cannot close at the reference input: \
///      none of the 6 solutions is real"
/// );
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CoupledError {
    /// The group.
    pub group: GroupRef,
    /// The cause.
    pub cause: CoupledCause,
}

/// A cause why a group without a closed form was not assembled.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CoupledCause {
    /// All solutions at the reference input are complex: the links do not reach each other.
    NoneReal {
        /// The number of complex solutions.
        complex: usize,
    },
    /// The start estimates are equally near to two assemblies.
    Ambiguous {
        /// All assemblies, the nearest first.
        assemblies: Vec<Placed>,
    },
    /// The solutions at the reference input could not be listed: legs that coincide, for instance.
    NotListed(
        /// Why.
        Unlisted,
    ),
    /// The solutions cannot be listed, and the estimates, from which one is followed, do not lead
    /// to any: the way ends before, as at a dead point.
    NotReached {
        /// The part of the estimates' error that remains there.
        left: f64,
        /// The closest approach of the loops.
        closest_approach: ClosestApproach,
    },
    /// The assembly is at a dead point at the reference input.
    Singular,
    /// The range of the input runs into a dead point, where the assembly ends.
    DeadPoint(
        /// The input there.
        Value,
    ),
    /// The assembly cannot be followed through the range of the input.
    NotFollowed(
        /// The input where it ends.
        Value,
    ),
    /// With several inputs: positions in the ranges, away from dead points, are not served,
    /// although the mechanism can be assembled there, as far as is known. This is a limit of the
    /// preparation, not a dead point.
    LeavesOut {
        /// The share of the ranges.
        share: f64,
        /// The inputs at one of the positions.
        example: Placed,
    },
    /// With several inputs: a dead point is so near to the reference that the assembly is not
    /// served there.
    BesideDeadPoint(
        /// The reference inputs.
        Placed,
    ),
}

/// The values of a group's unknowns in one assembly, or of its inputs at one position.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed(
    /// The values; of the unknowns those that have start estimates.
    pub Vec<Value>,
);

/// A name with a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// The name.
    pub name: &'static str,
    /// The value; angles in radians.
    pub value: f64,
    /// Unit of a length; empty for a number.
    pub unit: &'static str,
    /// True for an angle, which is printed in degrees.
    pub angle: bool,
}

impl fmt::Display for CoupledError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { group, cause } = self;
        write!(f, "{group} {cause}")
    }
}

/// Advice for groups without a listing.
const ANOTHER_WAY: &str =
    "`assemble_from` follows an assembly of other dimensions to these, without a listing";

/// Continues a sentence that begins with the group.
impl fmt::Display for CoupledCause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoneReal { complex: 0 } => {
                f.write_str("cannot close at the reference input: there is no solution")
            }
            Self::NoneReal { complex } => write!(
                f,
                "cannot close at the reference input: none of the {complex} solutions is real"
            ),
            Self::Ambiguous { assemblies } => {
                write!(
                    f,
                    "can close in {} ways, of which two are equally near to the start estimates: ",
                    assemblies.len()
                )?;
                for (index, assembly) in assemblies.iter().enumerate() {
                    let between = if index == 0 { "" } else { "; " };
                    write!(f, "{between}{assembly}")?;
                }
                Ok(())
            }
            Self::NotListed(Unlisted::Degenerate) => write!(
                f,
                "cannot be solved: the solutions at the reference input cannot be listed: they may not be isolated, as where legs coincide, \
                 guides are parallel or lengths are zero; otherwise this is a limit of linkage: {ANOTHER_WAY}"
            ),
            Self::NotListed(Unlisted::Followed) => f.write_str(
                "is followed from its estimates alone: its solutions are not listed, which is a limit of linkage",
            ),
            Self::NotListed(why) => write!(
                f,
                "cannot be solved: the solutions at the reference input cannot all be listed: {why}; this is a limit of \
                 linkage, not of the mechanism: {ANOTHER_WAY}"
            ),
            Self::NotReached { left, closest_approach } => write!(
                f,
                "cannot be reached from its estimates at the reference input: the way ends where {:.1} % of what they miss by is \
                 taken back, at a dead point or where a pivot of the elimination becomes small; {closest_approach}",
                100.0 * (1.0 - left)
            ),
            Self::Singular => {
                f.write_str("cannot run from the reference input: it is a dead point")
            }
            Self::DeadPoint(at) => write!(
                f,
                "cannot run through the range of the input: it reaches a dead point at {at}"
            ),
            Self::NotFollowed(at) => write!(
                f,
                "cannot be followed through the range of the input beyond {at}: another assembly is \
                 too near"
            ),
            Self::LeavesOut { share, example } => write!(
                f,
                "cannot be prepared over these ranges of the inputs: {:.1} % of their positions would be left out, {example} among \
                 them, though no dead point is near; this is a limit of linkage: shorten the ranges",
                100.0 * share
            ),
            Self::BesideDeadPoint(reference) => write!(
                f,
                "cannot be prepared at the reference inputs, {reference}: a dead point is so near that the smallest cells of linkage do not \
                 reach the assembly there; move the reference away from it, or shorten the ranges"
            ),
        }
    }
}

impl fmt::Display for Placed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, value) in self.0.iter().enumerate() {
            let between = if index == 0 { "" } else { ", " };
            write!(f, "{between}{value}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (value, unit) = if self.angle {
            (self.value.to_degrees(), "deg")
        } else {
            (self.value, self.unit)
        };
        let gap = if unit.is_empty() { "" } else { " " };
        write!(f, "{} = {}{gap}{unit}", self.name, rounded(value))
    }
}

impl core::error::Error for CoupledError {}
