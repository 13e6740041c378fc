//! Radii of gears, from the motion of their links.

use super::geometry::wrapped;
use crate::positioned_picture::PositionedPicture;
use linkage_core::Gear;

/// The radii of a belt's wheels together, as a share of the distance of their centres.
const BELT: f64 = 0.6;

/// Two wheels, in units of the mechanism.
pub(crate) struct PitchCircles {
    pub(crate) radii: [f64; 2],
    /// The turns of the second wheel for one turn of the first.
    pub(crate) ratio: f64,
}

impl PitchCircles {
    /// `None` where one of the links never turns, or nothing is finite.
    pub(crate) fn new(shown: &PositionedPicture<'_>, gear: &Gear) -> Option<Self> {
        let angle = |wheel: usize, row: usize| {
            let from = shown.point_at(gear.centres[wheel], row);
            let to = shown.point_at(gear.ends[wheel], row);
            (to[1] - from[1]).atan2(to[0] - from[0])
        };
        // Best in the sense of least squares; steps are far less than half a turn.
        let (mut product, mut square) = (0.0, 0.0);
        for row in 1..shown.rows() {
            let [a, b] = [0, 1].map(|wheel| wrapped(angle(wheel, row) - angle(wheel, row - 1)));
            if a.is_finite() && b.is_finite() {
                product += a * b;
                square += a * a;
            }
        }
        let ratio = product / square;
        let row = (0..shown.rows()).find(|row| shown.is_assembled(*row))?;
        let [from, to] = gear.centres.map(|centre| shown.point_at(centre, row));
        let apart = (to[0] - from[0]).hypot(to[1] - from[1]);
        let share = ratio.abs() / (1.0 + ratio.abs());
        let both = if ratio < 0.0 { apart } else { BELT * apart };
        let is_sound = ratio.is_finite() && ratio != 0.0 && apart > 0.0;
        is_sound.then_some(Self {
            radii: [share * both, (1.0 - share) * both],
            ratio,
        })
    }
}
