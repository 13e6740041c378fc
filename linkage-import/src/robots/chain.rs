//! The coordinates of a robot's joints, and the positions of its bodies.

use super::model::{Closure, Motion, Robot};
use super::motion_plane::Plane;
use super::rod_bodies::{Rod, rods};
use crate::placement::{AXES, FIXED, Placement, Vector, cross, difference, scaled, sum, unit};

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
    /// For each body, the bodies that it hangs on, itself included.
    carriers: Vec<Vec<bool>>,
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
            carriers: carriers(robot),
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
    pub(super) fn led_by(&self, pose: &Pose, body: usize) -> (usize, f64) {
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

    /// The nearest body that carries both ends of a closure by hinges and slides alone, else the
    /// fixed one. In the plane, it is the fixed one.
    pub(super) fn common_carrier(&self, closure: &Closure) -> usize {
        let joint = |body: usize| self.robot.bodies[body].joint.as_ref();
        let parent = |body: &usize| joint(*body).map(|joint| joint.parent);
        let [a, b] = closure.bodies;
        let mut carriers = std::iter::successors(Some(a), parent);
        let common = carriers
            .find(|carrier| self.carriers[b][*carrier])
            .unwrap_or(0);
        let is_seen = |end: usize| {
            std::iter::successors(Some(end), parent)
                .take_while(|body| *body != common)
                .all(|body| {
                    joint(body).is_some_and(|joint| match joint.motion {
                        Motion::Hinge(_) | Motion::Slide(_) | Motion::Fixed => true,
                        Motion::Ball | Motion::Free => false,
                    })
                })
        };
        match self.plane.is_none() && is_seen(a) && is_seen(b) {
            true => common,
            false => 0,
        }
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
    pub(super) fn velocity(
        &self,
        pose: &Pose,
        coordinate: &Coordinate,
        body: usize,
        point: Vector,
    ) -> Option<[Vector; 2]> {
        if !self.carriers[body][coordinate.body] {
            return None;
        }
        let joint = self.robot.bodies[coordinate.body].joint.as_ref()?;
        let placed = &pose.bodies[coordinate.body];
        let turn = placed.direction(coordinate.turn);
        let arm = difference(point, placed.point(joint.at));
        let shift = placed.direction(coordinate.shift);
        Some([sum(shift, cross(turn, arm)), turn])
    }
}

/// Returns for each body the bodies that it hangs on. A parent is not always before its children.
fn carriers(robot: &Robot) -> Vec<Vec<bool>> {
    let parent = |body: &usize| {
        let joint = robot.bodies[*body].joint.as_ref();
        joint.map(|joint| joint.parent)
    };
    let count = robot.bodies.len();
    let of_body = |body: usize| {
        let mut carries = vec![false; count];
        for carrier in std::iter::successors(Some(body), parent) {
            carries[carrier] = true;
        }
        carries
    };
    (0..count).map(of_body).collect()
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
