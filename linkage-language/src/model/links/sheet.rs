//! All that the items are written from.

use super::drawing::Drawing;
use super::linkage::Linkage;
use super::order::Plan;
use super::rigid_bodies::Bodies;

pub(super) struct Sheet<'a> {
    pub(super) linkage: &'a Linkage<'a>,
    pub(super) bodies: &'a Bodies,
    pub(super) drawing: &'a Drawing,
    pub(super) plan: &'a Plan,
}

/// Lengths in metres below this part of the largest coordinate are none.
const NONE: f64 = 1e-9;

impl Sheet<'_> {
    /// Returns the largest coordinate of all joints.
    pub(super) fn size(&self) -> f64 {
        let positions = self.drawing.positions.iter().flatten();
        let coordinates = positions.filter_map(|position| self.drawing.coordinates(position));
        coordinates
            .flatten()
            .fold(0.0, |size, coordinate| size.max(coordinate.abs()))
    }

    /// Returns true if two joints are drawn at one point.
    pub(super) fn are_at_one_place(&self, first: usize, second: usize) -> bool {
        let distance = self.drawing.distance(first, second);
        distance.is_some_and(|length| length <= NONE * self.size())
    }

    /// Returns true if the angle of a link follows from that of another wheel, or gives it.
    pub(super) fn turns_by_wheels(&self, link: usize) -> bool {
        let body = self.bodies.of_link[link];
        let mut wheels = self.linkage.wheels.iter();
        wheels.any(|pair| {
            let mut bodies = pair.wheels.iter().map(|link| self.bodies.of_link[*link]);
            bodies.any(|other| other == body)
        })
    }
}
