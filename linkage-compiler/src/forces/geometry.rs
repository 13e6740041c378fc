//! The declared points, axes and angles as expressions.

use linkage_symbolic::{Graph, Vector, Vn};

use crate::algebra::{Algebra, Scalar, Translate, Value, scalar};
use crate::forces::tree::Tree;
use crate::model::Expr;

/// The rotation of a body.
#[derive(Clone, Debug)]
pub(super) enum BodyTurn<'m> {
    /// The same rotation as its parent.
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
    /// For each body: the points of their own joints.
    pub(super) origins: Vec<Vn<'m>>,
    pub(super) turning: Vec<BodyTurn<'m>>,
    /// For each joint.
    pub(super) points: Vec<Vn<'m>>,
    /// For each joint: unit vectors along guides and axes.
    pub(super) directions: Vec<Option<Vn<'m>>>,
}

impl<'m> Geometry<'m> {
    /// The declarations as expressions, bodies in the order of the tree.
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
        let mut turning = vec![BodyTurn::Along; mechanism.bodies.len()];
        for &body in &tree.order {
            let declared = &mechanism.bodies[body];
            let Some(turns) = &declared.turns else {
                continue;
            };
            turning[body] = match algebra.translate(turns) {
                Value::Array(parts) => BodyTurn::Frame(
                    [1, 2, 3].map(|axis| scalar::vector(&algebra.names, &parts[axis])),
                ),
                Value::Vector(along) => BodyTurn::Rod(along),
                Value::Scalar(angle) => match directions[declared.joint] {
                    Some(axis) if dimensions == 3 => BodyTurn::About(angle, axis),
                    _ => BodyTurn::Angle(angle),
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

    /// The number of components of a turn.
    pub(super) fn turns(&self) -> usize {
        if self.is_plane() { 1 } else { 3 }
    }

    /// No force, no velocity.
    pub(super) fn zero_vector(&self, graph: &'m Graph) -> Vn<'m> {
        graph.zeros(self.dimensions)
    }

    /// No moment, no angular velocity.
    pub(super) fn zero_turn(&self, graph: &'m Graph) -> Vn<'m> {
        graph.zeros(self.turns())
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
            BodyTurn::Rod(along) => Some(along),
            BodyTurn::Along | BodyTurn::Angle(_) | BodyTurn::About(..) | BodyTurn::Frame(_) => None,
        }
    }

    /// The axis about which a body turns with an angle in space.
    pub(super) fn axis(&self, body: usize) -> Option<Vn<'m>> {
        match self.turning[body] {
            BodyTurn::About(_, axis) => Some(axis),
            BodyTurn::Along | BodyTurn::Angle(_) | BodyTurn::Frame(_) | BodyTurn::Rod(_) => None,
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
            if let BodyTurn::Angle(angle) = &self.turning[body] {
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
    scalar::vector(&algebra.names, &value)
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
