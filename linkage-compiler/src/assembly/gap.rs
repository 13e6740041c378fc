//! The distance by which the links of a group miss each other, as text.

use linkage_core::range_check::significant;

use crate::message_format::MessageFormat;
use crate::solve::Solved;

impl MessageFormat<'_> {
    pub(super) fn gap(&self, solved: &Solved, gap: f64) -> String {
        let dimension = solved.gap_dimension(self.mechanism());
        format!(
            "{}{}",
            significant(gap),
            dimension.unit(self.mechanism().unit)
        )
    }
}
