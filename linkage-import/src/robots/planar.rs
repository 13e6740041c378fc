//! The text of a robot that moves in a plane.

use super::model::{ClosingJoint, Closure, Joint, Motion};
use super::motion_plane::Plane;
use super::offsets::Offsets;
use super::wording::{Sections, Wording};
use crate::placement::{Vector, cross};

/// The text of a plane mechanism that is being written.
pub(super) struct Writer<'w, 'c> {
    pub(super) wording: &'w mut Wording<'c>,
    pub(super) plane: Plane,
    /// The angle of each body; none for bodies that do not turn.
    pub(super) turns: Vec<Option<String>>,
    pub(super) sections: Sections,
    offsets: Offsets<2>,
    /// The joints that close loops, between bodies.
    pub(super) closing_joints: Vec<String>,
}

/// Writes the mechanism.
pub(super) fn sections(wording: &mut Wording, plane: Plane) -> Sections {
    let count = wording.chain.robot.bodies.len();
    let mut writer = Writer {
        wording,
        plane,
        turns: vec![None; count],
        sections: Sections::default(),
        offsets: Offsets::default(),
        closing_joints: Vec::new(),
    };
    writer.wording.inputs(&mut writer.sections);
    writer.sections.lets = writer.wording.lets_of_followers();
    for body in 1..count {
        writer.body(body);
    }
    writer.closures();
    writer.links();
    writer.masses();
    writer.sections
}

impl Writer<'_, '_> {
    pub(super) fn turn(&self, body: usize) -> String {
        self.turns[body]
            .clone()
            .unwrap_or_else(|| "0deg".to_owned())
    }

    /// True if another joint follows that of a body.
    fn leads(&self, body: usize) -> bool {
        let bodies = self.wording.chain.robot.bodies.iter();
        let mut followed = bodies.filter_map(|other| other.joint.as_ref()?.follows.as_ref());
        followed.any(|(leader, _)| *leader == body)
    }

    fn is_positive(&self, joint: &Joint) -> bool {
        match joint.motion {
            Motion::Hinge(axis) => self.plane.is_positive(axis),
            Motion::Slide(_) | Motion::Ball | Motion::Free | Motion::Fixed => true,
        }
    }

    /// The point or the direction of a body: turned with it.
    pub(super) fn turned(&self, body: usize, vector: &str) -> String {
        match &self.turns[body] {
            Some(turn) => format!("rotate({vector}, {turn})"),
            None => vector.to_owned(),
        }
    }

    /// A point of a body from where it is drawn. `what` is the end of the name of its offset.
    pub(super) fn carried(&mut self, body: usize, at: Vector, what: &str) -> String {
        let drawn = self.plane.coordinates(at);
        let Some(joint) = &self.wording.body(body).joint else {
            return self.wording.point(&drawn);
        };
        let pivot = self.plane.coordinates(joint.at);
        let offset = [drawn[0] - pivot[0], drawn[1] - pivot[1]];
        let name = self.wording.pivots[body].clone();
        if offset[0].hypot(offset[1]) < 1e-12 * self.wording.chain.size {
            return name;
        }
        let offset_name =
            self.offsets
                .parameter(self.wording, &mut self.sections, (body, offset), what);
        format!("{name} + {}", self.turned(body, &offset_name))
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
        let on = self.turns[joint.parent].clone();
        match joint.motion {
            Motion::Hinge(_) | Motion::Ball => {
                self.sections.lets.push(format!("let {pivot} = {at};"));
                let wanted = format!("turn_{}", self.wording.bodies[body]);
                let turn = self.wording.names.unique(&wanted, "turn_");
                // A joint that others follow is an unknown itself, else the angle of its body.
                let is_leader = self.leads(body);
                if is_leader && !is_given {
                    self.sections
                        .unknowns
                        .push(format!("unknown {name} = 0deg;"));
                }
                if is_given || is_leader {
                    let sign = if self.is_positive(&joint) { "+" } else { "-" };
                    let text = match (&on, sign) {
                        (None, "+") => name,
                        (None, _) => format!("-{name}"),
                        (Some(on), sign) => format!("{on} {sign} {name}"),
                    };
                    self.sections.lets.push(format!("let {turn} = {text};"));
                } else {
                    self.sections
                        .unknowns
                        .push(format!("unknown {turn} = 0deg;    // joint {name}"));
                }
                self.turns[body] = Some(turn);
            }
            Motion::Slide(axis) => {
                let direction = self.wording.direction(&self.plane.coordinates(axis));
                let along = self.turned(joint.parent, &direction);
                if !is_given {
                    self.sections.unknowns.push(format!("unknown {name} = 0m;"));
                }
                self.sections
                    .lets
                    .push(format!("let {pivot} = {at} + {name} * {along};"));
                self.turns[body] = on;
            }
            Motion::Fixed => {
                self.sections.lets.push(format!("let {pivot} = {at};"));
                self.turns[body] = on;
            }
            Motion::Free => {
                let drawn = self.wording.point(&self.plane.coordinates(joint.at));
                self.sections
                    .unknowns
                    .push(format!("unknown {name} = frame({drawn}, (1, 0));"));
                self.sections
                    .lets
                    .push(format!("let {pivot} = {name}.origin;"));
                self.turns[body] = Some(format!("{name}.angle"));
            }
        }
        self.sections.point(pivot, joint.bodies(body), joint.at);
        if let Some(turn) = &self.turns[body]
            && !turn.contains('.')
            && !self.sections.quantities.contains(turn)
        {
            self.sections.quantities.push(turn.clone());
        }
    }

