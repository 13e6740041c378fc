//! The declared points, axes and angles as expressions.

use crate::algebra::translate;
use linkage_symbolic::{Graph, Vector, Vn};

use crate::algebra::{Algebra, Scalar, Translate, Value};
use crate::model::{Expr, JointKind};

use super::tree::Tree;

/// What a body turns with.
#[derive(Clone, Debug)]
pub(super) enum Turning<'m> {
    /// As the body that it hangs on.
    Along,
    /// In the plane.
    Angle(Scalar<'m>),
    /// The angle about an axis of the body that it hangs on.
    About(Scalar<'m>, Vn<'m>),
    /// Three axes in space.
    Frame([Vn<'m>; 3]),
    /// A slender rod along a vector; it does not turn about itself.
    Rod(Vn<'m>),
}

#[derive(Clone, Debug, Default)]
pub(super) struct Geometry<'m> {
    /// 2 in the plane, 3 in space.
    pub(super) dimensions: usize,
    /// By body: the points of their own joints.
    pub(super) origins: Vec<Vn<'m>>,
    pub(super) turning: Vec<Turning<'m>>,
    /// By joint.
    pub(super) points: Vec<Vn<'m>>,
    /// By joint: unit vectors along guides and axes.
    pub(super) directions: Vec<Option<Vn<'m>>>,
}

impl<'m> Geometry<'m> {
    /// What is declared, bodies in the order of the tree.
    pub(super) fn new(algebra: &mut Algebra<'m>, tree: &Tree) -> Self {
        let mechanism = algebra.mechanism;
        let joints = mechanism.joints.iter();
        let points: Vec<Vn> = joints
            .clone()
            .map(|joint| vector_of(algebra, &joint.at))
            .collect();
        let dimensions = points.iter().map(Vn::len).max().unwrap_or(2);
        let directions: Vec<Option<Vn>> = joints
            .map(|joint| joint.direction.as_ref().map(|way| unit_of(algebra, way)))
            .collect();
        let mut turning = vec![Turning::Along; mechanism.bodies.len()];
        for &body in &tree.order {
            let own = &mechanism.bodies[body];
            let Some(turns) = &own.turns else { continue };
            turning[body] = match algebra.translate(turns) {
                Value::Array(parts) => {
                    Turning::Frame([1, 2, 3].map(|axis| translate::vector(algebra, &parts[axis])))
                }
                Value::Vector(along) => Turning::Rod(along),
                Value::Scalar(angle) => match directions[own.joint] {
                    Some(axis) if dimensions == 3 => Turning::About(angle, axis),
                    _ => Turning::Angle(angle),
                },
            };
        }
        let bodies = mechanism.bodies.iter();
        Self {
            dimensions,
            origins: bodies.map(|body| points[body.joint]).collect(),
            turning,
            points,
            directions,
        }
    }

    /// True in the plane.
    pub(super) fn is_plane(&self) -> bool {
        self.dimensions == 2
    }

    /// How many components a turn has.
    pub(super) fn turns(&self) -> usize {
        match self.is_plane() {
            true => 1,
            false => 3,
        }
    }

    /// Unit vectors along the axes of coordinates.
    pub(super) fn units(&self, graph: &'m Graph) -> Vec<Vn<'m>> {
        let (one, zero) = (graph.one(), graph.zero());
        let unit = |axis| {
            let components = (0..self.dimensions).map(|k| if k == axis { one } else { zero });
            graph.components(&components.collect::<Vec<_>>())
        };
        (0..self.dimensions).map(unit).collect()
    }

    /// The vector along a slender rod.
    pub(super) fn rod(&self, body: usize) -> Option<Vn<'m>> {
        match self.turning[body] {
            Turning::Rod(along) => Some(along),
            Turning::Along | Turning::Angle(_) | Turning::About(..) | Turning::Frame(_) => None,
        }
    }

    /// The axis about which a body turns with an angle in space.
    pub(super) fn axis(&self, body: usize) -> Option<Vn<'m>> {
        match self.turning[body] {
            Turning::About(_, axis) => Some(axis),
            Turning::Along | Turning::Angle(_) | Turning::Frame(_) | Turning::Rod(_) => None,
        }
    }

    /// The angle of a body in the plane; `None` is the frame.
    pub(super) fn angle(
        &self,
        algebra: &Algebra<'m>,
        tree: &Tree,
        body: Option<usize>,
    ) -> Scalar<'m> {
        let mut next = body;
        while let Some(body) = next {
            if let Turning::Angle(angle) = &self.turning[body] {
                return angle.clone();
            }
            next = tree.parent[body];
        }
        algebra.zero().into()
    }
}

/// A point or vector.
pub(super) fn vector_of<'m>(algebra: &mut Algebra<'m>, expr: &Expr) -> Vn<'m> {
    let value = algebra.translate(expr);
    translate::vector(algebra, &value)
}

/// The direction of a vector.
fn unit_of<'m>(algebra: &mut Algebra<'m>, expr: &Expr) -> Vn<'m> {
    let vector = vector_of(algebra, expr);
    match vector.in_space() {
        Some(vector) => vector.unit().into(),
        None => {
            let vector = Vector([vector.at(0), vector.at(1)]);
            vector.length_and_unit().1.into()
        }
    }
}

/// What of its body's turning a joint allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Turns {
    Not,
    /// About the joint's axis; in the plane that is every turn.
    AboutAxis,
    Freely,
}

/// How a joint lets its body turn.
pub(super) fn turns_of(kind: JointKind) -> Turns {
    match kind {
        JointKind::Slide | JointKind::Fixed => Turns::Not,
        JointKind::Pin | JointKind::Cylinder => Turns::AboutAxis,
        JointKind::Ball => Turns::Freely,
    }
}

/// Whether a joint lets its body slide along its direction.
pub(super) fn slides_along(kind: JointKind) -> bool {
    match kind {
        JointKind::Slide | JointKind::Cylinder => true,
        JointKind::Pin | JointKind::Ball | JointKind::Fixed => false,
    }
}
