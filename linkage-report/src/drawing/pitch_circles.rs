//! Radii of gears, from the motion of their links.

use super::geometry::wrapped;
use crate::positioned_picture::PositionedPicture;
use linkage_core::{Gear, WheelContact, WheelTurn};

/// The radii of a belt's wheels together, as a share of the distance of their centres.
const BELT: f64 = 0.6;

/// Two wheels, in units of the mechanism.
pub(crate) struct PitchCircles {
    pub(crate) radii: [f64; 2],
    /// The turns of the second wheel for one turn of the first, as seen from the line through their
    /// centres.
    pub(crate) ratio: f64,
    /// True if a belt joins them.
    pub(crate) belt: bool,
}

impl PitchCircles {
    /// `None` where one of the links never turns, or nothing is finite.
    pub(crate) fn new(shown: &PositionedPicture<'_>, gear: &Gear) -> Option<Self> {
        // Best in the sense of least squares; steps are far less than half a turn.
        let (mut product, mut square) = (0.0, 0.0);
        for row in 1..shown.rows() {
            let line = wrapped(line(shown, gear, row) - line(shown, gear, row - 1));
            let [a, b] = [0, 1].map(|wheel| {
                let step = angle(shown, gear, wheel, row) - angle(shown, gear, wheel, row - 1);
                wrapped(step) - line
            });
            if a.is_finite() && b.is_finite() {
                product += a * b;
                square += a * a;
            }
        }
        let ratio = product / square;
        let row = (0..shown.rows()).find(|row| shown.is_assembled(*row))?;
        let [from, to] = gear.centres.map(|centre| shown.point_at(centre, row));
        let apart = (to[0] - from[0]).hypot(to[1] - from[1]);
        let belt = match gear.contact {
            WheelContact::Teeth => false,
            WheelContact::Belt => true,
            WheelContact::BySense => ratio > 0.0,
        };
        let share = ratio.abs() / (1.0 + ratio.abs());
        let radii = match (belt, ratio > 0.0) {
            (false, true) => [ratio, 1.0].map(|size| size * apart / (ratio - 1.0).abs()),
            (true, _) => [share * (BELT * apart), (1.0 - share) * (BELT * apart)],
            (false, false) => [share * apart, (1.0 - share) * apart],
        };
        let is_sound = radii.into_iter().all(f64::is_finite) && ratio != 0.0 && apart > 0.0;
        is_sound.then_some(Self { radii, ratio, belt })
    }
}

/// The direction of the line through the centres.
fn line(shown: &PositionedPicture<'_>, gear: &Gear, row: usize) -> f64 {
    let [from, to] = gear.centres.map(|centre| shown.point_at(centre, row));
    (to[1] - from[1]).atan2(to[0] - from[0])
}

/// The angle of a wheel.
fn angle(shown: &PositionedPicture<'_>, gear: &Gear, wheel: usize, row: usize) -> f64 {
    let [x, y] = match gear.turns[wheel] {
        WheelTurn::End(end) => {
            let [from, to] = [gear.centres[wheel], end].map(|point| shown.point_at(point, row));
            [to[0] - from[0], to[1] - from[1]]
        }
        WheelTurn::Direction(direction) => {
            let [x, y, _] = shown.way(direction, row);
            [x, y]
        }
        WheelTurn::Fixed => [1.0, 0.0],
    };
    y.atan2(x)
}
