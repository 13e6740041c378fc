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

impl Sheet<'_> {
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
