//! What emission prints beside the programs.

use crate::algebra::{Algebra, Nominal};
use crate::emit::facts::{Facts, GroupFacts, InputFacts};
use crate::formulate::{Formulation, Reference, Solved, candidate_rates, followed_range};

pub(crate) fn collect(
    algebra: &Algebra,
    formulation: &Formulation,
    nominal: &Nominal,
    reference: &Reference,
) -> Facts {
    let inputs = (0..nominal.inputs.len()).map(|input| InputFacts {
        reference: nominal.inputs[input],
        range: nominal.ranges[input],
        followed: followed_range(algebra, nominal, input),
        rates: candidate_rates(algebra, input),
    });
    Facts {
        nominal: nominal.parameters.clone(),
        tolerance: nominal.tolerances.clone(),
        inputs: inputs.collect(),
        groups: formulation
            .groups
            .iter()
            .map(|g| group_facts(algebra, g, reference))
            .collect(),
        mobility: formulation.mobility,
        longest: reference.longest,
    }
}

fn group_facts(algebra: &Algebra, solved: &Solved, reference: &Reference) -> GroupFacts {
    let mechanism = algebra.mechanism;
    let unknown = |&k: &usize| mechanism.unknowns[k].name.clone();
    GroupFacts {
        class: solved.closed.class,
        order: solved.closed.order,
        kind: solved.closed.kind.to_string(),
        loops: solved.group.loops.iter().map(|k| k + 1).collect(),
        unknowns: solved.group.unknowns.iter().map(unknown).collect(),
        mode: solved.mode,
        coupled: solved.prepared.is_some(),
        plus: solved
            .mode
            .is_none_or(|mode| reference.machine.modes[mode] > 0.0),
        method: solved.closed.method,
        gap_unit: solved.gap_dimension(mechanism).unit(mechanism.unit),
    }
}
