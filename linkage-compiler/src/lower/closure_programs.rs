//! One program for all groups, and those of coupled groups: the programs that close the loops at
//! compile time.

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::passes::reciprocals;
use linkage_symbolic::schedule::schedule_whole;
use linkage_symbolic::{Ex, NodeId};

use crate::algebra::{Algebra, Nominal};
use crate::ir::{ClosurePrograms, Outputs};
use crate::solve::{Formulation, Prepared};

use super::groups::{AssemblySource, find_turning, group_nodes, groups};
use super::plain::{plain, valued_angles};

/// See [`ClosurePrograms`].
pub(crate) fn closure_programs<'m>(
    algebra: &mut Algebra<'m>,
    formulation: &Formulation<'m>,
    nominal: &Nominal,
) -> ClosurePrograms {
    let mut inliner = Inliner::default();
    let source = |prepared: &Prepared| {
        if prepared.system.terms.is_empty() {
            AssemblySource::Estimates
        } else {
            AssemblySource::ListingOrEstimates
        }
    };
    let coupled_nodes = group_nodes(algebra, formulation, nominal, &mut inliner, source);
    let mut lists: Vec<Vec<NodeId>> = Vec::new();
    let mut all = Vec::new();
    let mut next = 0;
    for (index, solved) in formulation.groups.iter().enumerate() {
        let mut outputs = Outputs::default();
        let mut numbers: Vec<Ex> = Vec::new();
        for &unknown in &solved.group.unknowns {
            if formulation.last_group_with(unknown) != Some(index) {
                continue;
            }
            outputs.unknowns.push((unknown, next + numbers.len()));
            numbers.extend(algebra.names.numbers_of(unknown));
        }
        if solved.mode.is_some() && outputs.unknowns.is_empty() {
            for angle in solved.group.form.introduced_angles(&algebra.names) {
                outputs.links.push((angle, next + numbers.len()));
                numbers.extend(algebra.names.angles[angle].unit.components());
            }
        }
        outputs.gap = next + numbers.len();
        outputs.slack = outputs.gap + 1;
        outputs.margin = outputs.gap + 2;
        outputs.slack_scale = outputs.gap + 3;
        let closed = &solved.closed;
        numbers.extend([closed.gap, closed.slack, closed.margin, closed.slack_scale]);
        next += numbers.len();
        lists.push(plain(&mut inliner, &numbers));
        all.push(outputs);
    }
    let mut closure = ClosurePrograms {
        groups: all,
        coupled: groups(algebra, formulation, nominal, &coupled_nodes, |nodes| {
            reciprocals::share(schedule_whole(&inliner.target, nodes))
        }),
        ..ClosurePrograms::default()
    };
    let mut units: Vec<Ex> = Vec::new();
    let valued = valued_angles(&inliner.target, &lists.concat());
    for angle in formulation.in_order(algebra, valued) {
        closure.valued.push((angle, next + units.len()));
        units.extend(algebra.names.angles[angle].unit.components());
    }
    let angles: Vec<usize> = closure.valued.iter().map(|(angle, _)| *angle).collect();
    find_turning(
        &mut closure.coupled,
        &coupled_nodes,
        &inliner.target,
        &angles,
    );
    lists.push(plain(&mut inliner, &units));
    closure.program = reciprocals::share(schedule_whole(&inliner.target, &lists.concat()));
    let mut next = 0;
    let mut end = 0;
    for (list, outputs) in lists.iter().zip(&mut closure.groups) {
        // The nodes that compute a list come before the further nodes of later lists.
        let last = closure.program.outputs[next..]
            .iter()
            .take(list.len())
            .max();
        end = end.max(last.map_or(0, |value| value.0 + 1));
        outputs.end = end;
        next += list.len();
    }
    closure
}
