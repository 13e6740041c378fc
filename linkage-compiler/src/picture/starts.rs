//! Points that chains begin with.

use crate::model::{Expr, ExprKind, Function, Name};

use super::chains::Sketch;
use super::marks::{Mean, Shape, Title};

impl<'m> Sketch<'_, 'm> {
    /// A term that is a point.
    pub(super) fn start(&mut self, expr: &'m Expr) -> usize {
        if let Some((frames, own)) = self.elsewhere(expr)
            && let Some(point) = self.within(frames, |sketch| sketch.point_of(own))
        {
            return point;
        }
        let at = self.vector(expr);
        let point = self.point(at);
        if let ExprKind::Call(Function::PointIn, arguments) = &expr.kind
            && let Some((origin, first)) = self.frame_of(&arguments[0])
        {
            match self.unknown_frame(&arguments[0]) {
                Some((index, text)) => {
                    let title = Some(Title { rank: 1, text });
                    self.segment(origin, point, title, Shape::Frame(index));
                }
                None => self.segment(origin, point, None, Shape::Body(None)),
            }
            // An axis of the frame may be the line from one point of a link to another one.
            let ends = self.difference(first).map(|(to, from)| [from, to]);
            let of = ends.and_then(|ends| {
                let [from, to] = ends.map(|end| self.point_of(end));
                Some(vec![from?, to?])
            });
            self.means.extend(of.map(|of| Mean { point, of }));
        }
        if let ExprKind::Binary(..) = expr.kind {
            let of = self.points_in(expr).into_iter().map(|own| {
                let at = self.vector(own);
                self.point(at)
            });
            let of = of.collect();
            self.means.push(Mean { point, of });
        }
        point
    }

    /// The names of points in an expression.
    fn points_in(&self, expr: &'m Expr) -> Vec<&'m Expr> {
        let names = expr.parts().filter(|part| part.as_name().is_some());
        names.filter(|own| self.weight(own) == Some(1.0)).collect()
    }

    /// The derived quantity that an unknown frame is, and its name.
    fn unknown_frame(&self, frame: &'m Expr) -> Option<(usize, String)> {
        let ExprKind::Name(Name::Let(index)) = frame.kind else {
            return None;
        };
        let own = &self.algebra.mechanism.lets[index];
        own.is_unknown_frame.then(|| (index, own.name.clone()))
    }

    /// The point that a frame has its origin in, and the vector along its first axis.
    fn frame_of(&mut self, frame: &'m Expr) -> Option<(usize, &'m Expr)> {
        let mechanism = self.algebra.mechanism;
        match &frame.kind {
            ExprKind::Name(name) => self.frame_of(mechanism.value_of(*name)?),
            ExprKind::Call(Function::Frame, arguments) => {
                Some((self.point_of(&arguments[0])?, &arguments[1]))
            }
            // Nothing else is a frame.
            _ => None,
        }
    }
}
