//! Lines and planes that are written as scalar products.

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::Translate;
use crate::model::{BinaryOp, Expr, ExprKind, Function, Name};

use super::chains::Sketch;
use super::frames::Frames;
use super::marks::Line;
use super::point_or_vector::Moves;

/// `dot(p - q, n) = d` in space: `p` stays on a plane.
#[derive(Clone, Debug)]
pub(super) struct Plane<'m> {
    difference: Vn<'m>,
    /// The coordinates in which both are written.
    frames: Frames,
    normal: Vn<'m>,
    /// `d`.
    offset: Ex<'m>,
    is_used: bool,
}

impl<'m> Sketch<'_, 'm> {
    /// `dot(p - q, u) = 0` and `cross(p - q, u) = 0` in the plane: `p` stays on a line. In space two planes do the same.
    pub(super) fn look_for_line(&mut self, side: &'m Expr, other: &'m Expr) {
        let (is_dot, arguments) = match &side.kind {
            ExprKind::Call(Function::Dot, arguments) => (true, arguments),
            ExprKind::Call(Function::Cross, arguments) => (false, arguments),
            _ => return,
        };
        let through = matches!(other.kind, ExprKind::Number(0.0));
        for (vector, direction) in [(0, 1), (1, 0)] {
            let Some((p, q)) = self.difference(&arguments[vector]) else {
                continue;
            };
            let (Some(slider), Some(carrier)) = (self.point_of(p), self.point_of(q)) else {
                continue;
            };
            if self.dimension == 3 {
                if is_dot && self.moves(other) == Moves::Not {
                    let offset = self.algebra.translate(other);
                    let offset = self.algebra.number(&offset);
                    let plane = Plane {
                        difference: self.vector(&arguments[vector]),
                        frames: self.frames.clone(),
                        normal: self.vector(&arguments[direction]),
                        offset,
                        is_used: false,
                    };
                    let name = self.spoken(&arguments[vector]);
                    self.meet(plane, [slider, carrier], name);
                }
            } else if through {
                let value = self.algebra.translate(&arguments[direction]);
                let unit = self.algebra.vector(&value).unit();
                let unit = Vector([unit.at(0), unit.at(1)]);
                // Across what the product is taken with, or along it.
                let along = if is_dot { unit.perp() } else { unit }.into();
                let foot = self.algebra.graph.zeros(self.dimension);
                self.line([slider, carrier], foot, along, None);
            }
            return;
        }
    }

    /// Remembers a plane, or the line in which it meets another one of the same point.
    fn meet(&mut self, plane: Plane<'m>, [slider, carrier]: [usize; 2], name: Option<String>) {
        let same = |own: &&mut Plane<'m>| {
            !own.is_used && own.difference == plane.difference && own.frames == plane.frames
        };
        let Some(other) = self.planes.iter_mut().find(same) else {
            return self.planes.push(plane);
        };
        other.is_used = true;
        let (first, second) = (other.offset, plane.offset);
        let normals = [other.normal, plane.normal].map(Vn::in_space);
        if let [Some(a), Some(b)] = normals {
            let along = a.cross(b);
            let foot = match [first, second].map(Ex::constant_value) {
                [Some(0.0), Some(0.0)] => self.algebra.graph.zeros(3),
                // At right angles to the line it reaches both planes.
                _ => {
                    let foot = first * b.cross(along) + second * along.cross(a);
                    (foot / along.dot(along)).into()
                }
            };
            self.line([slider, carrier], foot, along.unit().into(), name);
        }
    }

    fn line(
        &mut self,
        [slider, carrier]: [usize; 2],
        foot: Vn<'m>,
        along: Vn<'m>,
        name: Option<String>,
    ) {
        let (foot, along) = (self.seen_way(foot), self.seen_way(along));
        let own = self.points[slider].name.as_ref();
        let own = own.map_or_else(|| "slide".to_owned(), |title| title.text.clone());
        self.lines.push(Line {
            slider,
            carrier: Some(carrier),
            foot: Some(foot),
            along,
            name: name.unwrap_or(own),
        });
    }

    /// `p` and `q` of a vector that is written as `p - q`.
    pub(super) fn difference(&self, vector: &'m Expr) -> Option<(&'m Expr, &'m Expr)> {
        match &vector.kind {
            ExprKind::Binary(BinaryOp::Sub, p, q) => Some((p, q)),
            ExprKind::Name(Name::Let(index)) => {
                self.difference(&self.algebra.mechanism.lets[*index].value)
            }
            _ => None,
        }
    }
}
