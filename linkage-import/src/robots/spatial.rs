//! The text of a robot that moves in space.

use std::collections::BTreeMap;

use super::model::Motion;
use super::offsets::Offsets;
use super::wording::{Sections, Wording};
use crate::placement::{Vector, difference, length};

/// The text of a mechanism of space that is being written.
pub(super) struct Writer<'w, 'c> {
    pub(super) wording: &'w mut Wording<'c>,
    pub(super) sections: Sections,
    offsets: Offsets<3>,
    /// The far end of each rod, by its body.
    pub(super) rod_ends: BTreeMap<usize, String>,
    /// The joints of the mechanics that close loops.
    pub(super) closing_joints: Vec<String>,
}

/// Writes the mechanism.
pub(super) fn sections(wording: &mut Wording) -> Sections {
    let mut writer = Writer {
        wording,
        sections: Sections::default(),
        offsets: Offsets::default(),
        rod_ends: BTreeMap::new(),
        closing_joints: Vec::new(),
    };
    writer.wording.inputs(&mut writer.sections);
    writer.sections.lets = writer.wording.lets_of_followers();
    for body in 1..writer.wording.chain.robot.bodies.len() {
        writer.body(body);
    }
    for index in 0..writer.wording.chain.robot.closures.len() {
        writer.closure(index);
    }
    writer.masses();
    writer.sections
}

impl Writer<'_, '_> {
    pub(super) fn is_rod(&self, body: usize) -> bool {
        let mut rods = self.wording.chain.rods.iter();
        rods.any(|rod| rod.body == body)
    }

    /// A vector that is turned as a body is, seen from a body that carries it: the first one is fixed.
    pub(super) fn turned(
        &self,
        base: usize,
        body: usize,
        vector: String,
        is_length: bool,
    ) -> String {
        let joint = self.wording.body(body).joint.as_ref();
        let Some(joint) = joint.filter(|_| body != base) else {
            return vector;
        };
        let name = &self.wording.joints[body];
        match joint.motion {
            Motion::Hinge(axis) => {
                let axis = self.wording.direction(&axis);
                let inner = format!("turn({vector}, {axis}, {name})");
                self.turned(base, joint.parent, inner, is_length)
            }
            Motion::Slide(_) | Motion::Fixed => self.turned(base, joint.parent, vector, is_length),
            Motion::Ball | Motion::Free => match is_length {
                true => format!("(point_in({name}, {vector}) - {name}.origin)"),
                false => format!("((point_in({name}, 1m * {vector}) - {name}.origin) / 1m)"),
            },
        }
    }

    /// A direction of a body from where it is drawn.
    pub(super) fn direction(&self, body: usize, direction: Vector) -> String {
        self.direction_on(0, body, direction)
    }

    /// A direction of a body, seen from a body that carries it.
    pub(super) fn direction_on(&self, base: usize, body: usize, direction: Vector) -> String {
        self.turned(base, body, self.wording.direction(&direction), false)
    }

    /// A point of a body from where it is drawn.
    pub(super) fn carried(&mut self, body: usize, at: Vector, what: &str) -> String {
        let Some(joint) = &self.wording.body(body).joint else {
            return self.wording.point(&at);
        };
        let pivot = joint.at;
        let name = self.wording.pivots[body].clone();
        match self.offset(body, difference(at, pivot), what) {
            Some(offset) => format!("{name} + {}", self.turned(0, body, offset, true)),
            None => name,
        }
    }

    /// The parameter of the way from the pivot of a body to a point of the body; none if they are
    /// one.
    pub(super) fn offset(&mut self, body: usize, offset: Vector, what: &str) -> Option<String> {
        if length(offset) < 1e-12 * self.wording.chain.size {
            return None;
        }
        let parameter =
            self.offsets
                .parameter(self.wording, &mut self.sections, (body, offset), what);
        Some(parameter)
    }

    fn body(&mut self, body: usize) {
        let Some(joint) = self.wording.body(body).joint.clone() else {
            return;
        };
        let name = self.wording.joints[body].clone();
        let pivot = self.wording.pivots[body].clone();
        let is_led = joint.follows.is_some();
        let is_given = is_led || self.wording.is_input(body);
        let at = self.carried(joint.parent, joint.at, &name);
        match joint.motion {
            Motion::Hinge(_) => {
                if !is_given {
                    self.sections
                        .unknowns
                        .push(format!("unknown {name} = 0deg;"));
                }
                self.sections.lets.push(format!("let {pivot} = {at};"));
                self.sections.quantities.push(name);
            }
            Motion::Slide(axis) => {
                if !is_given {
                    self.sections.unknowns.push(format!("unknown {name} = 0m;"));
                }
                let along = self.direction(joint.parent, axis);
                self.sections
                    .lets
                    .push(format!("let {pivot} = {at} + {name} * {along};"));
                self.sections.quantities.push(name);
            }
            Motion::Fixed => self.sections.lets.push(format!("let {pivot} = {at};")),
            Motion::Ball if self.is_rod(body) => {
                self.sections.lets.push(format!("let {pivot} = {at};"));
            }
            Motion::Ball | Motion::Free => {
                let drawn = self.wording.point(&joint.at);
                self.sections.unknowns.push(format!(
                    "unknown {name} = frame({drawn}, (1, 0, 0), (0, 0, 1));"
                ));
                self.sections
                    .lets
                    .push(format!("let {pivot} = {name}.origin;"));
                if joint.motion == Motion::Ball {
                    self.sections.loops.push(format!("loop {pivot} = {at};"));
                }
            }
        }
        self.sections.point(pivot, joint.bodies(body), joint.at);
    }
}
