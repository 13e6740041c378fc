//! Machines: one colour for one part, in the drawing, in its legend and in the cyclogram.

use serde_json::{Value, json};
use std::string::ToString;
use std::vec::Vec;

use super::builder::Report;
use super::positioned_picture::PositionedPicture;
use super::{positioned_picture, tables};
use linkage_analysis::cyclogram::{Cyclogram, Member};
use linkage_analysis::internals::intervals;
use linkage_formats::colour::LINKS;
use linkage_formats::{Mistake, ReportError};

/// The unit of a shaft's angle.
const ANGLE: &str = "rad";
/// The name of the cyclogram's files.
const FILE: &str = "cyclogram";

impl PositionedPicture<'_> {
    /// Returns the number of the colour of a link: that of its part, and the one after all parts
    /// for links of the machine itself. Without parts the colours of the list are used in turn.
    pub(super) fn link_hue(&self, link: usize) -> usize {
        let parts = self.picture.parts;
        let of = parts.iter().position(|part| part.links.contains(&link));
        match parts {
            [] => link % LINKS,
            _ => of.unwrap_or(parts.len()),
        }
    }

    /// The same for a guide that is a link of its own.
    pub(super) fn guide_hue(&self, guide: usize) -> usize {
        let parts = self.picture.parts;
        let of = parts.iter().position(|part| part.guides.contains(&guide));
        match parts {
            [] => (self.picture.links.len() + guide) % LINKS,
            _ => of.unwrap_or(parts.len()),
        }
    }
}

pub(super) fn check_cyclogram(report: &Report, mistakes: &mut Vec<Mistake>) {
    let Some(cyclogram) = &report.cyclogram else {
        return;
    };
    if let Err(ReportError::Mistakes(found)) = cyclogram.svg() {
        mistakes.extend(found);
    }
    if report.input.unit != ANGLE {
        mistakes.push(Mistake::NoShaft {
            input: report.input.name.to_string(),
            unit: report.input.unit,
        });
    }
    let mut functions = tables::function_names(&report.tables).into_iter();
    if let Some(function) = functions.find(|function| function == FILE) {
        mistakes.push(Mistake::File { function });
    }
}

/// Returns the number of the colour of each organ: that of the part in its name, as in `hook` or
/// `hook.tip`, and the ones after all parts for others.
pub(super) fn organ_hues(report: &Report, cyclogram: &Cyclogram) -> Vec<usize> {
    let parts =
        positioned_picture::find_picture(report).map_or(&[][..], |shown| shown.picture.parts);
    let part = |organ: &Member| {
        let name = organ.name().split('.').next();
        parts.iter().position(|part| Some(part.name) == name)
    };
    let mut others = parts.len()..;
    let organs = cyclogram.members().iter();
    let hues = organs.map(|organ| part(organ).or_else(|| others.next()));
    hues.map(Option::unwrap_or_default).collect()
}

/// Returns the number of colours of links that the page needs: for parts, for links of the machine
/// itself, for organs.
pub(super) fn link_hues(report: &Report) -> usize {
    let parts =
        positioned_picture::find_picture(report).map_or(0, |shown| shown.picture.parts.len());
    let organs = report
        .cyclogram
        .iter()
        .flat_map(|cyclogram| organ_hues(report, cyclogram));
    organs.fold(parts, usize::max) + 1
}

pub(super) fn cyclogram_value(report: &Report, cyclogram: &Cyclogram) -> Value {
    let mut value = intervals::value(cyclogram);
    for (organ, hue) in organ_hues(report, cyclogram).into_iter().enumerate() {
        value["organs"][organ]["colour"] = json!(hue);
    }
    value
}
