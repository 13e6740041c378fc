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
    Ball,
}

impl Joint {
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
