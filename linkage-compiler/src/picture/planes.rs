//! Lines and planes that are written as scalar products.

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::{Algebra, Translate, scalar};
use crate::model::{Expr, ExprKind, Function};
use crate::picture::layout::Layout;
use crate::picture::marks::{Line, Plane};
use crate::picture::point_or_vector::Moves;
use crate::picture::sketch::Sketch;
use crate::picture::statement::Statement;
use crate::picture::{chains, expressions, layout};

/// `dot(p - q, u) = 0` and `cross(p - q, u) = 0` in the plane: `p` stays on a line. In space two
/// planes do the same.
pub(super) fn look_for_line<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    statement: Statement<'_>,
    side: &'m Expr,
    other: &'m Expr,
) {
    let (is_dot, arguments) = match &side.kind {
        ExprKind::Call(Function::Dot, arguments) => (true, arguments),
        ExprKind::Call(Function::Cross, arguments) => (false, arguments),
        _ => return,
    };
    let through = matches!(other.kind, ExprKind::Number(0.0));
    for (vector, direction) in [(0, 1), (1, 0)] {
        let Some((p, q)) = expressions::difference(algebra.mechanism, &arguments[vector]) else {
            continue;
        };
        let (Some(slider), Some(carrier)) = (
            chains::point_of(algebra, layout, sketch, statement, p),
            chains::point_of(algebra, layout, sketch, statement, q),
        ) else {
            continue;
        };
        if layout.dimension == 3 {
            if is_dot && layout.roles.moves(other) == Moves::Not {
                let offset = algebra.translate(other);
                let offset = scalar::number(&algebra.names, &offset);
                let plane = Plane {
                    difference: layout::vector(algebra, layout.dimension, &arguments[vector]),
                    frames: statement.frames.to_vec(),
                    normal: layout::vector(algebra, layout.dimension, &arguments[direction]),
                    offset,
                    is_used: false,
                };
                let name = expressions::spoken(algebra.mechanism, &arguments[vector]);
                meet(
                    algebra,
                    layout,
                    sketch,
                    statement.frames,
                    plane,
                    [slider, carrier],
                    name,
                );
            }
        } else if through {
            let value = algebra.translate(&arguments[direction]);
            let unit = scalar::vector(&algebra.names, &value).unit();
            let unit = Vector([unit.at(0), unit.at(1)]);
            // Across what the product is taken with, or along it.
            let along = if is_dot { unit.perp() } else { unit }.into();
            let foot = algebra.graph.zeros(layout.dimension);
            let ways = [foot, along].map(|way| layout.seen_way(algebra, statement.frames, way));
            line(sketch, [slider, carrier], ways, None);
        }
        return;
    }
}

/// Remembers a plane, or the line in which it meets another one of the same point.
fn meet<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    frames: &[usize],
    plane: Plane<'m>,
    [slider, carrier]: [usize; 2],
    name: Option<String>,
) {
    let same = |known: &&mut Plane<'m>| {
        !known.is_used && known.difference == plane.difference && known.frames == plane.frames
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
            [Some(0.0), Some(0.0)] => algebra.graph.zeros(3),
            // At right angles to the line it reaches both planes.
            _ => {
                let foot = first * b.cross(along) + second * along.cross(a);
                (foot / along.dot(along)).into()
            }
        };
        let ways = [foot, along.unit().into()];
        let ways = ways.map(|way| layout.seen_way(algebra, frames, way));
        line(sketch, [slider, carrier], ways, name);
    }
}

/// Remembers a line by its foot and its direction in the drawing.
fn line<'m>(
    sketch: &mut Sketch<'m>,
    [slider, carrier]: [usize; 2],
    [foot, along]: [Vn<'m>; 2],
    name: Option<String>,
) {
    let title = sketch.points[slider].name.as_ref();
    let point_name = title.map_or_else(|| "slide".to_owned(), |title| title.text.clone());
    sketch.lines.push(Line {
        slider,
        carrier: Some(carrier),
        foot: Some(foot),
        along,
        name: name.unwrap_or(point_name),
    });
}
