//! Derivatives by parameters through the intermediates of a mechanism: few unknowns that all
//! effects of some groups pass through.
//!
//! The dimensions of a dyad often change the numbers behind it through one angle only. Then those
//! numbers are differentiated by the angle, the angle by the dimensions, and both are multiplied:
//! the sweep backwards of each number is done once for all of them.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::{acting, adjoint, mentioned, partial};
use crate::algebra::memo::{ByParameter, Flow, ThroughIntermediates};
use crate::algebra::solutions::Solutions;
use crate::algebra::systems::{Solved, System};

/// A dependent of an unknown or a rate: a result, or an intermediate behind it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Behind {
    Result(usize),
    Intermediate(Solved),
}

/// Finds the intermediates between parameters and `results`: the used unknowns of a group, if they
/// are fewer than the dependents. Results themselves may use more: everything behind is visited
/// once.
pub(crate) fn find_intermediates<'m>(algebra: &mut Algebra<'m>, results: &[Ex<'m>]) {
    let mut hanging: BTreeMap<Solved, BTreeSet<Behind>> = BTreeMap::new();
    for (index, &result) in results.iter().enumerate() {
        let memo = &mut algebra.derivatives.partials.mentioned;
        let graph = algebra.graph;
        for solved in mentioned::mentioned_in(graph, &algebra.solutions, memo, &[result]) {
            let behind = hanging.entry(solved).or_default();
            behind.insert(Behind::Result(index));
        }
    }
    let mut narrow = BTreeSet::new();
    // The last group first.
    while let Some(group) = hanging.keys().next_back().map(|solved| solved.system.group) {
        let used = hanging.split_off(&first_of(group));
        let behind: BTreeSet<&Behind> = used.values().flatten().collect();
        let are_results = behind
            .iter()
            .all(|dependent| matches!(dependent, Behind::Result(_)));
        let is_narrow = used.len() < behind.len() || are_results;
        for (solved, behind) in &used {
            for earlier in mentioned_by_group(algebra, &solved.system) {
                let all = hanging.entry(earlier).or_default();
                if is_narrow {
                    _ = all.insert(Behind::Intermediate(solved.clone()));
                } else {
                    all.extend(behind.iter().cloned())
                }
            }
        }
        if is_narrow {
            narrow.extend(used.into_keys());
        }
    }
    algebra.solutions.intermediates = narrow;
}

/// Returns the mentions of earlier groups by a system and the systems of its group that it
/// mentions.
fn mentioned_by_group(algebra: &mut Algebra<'_>, system: &System) -> BTreeSet<Solved> {
    let mut earlier = BTreeSet::new();
    let mut entered = BTreeSet::from([system.clone()]);
    let mut open = vec![system.clone()];
    while let Some(next) = open.pop() {
        for solved in mentioned::mentioned_by(algebra, &next) {
            if solved.system.group < system.group {
                earlier.insert(solved);
            } else if entered.insert(solved.system.clone()) {
                open.push(solved.system);
            }
        }
    }
    earlier
}

/// The derivative by a parameter through the intermediates.
pub(crate) fn derivative_through<'m>(
    algebra: &mut Algebra<'m>,
    x: Ex<'m>,
    parameter: SymbolId,
) -> Ex<'m> {
    let known = algebra.derivatives.adjoints.flows.get(&x.id()).cloned();
    let through = known.unwrap_or_else(|| {
        let through = Rc::new(through_intermediates(algebra, x));
        let all = &mut algebra.derivatives.adjoints.flows;
        all.insert(x.id(), Rc::clone(&through));
        through
    });
    let start = partial::partial(algebra, x, parameter);
    let direct = adjoint::minus_slopes(algebra, start, &through.flow, parameter);
    let acting = through.acting.positions_for(parameter).iter();
    acting.fold(direct, |sum, &index| {
        let (intermediate, weight) = &through.intermediates[index];
        sum + *weight * rate_between(algebra, intermediate, parameter)
    })
}

/// Sweeps from a number backwards, with its derivatives by all intermediates, also by those before
/// others.
fn through_intermediates<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>) -> ThroughIntermediates<'m> {
    let zero = algebra.zero();
    let weights = adjoint::weights_of(algebra, x);
    let mut flow = adjoint::sweep(algebra, weights, is_intermediate);
    let mut open = std::mem::take(&mut flow.ends);
    let mut places = BTreeMap::new();
    while let Some((intermediate, weight)) = open.pop_last() {
        for (earlier, share) in &flow_of(algebra, &intermediate).ends {
            *open.entry(earlier.clone()).or_insert(zero) += weight * *share;
        }
        places.insert(intermediate, weight);
    }
    let mut acting = ByParameter::default();
    for (index, intermediate) in places.keys().enumerate() {
        for multiplier in &flow_of(algebra, intermediate).multipliers {
            acting.add(
                index,
                &acting::acting_on_system(algebra, &multiplier.system),
            );
        }
    }
    ThroughIntermediates {
        flow,
        intermediates: places.into_iter().collect(),
        acting,
    }
}

fn is_intermediate(solutions: &Solutions<'_>, solved: &Solved) -> bool {
    solutions.intermediates.contains(solved)
}

/// Sweeps from an intermediate to those of earlier groups.
fn flow_of<'m>(algebra: &mut Algebra<'m>, intermediate: &Solved) -> Rc<Flow<'m>> {
    if let Some(known) = algebra
        .derivatives
        .adjoints
        .of_intermediates
        .get(intermediate)
    {
        return Rc::clone(known);
    }
    let group = intermediate.system.group;
    let weights = vec![(intermediate.clone(), algebra.one())];
    let flow = Rc::new(adjoint::sweep(algebra, weights, |solutions, solved| {
        solved.system.group < group && is_intermediate(solutions, solved)
    }));
    let all = &mut algebra.derivatives.adjoints.of_intermediates;
    all.insert(intermediate.clone(), Rc::clone(&flow));
    flow
}

/// Returns the derivative of an intermediate by a parameter, without the part through those of
/// earlier groups.
fn rate_between<'m>(
    algebra: &mut Algebra<'m>,
    intermediate: &Solved,
    parameter: SymbolId,
) -> Ex<'m> {
    let key = (intermediate.clone(), parameter);
    if let Some(&known) = algebra.derivatives.adjoints.between.get(&key) {
        return known;
    }
    let flow = flow_of(algebra, intermediate);
    let zero = algebra.zero();
    let rate = adjoint::minus_slopes(algebra, zero, &flow, parameter);
    algebra.derivatives.adjoints.between.insert(key, rate);
    rate
}

/// Returns the smallest result of a group.
fn first_of(group: usize) -> Solved {
    Solved {
        system: System::new(group, Vec::new()),
        position: 0,
    }
}
