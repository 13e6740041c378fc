//! The four-bars through nine points.

use super::super::Pose;
use super::super::four_bar::{FourBar, Passage};
use super::super::verify;
use std::vec::Vec;

/// Triples of cognates for almost all nine points, real and complex.
///
/// The number is that of the literature (first by Wampler, Morgan and Sommese, found again by all
/// methods since), and of the generator of the stored solutions: a number computed with much
/// evidence, not a theorem.
pub const TRIPLES: usize = 1442;

/// The four-bars through nine points.
#[derive(Clone, Debug, PartialEq)]
pub struct NinePoints {
    /// The real ones: three four-bars with the same coupler curve each (Roberts).
    pub triples: Vec<Triple>,
    /// The number of complex triples: no mechanisms.
    pub complex: usize,
    /// Paths without an end of their own: at points with a symmetry or next to others with double
    /// solutions. Also triples of which a cognate does not close at all points with the joints that
    /// rounding leaves.
    pub undecided: usize,
}

impl NinePoints {
    /// Returns whether all [`TRIPLES`] have been found: each shown to exist, to be real or complex
    /// and to differ from the others (Krawczyk's test on discs, rounding included). There are no
    /// others then, if 1442 is the number. This holds whatever way they have been found.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.triples.len() + self.complex == TRIPLES
    }
}

/// Three four-bars with the same coupler curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Triple {
    /// The cognates; each two have a joint of the frame in common.
    pub four_bars: [PathFourBar; 3],
    /// Bound of the errors of the joints of the first one, in units of the points.
    pub error: f64,
}

impl Triple {
    /// Returns whether both links of each cognate keep their lengths at all points.
    pub(super) fn closes(&self) -> bool {
        let mut cognates = self.four_bars.iter();
        cognates.all(|path| verify::closes(&path.four_bar, &path.poses))
    }
}

/// A four-bar and how it passes the points.
#[derive(Clone, Debug, PartialEq)]
pub struct PathFourBar {
    /// Its joints. The coupler's frame has its origin at the point of the path, and angle 0 at the
    /// first point.
    pub four_bar: FourBar,
    /// The coupler at the points.
    pub poses: [Pose; 9],
    /// Circuits, branches, order.
    pub passage: Passage,
}
