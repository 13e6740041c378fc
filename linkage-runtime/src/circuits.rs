//! Which assemblies run through the whole range of an input, and where the others end.

mod coupled;
mod curve;
mod join;
mod levels;
mod margins;
mod meetings;
mod parts;
mod print;
mod search;
mod slab;
mod stretches;
#[cfg(test)]
mod tests;
mod trace;

use crate::error::AssemblyError;
use alloc::vec::Vec;
use linkage_core::Cycle;
use margins::{least, up_to};
use search::{End, Leaf, Search};

pub use levels::{Bounds, Chosen, Levels, NoPrograms, Searched, SurveyedUnknown};

/// All assemblies over the range of an input.
///
/// Printed, it is a table; angles are in degrees.
#[derive(Clone, Debug, PartialEq)]
pub struct Circuits<A> {
    /// The range.
    pub cycle: Cycle,
    /// Name of the input.
    pub input: &'static str,
    /// The assemblies, in the order of the inputs where they begin.
    pub branches: Vec<Branch<A>>,
    /// Which of them meet in change points.
    pub meetings: Vec<Meeting>,
}

/// Two assemblies that meet, and both go on: from a change point the mechanism can go on in either.
#[derive(Clone, Debug, PartialEq)]
pub struct Meeting {
    /// Their places among the branches.
    pub branches: [usize; 2],
    /// The inputs at which they meet; of a turn that begins at one, its end is none.
    pub at: Vec<f64>,
}

/// An assembly and how far it reaches.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch<A> {
    /// The assembly.
    pub assembly: A,
    /// Number of its circuit. Without being taken apart, a mechanism reaches all assemblies of a circuit, through turning
    /// points, and no other.
    pub circuit: usize,
    /// Where it begins and ends.
    pub ends: [BranchEnd; 2],
    /// Whether it is the same again after a full turn of the input.
    pub closed: bool,
    /// Its smallest margin, 0 at a turning point.
    pub margin: f64,
    /// The input where the margin is smallest.
    pub at: f64,
    /// The input at which `unknowns` are: the reference if the assembly exists there.
    pub input: f64,
    /// Where the unknowns are, to be copied as start estimates for that input.
    pub unknowns: Vec<Estimate>,
}

/// Where an unknown is. Printed, it is a start estimate: `theta = 40.2074deg`.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// The unknown.
    pub name: &'static str,
    /// Unit of a length; empty for a number.
    pub unit: &'static str,
    /// Whether it is an angle, from -pi to pi; it is printed in degrees.
    pub angle: bool,
    /// Its value, or the components of a point.
    pub numbers: Vec<f64>,
}

/// Where an assembly begins or ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BranchEnd {
    /// With the range.
    Range(f64),
    /// At a turning point, a dead point of the input, where it meets another assembly of its circuit.
    TurningPoint(f64),
    /// It is not known beyond this input, although there is no turning point: a slide runs off to infinity, or two circuits cross.
    Lost(f64),
}

impl BranchEnd {
    /// The input.
    #[must_use]
    pub fn x(self) -> f64 {
        match self {
            Self::Range(x) | Self::TurningPoint(x) | Self::Lost(x) => x,
        }
    }
}

impl<A> Branch<A> {
    /// Whether it runs through the whole range.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let through = |end: &BranchEnd| matches!(end, BranchEnd::Range(_));
        self.ends.iter().all(through)
    }
}

impl<A> Circuits<A> {
    /// The assemblies that run through the whole range.
    pub fn whole(&self) -> impl Iterator<Item = &Branch<A>> {
        self.branches.iter().filter(|branch| branch.is_whole())
    }
}

/// How close the places of one assembly are from one turn to the next, relative to their size.
const SAME: f64 = 1e-6;

/// More modes than this are not searched.
const MOST_MODES: usize = 16;

