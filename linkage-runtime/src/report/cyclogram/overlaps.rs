//! What two organs do at once.

use serde_json::{Value, json};
use std::string::String;
use std::vec::Vec;

use super::{CsvStyle, ReportError, band, checked, index, word};
use crate::cyclogram::{Cyclogram, Overlap, Overlaps};
use crate::report::units::titled;

impl Cyclogram {
    /// The [overlaps](Self::overlaps) as CSV: which organ, what it does, in which band; the same of the other one; from
    /// which angle to which, for how long.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] if the style cannot tell cells apart.
    pub fn overlaps_csv(&self, style: &CsvStyle) -> Result<String, ReportError> {
        checked(style)?;
        let (unit, shown) = style.shown("rad");
        let words = [
            "organ",
            "motion",
            "band",
            "other organ",
            "its motion",
            "its band",
        ];
        let words = words.map(String::from);
        let angles = ["from", "to", "range"].map(|name| titled(name, unit));
        let titles = words.iter().chain(&angles);
        let mut text = style.line(titles.map(|title| style.word(title)));
        for overlap in self.overlaps().all() {
            let bands = [0, 1].map(|k| band(&self.members[overlap.members[k]], overlap.motions[k]));
            let words = [0, 1].map(|k| {
                let organ = &self.members[overlap.members[k]];
                [organ.name(), word(overlap.motions[k]), &bands[k]].map(|word| style.word(word))
            });
            let interval = &overlap.interval;
            let numbers = [interval.from, interval.to, interval.range];
            let numbers = numbers.map(|x| style.number(shown(x)).into());
            text.push_str(&style.line(words.into_iter().flatten().chain(numbers)));
        }
        Ok(text)
    }
}

impl Overlaps<'_> {
    pub(super) fn value(&self) -> Vec<Value> {
        let overlap = |own: &Overlap| {
            json!({
                "organs": own.members,
                "motions": own.motions.map(word),
                "bands": own.motions.map(index),
                "from": own.interval.from,
                "to": own.interval.to,
                "range": own.interval.range,
            })
        };
        self.all().iter().map(overlap).collect()
    }
}
