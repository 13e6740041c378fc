//! Cyclograms as files: CSV, JSON, and the diagram of bars.

mod bars;
mod order;
mod overlaps;

use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::vec::Vec;

use super::letters::control;
use super::units::titled;
use super::{CsvStyle, ReportError};
use crate::cyclogram::{Band, Cyclogram, Member, Motion};

impl Cyclogram {
    /// The intervals of all organs as CSV, organ by organ: what it does, in which band, from which angle to which,
    /// for how long, and by how much tolerances shift the beginning and the end, if they were given.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] if the style cannot tell cells apart.
    pub fn csv(&self, style: &CsvStyle) -> Result<String, ReportError> {
        checked(style)?;
        let (unit, shown) = style.shown("rad");
        let angles = ["from", "to", "range", "+- from", "+- to"];
        let angles = angles.map(|name| titled(name, unit));
        let words = ["organ", "motion", "band"].map(String::from);
        let titles = words.iter().chain(&angles);
        let mut text = style.line(titles.map(|title| style.word(title)));
        for organ in &self.members {
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

    /// All of it as JSON, angles in radians: each organ with its limits, bands, intervals and events, these with
    /// their sensitivities and shifts; the order of all events, each with the one that it follows; and the overlaps.
    #[must_use]
    pub fn json(&self) -> String {
        self.value().to_string()
    }

    pub(super) fn value(&self) -> Value {
        json!({
            "from": self.range.0,
            "to": self.range.1,
            "organs": self.members.iter().map(organ_value).collect::<Vec<_>>(),
            "order": self.order_value(),
            "overlaps": self.overlaps().value(),
        })
    }

    /// The diagram of bars: a row for each organ, with the line on which it rises and falls, bars where it dwells,
    /// and the angles of its events. It follows the reader's choice of a light or dark ground.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] if names have control characters.
    pub fn svg(&self) -> Result<String, ReportError> {
        let names: Vec<_> = self.members.iter().map(Member::name).collect();
        let mistakes: Vec<_> = names
            .iter()
            .filter_map(|name| control("the name of an organ", name))
            .collect();
        match mistakes.is_empty() {
            true => Ok(self.drawn(&(0..names.len()).collect::<Vec<_>>())),
            false => Err(ReportError::Mistakes(mistakes)),
        }
    }

    /// The diagram with these of the colours of links, organ by organ.
    pub(super) fn drawn(&self, hues: &[usize]) -> String {
        bars::drawn(self, hues)
    }

    /// Writes the diagram, by the ending of the file's name, as SVG or (with feature `png`) as PNG.
    ///
    /// # Errors
    ///
    /// As [`svg`](Self::svg), if the file cannot be written, and for any other ending.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<PathBuf, ReportError> {
        super::write::picture(path.as_ref(), &self.svg()?)
    }
}

fn checked(style: &CsvStyle) -> Result<(), ReportError> {
    style
        .mistake()
        .map_or(Ok(()), |mistake| Err(mistake.into()))
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

const fn word(motion: Motion) -> &'static str {
    match motion {
        Motion::Advance => "advance",
        Motion::Dwell(_) => "dwell",
        Motion::Return => "return",
    }
}

const fn index(motion: Motion) -> Option<usize> {
    match motion {
        Motion::Dwell(band) => Some(band),
        Motion::Advance | Motion::Return => None,
    }
}

/// The band of a dwell in words.
fn band(organ: &Member, motion: Motion) -> String {
    index(motion).map_or_else(String::new, |band| organ.bands()[band].to_string())
}
