//! Lines and planes that are written as scalar products.

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::{Translate, scalar};
use crate::model::{Expr, ExprKind, Function};
use crate::picture::marks::{Line, Plane};
use crate::picture::point_or_vector::Moves;
use crate::picture::sketch::Sketch;
use crate::picture::{chains, expressions, sketch};

/// `dot(p - q, u) = 0` and `cross(p - q, u) = 0` in the plane: `p` stays on a line. In space two
/// planes do the same.
pub(super) fn look_for_line<'m>(sketch: &mut Sketch<'_, 'm>, side: &'m Expr, other: &'m Expr) {
    let (is_dot, arguments) = match &side.kind {
        ExprKind::Call(Function::Dot, arguments) => (true, arguments),
        ExprKind::Call(Function::Cross, arguments) => (false, arguments),
        _ => return,
    };
    let through = matches!(other.kind, ExprKind::Number(0.0));
    for (vector, direction) in [(0, 1), (1, 0)] {
        let Some((p, q)) = expressions::difference(sketch.algebra.mechanism, &arguments[vector])
        else {
            continue;
        };
        let (Some(slider), Some(carrier)) =
            (chains::point_of(sketch, p), chains::point_of(sketch, q))
        else {
            continue;
        };
        if sketch.dimension == 3 {
            if is_dot && sketch.moves(other) == Moves::Not {
                let offset = sketch.algebra.translate(other);
                let offset = scalar::number(sketch.algebra, &offset);
                let plane = Plane {
                    difference: sketch.vector(&arguments[vector]),
                    frames: sketch.frames.clone(),
                    normal: sketch.vector(&arguments[direction]),
                    offset,
                    is_used: false,
                };
                let name = expressions::spoken(sketch.algebra.mechanism, &arguments[vector]);
                meet(sketch, plane, [slider, carrier], name);
            }
        } else if through {
            let value = sketch.algebra.translate(&arguments[direction]);
            let unit = scalar::vector(sketch.algebra, &value).unit();
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
        sketch::seen_way(sketch, foot),
        sketch::seen_way(sketch, along),
    );
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
