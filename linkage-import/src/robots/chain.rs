//! The equations of a robot's loops, and their derivatives with respect to the joints.

use super::model::{ClosingJoint, Closure, Motion, Robot};
use super::motion_plane::Plane;
use super::placement::{
    AXES, FIXED, Placement, Vector, cross, difference, dot, length, normals, scaled, sum, unit,
};
use super::rod_bodies::{Rod, rods};

/// A number of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Coordinate {
    pub(super) body: usize,
    /// Rotation about the joint's point, where it is drawn.
    turn: Vector,
    /// Shift.
    shift: Vector,
    /// True for a hinge or a slide.
    pub(super) is_scalar: bool,
}

/// A robot with its coordinates and equations.
pub(super) struct Chain<'r> {
    pub(super) robot: &'r Robot,
    pub(super) plane: Option<Plane>,
    pub(super) rods: Vec<Rod>,
    pub(super) coordinates: Vec<Coordinate>,
    pub(super) size: f64,
}

/// The position of a robot: the value of each coordinate's joint, or its placement.
#[derive(Clone, Debug)]
pub(super) struct Pose {
    /// Of hinges and slides, by bodies.
    values: Vec<f64>,
    /// Of all joints, in drawn coordinates.
    joints: Vec<Placement>,
    /// From drawn to current positions.
    pub(super) bodies: Vec<Placement>,
}

/// An equation: its error, and the changes by all coordinates.
#[derive(Clone, Debug)]
pub(super) struct Equation {
    /// The closure that it belongs to.
    pub(super) closure: usize,
    pub(super) error: f64,
    pub(super) changes: Vec<f64>,
}

impl<'r> Chain<'r> {
    pub(super) fn new(robot: &'r Robot) -> Self {
        let plane = Plane::of_robot(robot);
        let rods = match plane {
            Some(_) => Vec::new(),
            None => rods(robot),
        };
        let mut chain = Self {
            robot,
            plane,
            rods,
            coordinates: Vec::new(),
            size: robot.size().max(f64::MIN_POSITIVE),
        };
        for body in 1..robot.bodies.len() {
            if !chain.rods.iter().any(|rod| rod.body == body) {
                chain.add_coordinates(body);
            }
        }
        chain
    }

    fn add_coordinates(&mut self, body: usize) {
        let Some(joint) = &self.robot.bodies[body].joint else {
            return;
        };
        let mut add = |turn: Vector, shift: Vector, is_scalar: bool| {
            self.coordinates.push(Coordinate {
                body,
                turn,
                shift,
                is_scalar,
            });
        };
        let none = [0.0; 3];
        match (joint.motion, self.plane) {
            (Motion::Hinge(axis), _) => add(axis, none, true),
            (Motion::Slide(axis), _) => add(none, axis, true),
            (Motion::Fixed, _) => {}
            (Motion::Ball, Some(plane)) => add(plane.normal, none, true),
            (Motion::Ball, None) => AXES.into_iter().for_each(|axis| add(axis, none, false)),
            (Motion::Free, plane) => {
                let (turns, shifts) = match plane {
                    Some(plane) => (vec![plane.normal], plane.axes.to_vec()),
                    None => (AXES.to_vec(), AXES.to_vec()),
                };
                turns.into_iter().for_each(|axis| add(axis, none, false));
                shifts.into_iter().for_each(|axis| add(none, axis, false));
            }
        }
    }

    /// The drawn position, with joints that follow others where these put them.
    pub(super) fn drawn(&self) -> Pose {
        let count = self.robot.bodies.len();
        let mut pose = Pose {
            values: vec![0.0; count],
            joints: vec![FIXED; count],
            bodies: vec![FIXED; count],
        };
        self.settle(&mut pose);
        pose
    }

    /// Moves joints that follow others, and places all bodies.
    fn settle(&self, pose: &mut Pose) {
        for body in 1..self.robot.bodies.len() {
            pose.values[body] = self.value(pose, body);
        }
        for body in 1..self.robot.bodies.len() {
            let Some(joint) = &self.robot.bodies[body].joint else {
                continue;
            };
            let first = self.coordinates.iter().find(|c| c.body == body);
            if let Some(coordinate) = first.filter(|coordinate| coordinate.is_scalar) {
                pose.joints[body] = moved(joint.at, coordinate, pose.values[body]);
            }
            pose.bodies[body] = pose.bodies[joint.parent].then(&pose.joints[body]);
        }
    }

