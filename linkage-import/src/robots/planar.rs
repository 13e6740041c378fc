//! The text of a robot that moves in a plane.

use super::model::{ClosingJoint, Joint, Motion};
use super::motion_plane::Plane;
use super::placement::{Vector, cross, dot};
use super::wording::{Sections, Wording, digits};

/// The text of a plane mechanism that is being written.
struct Writer<'w, 'c> {
    wording: &'w mut Wording<'c>,
    plane: Plane,
    /// The angle of each body; none for bodies that do not turn.
    turns: Vec<Option<String>>,
    sections: Sections,
    /// Parameters by bodies and what they lead to.
    offsets: Vec<(usize, [f64; 2], String)>,
    /// The joints that close loops, between bodies.
    closing_pins: Vec<String>,
}

/// Writes the mechanism.
pub(super) fn sections(wording: &mut Wording, plane: Plane) -> Sections {
    let count = wording.chain.robot.bodies.len();
    let mut writer = Writer {
        wording,
        plane,
        turns: vec![None; count],
        sections: Sections::default(),
        offsets: Vec::new(),
        closing_pins: Vec::new(),
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
    fn turn(&self, body: usize) -> String {
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
    fn turned(&self, body: usize, vector: &str) -> String {
        match &self.turns[body] {
            Some(turn) => format!("rotate({vector}, {turn})"),
            None => vector.to_owned(),
        }
    }

    /// A point of a body from where it is drawn. `what` is the end of the name of its offset.
    fn carried(&mut self, body: usize, at: Vector, what: &str) -> String {
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
        let same = |known: &&(usize, [f64; 2], String)| known.0 == body && known.1 == offset;
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
        let bodies = match joint.motion {
            Motion::Slide(_) => vec![body],
            Motion::Hinge(_) | Motion::Ball | Motion::Free | Motion::Fixed => {
                vec![body, joint.parent]
            }
        };
        self.sections.point(pivot, bodies, joint.at);
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
                let wanted = format!("{name}_{}", ["a", "b"][end]);
                let point = self.wording.names.unique(&wanted, "loop_");
                self.sections.lets.push(format!("let {point} = {text};"));
                point
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
            // A pin that follows from the others would have no certain force.
            let is_pin = matches!(
                closure.closing,
                ClosingJoint::Point | ClosingJoint::Hinge(_)
            );
            if is_pin && has_all {
                self.closing_pin(&name, closure.bodies, &first);
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

    /// Adds the pin that closes a loop. Fixed bodies come second.
    fn closing_pin(&mut self, name: &str, [a, b]: [usize; 2], point: &str) {
        let is_body = self.wording.bodies.iter().any(|body| body == name);
        let name = match is_body {
            true => self.wording.names.unique(&format!("{name}_pin"), "pin_"),
            false => name.to_owned(),
        };
        let [first, second] = [a.max(b), a.min(b)].map(|body| &self.wording.bodies[body]);
        self.closing_pins
            .push(format!("pin {name} = {first} on {second} at {point};"));
    }

    /// The points of each link.
    fn links(&mut self) {
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
    fn masses(&mut self) {
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
            let kind = match joint.motion {
                Motion::Hinge(_) | Motion::Ball | Motion::Free => {
                    format!("pin on {on} at {pivot}, turns {}", self.turn(index))
                }
                Motion::Slide(axis) => {
                    let direction = self.wording.direction(&self.plane.coordinates(axis));
                    let along = self.turned(joint.parent, &direction);
                    format!("slide on {on} at {pivot} along {along}")
                }
                Motion::Fixed => format!("fixed on {on} at {pivot}"),
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
        self.sections.bodies.append(&mut self.closing_pins);
    }
}
