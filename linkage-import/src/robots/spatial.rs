//! The text of a robot that moves in space.

use std::collections::BTreeMap;

use super::model::{ClosingJoint, Motion};
use super::placement::{AXES, Vector, difference, length, normals};
use super::wording::{Sections, Wording};

/// The text of a mechanism of space that is being written.
pub(super) struct Writer<'w, 'c> {
    pub(super) wording: &'w mut Wording<'c>,
    pub(super) sections: Sections,
    /// Parameters by bodies and what they lead to.
    offsets: Vec<(usize, Vector, String)>,
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
        offsets: Vec::new(),
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

    /// A vector that is turned as a body is.
    fn turned(&self, body: usize, vector: String, is_length: bool) -> String {
        let Some(joint) = &self.wording.body(body).joint else {
            return vector;
        };
        let name = &self.wording.joints[body];
        match joint.motion {
            Motion::Hinge(axis) => {
                let axis = self.wording.direction(&axis);
                let inner = format!("turn({vector}, {axis}, {name})");
                self.turned(joint.parent, inner, is_length)
            }
            Motion::Slide(_) | Motion::Fixed => self.turned(joint.parent, vector, is_length),
            Motion::Ball | Motion::Free => match is_length {
                true => format!("(point_in({name}, {vector}) - {name}.origin)"),
                false => format!("((point_in({name}, 1m * {vector}) - {name}.origin) / 1m)"),
            },
        }
    }

    /// A direction of a body from where it is drawn.
    pub(super) fn direction(&self, body: usize, direction: Vector) -> String {
        self.turned(body, self.wording.direction(&direction), false)
    }

    /// A point of a body from where it is drawn.
    pub(super) fn carried(&mut self, body: usize, at: Vector, what: &str) -> String {
        let Some(joint) = &self.wording.body(body).joint else {
            return self.wording.point(&at);
        };
        let offset = difference(at, joint.at);
        let name = self.wording.pivots[body].clone();
        if length(offset) < 1e-12 * self.wording.chain.size {
            return name;
        }
        let same = |known: &&(usize, Vector, String)| known.0 == body && known.1 == offset;
        let known = self.offsets.iter().find(same).map(|known| known.2.clone());
        let offset_name = known.unwrap_or_else(|| {
            let wanted = format!("{}_{what}", self.wording.bodies[body]);
            let unique = self.wording.names.unique(&wanted, "of_");
            let value = self.wording.point(&offset);
            self.sections
                .parameters
                .push(format!("param {unique} = {value};"));
            self.offsets.push((body, offset, unique.clone()));
            unique
        });
        format!("{name} + {}", self.turned(body, offset_name, true))
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
        let bodies = match joint.motion {
            Motion::Slide(_) => vec![body],
            Motion::Hinge(_) | Motion::Ball | Motion::Free | Motion::Fixed => {
                vec![body, joint.parent]
            }
        };
        self.sections.point(pivot, bodies, joint.at);
    }

    fn closure(&mut self, index: usize) {
        let closure = &self.wording.chain.robot.closures[index];
        let name = self.wording.names.unique(&closure.name, "loop_");
        let rods = self.wording.chain.rods.iter();
        let rod = rods.copied().find(|rod| rod.closure == index);
        if let Some(rod) = rod {
            let [first, second] = rod.ends;
            let first = self.carried(first.0, first.1, &name);
            let second = self.carried(second.0, second.1, &name);
            let wanted = format!("{}_length", self.wording.bodies[rod.body]);
            let long = self.wording.names.unique(&wanted, "rod_");
            let value = self.wording.metres(rod.length);
            self.sections
                .parameters
                .push(format!("param {long} = {value};"));
            let end = self.wording.names.unique(&format!("{name}_end"), "loop_");
            self.sections.lets.push(format!("let {end} = {second};"));
            let texts = [(Vec::new(), [format!("distance({first}, {end})"), long])];
            self.wording.equations(index, &texts, &mut self.sections);
            self.wording.gap(index, &mut self.sections);
            let [rod_name, other] =
                [rod.body, rod.ends[1].0].map(|body| self.wording.bodies[body].clone());
            self.closing_joints
                .push(format!("ball {name} = {rod_name} on {other} at {end};"));
            self.rod_ends.insert(rod.body, end.clone());
            let (body, at) = rod.ends[1];
            self.sections.point(end, vec![body], at);
            return;
        }
        let [a, b] = closure.bodies;
        let [first, second] = [0, 1].map(|end| {
            let text = self.carried(closure.bodies[end], closure.at[end], &name);
            let wanted = format!("{name}_{}", ["a", "b"][end]);
            let point = self.wording.names.unique(&wanted, "loop_");
            self.sections.lets.push(format!("let {point} = {text};"));
            point
        });
        let components = ["x", "y", "z"].map(ToOwned::to_owned).to_vec();
        let together = (components, [first.clone(), second.clone()]);
        let right_angle = |one: Vector, other: Vector| {
            let text = format!(
                "dot({}, {})",
                self.direction(a, one),
                self.direction(b, other)
            );
            (Vec::new(), [text, "0".to_owned()])
        };
        // About x, y and z.
        let turns = [0, 1, 2].map(|k| right_angle(AXES[(k + 1) % 3], AXES[(k + 2) % 3]));
        let (kind, clause) = match closure.closing {
            ClosingJoint::Point => ("ball", String::new()),
            ClosingJoint::Weld => ("fixed", String::new()),
            ClosingJoint::Hinge(axis) => ("pin", format!(" about {}", self.direction(a, axis))),
            ClosingJoint::Slide(axis) => ("slide", format!(" along {}", self.direction(b, axis))),
        };
        let texts = match closure.closing {
            ClosingJoint::Point => vec![together],
            ClosingJoint::Weld => [vec![together], turns.to_vec()].concat(),
            ClosingJoint::Hinge(axis) => {
                let across = normals(axis).map(|normal| right_angle(axis, normal));
                [vec![together], across.to_vec()].concat()
            }
            ClosingJoint::Slide(axis) => {
                let across = normals(axis).map(|normal| {
                    let normal = self.direction(b, normal);
                    let off = format!("dot({first} - {second}, {normal})");
                    (Vec::new(), [off, "0m".to_owned()])
                });
                [across.to_vec(), turns.to_vec()].concat()
            }
        };
        self.wording.equations(index, &texts, &mut self.sections);
        self.wording.gap(index, &mut self.sections);
        // The fixed body cannot be the first one.
        let [one, other] = [a.max(b), a.min(b)].map(|body| self.wording.bodies[body].clone());
        self.closing_joints.push(format!(
            "{kind} {name} = {one} on {other} at {second}{clause};"
        ));
        self.sections
            .point(first, vec![closure.bodies[0]], closure.at[0]);
    }
}
