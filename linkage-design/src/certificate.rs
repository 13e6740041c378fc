//! No mechanism is returned that does not assemble over its whole range on one circuit.
//!
//! Its assemblies are found over the range, each with its ends: those of groups with a closed form
//! by bounds of their discriminants, so that none is missed; those of coupled groups as far as
//! listings at some inputs and steps along their curves see. One of them must run through the whole
//! range, a turn must close, and by all that the objectives ask for it must be the optimum: so it
//! is the assembly that was optimised, all its positions are on one circuit, and they are reached
//! without a dead point between them.

use core::fmt;
use std::boxed::Box;
use std::vec::Vec;

use linkage_core::format::rounded;
use linkage_runtime::{AssemblyError, Branch, BranchEnd, Circuits};

/// The least margin that is no dead point: that which the compiler asks of a declaration.
const LEAST: f64 = 1e-6;

/// Numbers of the same assembly differ by less than this part of their sizes; those of other
/// assemblies by far more.
const SAME: f64 = 1e-6;

/// A local optimum that does not run through its whole range.
#[derive(Clone, Debug, PartialEq)]
pub struct Interrupted {
    /// Its sum of squares.
    pub sum: f64,
    /// Why it does not.
    pub why: Interruption,
}

/// Why a mechanism does not run through its whole range.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Interruption {
    /// It assembles nowhere.
    Unassembled(Box<AssemblyError>),
    /// No single assembly has all positions that are wanted: it would have to be taken apart
    /// between two of them.
    Apart,
    /// It assembles between these inputs only.
    Ends(Vec<[f64; 2]>),
    /// It has a dead point at this input.
    DeadPoint(f64),
    /// After a full turn of the input it is in another assembly.
    Other,
}

impl fmt::Display for Interrupted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the best of these, with a sum of squares of {}, {}",
            rounded(self.sum),
            self.why
        )
    }
}

/// The verb for the mechanism that is named before.
impl fmt::Display for Interruption {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unassembled(error) => write!(f, "does not assemble: {error}"),
            Self::Apart => f.write_str("would have to be taken apart between two of its positions"),
            Self::Ends(intervals) => {
                f.write_str("assembles only between the inputs ")?;
                for (k, [from, to]) in intervals.iter().enumerate() {
                    let and = if k > 0 { ", and between " } else { "" };
                    write!(f, "{and}{} and {}", rounded(*from), rounded(*to))?;
                }
                Ok(())
            }
            Self::DeadPoint(input) => write!(f, "has a dead point at input {}", rounded(*input)),
            Self::Other => f.write_str("is in another assembly after a full turn of the input"),
        }
    }
}

/// The assembly over the whole range that is the same as the one that is meant, or why there is
/// none.
pub(crate) fn certify<A>(
    found: Result<Circuits<A>, AssemblyError>,
    mut same: impl FnMut(&Branch<A>) -> bool,
) -> Result<Branch<A>, Interruption> {
    let found = found.map_err(|error| Interruption::Unassembled(Box::new(error)))?;
    let turns = found.cycle.turn().is_some();
    let mut parts = Vec::new();
    for branch in found.branches {
        if !same(&branch) {
            continue;
        }
        if !branch.is_whole() {
            // A mode that is real in several intervals has a branch in each.
            parts.push(branch.ends.map(BranchEnd::x));
        } else if turns && !branch.closed {
            return Err(Interruption::Other);
        } else if branch.margin > LEAST {
            return Ok(branch);
        } else {
            return Err(Interruption::DeadPoint(branch.at));
        }
    }
    Err(match parts.is_empty() {
        true => Interruption::Apart,
        false => Interruption::Ends(parts),
    })
}

/// Returns true if numbers are those of the same assembly, each compared with a size.
pub(crate) fn alike(a: &[f64], b: &[f64], sizes: impl IntoIterator<Item = f64>) -> bool {
    let mut pairs = a.iter().zip(b).zip(sizes);
    a.len() == b.len() && pairs.all(|((a, b), size)| (a - b).abs() <= SAME * size)
}
