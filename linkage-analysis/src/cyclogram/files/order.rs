//! The order of the events of all organs, each with the event before it.

use serde_json::{Value, json};
use std::string::{String, ToString};
use std::vec::Vec;

use super::text::checked;
use crate::cyclogram::{Cyclogram, Member, Moment};
use linkage_formats::units::titled;
use linkage_formats::{CsvStyle, ReportError};

/// Returns the events of all members in their order as CSV.
pub(super) fn order_csv(cyclogram: &Cyclogram, style: &CsvStyle) -> Result<String, ReportError> {
    checked(style)?;
    let (unit, shown) = style.shown("rad");
    let at = ["at", "+- at"].map(|name| titled(name, unit));
    let titles = [
        &at[0],
        &at[1],
        "event",
        &titled("after", unit),
        "after what",
    ];
    let mut text = style.line(titles.map(|title| style.word(title)));
    for [before, moment] in pairs(cyclogram) {
        let number = |x: f64| style.number(shown(x)).into();
        let shift = moment.member.shift(moment.index).unwrap_or(f64::NAN);
        let [what, follows] = [moment, before].map(|moment| moment.to_string());
        text.push_str(&style.line([
            number(moment.event.at),
            number(shift),
            style.word(&what),
            number(moment.after),
            style.word(&follows),
        ]));
    }
    Ok(text)
}

pub(super) fn order_value(cyclogram: &Cyclogram) -> Vec<Value> {
    let index = |organ: &Member| {
        cyclogram
            .members
            .iter()
            .position(|other| core::ptr::eq(other, organ))
    };
    let moment = |[before, moment]: [Moment<'_>; 2]| {
        json!({
            "organ": index(moment.member),
            "event": moment.index,
            "at": moment.event.at,
            "after": moment.after,
            "follows": { "organ": index(before.member), "event": before.index },
        })
    };
    pairs(cyclogram).map(moment).collect()
}

/// Each event behind the one that it follows: the first of the cycle follows the last one.
fn pairs(cyclogram: &Cyclogram) -> impl Iterator<Item = [Moment<'_>; 2]> {
    let all: Vec<Moment<'_>> = cyclogram.moments().collect();
    let count = all.len();
    (0..count).map(move |k| [all[(k + count - 1) % count], all[k]])
}
