//! The parts of a mechanism as they are placed in the drawing.

use linkage_symbolic::{Graph, Vn};

use crate::algebra::{Algebra, Translate, scalar};
use crate::model::Expr;
use crate::picture::point_or_vector::Roles;
use crate::picture::pose::Pose;

/// The parts of a mechanism in the drawing: which names are points, and where placed parts are.
pub(super) struct Layout<'m> {
    /// 2 in the plane, 3 in space.
    pub(super) dimension: usize,
    pub(super) roles: Roles<'m>,
    /// The positions of placed parts.
    pub(super) poses: Vec<Pose<'m>>,
}

impl<'m> Layout<'m> {
    pub(super) fn new(algebra: &mut Algebra<'m>, dimension: usize) -> Self {
        let roles = Roles::new(algebra.mechanism);
        let placed = algebra.mechanism.placed.iter();
        let poses = placed.map(|placed| Pose::new(placed, algebra, &roles));
        Self {
            dimension,
            poses: poses.collect(),
            roles,
        }
    }

    /// The position in the drawing of a point that is written in some coordinates.
    pub(super) fn seen_point(
        &self,
        algebra: &mut Algebra<'m>,
        frames: &[usize],
        written: Vn<'m>,
    ) -> Vn<'m> {
        let poses = frames.iter().map(|&frame| &self.poses[frame]);
        poses.fold(written, |point, pose| pose.point(point, algebra))
    }

    /// The vector in the drawing of a step or direction that is written in some coordinates.
    pub(super) fn seen_way(
        &self,
        algebra: &mut Algebra<'m>,
        frames: &[usize],
        written: Vn<'m>,
    ) -> Vn<'m> {
        let poses = frames.iter().map(|&frame| &self.poses[frame]);
        poses.fold(written, |step, pose| pose.way(step, algebra))
    }
}

/// The unit vector along a coordinate axis.
pub(super) fn axis_of(graph: &Graph, dimension: usize, component: usize) -> Vn<'_> {
    let mut axis = vec![graph.zero(); dimension];
    axis[component] = graph.one();
    graph.components(&axis)
}

/// A vector with as many components as the drawing has dimensions.
pub(super) fn vector<'m>(algebra: &mut Algebra<'m>, dimension: usize, expr: &Expr) -> Vn<'m> {
    let value = algebra.translate(expr);
    scalar::vector(&algebra.names, &value).resized(dimension)
}