    fn closures(&mut self) {
        for (index, closure) in self.wording.chain.robot.closures.iter().enumerate() {
            let name = self.wording.names.unique(&closure.name, "loop_");
            let [a, b] = closure.bodies;
            let [first, second] = [0, 1].map(|end| {
                let text = self.carried(closure.bodies[end], closure.at[end], &name);
                self.wording
                    .closing_point(&name, end, &text, &mut self.sections)
            });
            let ends = [first.clone(), second.clone()];
            let components = vec!["x".to_owned(), "y".to_owned()];
            let turns = (Vec::new(), [self.turn(a), self.turn(b)]);
            let texts = match closure.closing {
                ClosingJoint::Point | ClosingJoint::Hinge(_) => vec![(components, ends)],
                ClosingJoint::Weld => vec![(components, ends), turns],
                ClosingJoint::Slide(axis) => {
                    let normal = self.plane.coordinates(cross(self.plane.normal, axis));
                    let normal = self.turned(b, &self.wording.direction(&normal));
                    let off = format!("dot({first} - {second}, {normal})");
                    vec![(Vec::new(), [off, "0m".to_owned()]), turns]
                }
            };
            let has_all = self.wording.equations(index, &texts, &mut self.sections);
            // A joint of which equations follow from others would have no certain force.
            if has_all {
                self.closing_joint(&name, closure, &first);
            }
            self.wording.gap(index, &mut self.sections);
            if closure.closing == ClosingJoint::Point || closure.closing == ClosingJoint::Weld {
                self.sections.warnings.push(format!(
                    "the loop `{}` holds in space; in the plane its other equations are too many and are left out",
                    crate::names::shown(&closure.name)
                ));
            }
            self.sections
                .point(first, vec![closure.bodies[0]], closure.at[0]);
        }
    }

    /// Adds the joint of the mechanics that closes a loop. Fixed bodies come second.
    fn closing_joint(&mut self, name: &str, closure: &Closure, point: &str) {
        let [a, b] = closure.bodies;
        let (kind, clause) = match closure.closing {
            ClosingJoint::Point | ClosingJoint::Hinge(_) => ("pin", String::new()),
            ClosingJoint::Slide(axis) => {
                let axis = self.wording.direction(&self.plane.coordinates(axis));
                ("slide", format!(" along {}", self.turned(b, &axis)))
            }
            ClosingJoint::Weld => ("fixed", String::new()),
        };
        let is_body = self.wording.bodies.iter().any(|body| body == name);
        let name = match is_body {
            true => self
                .wording
                .names
                .unique(&format!("{name}_{kind}"), "joint_"),
            false => name.to_owned(),
        };
        let [first, second] = [a.max(b), a.min(b)].map(|body| &self.wording.bodies[body]);
        self.closing_joints.push(format!(
            "{kind} {name} = {first} on {second} at {point}{clause};"
        ));
    }
}
