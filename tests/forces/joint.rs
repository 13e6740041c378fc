//! Joints by what they transmit.

use super::Vector;

/// A joint: the directions of the forces and couples that it can transmit.
#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) body: usize,
    pub(crate) on: Option<usize>,
    pub(crate) point: Vector,
    pub(crate) forces: Vec<Vector>,
    pub(crate) couples: Vec<Vector>,
    /// A drive holds the motion along or about this direction; `true` for a force.
    pub(crate) drive: Option<(bool, Vector)>,
}

/// Which motions a joint leaves open.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    Fixed,
    /// About an axis.
    Pin(Vector),
    /// Along a direction.
    Slide(Vector),
    Cylinder(Vector),
    /// A pin of the plane that slides along a direction.
    Roller(Vector),
    Ball,
}

impl Kind {
    /// The direction of its drive; `true` for a force.
    pub(crate) fn drive(self) -> Option<(bool, Vector)> {
        match self {
            Kind::Pin(axis) => Some((false, axis.normalize())),
            Kind::Slide(way) | Kind::Roller(way) => Some((true, way.normalize())),
            Kind::Fixed | Kind::Cylinder(_) | Kind::Ball => None,
        }
    }
}

impl Joint {
    pub(crate) fn new(
        kind: Kind,
        (body, on): (usize, Option<usize>),
        point: Vector,
        plane: bool,
    ) -> Self {
        let (mut forces, mut couples) = match kind {
            Kind::Fixed => (all(), all()),
            Kind::Pin(axis) => (all(), across(axis)),
            Kind::Slide(way) => (across(way), all()),
            Kind::Cylinder(axis) => (across(axis), across(axis)),
            Kind::Roller(way) => (across(way), Vec::new()),
            Kind::Ball => (all(), Vec::new()),
        };
        if plane {
            forces.retain(|v| v.z.abs() < 0.5);
            couples.retain(|v| v.z.abs() > 0.5);
        }
        Self {
            body,
            on,
            point,
            forces,
            couples,
            drive: None,
        }
    }

    /// Force and moment about the origin for each unknown, in newtons: couples act on a lever of the typical length.
    pub(crate) fn wrenches(&self, length: f64) -> Vec<[Vector; 2]> {
        let force = |v: &Vector| [*v, self.point.cross(v)];
        let couple = |v: &Vector| [Vector::zeros(), v * length];
        let forces = self.forces.iter().map(force);
        let couples = self.couples.iter().map(couple);
        let drive = self.drive.iter().map(|(is_force, v)| match is_force {
            true => force(v),
            false => couple(v),
        });
        forces.chain(couples).chain(drive).collect()
    }
}

fn all() -> Vec<Vector> {
    vec![Vector::x(), Vector::y(), Vector::z()]
}

/// Two directions at right angles to one and to each other. For one in the plane, one of them is in the plane.
fn across(way: Vector) -> Vec<Vector> {
    let way = way.normalize();
    if way.z.abs() > 0.9 {
        let first = way.cross(&Vector::x()).normalize();
        return vec![first, way.cross(&first)];
    }
    let first = way.cross(&Vector::z()).normalize();
    vec![first, way.cross(&first)]
}
