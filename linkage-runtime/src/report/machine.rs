//! Machines: one colour for one part, in the drawing, in its legend and in the cyclogram.

use serde_json::{Value, json};
use std::string::ToString;
use std::vec::Vec;

use super::colour::LINKS;
use super::shown::Shown;
use super::{Mistake, Report, ReportError};
use crate::cyclogram::{Cyclogram, Member};

/// The unit of a shaft's angle.
const ANGLE: &str = "rad";
/// The name of the cyclogram's files.
const FILE: &str = "cyclogram";

impl Shown<'_> {
    /// Which of the colours of links a link has: that of its part, links of the machine itself that behind all parts. Without parts each
    /// has one of the listed ones, which begin again.
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

impl Report {
    /// What the organs of the machine do at which angle of its shaft, which is the input: as a diagram of bars below the drawing of the
    /// page, with a line where the machine stands, as a table, and as files.
    #[must_use]
    pub fn cyclogram(mut self, cyclogram: &Cyclogram) -> Self {
        self.cyclogram = Some(cyclogram.clone());
        self
    }

    pub(super) fn check_cyclogram(&self, mistakes: &mut Vec<Mistake>) {
        let Some(cyclogram) = &self.cyclogram else {
            return;
        };
        if let Err(ReportError::Mistakes(own)) = cyclogram.svg() {
            mistakes.extend(own);
        }
        if self.input.unit != ANGLE {
            mistakes.push(Mistake::NoShaft {
                input: self.input.name.to_string(),
                unit: self.input.unit,
            });
        }
        let mut functions = self.functions().into_iter();
        if let Some(function) = functions.find(|function| function == FILE) {
            mistakes.push(Mistake::File { function });
        }
    }

    /// Of each organ, which of the colours of links it has: that of the part whose name it bears, as `hook` or `hook.tip`, others those behind all
    /// parts.
    pub(super) fn organ_hues(&self, cyclogram: &Cyclogram) -> Vec<usize> {
        let parts = self.shown().map_or(&[][..], |shown| shown.picture.parts);
        let part = |organ: &Member| {
            let name = organ.name().split('.').next();
            parts.iter().position(|part| Some(part.name) == name)
        };
        let mut others = parts.len()..;
        let organs = cyclogram.members().iter();
        let hues = organs.map(|organ| part(organ).or_else(|| others.next()));
        hues.map(Option::unwrap_or_default).collect()
    }

    /// How many colours of links the page has: of parts, of what the machine itself adds, of organs.
    pub(super) fn link_hues(&self) -> usize {
        let parts = self.shown().map_or(0, |shown| shown.picture.parts.len());
        let organs = self.cyclogram.iter().flat_map(|own| self.organ_hues(own));
        organs.fold(parts, usize::max) + 1
    }

    pub(super) fn cyclogram_value(&self, cyclogram: &Cyclogram) -> Value {
        let mut value = cyclogram.value();
        for (organ, hue) in self.organ_hues(cyclogram).into_iter().enumerate() {
            value["organs"][organ]["colour"] = json!(hue);
        }
        value
    }
}
