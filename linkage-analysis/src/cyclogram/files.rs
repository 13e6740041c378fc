//! Cyclograms as files: CSV, JSON, and the diagram of bars.

pub mod bars;
pub mod intervals;
mod order;
mod overlaps;
mod text;

use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::vec::Vec;

use crate::cyclogram::{Cyclogram, Member};
use linkage_formats::characters::control;
use linkage_formats::{CsvStyle, ReportError, output_file};

impl Cyclogram {
    /// Returns the intervals of all organs as CSV, organ by organ: the motion, the band, the angles
    /// of both ends, the length, and the shifts of both ends by tolerances, if they were given.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] if the style cannot tell cells apart.
    pub fn csv(&self, style: &CsvStyle) -> Result<String, ReportError> {
        intervals::intervals_csv(self, style)
    }

    /// All of it as JSON, angles in radians: each organ with its limits, bands, intervals and
    /// events, these with their sensitivities and shifts; the order of all events, each with the
    /// one that it follows; and the overlaps.
    #[must_use]
    pub fn json(&self) -> String {
        intervals::value(self).to_string()
    }

    /// Returns the events of all organs as CSV, in order of the angle: the angle, its shift by
    /// tolerances, if they were given, the event, and the angle since the event before it.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] if the style cannot tell cells apart.
    pub fn order_csv(&self, style: &CsvStyle) -> Result<String, ReportError> {
        order::order_csv(self, style)
    }

    /// Returns the [overlaps](Self::overlaps) as CSV: organ, motion and band of both, the angles of
    /// both ends, and the length.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] if the style cannot tell cells apart.
    pub fn overlaps_csv(&self, style: &CsvStyle) -> Result<String, ReportError> {
        overlaps::overlaps_csv(self, style)
    }

    /// The diagram of bars: a row for each organ, with the line on which it rises and falls, bars
    /// where it dwells, and the angles of its events. It follows the reader's choice of a light or
    /// dark ground.
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
            true => Ok(bars::drawn(self, &(0..names.len()).collect::<Vec<_>>())),
            false => Err(ReportError::Mistakes(mistakes)),
        }
    }

    /// Writes the diagram, by the ending of the file's name, as SVG or (with feature `png`) as PNG.
    ///
    /// # Errors
    ///
    /// As [`svg`](Self::svg), if the file cannot be written, and for any other ending.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<PathBuf, ReportError> {
        output_file::picture(path.as_ref(), &self.svg()?)
    }
}
