//! All assemblies over a range, with their circuits, ends, margins and meetings.

use super::branch::{Branch, Circuits};
use super::join::join;
use super::leaf::Leaf;
use super::levels::Levels;
use super::margins::{least, up_to};
use super::meetings::meetings;
use super::search::LevelSearch;
use super::unknowns::{estimates, numbers};
use crate::error::AssemblyError;
use alloc::vec::Vec;
use linkage_core::Cycle;

/// Finds all assemblies over a range, how far each reaches, which of them meet, and where their
/// margins are smallest.
///
/// Groups with a closed form end where their discriminants vanish: bounds over intervals show that
/// no such place is missed. Behind a coupled group, and in mechanisms that are interpreted, there
/// are no bounds, and samples look for them. Solutions of coupled groups are followed along their
/// curves, through turning points, so that no end is without the assembly that it is shared with.
///
/// # Errors
///
/// An error if nothing is found, and a listing failed.
pub fn circuits<M: Levels>(
    mechanism: &M,
    cycle: &Cycle,
) -> Result<Circuits<M::Assembly>, AssemblyError> {
    let LevelSearch {
        mut leaves,
        undetermined,
        mut error,
        ..
    } = LevelSearch::run(mechanism, *cycle)?;
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
    let (circuits, closed) = join(&leaves, &seams, cycle.turn().is_some());
    let alone: Vec<M::Assembly> = assemblies
        .iter()
        .map(|(assembly, _)| assembly.clone())
        .collect();
    let meetings = meetings(mechanism, cycle, &leaves, &alone);
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
        undetermined,
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
