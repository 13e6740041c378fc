//! Drawings that move.

use std::string::{String, ToString};
use std::vec::Vec;

use super::Drawing;
use crate::report::svg::Svg;
use crate::report::{Mistake, ReportError};

/// A cycle has about so many positions; between them all points move straight. Half way a link that turns once is shorter by a thousandth of
/// its length (the cosine of 3 degrees), one that turns four times by two percent: nobody sees it, and each position is written out.
const KEYS: usize = 60;

impl Drawing<'_> {
    /// Lets the mechanism run over the range of the report, again and again, in so many seconds: onward where it begins anew as it ended, else there and
    /// back. Any browser shows it, a reader of a page beside the text, too; where SVG does not move, it stands at the first position.
    ///
    /// It shows links, joints, guides, paths and ghosts. Names, dimensions, vectors, ellipses and the arrows of inputs belong to one position and are
    /// left out. It is for mechanisms of the plane, a limit of ours: the page of a report moves those in space.
    #[must_use]
    pub fn moving(mut self, seconds: f64) -> Self {
        let planar = self.shown.picture.dimension == 2;
        self.mistakes
            .extend((!planar).then_some(Mistake::MovesInSpace));
        if !(seconds > 0.0 && seconds.is_finite()) {
            self.mistakes.push(Mistake::Seconds { seconds });
        }
        self.seconds = Some(seconds);
        self
    }

    /// The drawing that moves.
    pub(super) fn film(&self, seconds: f64) -> Result<String, ReportError> {
        let rows = self.key_rows();
        if let Some(row) = rows.iter().find(|row| !self.shown.is_assembled(**row)) {
            let input = &self.report.input;
            return Err(ReportError::Mistakes(Vec::from([Mistake::NotAssembled {
                input: input.name.to_string(),
                unit: input.unit,
                at: Some(self.report.positions[*row]),
            }])));
        }
        let frames = rows.iter().map(|row| self.drawn(*row, rows[0]));
        // A link with another number of corners, or a direction that vanishes, at one position only.
        let changes = || ReportError::Mistakes(Vec::from([Mistake::Changes]));
        Svg::film(frames.collect(), seconds).ok_or_else(changes)
    }

    /// The rows that are drawn: equally far from each other, but for the last one.
    fn key_rows(&self) -> Vec<usize> {
        let last = self.report.positions.len() - 1;
        if self.report.is_periodic() {
            return (0..last).step_by(last.div_ceil(KEYS)).collect();
        }
        let there = (0..last).step_by(last.div_ceil(KEYS / 2));
        let back = there.clone().skip(1).rev();
        there.clone().chain([last]).chain(back).collect()
    }
}
