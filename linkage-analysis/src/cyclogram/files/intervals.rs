//! The intervals of all members: CSV and JSON.

use serde_json::{Value, json};
use std::string::{String, ToString};
use std::vec::Vec;

use super::text::{band, checked, index, word};
use super::{order, overlaps};
use crate::cyclogram::{Band, Cyclogram, Member};
use linkage_formats::units::titled;
use linkage_formats::{CsvStyle, ReportError};

/// Returns the intervals of all members as CSV.
pub(super) fn intervals_csv(
    cyclogram: &Cyclogram,
    style: &CsvStyle,
) -> Result<String, ReportError> {
    checked(style)?;
    let (unit, shown) = style.shown("rad");
    let angles = ["from", "to", "range", "+- from", "+- to"];
    let angles = angles.map(|name| titled(name, unit));
    let words = ["organ", "motion", "band"].map(String::from);
    let titles = words.iter().chain(&angles);
    let mut text = style.line(titles.map(|title| style.word(title)));
    for organ in &cyclogram.members {
        let count = organ.events().len();
        for (index, (motion, interval)) in organ.intervals().enumerate() {
            let band = band(organ, motion);
            let words = [organ.name(), word(motion), &band].map(|word| style.word(word));
            let shifts = [index, (index + 1) % count].map(|event| organ.shift(event));
            let [from, to] = shifts.map(|shift| shift.unwrap_or(f64::NAN));
            let numbers = [interval.from, interval.to, interval.range, from, to];
            let numbers = numbers.map(|x| style.number(shown(x)).into());
            text.push_str(&style.line(words.into_iter().chain(numbers)));
        }
    }
    Ok(text)
}

/// Returns the whole cyclogram as JSON.
pub fn value(cyclogram: &Cyclogram) -> Value {
    json!({
        "from": cyclogram.range.0,
        "to": cyclogram.range.1,
        "organs": cyclogram.members.iter().map(organ_value).collect::<Vec<_>>(),
        "order": order::order_value(cyclogram),
        "overlaps": overlaps::value(&cyclogram.overlaps()),
    })
}

fn organ_value(organ: &Member) -> Value {
    let intervals = organ.intervals().map(|(motion, interval)| {
        json!({
            "motion": word(motion),
            "band": index(motion),
            "from": interval.from,
            "to": interval.to,
            "range": interval.range,
        })
    });
    let events = organ.events().iter().enumerate().map(|(index, event)| {
        json!({
            "at": event.at,
            "value": event.value,
            "ends": word(event.ends),
            "begins": word(event.begins),
            "sensitivity": organ.sensitivity(index),
            "shift": organ.shift(index),
        })
    });
    let [lowest, highest] = organ.limits();
    json!({
        "name": organ.name(),
        "unit": organ.unit,
        "lowest": lowest,
        "highest": highest,
        "bands": organ.bands().iter().map(ToString::to_string).collect::<Vec<_>>(),
        "bounds": organ.bands().iter().map(bounds).collect::<Vec<_>>(),
        "intervals": intervals.collect::<Vec<_>>(),
        "events": events.collect::<Vec<_>>(),
    })
}

/// A band for programs: where it is measured from, and its numbers.
fn bounds(band: &Band) -> Value {
    match *band {
        Band::Top(width) => json!(["top", width]),
        Band::Bottom(width) => json!(["bottom", width]),
        Band::Between(low, high) => json!(["between", low, high]),
    }
}