/// Finds all assemblies over a range, how far each reaches, which of them meet, and where their margins are smallest.
///
/// Groups with a closed form end where their discriminants vanish: bounds over intervals show that no such place is missed. Behind a coupled
/// group, and in mechanisms that are interpreted, there are no bounds, and samples look for them. Solutions of coupled groups are followed
/// along their curves, through turning points, so that no end is without the assembly that it is shared with.
///
/// # Errors
///
/// If nothing is found, and what was looked for could not be listed.
pub fn circuits<M: Levels>(
    mechanism: &M,
    cycle: &Cycle,
) -> Result<Circuits<M::Assembly>, AssemblyError> {
    let Search {
        mut leaves,
        mut error,
        ..
    } = Search::run(mechanism, *cycle)?;
    leaves.sort_by(|a, b| a.inputs[0].total_cmp(&b.inputs[0]));
    let mut assemblies = Vec::new();
    leaves.retain(|leaf| match assemble(mechanism, leaf) {
        Ok(assembly) => {
            assemblies.push(assembly);
            true
        }
        Err(new) => {
            error.get_or_insert(new);
            false
        }
    });
    if leaves.is_empty() {
        let refused = error.filter(|error| !error.is_a_miss());
        refused.map_or_else(|| mechanism.check(cycle.low), Err)?;
    }
    let seams: Vec<[Vec<f64>; 2]> = leaves
        .iter()
        .zip(&assemblies)
        .map(|(leaf, (assembly, _))| leaf.inputs.map(|x| numbers(mechanism, assembly, x)))
        .collect();
    let (circuits, closed) = join::circuits(&leaves, &seams, cycle.turn().is_some());
    let own: Vec<M::Assembly> = assemblies.iter().map(|(own, _)| own.clone()).collect();
    let meetings = meetings::meetings(mechanism, cycle, &leaves, &own);
    let branches = leaves.iter().zip(assemblies).zip(circuits).zip(closed);
    let branches = branches.map(|(((leaf, (assembly, input)), circuit), closed)| {
        let mut ends = leaf.branch_ends();
        let (mut at, mut margin) = least(mechanism, leaf, &assembly);
        if margin.is_nan() && !leaf.turns() {
            (ends, at, margin) = up_to(mechanism, &assembly, ends, [input, at]);
        }
        Branch {
            unknowns: estimates(mechanism, &assembly, input),
            assembly,
            circuit,
            closed: closed && ends == leaf.branch_ends(),
            ends,
            margin,
            at,
            input,
        }
    });
    Ok(Circuits {
        cycle: *cycle,
        input: mechanism.searched().input,
        branches: branches.collect(),
        meetings,
    })
}

/// The assembly, and an input at which it is known: the reference if it exists there.
fn assemble<M: Levels>(mechanism: &M, leaf: &Leaf) -> Result<(M::Assembly, f64), AssemblyError> {
    let [low, high] = leaf.inputs;
    let middle = leaf.known.filter(|x| low < *x && *x < high);
    let middle = middle.unwrap_or(0.5 * (low + high));
    let assembly = mechanism.assembled(&leaf.chosen, middle)?;
    let reference = mechanism.searched().reference;
    let known = low < reference
        && reference < high
        && numbers(mechanism, &assembly, reference)
            .iter()
            .all(|x| x.is_finite());
    Ok((assembly, if known { reference } else { middle }))
}

/// The numbers of the unknowns.
fn numbers<M: Levels>(mechanism: &M, assembly: &M::Assembly, x: f64) -> Vec<f64> {
    let before = 1 + mechanism.searched().levels.len();
    mechanism.survey(assembly, x).as_ref()[before..].to_vec()
}

fn estimates<M: Levels>(mechanism: &M, assembly: &M::Assembly, x: f64) -> Vec<Estimate> {
    let numbers = numbers(mechanism, assembly, x);
    let mut next = numbers.iter().copied();
    let estimate = |unknown: &SurveyedUnknown| {
        let own: Vec<f64> = next.by_ref().take(unknown.numbers).collect();
        Estimate {
            name: unknown.name,
            unit: unknown.unit,
            angle: unknown.angle,
            numbers: match own[..] {
                [cosine, sine] if unknown.angle => {
                    Vec::from([linkage_core::Scalar::atan2(sine, cosine)])
                }
                _ => own,
            },
        }
    };
    let unknowns = mechanism.searched().unknowns;
    unknowns.iter().map(estimate).collect()
}

impl Leaf {
    /// Whether it ends at a turning point.
    fn turns(&self) -> bool {
        let turning = |end: &End| matches!(end, End::Turning { .. });
        self.ends.iter().any(turning)
    }

    fn branch_ends(&self) -> [BranchEnd; 2] {
        [0, 1].map(|side| match self.ends[side] {
            End::Range => BranchEnd::Range(self.inputs[side]),
            End::Turning { .. } => BranchEnd::TurningPoint(self.inputs[side]),
            End::Lost => BranchEnd::Lost(self.inputs[side]),
        })
    }
}

/// The input of a sample.
fn sample(cycle: &Cycle, index: usize) -> f64 {
    let last = cycle.samples.max(2) - 1;
    if index == last {
        return cycle.high;
    }
    cycle.low + (cycle.high - cycle.low) * (index as f64 / last as f64)
}

/// Whether places are the same, within a share of this size.
fn near(a: &[f64], b: &[f64], size: f64, share: f64) -> bool {
    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= share * size;
    a.iter().zip(b).all(close)
}

/// The largest of some numbers.
fn size(place: &[f64]) -> f64 {
    place.iter().fold(0.0, |size: f64, x| size.max(x.abs()))
}
