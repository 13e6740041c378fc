//! Assemblies over the range of an input.

use linkage_engine::{BranchEnd, Estimate};

use crate::assembly::Assembly;

/// The printed table, all branches, and their assemblies.
pub(crate) type Circuits = (String, Vec<Branch>, Vec<Assembly>);

/// Circuit, both ends with the inputs there, whether a turn leads back, the least margin with its
/// input, and the input at which the unknowns have these values.
pub(crate) type Branch = (
    usize,
    Vec<(&'static str, f64)>,
    bool,
    (f64, f64),
    f64,
    Vec<(&'static str, Vec<f64>)>,
);

/// Describes a branch.
pub(crate) fn branch<A>(found: &linkage_engine::Branch<A>) -> Branch {
    let end = |end: &BranchEnd| match *end {
        BranchEnd::Range(x) => ("range", x),
        BranchEnd::TurningPoint(x) => ("turning point", x),
        BranchEnd::Lost(x) => ("lost", x),
    };
    (
        found.circuit,
        found.ends.iter().map(end).collect(),
        found.closed,
        (found.margin, found.at),
        found.input,
        unknowns(&found.unknowns),
    )
}

/// Names and values of unknowns.
pub(crate) fn unknowns(estimates: &[Estimate]) -> Vec<(&'static str, Vec<f64>)> {
    let estimates = estimates.iter();
    estimates
        .map(|one| (one.name, one.numbers.clone()))
        .collect()
}
