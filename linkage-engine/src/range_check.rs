//! The check of the declared range.

use linkage_runtime::RangeReport;
use linkage_runtime::support::{Ranged, check_range};

use crate::assembled::Assembly;

impl Assembly<'_> {
    /// Checks the declared range. A mechanism without groups has no findings.
    ///
    /// It returns the same as the method `check_range` of the macro's assembly.
    #[must_use]
    pub fn check_range(&self) -> RangeReport {
        let mechanism = self.mechanism();
        let groups = mechanism.compiled.groups.iter();
        let slacks: Vec<_> = groups.map(|group| group.slack).collect();
        let ranged = Ranged {
            mechanism: mechanism.name,
            inputs: mechanism.inputs,
            groups: mechanism.structure.groups,
            slacks: &slacks,
            units: &mechanism.gap_units,
            repeats: mechanism.compiled.repeats(),
        };
        check_range(&ranged, &|x| self.survey(x), &|x| self.gaps(x))
    }
}
