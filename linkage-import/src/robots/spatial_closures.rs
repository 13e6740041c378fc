//! Loops of a robot that moves in space.
//!
//! A loop is seen from the nearest body that carries both of its ends, so that joints below this
//! body are in no equation.

use super::model::{ClosingJoint, Motion};
use super::spatial::Writer;
use crate::placement::{AXES, Vector, difference, normals};

impl Writer<'_, '_> {
    /// A point of a body, seen from a body that carries it by hinges and slides: from its pivot.
    fn point_on(&mut self, base: usize, body: usize, at: Vector, what: &str) -> String {
        let Some(joint) = self.wording.body(body).joint.clone() else {
            return self.wording.point(&at);
        };
        let offset = self.offset(body, difference(at, joint.at), what);
        if body == base {
            return offset.unwrap_or_else(|| self.wording.point(&[0.0; 3]));
        }
        let name = self.wording.joints[body].clone();
        let mut text = self.point_on(base, joint.parent, joint.at, &name);
        if let Motion::Slide(axis) = joint.motion {
            let along = self.direction_on(base, joint.parent, axis);
            text = format!("{text} + {name} * {along}");
        }
        match offset {
            Some(offset) => format!("{text} + {}", self.turned(base, body, offset, true)),
            None => text,
        }
    }

    /// Adds the loop of a closing joint.
    pub(super) fn closure(&mut self, index: usize) {
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
            self.wording
                .closing_point(&name, end, &text, &mut self.sections)
        });
        let base = self.wording.chain.common_carrier(closure);
        let ends = [0, 1].map(|end| match base {
            0 => [&first, &second][end].clone(),
            _ => {
                let text = self.point_on(base, closure.bodies[end], closure.at[end], &name);
                let seen = format!(
                    "{name}_{}_on_{}",
                    ["a", "b"][end],
                    self.wording.bodies[base]
                );
                let point = self.wording.names.unique(&seen, "loop_");
                self.sections.lets.push(format!("let {point} = {text};"));
                point
            }
        });
        let components = ["x", "y", "z"].map(ToOwned::to_owned).to_vec();
        let apart = format!("{} - {}", ends[0], ends[1]);
        let together = (components, ends);
        let right_angle = |one: Vector, other: Vector| {
            let text = format!(
                "dot({}, {})",
                self.direction_on(base, a, one),
                self.direction_on(base, b, other)
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
                    let normal = self.direction_on(base, b, normal);
                    let off = format!("dot({apart}, {normal})");
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
