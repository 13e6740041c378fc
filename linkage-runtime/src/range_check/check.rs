//! The check of the declared range of one input.

use super::report::{RangeReport, Ranged};
use super::search::RangeSearch;
use crate::support::{AssemblyData, List, PlainGroups};
use alloc::vec::Vec;
use linkage_core::range_check::{Driven, Slack, checked};

/// Searches the declared range of an assembly, with the criteria of the compiler.
pub fn check_range_of<C: PlainGroups>(assembly: &C::Assembly) -> RangeReport {
    let data = C::data(assembly);
    let core = AssemblyData::core(data);
    let (description, groups) = (core.dimensions.description(), core.dimensions.group_data());
    let ranged = Ranged {
        mechanism: description.name,
        inputs: description.inputs,
        groups: description.groups,
        slacks: groups.slacks,
        units: description.gap_units,
        repeats: groups.repeats,
    };
    let arguments = |x: &[f64]| {
        let inputs = C::Inputs::list(x.len(), |k| x[k]);
        core.dimensions
            .arguments(AssemblyData::starts(data), &inputs)
    };
    let survey = |x: &[f64]| C::survey::<false>(core, arguments(x)).as_ref().to_vec();
    let gaps = |x: &[f64]| {
        let (mechanism, modes, prepared) = core.loaded();
        mechanism
            .gaps(modes, prepared, arguments(x))
            .as_ref()
            .to_vec()
    };
    check_range(&ranged, &survey, &gaps)
}

/// Searches the declared range, with the criteria of the compiler. `survey` returns the least
/// margin of all groups and the slack of each at given inputs, `gaps` by how much each group misses
/// closing.
///
/// An angle without a range is the only input that is checked for change points over the turn about
/// its reference.
pub fn check_range(
    ranged: &Ranged<'_>,
    survey: &dyn Fn(&[f64]) -> Vec<f64>,
    gaps: &dyn Fn(&[f64]) -> Vec<f64>,
) -> RangeReport {
    let mut report = RangeReport {
        mechanism: ranged.mechanism,
        input: None,
        range: [f64::NAN; 2],
        works: [f64::NAN; 2],
        findings: Vec::new(),
        unchecked: None,
        groups: ranged.groups,
        units: ranged.units.to_vec(),
    };
    let inputs = ranged.inputs.iter().map(|input| Driven {
        angle: input.unit == "rad",
        reference: input.reference,
        range: input.range,
    });
    let (input, range) = match checked(inputs, ranged.slacks.contains(&Slack::Prepared)) {
        Ok(found) => found,
        Err(why) => {
            report.unchecked = Some(why);
            return report;
        }
    };
    let mut search = RangeSearch::new(ranged, input, range, survey, gaps);
    report.input = Some(ranged.inputs[input]);
    report.range = search.range;
    report.findings = search.findings();
    report.works = search.works();
    report
}
