//! Bodies and links of a robot that moves in a plane, behind its loops.

use super::model::Motion;
use super::planar::Writer;
use super::wording::digits;
use crate::placement::dot;

impl Writer<'_, '_> {
    /// The points of each link.
    pub(super) fn links(&mut self) {
        let robot = self.wording.chain.robot;
        let mut links: Vec<Vec<(String, [f64; 2])>> = vec![Vec::new(); robot.bodies.len()];
        let joints = robot.bodies.iter().enumerate();
        let joints = joints.filter_map(|(body, of_body)| Some((body, of_body.joint.as_ref()?.at)));
        let closures = robot.closures.iter();
        let ends =
            closures.flat_map(|closure| [0, 1].map(|end| (closure.bodies[end], closure.at[end])));
        self.sections.drawn = joints.chain(ends).collect();
        for (index, body) in robot.bodies.iter().enumerate() {
            let Some(joint) = &body.joint else {
                continue;
            };
            let point = (
                self.wording.pivots[index].clone(),
                self.plane.coordinates(joint.at),
            );
            if !matches!(joint.motion, Motion::Slide(_)) {
                links[joint.parent].push(point.clone());
            }
            links[index].push(point);
        }
        let lets = self.sections.lets.clone();
        for (closure, body, end) in robot
            .closures
            .iter()
            .flat_map(|closure| [0, 1].map(|end| (closure, closure.bodies[end], end)))
        {
            // The names of the ends are those of the lets.
            let text = self.carried(body, closure.at[end], "end");
            let of_let = lets.iter().find_map(|line| {
                let (name, value) = line.strip_prefix("let ")?.split_once(" = ")?;
                (value == format!("{text};")).then(|| name.to_owned())
            });
            if let Some(name) = of_let {
                links[body].push((name, self.plane.coordinates(closure.at[end])));
            }
        }
        for points in links.iter().skip(1) {
            let mut distinct: Vec<&(String, [f64; 2])> = Vec::new();
            for point in points {
                let is_new = distinct.iter().all(|other| {
                    (other.1[0] - point.1[0]).hypot(other.1[1] - point.1[1])
                        > 1e-9 * self.wording.chain.size
                });
                if is_new {
                    distinct.push(point);
                }
            }
            if distinct.len() > 1 {
                let names = distinct.iter().map(|point| point.0.clone()).collect();
                self.sections.links.push(names);
            }
        }
    }

    /// Bodies with their masses, if every body hangs on a joint.
    pub(super) fn masses(&mut self) {
        let robot = self.wording.chain.robot;
        if let Some(gravity) = robot.gravity {
            let [x, y] = self.plane.coordinates(gravity).map(digits);
            self.sections
                .bodies
                .push(format!("gravity = ({x}m/s^2, {y}m/s^2);"));
        }
        let joints = robot.bodies.iter().filter_map(|body| body.joint.as_ref());
        if joints.clone().any(|joint| joint.motion == Motion::Free) {
            self.sections
                .warnings
                .push("masses are left out, because a body floats".to_owned());
            return;
        }
        for (index, body) in robot.bodies.iter().enumerate() {
            let Some(joint) = &body.joint else {
                continue;
            };
            let on = &self.wording.bodies[joint.parent];
            let pivot = &self.wording.pivots[index];
            let name = self.wording.joint_name(index);
            let kind = match joint.motion {
                Motion::Hinge(_) | Motion::Ball | Motion::Free => {
                    format!("pin{name} on {on} at {pivot}, turns {}", self.turn(index))
                }
                Motion::Slide(axis) => {
                    let direction = self.wording.direction(&self.plane.coordinates(axis));
                    let along = self.turned(joint.parent, &direction);
                    format!("slide{name} on {on} at {pivot} along {along}")
                }
                Motion::Fixed => format!("fixed{name} on {on} at {pivot}"),
            };
            let mut line = format!("body {} = {kind}", self.wording.bodies[index]);
            if let Some(mass) = body.mass() {
                let centre = self.carried(index, mass.centre, "centre");
                let n = self.plane.normal;
                let inertia = dot(n, mass.inertia.map(|row| dot(row, n)));
                line += &format!(", mass {}kg at {centre}", digits(mass.mass));
                if inertia > 0.0 {
                    line += &format!(", inertia {}kg*m^2", digits(inertia));
                }
            }
            self.sections.bodies.push(line + ";");
        }
        self.sections.bodies.append(&mut self.closing_joints);
    }
}
