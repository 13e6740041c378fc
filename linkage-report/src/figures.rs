//! Figures of the cycle, from courses of quantities.

use std::string::String;
use std::vec::Vec;

use linkage_analysis::summary::{Curve, Extremes, TimeRatio};

/// The figures of the course of a quantity.
#[derive(Clone, Debug)]
pub(super) struct Figures {
    pub(super) quantity: String,
    pub(super) unit: String,
    /// Extremes of the quantity and of its first and second derivative, if they are known.
    pub(super) extremes: Vec<Extremes>,
    pub(super) time: Option<TimeRatio>,
    /// Inputs at which gaps begin or end.
    borders: Vec<f64>,
    /// The range of the input.
    width: f64,
}

impl Figures {
    /// Reads the figures of a course.
    pub(super) fn new<const N: usize, F: Fn(f64) -> [f64; N]>(
        quantity: String,
        unit: String,
        course: &Curve<N, F>,
    ) -> Self {
        Self {
            quantity,
            unit,
            extremes: (0..3)
                .filter_map(|k| course.extremes_of(k).cloned())
                .collect(),
            time: course.time_ratio(),
            borders: borders(course),
            width: course.range().1 - course.range().0,
        }
    }

    /// Returns true for an input at the border of a gap, or so near that rounding decides.
    pub(super) fn is_beside_a_gap(&self, at: f64) -> bool {
        let near = |border: &f64| (border - at).abs() <= NEAR * self.width;
        self.borders.iter().any(near)
    }
}

/// Returns the inputs at which a course is interrupted. The ends of its range are no interruption.
fn borders<const N: usize, F: Fn(f64) -> [f64; N]>(course: &Curve<N, F>) -> Vec<f64> {
    if !course.has_gaps() {
        return Vec::new();
    }
    let (low, high) = course.range();
    let parts = course.parts();
    let ends = parts.iter().flat_map(|part| [part.from, part.to]);
    ends.filter(|&end| end != low && end != high).collect()
}

/// The distance of inputs at a border, as a share of the range.
const NEAR: f64 = 1e-6;
