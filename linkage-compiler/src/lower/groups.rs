//! The programs by which coupled groups are prepared: in `assemble()`, and at compile time by the
//! interpreter.

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::program::Program;
use linkage_symbolic::{Ex, Graph, NodeId};

use crate::algebra::{Algebra, Bound, Nominal};
use crate::ir::{Coupled, Placed};
use crate::solve::{Formulation, Prepared, Version};

use super::plain::{plain, valued_angles};

/// The source of the assembly of a coupled group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum AssemblySource {
    /// The list of all assemblies.
    Listing,
    /// The list, or the estimates if the assemblies cannot be listed.
    ListingOrEstimates,
    /// The estimates.
    Estimates,
}

/// The programs of a coupled group before they are scheduled: nodes of a plain graph.
#[derive(Clone, Debug)]
pub(super) struct GroupNodes {
    source: AssemblySource,
    system: Vec<NodeId>,
    estimate: Vec<NodeId>,
    residuals: Vec<NodeId>,
    correct: Vec<NodeId>,
    placed: Vec<NodeId>,
}

impl GroupNodes {
    pub(super) fn all(&self) -> Vec<NodeId> {
        [
            &self.system[..],
            &self.estimate,
            &self.residuals,
            &self.correct,
            &self.placed,
        ]
        .concat()
    }
}

/// The programs of all coupled groups as nodes; `source` returns where each assembly comes from.
pub(super) fn group_nodes<'m>(
    algebra: &Algebra<'m>,
    formulation: &Formulation<'m>,
    nominal: &Nominal,
    inliner: &mut Inliner,
    source: impl Fn(&Prepared<'m>) -> AssemblySource,
) -> Vec<GroupNodes> {
    let mut all: Vec<GroupNodes> = Vec::new();
    for prepared in formulation.prepared() {
        let source = source(prepared);
        let [mut system, mut estimate, mut residuals] = [const { Vec::new() }; 3];
        if source != AssemblySource::Estimates {
            let coefficients = prepared.system.coefficients.iter();
            system = coefficients.flat_map(|x| x.components()).collect();
        }
        if source != AssemblySource::Listing {
            estimate = prepared.estimate(algebra, nominal);
            residuals = prepared.residuals();
        }
        all.push(GroupNodes {
            source,
            system: plain(inliner, &system),
            estimate: plain(inliner, &estimate),
            residuals: plain(inliner, &residuals),
            correct: plain(inliner, &prepared.step),
            placed: Vec::new(),
        });
    }
    for (index, solved) in formulation.groups.iter().enumerate() {
        let Some(prepared) = &solved.prepared else {
            continue;
        };
        // The unknowns have their values in a given state, not after the steps of a call.
        prepared.define(algebra.graph, Version::Raw);
        let placed_numbers = placed_unknowns(algebra, formulation, index).into_iter();
        let placed_numbers = placed_numbers.flat_map(|unknown| algebra.names.numbers_of(unknown));
        let placed_numbers: Vec<Ex> = placed_numbers.chain([prepared.reach]).collect();
        all[prepared.number].placed = plain(inliner, &placed_numbers);
        prepared.define(algebra.graph, Version::Called);
    }
    all
}

/// The unknowns that a group is the last to find.
fn placed_unknowns<'m>(
    algebra: &Algebra<'m>,
    formulation: &Formulation<'m>,
    group: usize,
) -> Vec<usize> {
    let unknowns = 0..algebra.names.bound.len();
    unknowns
        .filter(|&unknown| formulation.last_group_with(unknown) == Some(group))
        .collect()
}

/// Returns the other properties of the coupled groups; `program` schedules nodes.
pub(super) fn groups<'m>(
    algebra: &Algebra<'m>,
    formulation: &Formulation<'m>,
    nominal: &Nominal,
    nodes: &[GroupNodes],
    mut program: impl FnMut(&[NodeId]) -> Program,
) -> Vec<Coupled> {
    let mut groups = Vec::new();
    for (index, solved) in formulation.groups.iter().enumerate() {
        let Some(prepared) = &solved.prepared else {
            continue;
        };
        let group_nodes = &nodes[prepared.number];
        groups.push(Coupled {
            group: index,
            inputs: prepared.inputs.clone(),
            size: prepared.size,
            in_cells: prepared.in_cells,
            variables: prepared.system.variables.clone(),
            followed: group_nodes.source == AssemblySource::Estimates,
            terms: match group_nodes.source {
                AssemblySource::Estimates => Vec::new(),
                AssemblySource::Listing | AssemblySource::ListingOrEstimates => {
                    prepared.system.terms.clone()
                }
            },
            system: program(&group_nodes.system),
            estimate: program(&group_nodes.estimate),
            residuals: program(&group_nodes.residuals),
            correct: program(&group_nodes.correct),
            placed: program(&group_nodes.placed),
            missed: Program::default(),
            missed_loops: Vec::new(),
            turning: 0,
            start: None,
            reach: nominal.evaluate(&[prepared.reach])[0],
            unknowns: placed_unknowns(algebra, formulation, index)
                .into_iter()
                .flat_map(|unknown| placed(algebra, nominal, unknown))
                .collect(),
        });
    }
    groups
}

/// Stores in each group the number of angles, in their order, that must be followed before it: up
/// to the last whose value its programs use.
pub(super) fn find_turning(
    groups: &mut [Coupled],
    nodes: &[GroupNodes],
    graph: &Graph,
    angles: &[usize],
) {
    for (group, group_nodes) in groups.iter_mut().zip(nodes) {
        let valued = valued_angles(graph, &group_nodes.all());
        let last = angles.iter().rposition(|angle| valued.contains(angle));
        group.turning = last.map_or(0, |last| last + 1);
    }
}

fn placed(algebra: &Algebra, nominal: &Nominal, unknown: usize) -> Vec<Placed> {
    let estimates = &nominal.estimates[unknown];
    let angle = matches!(algebra.names.bound[unknown], Bound::Angle(_));
    let several = estimates.len() > 1;
    let numbers = estimates.iter().enumerate();
    numbers
        .map(|(component, &estimate)| Placed {
            unknown,
            component: several.then_some(component),
            angle,
            estimate,
        })
        .collect()
}
