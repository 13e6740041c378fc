//! The declared points, axes and angles as nodes.

use linkage_symbolic::NodeId;

use crate::algebra::{Algebra, Scalar, Translate, Value};
use crate::model::{Expr, JointKind};

use super::tree::Tree;

/// What a body turns with.
#[derive(Clone, Debug)]
pub(super) enum Turning {
    /// As the body that it hangs on.
    Along,
    /// In the plane.
    Angle(Scalar),
    /// The angle about an axis of the body that it hangs on.
    About(Scalar, Vec<NodeId>),
    /// Three axes in space.
    Frame([Vec<NodeId>; 3]),
    /// A slender rod along a vector; it does not turn about itself.
    Rod(Vec<NodeId>),
}

#[derive(Clone, Debug)]
pub(super) struct Geometry {
    /// 2 in the plane, 3 in space.
    pub(super) dimensions: usize,
    /// By body: the points of their own joints.
    pub(super) origins: Vec<Vec<NodeId>>,
    pub(super) turning: Vec<Turning>,
    /// By joint.
    pub(super) points: Vec<Vec<NodeId>>,
    /// By joint: unit vectors along guides and axes.
    pub(super) directions: Vec<Option<Vec<NodeId>>>,
}

impl Geometry {
    pub(super) fn new(algebra: &mut Algebra, tree: &Tree) -> Self {
        let mechanism = algebra.mechanism;
        let points: Vec<Vec<NodeId>> = mechanism
            .joints
            .iter()
            .map(|joint| algebra.vector_of(&joint.at))
            .collect();
        let dimensions = points.iter().map(Vec::len).max().unwrap_or(2);
        let directions: Vec<Option<Vec<NodeId>>> = mechanism
            .joints
            .iter()
            .map(|joint| joint.direction.as_ref().map(|way| algebra.unit_of(way)))
            .collect();
        let mut turning = vec![Turning::Along; mechanism.bodies.len()];
        for &body in &tree.order {
            let own = &mechanism.bodies[body];
            let Some(turns) = &own.turns else { continue };
            turning[body] = match algebra.translate(turns) {
                Value::Array(parts) => {
                    Turning::Frame([1, 2, 3].map(|axis| algebra.components(&parts[axis])))
                }
                Value::Vector(along) => Turning::Rod(along),
                Value::Scalar(angle) => match &directions[own.joint] {
                    Some(axis) if dimensions == 3 => Turning::About(angle, axis.clone()),
                    _ => Turning::Angle(angle),
                },
            };
        }
        let origins = mechanism
            .bodies
            .iter()
            .map(|body| points[body.joint].clone())
            .collect();
        Self {
            dimensions,
            origins,
            turning,
            points,
            directions,
        }
    }

    /// The vector along a slender rod.
    pub(super) fn rod(&self, body: usize) -> Option<Vec<NodeId>> {
        match &self.turning[body] {
            Turning::Rod(along) => Some(along.clone()),
            _ => None,
        }
    }

    /// How many components a turn has.
    pub(super) fn turns(&self) -> usize {
        match self.dimensions {
            2 => 1,
            _ => 3,
        }
    }

    /// The angle of a body in the plane; `None` is the frame.
    pub(super) fn angle(&self, algebra: &mut Algebra, tree: &Tree, body: Option<usize>) -> Scalar {
        let mut next = body;
        while let Some(body) = next {
            if let Turning::Angle(angle) = &self.turning[body] {
                return angle.clone();
            }
            next = tree.parent[body];
        }
        algebra.graph.zero().into()
    }
}

impl Algebra<'_> {
    /// A point or vector.
    pub(super) fn vector_of(&mut self, expr: &Expr) -> Vec<NodeId> {
        let value = self.translate(expr);
        self.components(&value)
    }

    pub(super) fn number_of(&mut self, expr: &Expr) -> NodeId {
        let value = self.translate(expr);
        self.as_node(&value)
    }

    /// The direction of a vector.
    fn unit_of(&mut self, expr: &Expr) -> Vec<NodeId> {
        match self.vector_of(expr)[..] {
            [x, y, z] => self.unit_vector([x, y, z]).to_vec(),
            [x, y] => self.length_and_unit([x, y]).1.to_vec(),
            _ => unreachable!("a vector has two or three components"),
        }
    }
}

/// Whether a joint lets its body turn about an axis, slide along it, or turn in every way.
pub(super) fn turns_about(kind: JointKind) -> bool {
    matches!(kind, JointKind::Pin | JointKind::Cylinder)
}

pub(super) fn slides_along(kind: JointKind) -> bool {
    matches!(kind, JointKind::Slide | JointKind::Cylinder)
}
