//! The check of the declared range of one input.

use super::report::{RangeReport, Ranged};
use super::search::RangeSearch;
use alloc::vec::Vec;
use linkage_core::range_check::{Driven, Slack, checked};

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
