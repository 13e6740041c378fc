//! What loops, derived names, bodies and joints are made of.

use crate::picture::bodies;
use crate::picture::frames;
use crate::picture::guides;
use crate::picture::parts;
use crate::picture::planes;
use crate::picture::terms;
use crate::picture::titles;
use linkage_symbolic::{Ex, NodeId};

use crate::model::{Expr, ExprKind, Function, Let, Loop, Mechanism, Name, Type};

use super::chains::Sketch;
use super::marks::{Asked, Shape, Term, Title};

/// Names in derived quantities stand behind those in loops, and where no loop uses the quantity behind all others.
const LET: [u8; 2] = [3, 6];

/// All that the program says of points and links.
pub(super) fn collect(sketch: &mut Sketch<'_, '_>) {
    look_at_lets(sketch);
    look_at_unknowns(sketch);
    for (index, own) in sketch.algebra.mechanism.loops.iter().enumerate() {
        if is_anywhere(sketch, own) {
            sketch.undrawn.push(index + 1);
        } else {
            let frames = frames::frames_of_loop(sketch, index);
            frames::within(sketch, frames, |sketch| look_at_loop(sketch, own));
        }
    }
    bodies::look_at_bodies(sketch);
}

/// Named points, those aside that are centres of mass only.
fn look_at_lets(sketch: &mut Sketch<'_, '_>) {
    let mechanism = sketch.algebra.mechanism;
    let loops: Vec<usize> = (0..mechanism.loops.len()).collect();
    let usage = mechanism.usage(&loops);
    for (index, own) in mechanism.lets.iter().enumerate() {
        let is_centre = !usage.lets[index] && is_mass_centre(mechanism, index);
        if sketch.roles.is_step(Name::Let(index)) || is_centre {
            continue;
        }
        sketch.remoteness = LET[usize::from(!usage.lets[index])];
        let frames = frames::frames_of(sketch, Name::Let(index));
        frames::within(sketch, frames, |sketch| look_at_let(sketch, own));
    }
    sketch.remoteness = 0;
}

fn look_at_let<'m>(sketch: &mut Sketch<'_, 'm>, own: &'m Let) {
    if let Some(point) = sketch.point_of(&own.value) {
        let at = sketch.vector(&own.value);
        let named = sketch.point(at);
        for point in [point, named] {
            let text = own.name.clone();
            titles::call(sketch, point, Title { rank: 0, text });
        }
        sketch.points[named].wanted = true;
    }
}

/// Unknown points.
fn look_at_unknowns(sketch: &mut Sketch<'_, '_>) {
    let mechanism = sketch.algebra.mechanism;
    for (index, own) in mechanism.unknowns.iter().enumerate() {
        let Type::Vector(count, dimension) = own.ty else {
            continue;
        };
        let is_point = count == sketch.dimension && dimension.half_lengths == 2;
        if is_point && !sketch.roles.is_step(Name::Unknown(index)) {
            let numbers = sketch.algebra.names.numbers_of(index).into_iter();
            let numbers: Vec<NodeId> = numbers.map(Ex::id).collect();
            let at = sketch.algebra.graph.components(&numbers);
            let frames = frames::frames_of(sketch, Name::Unknown(index));
            let point = frames::within(sketch, frames, |sketch| sketch.point(at));
            let text = own.name.clone();
            titles::call(sketch, point, Title { rank: 1, text });
            sketch.points[point].wanted = true;
        }
    }
}

/// The links that `picture` lists.
pub(super) fn add_lists<'m>(sketch: &mut Sketch<'_, 'm>, lists: &'m [Vec<Expr>]) {
    for list in lists {
        let points: Vec<usize> = list
            .iter()
            .map(|expr| {
                let at = sketch.vector(expr);
                let found = sketch.point_of(expr);
                let point = sketch.point(at);
                titles::name(sketch, point, 0, expr);
                sketch.points[point].wanted = true;
                found.unwrap_or(point)
            })
            .collect();
        let origin = list[0].origin;
        sketch.asked.push(Asked { points, origin });
    }
}

fn look_at_loop<'m>(sketch: &mut Sketch<'_, 'm>, own: &'m Loop) {
    match own.left.ty {
        Type::Vector(..) => {
            let is_flat = is_flat(sketch, &own.left) && is_flat(sketch, &own.right);
            for side in sides(sketch, own) {
                if let Some(end) = sketch.chain(side) {
                    sketch.points[end].wanted = true;
                    if is_flat {
                        parts::axis(sketch, end, guides::axis_of(sketch, 2));
                    }
                }
            }
        }
        _ => {
            for (side, other) in [(&own.left, &own.right), (&own.right, &own.left)] {
                let title = titles::spoken(sketch, other).map(|text| Title { rank: 2, text });
                look_for_rods(sketch, side, title);
                planes::look_for_line(sketch, side, other);
            }
        }
    }
}