    /// The value of a joint, or of the one that it follows.
    fn value(&self, pose: &Pose, body: usize) -> f64 {
        let joint = self.robot.bodies[body].joint.as_ref();
        match joint.and_then(|joint| joint.follows.as_ref()) {
            Some((leader, powers)) => {
                let value = self.value(pose, *leader);
                powers
                    .iter()
                    .rev()
                    .fold(0.0, |sum, power| sum * value + power)
            }
            None => pose.values[body],
        }
    }

    /// The slope of a joint's value with respect to that of the joint that leads it, and that joint.
    fn led_by(&self, pose: &Pose, body: usize) -> (usize, f64) {
        let joint = self.robot.bodies[body].joint.as_ref();
        let Some((leader, powers)) = joint.and_then(|joint| joint.follows.as_ref()) else {
            return (body, 1.0);
        };
        let value = self.value(pose, *leader);
        let terms = powers.iter().enumerate().skip(1).rev();
        let slope = terms.fold(0.0, |sum, (power, coefficient)| {
            sum * value + power as f64 * coefficient
        });
        let (first, outer) = self.led_by(pose, *leader);
        (first, outer * slope)
    }

    /// True for a coordinate of a joint that follows no other.
    pub(super) fn is_independent(&self, coordinate: &Coordinate) -> bool {
        let joint = self.robot.bodies[coordinate.body].joint.as_ref();
        joint.is_some_and(|joint| joint.follows.is_none())
    }

    /// Changes the coordinates, joint by joint from where they are.
    pub(super) fn step(&self, pose: &mut Pose, changes: &[f64]) {
        for (coordinate, change) in self.coordinates.iter().zip(changes) {
            let Some(joint) = &self.robot.bodies[coordinate.body].joint else {
                continue;
            };
            match coordinate.is_scalar {
                true => pose.values[coordinate.body] += change,
                false => {
                    let next = moved(joint.at, coordinate, *change);
                    let placed = &mut pose.joints[coordinate.body];
                    *placed = placed.then(&next);
                }
            }
        }
        self.settle(pose);
    }

    /// The velocity of a point of a body and its angular velocity, for a change of a coordinate.
    fn velocity(
        &self,
        pose: &Pose,
        coordinate: &Coordinate,
        body: usize,
        point: Vector,
    ) -> Option<[Vector; 2]> {
        if !self.robot.hangs_on(body, coordinate.body) {
            return None;
        }
        let joint = self.robot.bodies[coordinate.body].joint.as_ref()?;
        let placed = &pose.bodies[coordinate.body];
        let turn = placed.direction(coordinate.turn);
        let arm = difference(point, placed.point(joint.at));
        let shift = placed.direction(coordinate.shift);
        Some([sum(shift, cross(turn, arm)), turn])
    }

    /// All equations at a position, lengths as parts of the size.
    pub(super) fn rows(&self, pose: &Pose) -> Vec<Equation> {
        let mut rows = Vec::new();
        for (number, closure) in self.robot.closures.iter().enumerate() {
            match self.rods.iter().find(|rod| rod.closure == number) {
                Some(rod) => rows.push(self.rod_row(pose, rod)),
                None => self.closure_rows(pose, number, closure, &mut rows),
            }
        }
        rows
    }

    fn rod_row(&self, pose: &Pose, rod: &Rod) -> Equation {
        let [a, b] = rod.ends;
        let [at_a, at_b] = [a, b].map(|(body, at)| pose.bodies[body].point(at));
        let apart = difference(at_a, at_b);
        let along = unit(apart).unwrap_or(AXES[0]);
        let changes = self.coordinates.iter().map(|coordinate| {
            let part = |body, at| {
                let velocity = self.velocity(pose, coordinate, body, at);
                velocity.map_or(0.0, |[velocity, _]| dot(velocity, along))
            };
            (part(a.0, at_a) - part(b.0, at_b)) / self.size
        });
        Equation {
            closure: rod.closure,
            error: (length(apart) - rod.length) / self.size,
            changes: self.combined(pose, changes.collect()),
        }
    }

