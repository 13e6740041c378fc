//! Drawings that move.

use std::string::{String, ToString};
use std::vec::Vec;

use super::options::Drawing;
use super::picture;
use crate::missing;
use linkage_formats::svg::Svg;
use linkage_formats::{Mistake, ReportError};

/// A cycle has about so many positions; between them all points move straight. Half way a link that
/// turns once is shorter by a thousandth of its length (the cosine of 3 degrees), one that turns
/// four times by two percent: nobody sees it, and each position is written out.
const KEYS: usize = 60;

/// The drawing that moves.
pub(super) fn film(drawing: &Drawing<'_>, seconds: f64) -> Result<String, ReportError> {
    let rows = key_rows(drawing);
    if let Some(row) = rows.iter().find(|row| !drawing.shown.is_assembled(**row)) {
        let input = &drawing.report.input;
        return Err(ReportError::Mistakes(Vec::from([Mistake::NotAssembled {
            input: input.name.to_string(),
            unit: input.unit,
            at: Some(drawing.report.positions[*row]),
        }])));
    }
    let frames = rows
        .iter()
        .map(|row| picture::picture_at(drawing, *row, rows[0]));
    // A link with another number of corners, or a direction that vanishes, at one position only.
    let changes = || ReportError::Mistakes(Vec::from([Mistake::Changes]));
    Svg::film(frames.collect(), seconds).ok_or_else(changes)
}

/// The rows that are drawn: equally far from each other, except for the last one.
fn key_rows(drawing: &Drawing<'_>) -> Vec<usize> {
    let last = drawing.report.positions.len() - 1;
    if missing::is_periodic(drawing.report) {
        return (0..last).step_by(last.div_ceil(KEYS)).collect();
    }
    let there = (0..last).step_by(last.div_ceil(KEYS / 2));
    let back = there.clone().skip(1).rev();
    there.clone().chain([last]).chain(back).collect()
}