/// Whether a loop is one of the plane made of components of vectors of space: it is not known where in space it lies.
fn is_anywhere(sketch: &Sketch<'_, '_>, own: &Loop) -> bool {
    let sides = [&own.left, &own.right];
    let is_vector = matches!(own.left.ty, Type::Vector(..));
    is_vector
        && sides.iter().all(|side| is_flat(sketch, side))
        && sides.iter().any(|side| is_projection(sketch, side))
}

/// Whether it lies in a plane of a mechanism of space.
fn is_flat(sketch: &Sketch<'_, '_>, expr: &Expr) -> bool {
    sketch.dimension == 3 && matches!(expr.ty, Type::Vector(2, _) | Type::Zero(_))
}

/// Whether a vector of the plane has components of vectors of space: it may lie in any plane.
pub(super) fn is_projection(sketch: &Sketch<'_, '_>, expr: &Expr) -> bool {
    expr.parts().any(|part| match &part.kind {
        ExprKind::Component(vector, _) => matches!(vector.ty, Type::Vector(3, _)),
        ExprKind::Name(name) => {
            let value = sketch.algebra.mechanism.value_of(*name);
            value.is_some_and(|value| is_projection(sketch, value))
        }
        _ => false,
    })
}

/// The two ways from one point to another that a vector loop consists of, each in the order in which it is written.
fn sides<'m>(sketch: &mut Sketch<'_, 'm>, own: &'m Loop) -> [Vec<Term<'m>>; 2] {
    let [left, right] = [&own.left, &own.right].map(|side| {
        let mut terms = Vec::new();
        terms::collect_terms(sketch, side, 1.0, None, &mut terms);
        terms.into_iter().partition(|term| term.sign > 0.0)
    });
    let ((left, left_minus), (right, right_minus)) = (left, right);
    [(left, right_minus), (right, left_minus)].map(|(own, moved)| side(sketch, own, moved))
}

/// What one side adds, and what the other one subtracts: a way to where the difference begins, unless this side has a point to
/// begin with.
fn side<'m>(sketch: &Sketch<'_, 'm>, own: Vec<Term<'m>>, moved: Vec<Term<'m>>) -> Vec<Term<'m>> {
    let moved = moved.into_iter().map(|term| Term { sign: 1.0, ..term });
    let is_start = |term: &Term| terms::weight_of(sketch, term) == 1.0;
    let mut all: Vec<Term> = match own.iter().any(is_start) {
        true => own.into_iter().chain(moved).collect(),
        false => moved.chain(own).collect(),
    };
    all.sort_by_key(|term| !is_start(term));
    all
}

/// Distances between points.
fn look_for_rods<'m>(sketch: &mut Sketch<'_, 'm>, expr: &'m Expr, title: Option<Title>) {
    match &expr.kind {
        ExprKind::Call(Function::Distance, ends) => {
            if let (Some(from), Some(to)) = (sketch.point_of(&ends[0]), sketch.point_of(&ends[1])) {
                sketch.segment(from, to, title, Shape::Distance);
            }
        }
        ExprKind::Call(Function::Norm, vector) => look_for_rod(sketch, &vector[0], title),
        ExprKind::Call(Function::Dot, vectors) => {
            let both = (sketch.vector(&vectors[0]), sketch.vector(&vectors[1]));
            if both.0 == both.1 {
                look_for_rod(sketch, &vectors[0], title);
            }
        }
        ExprKind::Name(Name::Let(index)) => {
            if sketch.searched.insert(*index) {
                let own = &sketch.algebra.mechanism.lets[*index].value;
                let frames = frames::frames_of(sketch, Name::Let(*index));
                frames::within(sketch, frames, |sketch| look_for_rods(sketch, own, title));
            }
        }
        _ => {
            for operand in expr.operands() {
                look_for_rods(sketch, operand, title.clone());
            }
        }
    }
}

/// `q - p`, a rod between two points; a point alone is as far from the origin.
fn look_for_rod<'m>(sketch: &mut Sketch<'_, 'm>, vector: &'m Expr, title: Option<Title>) {
    let mut terms = Vec::new();
    terms::collect_terms(sketch, vector, 1.0, None, &mut terms);
    let (plus, mut minus): (Vec<_>, Vec<_>) = terms.into_iter().partition(|term| term.sign > 0.0);
    minus.iter_mut().for_each(|term| term.sign = 1.0);
    let weight = |side: &[Term]| {
        side.iter()
            .map(|term| terms::weight_of(sketch, term))
            .sum::<f64>()
    };
    let ends = [weight(&plus), weight(&minus)];
    let is_point = ends.contains(&1.0) || !plus.is_empty() && !minus.is_empty();
    if !is_point || ends.iter().any(|weight| ![0.0, 1.0].contains(weight)) {
        return;
    }
    if let (Some(to), Some(from)) = (sketch.chain(plus), sketch.chain(minus)) {
        sketch.segment(from, to, title, Shape::Distance);
    }
}

/// Whether a mass stands at a derived point.
fn is_mass_centre(mechanism: &Mechanism, index: usize) -> bool {
    let masses = mechanism.bodies.iter().flat_map(|body| &body.masses);
    let mut centres = masses.map(|(_, at)| at);
    centres.any(|at| at.as_name() == Some(Name::Let(index)))
}
