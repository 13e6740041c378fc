//! Points that chains begin with.

use crate::model::{Expr, ExprKind, Function, Name};
use crate::picture::frames;
use crate::picture::planes;
use crate::picture::terms;

use super::chains::Sketch;
use super::marks::{Mean, Shape, Title};

/// A term that is a point.
pub(super) fn start<'m>(sketch: &mut Sketch<'_, 'm>, expr: &'m Expr) -> usize {
    if let Some((frames, own)) = frames::elsewhere(sketch, expr)
        && let Some(point) = frames::within(sketch, frames, |sketch| sketch.point_of(own))
    {
        return point;
    }
    let at = sketch.vector(expr);
    let point = sketch.point(at);
    if let ExprKind::Call(Function::PointIn, arguments) = &expr.kind
        && let Some((origin, first)) = frame_of(sketch, &arguments[0])
    {
        match unknown_frame(sketch, &arguments[0]) {
            Some((index, text)) => {
                let title = Some(Title { rank: 1, text });
                sketch.segment(origin, point, title, Shape::Frame(index));
            }
            None => sketch.segment(origin, point, None, Shape::Body(None)),
        }
        // An axis of the frame may be the line from one point of a link to another one.
        let ends = planes::difference(sketch, first).map(|(to, from)| [from, to]);
        let of = ends.and_then(|ends| {
            let [from, to] = ends.map(|end| sketch.point_of(end));
            Some(vec![from?, to?])
        });
        sketch.means.extend(of.map(|of| Mean { point, of }));
    }
    if let ExprKind::Binary(..) = expr.kind {
        let of = points_in(sketch, expr).into_iter().map(|own| {
            let at = sketch.vector(own);
            sketch.point(at)
        });
        let of = of.collect();
        sketch.means.push(Mean { point, of });
    }
    point
}

/// The names of points in an expression.
fn points_in<'m>(sketch: &Sketch<'_, 'm>, expr: &'m Expr) -> Vec<&'m Expr> {
    let names = expr.parts().filter(|part| part.as_name().is_some());
    names
        .filter(|own| terms::weight(sketch, own) == Some(1.0))
        .collect()
}

/// The derived quantity that an unknown frame is, and its name.
fn unknown_frame<'m>(sketch: &Sketch<'_, 'm>, frame: &'m Expr) -> Option<(usize, String)> {
    let ExprKind::Name(Name::Let(index)) = frame.kind else {
        return None;
    };
    let own = &sketch.algebra.mechanism.lets[index];
    own.is_unknown_frame.then(|| (index, own.name.clone()))
}

/// The point that a frame has its origin in, and the vector along its first axis.
fn frame_of<'m>(sketch: &mut Sketch<'_, 'm>, frame: &'m Expr) -> Option<(usize, &'m Expr)> {
    let mechanism = sketch.algebra.mechanism;
    match &frame.kind {
        ExprKind::Name(name) => frame_of(sketch, mechanism.value_of(*name)?),
        ExprKind::Call(Function::Frame, arguments) => {
            Some((sketch.point_of(&arguments[0])?, &arguments[1]))
        }
        // Nothing else is a frame.
        _ => None,
    }
}
