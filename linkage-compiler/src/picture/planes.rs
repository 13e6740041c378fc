//! Lines and planes that are written as scalar products.

use crate::algebra::translate;
use crate::picture::frames;
use crate::picture::titles;
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

/// `dot(p - q, u) = 0` and `cross(p - q, u) = 0` in the plane: `p` stays on a line. In space two planes do the same.
pub(super) fn look_for_line<'m>(sketch: &mut Sketch<'_, 'm>, side: &'m Expr, other: &'m Expr) {
    let (is_dot, arguments) = match &side.kind {
        ExprKind::Call(Function::Dot, arguments) => (true, arguments),
        ExprKind::Call(Function::Cross, arguments) => (false, arguments),
        _ => return,
    };
    let through = matches!(other.kind, ExprKind::Number(0.0));
    for (vector, direction) in [(0, 1), (1, 0)] {
        let Some((p, q)) = difference(sketch, &arguments[vector]) else {
            continue;
        };
        let (Some(slider), Some(carrier)) = (sketch.point_of(p), sketch.point_of(q)) else {
            continue;
        };
        if sketch.dimension == 3 {
            if is_dot && sketch.moves(other) == Moves::Not {
                let offset = sketch.algebra.translate(other);
                let offset = translate::number(sketch.algebra, &offset);
                let plane = Plane {
                    difference: sketch.vector(&arguments[vector]),
                    frames: sketch.frames.clone(),
                    normal: sketch.vector(&arguments[direction]),
                    offset,
                    is_used: false,
                };
                let name = titles::spoken(sketch, &arguments[vector]);
                meet(sketch, plane, [slider, carrier], name);
            }
        } else if through {
            let value = sketch.algebra.translate(&arguments[direction]);
            let unit = translate::vector(sketch.algebra, &value).unit();
            let unit = Vector([unit.at(0), unit.at(1)]);
            // Across what the product is taken with, or along it.
            let along = if is_dot { unit.perp() } else { unit }.into();
            let foot = sketch.algebra.graph.zeros(sketch.dimension);
            line(sketch, [slider, carrier], foot, along, None);
        }
        return;
    }
}

/// Remembers a plane, or the line in which it meets another one of the same point.
fn meet<'m>(
    sketch: &mut Sketch<'_, 'm>,
    plane: Plane<'m>,
    [slider, carrier]: [usize; 2],
    name: Option<String>,
) {
    let same = |own: &&mut Plane<'m>| {
        !own.is_used && own.difference == plane.difference && own.frames == plane.frames
    };
    let Some(other) = sketch.planes.iter_mut().find(same) else {
        return sketch.planes.push(plane);
    };
    other.is_used = true;
    let (first, second) = (other.offset, plane.offset);
    let normals = [other.normal, plane.normal].map(Vn::in_space);
    if let [Some(a), Some(b)] = normals {
        let along = a.cross(b);
        let foot = match [first, second].map(Ex::constant_value) {
            [Some(0.0), Some(0.0)] => sketch.algebra.graph.zeros(3),
            // At right angles to the line it reaches both planes.
            _ => {
                let foot = first * b.cross(along) + second * along.cross(a);
                (foot / along.dot(along)).into()
            }
        };
        line(sketch, [slider, carrier], foot, along.unit().into(), name);
    }
}

fn line<'m>(
    sketch: &mut Sketch<'_, 'm>,
    [slider, carrier]: [usize; 2],
    foot: Vn<'m>,
    along: Vn<'m>,
    name: Option<String>,
) {
    let (foot, along) = (
        frames::seen_way(sketch, foot),
        frames::seen_way(sketch, along),
    );
    let own = sketch.points[slider].name.as_ref();
    let own = own.map_or_else(|| "slide".to_owned(), |title| title.text.clone());
    sketch.lines.push(Line {
        slider,
        carrier: Some(carrier),
        foot: Some(foot),
        along,
        name: name.unwrap_or(own),
    });
}

/// `p` and `q` of a vector that is written as `p - q`.
pub(super) fn difference<'m>(
    sketch: &Sketch<'_, 'm>,
    vector: &'m Expr,
) -> Option<(&'m Expr, &'m Expr)> {
    match &vector.kind {
        ExprKind::Binary(BinaryOp::Sub, p, q) => Some((p, q)),
        ExprKind::Name(Name::Let(index)) => {
            difference(sketch, &sketch.algebra.mechanism.lets[*index].value)
        }
        _ => None,
    }
}
