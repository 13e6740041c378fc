//! Derivatives by parameters through the narrow places of a mechanism.
//!
//! All that the dimensions of a dyad do to the numbers behind it, they often do through one angle. Then those numbers
//! are differentiated by the angle, the angle by the dimensions, and both are multiplied: what a sweep backwards would
//! do for each number is done once for all of them.

use crate::algebra::acting;
use crate::algebra::adjoint;
use crate::algebra::partial;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use linkage_symbolic::{Ex, SymbolId};

use super::Algebra;
use super::acting::ByParameter;
use super::adjoint::Flow;
use super::partial::{Solved, System};

/// What hangs on an unknown or a rate: results, and narrow places behind it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Behind {
    Result(usize),
    Place(Solved),
}

/// The way from a number backwards through all narrow places.
#[derive(Clone, Debug)]
pub(super) struct Through<'m> {
    /// To the first ones.
    flow: Flow<'m>,
    /// All of them in order, with the derivatives of the number with respect to each.
    places: Vec<(Solved, Ex<'m>)>,
    /// The narrow places between which and those before a parameter acts.
    acting: ByParameter,
}

/// Finds the narrow places between parameters and `results`: what is used of a group, if that is less than what
/// hangs on it. What the results themselves use may be more: what is behind it is gone through once.
pub(crate) fn find_narrow_places<'m>(algebra: &mut Algebra<'m>, results: &[Ex<'m>]) {
    let mut hanging: BTreeMap<Solved, BTreeSet<Behind>> = BTreeMap::new();
    for (index, &result) in results.iter().enumerate() {
        for solved in partial::mentioned_in(algebra, &[result]) {
            let behind = hanging.entry(solved).or_default();
            behind.insert(Behind::Result(index));
        }
    }
    let mut narrow = BTreeSet::new();
    // The last group first.
    while let Some(group) = hanging.keys().next_back().map(|own| own.system.group) {
        let used = hanging.split_off(&first_of(group));
        let behind: BTreeSet<&Behind> = used.values().flatten().collect();
        let are_results = behind.iter().all(|own| matches!(own, Behind::Result(_)));
        let is_narrow = used.len() < behind.len() || are_results;
        for (solved, behind) in &used {
            for earlier in mentioned_by_group(algebra, &solved.system) {
                let all = hanging.entry(earlier).or_default();
                match is_narrow {
                    true => _ = all.insert(Behind::Place(solved.clone())),
                    false => all.extend(behind.iter().cloned()),
                }
            }
        }
        if is_narrow {
            narrow.extend(used.into_keys());
        }
    }
    algebra.solutions.narrow = narrow;
}

/// What the equations of a system, and those of its group that it mentions, mention of earlier groups.
fn mentioned_by_group(algebra: &mut Algebra<'_>, system: &System) -> BTreeSet<Solved> {
    let mut earlier = BTreeSet::new();
    let mut entered = BTreeSet::from([system.clone()]);
    let mut open = vec![system.clone()];
    while let Some(next) = open.pop() {
        for solved in adjoint::mentioned_by(algebra, &next) {
            if solved.system.group < system.group {
                earlier.insert(solved);
            } else if entered.insert(solved.system.clone()) {
                open.push(solved.system);
            }
        }
    }
    earlier
}

/// The derivative by a parameter through the narrow places.
pub(super) fn derivative_through<'m>(
    algebra: &mut Algebra<'m>,
    x: Ex<'m>,
    parameter: SymbolId,
) -> Ex<'m> {
    let known = algebra.derivatives.adjoints.flows.get(&x.id()).cloned();
    let through = known.unwrap_or_else(|| {
        let through = Rc::new(way_through(algebra, x));
        let all = &mut algebra.derivatives.adjoints.flows;
        all.insert(x.id(), Rc::clone(&through));
        through
    });
    let start = partial::partial(algebra, x, parameter);
    let direct = adjoint::minus_slopes(algebra, start, &through.flow, parameter);
    let acting = through.acting.of(parameter).iter();
    acting.fold(direct, |sum, &index| {
        let (place, weight) = &through.places[index];
        sum + *weight * rate_between(algebra, place, parameter)
    })
}

/// From a number backwards, with its derivatives by all narrow places, also by those before others.
fn way_through<'m>(algebra: &mut Algebra<'m>, x: Ex<'m>) -> Through<'m> {
    let zero = algebra.zero();
    let weights = adjoint::weights_of(algebra, x);
    let mut flow = adjoint::sweep(algebra, weights, |own, solved| is_narrow(own, solved));
    let mut open = std::mem::take(&mut flow.ends);
    let mut places = BTreeMap::new();
    while let Some((place, weight)) = open.pop_last() {
        for (earlier, own) in &flow_of(algebra, &place).ends {
            *open.entry(earlier.clone()).or_insert(zero) += weight * *own;
        }
        places.insert(place, weight);
    }
    let mut acting = ByParameter::default();
    for (index, place) in places.keys().enumerate() {
        for own in &flow_of(algebra, place).multipliers {
            acting.add(index, &acting::acting_on_system(algebra, &own.system));
        }
    }
    Through {
        flow,
        places: places.into_iter().collect(),
        acting,
    }
}

fn is_narrow(algebra: &Algebra<'_>, solved: &Solved) -> bool {
    algebra.solutions.narrow.contains(solved)
}

/// From a narrow place to those of earlier groups.
fn flow_of<'m>(algebra: &mut Algebra<'m>, place: &Solved) -> Rc<Flow<'m>> {
    if let Some(known) = algebra.derivatives.adjoints.of_places.get(place) {
        return Rc::clone(known);
    }
    let group = place.system.group;
    let weights = vec![(place.clone(), algebra.one())];
    let flow = Rc::new(adjoint::sweep(algebra, weights, |own, solved| {
        solved.system.group < group && is_narrow(own, solved)
    }));
    let all = &mut algebra.derivatives.adjoints.of_places;
    all.insert(place.clone(), Rc::clone(&flow));
    flow
}

/// The derivative of a narrow place by a parameter, without what passes those of earlier groups.
fn rate_between<'m>(algebra: &mut Algebra<'m>, place: &Solved, parameter: SymbolId) -> Ex<'m> {
    let key = (place.clone(), parameter);
    if let Some(&known) = algebra.derivatives.adjoints.between.get(&key) {
        return known;
    }
    let flow = flow_of(algebra, place);
    let zero = algebra.zero();
    let rate = adjoint::minus_slopes(algebra, zero, &flow, parameter);
    algebra.derivatives.adjoints.between.insert(key, rate);
    rate
}

/// The smallest of what is solved in a group.
fn first_of(group: usize) -> Solved {
    Solved {
        system: System::new(group, Vec::new()),
        position: 0,
    }
}