    /// Adds the changes of joints that follow others to those of their leaders.
    fn combined(&self, pose: &Pose, mut changes: Vec<f64>) -> Vec<f64> {
        for (index, coordinate) in self.coordinates.iter().enumerate() {
            if self.is_independent(coordinate) {
                continue;
            }
            let (leader, slope) = self.led_by(pose, coordinate.body);
            let change = std::mem::take(&mut changes[index]);
            let led_by = self.coordinates.iter().position(|c| c.body == leader);
            if let Some(leader) = led_by {
                changes[leader] += slope * change;
            }
        }
        changes
    }

    fn closure_rows(
        &self,
        pose: &Pose,
        number: usize,
        closure: &Closure,
        rows: &mut Vec<Equation>,
    ) {
        let [a, b] = closure.bodies;
        let at_a = pose.bodies[a].point(closure.at[0]);
        let at_b = pose.bodies[b].point(closure.at[1]);
        let apart = difference(at_a, at_b);
        let mut shift = |direction: Vector| {
            let changes = self.coordinates.iter().map(|coordinate| {
                let part = |body| {
                    let velocity = self.velocity(pose, coordinate, body, at_a);
                    velocity.map_or(0.0, |[velocity, _]| dot(velocity, direction))
                };
                (part(a) - part(b)) / self.size
            });
            rows.push(Equation {
                closure: number,
                error: dot(apart, direction) / self.size,
                changes: self.combined(pose, changes.collect()),
            });
        };
        match (closure.closing, self.plane) {
            (ClosingJoint::Slide(axis), Some(plane)) => {
                shift(pose.bodies[b].direction(cross(plane.normal, axis)));
            }
            (ClosingJoint::Slide(axis), None) => normals(axis)
                .into_iter()
                .for_each(|normal| shift(pose.bodies[b].direction(normal))),
            (_, Some(plane)) => plane.axes.into_iter().for_each(shift),
            (_, None) => AXES.into_iter().for_each(shift),
        }
        for (axis, error) in self.turns(pose, closure) {
            let changes = self.coordinates.iter().map(|coordinate| {
                let part = |body| {
                    let velocity = self.velocity(pose, coordinate, body, at_a);
                    velocity.map_or(0.0, |[_, turn]| dot(turn, axis))
                };
                part(a) - part(b)
            });
            rows.push(Equation {
                closure: number,
                error,
                changes: self.combined(pose, changes.collect()),
            });
        }
    }

    /// The directions about which a closure turns nothing, with its error about each.
    fn turns(&self, pose: &Pose, closure: &Closure) -> Vec<(Vector, f64)> {
        let [a, b] = closure.bodies.map(|body| pose.bodies[body]);
        let relative = a.then(&b.inverse());
        let error = |axis: Vector| {
            // Half of the antisymmetric part.
            let sum = AXES.iter().fold([0.0; 3], |total, near| {
                sum(total, cross(*near, relative.direction(*near)))
            });
            0.5 * dot(sum, axis)
        };
        match (closure.closing, self.plane) {
            (ClosingJoint::Point, _) | (ClosingJoint::Hinge(_), Some(_)) => Vec::new(),
            (ClosingJoint::Hinge(axis), None) => {
                let along = a.direction(axis);
                normals(axis)
                    .map(|normal| {
                        let normal = b.direction(normal);
                        (cross(along, normal), dot(along, normal))
                    })
                    .to_vec()
            }
            (ClosingJoint::Slide(_) | ClosingJoint::Weld, Some(plane)) => {
                vec![(plane.normal, error(plane.normal))]
            }
            (ClosingJoint::Slide(_) | ClosingJoint::Weld, None) => {
                AXES.map(|axis| (axis, error(axis))).to_vec()
            }
        }
    }
}

/// A joint that moves by a value from where it is drawn.
fn moved(at: Vector, coordinate: &Coordinate, value: f64) -> Placement {
    let turned = match unit(coordinate.turn) {
        Some(axis) => Placement::turned(axis, value),
        None => FIXED,
    };
    Placement::shifted(sum(at, scaled(coordinate.shift, value)))
        .then(&turned)
        .then(&Placement::shifted(scaled(at, -1.0)))
}
