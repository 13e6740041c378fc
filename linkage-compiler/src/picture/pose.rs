//! Positions of the parts of a machine that are placed elsewhere.

use linkage_symbolic::{Ex, NodeId, Vector, Vn};

use crate::algebra::{Algebra, Translate, Value, calls, scalar};
use crate::model::{Function, Placed};
use crate::picture::point_or_vector::{Moves, Roles};

/// Coordinates within others, by their numbers among the placed parts, the innermost first; none
/// are the drawing's.
pub(super) type Frames = Vec<usize>;

/// The position of a placed part in its surroundings.
#[derive(Clone, Debug)]
pub(super) struct Pose<'m> {
    placement: Option<Placement<'m>>,
    turned: Option<Value<'m>>,
    pub(super) moves: Moves,
}

#[derive(Clone, Debug)]
pub(super) enum Placement<'m> {
    Point(Vn<'m>),
    /// A frame of space: its value, and its axes.
    Frame(Value<'m>, [Vn<'m>; 3]),
}

impl<'m> Pose<'m> {
    pub(super) fn new(placed: &Placed, algebra: &mut Algebra<'m>, roles: &Roles) -> Self {
        let both = placed.at.iter().chain(&placed.turned);
        let moves = both.map(|expr| roles.moves(expr)).max();
        let placement = placed.at.as_ref().map(|at| match algebra.translate(at) {
            Value::Array(parts) => {
                let axes = [1, 2, 3].map(|axis| scalar::vector(&algebra.names, &parts[axis]));
                Placement::Frame(Value::Array(parts), axes)
            }
            value => Placement::Point(scalar::vector(&algebra.names, &value)),
        });
        Self {
            placement,
            turned: placed.turned.as_ref().map(|angle| algebra.translate(angle)),
            moves: moves.unwrap_or(Moves::Not),
        }
    }

    pub(super) fn point(&self, point: Vn<'m>, algebra: &mut Algebra<'m>) -> Vn<'m> {
        match &self.placement {
            None => self.way(point, algebra),
            Some(Placement::Point(at)) => at.resized(point.len()) + self.way(point, algebra),
            Some(Placement::Frame(frame, _)) => {
                let seen = calls::call(
                    &mut algebra.names,
                    Function::PointIn,
                    vec![frame.clone(), point.into()],
                );
                scalar::vector(&algebra.names, &seen)
            }
        }
    }

    /// A step or a direction.
    pub(super) fn way(&self, step: Vn<'m>, algebra: &mut Algebra<'m>) -> Vn<'m> {
        match (&self.turned, &self.placement) {
            (Some(angle), _) => {
                let turned = calls::call(
                    &mut algebra.names,
                    Function::Rotate,
                    vec![step.into(), angle.clone()],
                );
                let turned = scalar::vector(&algebra.names, &turned);
                // In a picture of space it turns about z.
                let third = step.iter().skip(2);
                let components: Vec<NodeId> = turned.iter().chain(third).map(Ex::id).collect();
                algebra.graph.components(&components)
            }
            (None, Some(Placement::Frame(_, axes))) => {
                let component = |k: usize| {
                    let axes = axes.map(|axis| axis.at(k));
                    step.dot(Vector(axes).into()).id()
                };
                algebra.graph.components(&[0, 1, 2].map(component))
            }
            (None, _) => step,
        }
    }
}
