//! Speeds and accelerations of pieces of a course at their ends.

use linkage_symbolic::Graph;

use super::{At, Check};
use crate::algebra::{clamped_curvatures, ends_of_law};
use crate::model::{Ends, Law, MotionLawKind, Pieces};

/// Speed and acceleration on one side of a knot.
pub(super) type Rates = [f64; 2];

impl Check<'_, '_> {
    /// The speeds and accelerations of all pieces at their ends; nothing where none jumps.
    pub(super) fn pieces(&self) -> Vec<[Rates; 2]> {
        let pieces = self.knots.windows(2).zip(&self.course.knots[1..]);
        match self.course.kind {
            MotionLawKind::Laws => pieces.map(|(pair, knot)| rates(pair, knot.law)).collect(),
            MotionLawKind::Spline(Ends::Clamped, Pieces::Cubic) => {
                let graph = Graph::new();
                let points = self.knots.iter();
                let points =
                    points.map(|knot| (graph.number(knot.abscissa), graph.number(knot.value)));
                let curvatures = clamped_curvatures(&points.collect::<Vec<_>>());
                let [first, last] =
                    curvatures.map(|curvature| curvature.constant_value().unwrap_or(f64::NAN));
                // Nothing jumps within the spline: equal values on both sides are as good as rest.
                let mut all = vec![[[0.0; 2]; 2]; self.knots.len() - 1];
                all[0][0][1] = first;
                all[self.knots.len() - 2][1][1] = last;
                all
            }
            // A natural spline goes on as it ends, a periodic one as it began; a clamped quintic
            // one ends without acceleration.
            MotionLawKind::Rise | MotionLawKind::Spline(..) => Vec::new(),
        }
    }
}

/// Speed and acceleration of a piece at its begin and end.
fn rates(pair: &[At], law: Option<Law>) -> [Rates; 2] {
    let Some(law) = law else {
        return [[0.0; 2]; 2];
    };
    let width = pair[1].abscissa - pair[0].abscissa;
    let height = pair[1].value - pair[0].value;
    ends_of_law(law).map(|[speed, acceleration]| {
        [
            speed * height / width,
            acceleration * height / (width * width),
        ]
    })
}
