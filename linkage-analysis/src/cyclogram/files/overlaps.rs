//! Simultaneous motions of two organs.

use serde_json::{Value, json};
use std::string::String;
use std::vec::Vec;

use super::text::{band, checked, index, word};
use crate::cyclogram::{Cyclogram, Overlap, Overlaps};
use linkage_formats::units::titled;
use linkage_formats::{CsvStyle, ReportError};

/// Returns the overlaps of all members as CSV.
pub(super) fn overlaps_csv(cyclogram: &Cyclogram, style: &CsvStyle) -> Result<String, ReportError> {
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
    for overlap in cyclogram.overlaps().all() {
        let bands =
            [0, 1].map(|k| band(&cyclogram.members[overlap.members[k]], overlap.motions[k]));
        let words = [0, 1].map(|k| {
            let organ = &cyclogram.members[overlap.members[k]];
            [organ.name(), word(overlap.motions[k]), &bands[k]].map(|word| style.word(word))
        });
        let interval = &overlap.interval;
        let numbers = [interval.from, interval.to, interval.range];
        let numbers = numbers.map(|x| style.number(shown(x)).into());
        text.push_str(&style.line(words.into_iter().flatten().chain(numbers)));
    }
    Ok(text)
}

pub(super) fn value(overlaps: &Overlaps<'_>) -> Vec<Value> {
    let overlap = |overlap: &Overlap| {
        json!({
            "organs": overlap.members,
            "motions": overlap.motions.map(word),
            "bands": overlap.motions.map(index),
            "from": overlap.interval.from,
            "to": overlap.interval.to,
            "range": overlap.interval.range,
        })
    };
    overlaps.all().iter().map(overlap).collect()
}
