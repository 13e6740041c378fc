//! Links in loops, derived names, bodies and joints.

use linkage_symbolic::{Ex, NodeId};

use crate::model::{Expr, ExprKind, Function, Let, Loop, Mechanism, Name, Type};
use crate::picture::marks::{Asked, Shape, Term, Title};
use crate::picture::sketch::Sketch;
use crate::picture::{
    bodies, chains, expressions, frames, parts, planes, sketch, terms, titles, weights,
};

/// UniqueNames in derived quantities stand behind those in loops, and where no loop uses the
/// quantity behind all others.
const LET: [u8; 2] = [3, 6];

/// All that the program says of points and links.
pub(super) fn collect(sketch: &mut Sketch<'_, '_>) {
    look_at_lets(sketch);
    look_at_unknowns(sketch);
    for (index, equation) in sketch.algebra.mechanism.loops.iter().enumerate() {
        if expressions::is_anywhere(sketch, equation) {
            sketch.undrawn.push(index + 1);
        } else {
            let frames = frames::frames_of_loop(sketch, index);
            sketch::within(sketch, frames, |sketch| look_at_loop(sketch, equation));
        }
    }
    bodies::look_at_bodies(sketch);
}

/// Named points, those aside that are centres of mass only.
fn look_at_lets(sketch: &mut Sketch<'_, '_>) {
    let mechanism = sketch.algebra.mechanism;
    let loops: Vec<usize> = (0..mechanism.loops.len()).collect();
    let usage = mechanism.usage(&loops);
    for (index, item) in mechanism.lets.iter().enumerate() {
        let is_centre = !usage.lets[index] && is_mass_centre(mechanism, index);
        if sketch.roles.is_step(Name::Let(index)) || is_centre {
            continue;
        }
        sketch.remoteness = LET[usize::from(!usage.lets[index])];
        let frames = frames::frames_of(sketch, Name::Let(index));
        sketch::within(sketch, frames, |sketch| look_at_let(sketch, item));
    }
    sketch.remoteness = 0;
}

fn look_at_let<'m>(sketch: &mut Sketch<'_, 'm>, item: &'m Let) {
    if let Some(point) = chains::point_of(sketch, &item.value) {
        let at = sketch.vector(&item.value);
        let named = sketch.point(at);
        for point in [point, named] {
            let text = item.name.clone();
            titles::call(sketch, point, Title { rank: 0, text });
        }
        sketch.points[named].wanted = true;
    }
}

/// Unknown points.
fn look_at_unknowns(sketch: &mut Sketch<'_, '_>) {
    let mechanism = sketch.algebra.mechanism;
    for (index, unknown) in mechanism.unknowns.iter().enumerate() {
        let Type::Vector(count, dimension) = unknown.ty else {
            continue;
        };
        let is_point = count == sketch.dimension && dimension.half_lengths == 2;
        if is_point && !sketch.roles.is_step(Name::Unknown(index)) {
            let numbers = sketch.algebra.names.numbers_of(index).into_iter();
            let numbers: Vec<NodeId> = numbers.map(Ex::id).collect();
            let at = sketch.algebra.graph.components(&numbers);
            let frames = frames::frames_of(sketch, Name::Unknown(index));
            let point = sketch::within(sketch, frames, |sketch| sketch.point(at));
            let text = unknown.name.clone();
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
                let found = chains::point_of(sketch, expr);
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

fn look_at_loop<'m>(sketch: &mut Sketch<'_, 'm>, equation: &'m Loop) {
    match equation.left.ty {
        Type::Vector(..) => {
            let is_flat = expressions::is_flat(sketch, &equation.left)
                && expressions::is_flat(sketch, &equation.right);
            for side in sides(sketch, equation) {
                if let Some(end) = chains::chain(sketch, side) {
                    sketch.points[end].wanted = true;
                    if is_flat {
                        parts::axis(sketch, end, sketch::axis_of(sketch, 2));
                    }
                }
            }
        }
        _ => {
            for (side, other) in [
                (&equation.left, &equation.right),
                (&equation.right, &equation.left),
            ] {
                let title = expressions::spoken(sketch.algebra.mechanism, other)
                    .map(|text| Title { rank: 2, text });
                look_for_rods(sketch, side, title);
                planes::look_for_line(sketch, side, other);
            }
        }
    }
}

/// The two ways from one point to another that a vector loop consists of, each in the order in
/// which it is written.
fn sides<'m>(sketch: &mut Sketch<'_, 'm>, equation: &'m Loop) -> [Vec<Term<'m>>; 2] {
    let [left, right] = [&equation.left, &equation.right].map(|side| {
        let mut terms = Vec::new();
        terms::collect_terms(sketch, side, 1.0, None, &mut terms);
        terms.into_iter().partition(|term| term.sign > 0.0)
    });
    let ((left, left_minus), (right, right_minus)) = (left, right);
    [(left, right_minus), (right, left_minus)].map(|(added, moved)| side(sketch, added, moved))
}

/// The terms that one side adds and the other one subtracts: a way to the start of the difference,
/// unless this side has a point to begin with.
fn side<'m>(sketch: &Sketch<'_, 'm>, added: Vec<Term<'m>>, moved: Vec<Term<'m>>) -> Vec<Term<'m>> {
    let moved = moved.into_iter().map(|term| Term { sign: 1.0, ..term });
    let is_start = |term: &Term| weights::weight_of(sketch, term) == 1.0;
    let mut terms: Vec<Term> = if added.iter().any(is_start) {
        added.into_iter().chain(moved).collect()
    } else {
        moved.chain(added).collect()
    };
    terms.sort_by_key(|term| !is_start(term));
    terms
}

/// Distances between points.
fn look_for_rods<'m>(sketch: &mut Sketch<'_, 'm>, expr: &'m Expr, title: Option<Title>) {
    match &expr.kind {
        ExprKind::Call(Function::Distance, ends) => {
            if let (Some(from), Some(to)) = (
                chains::point_of(sketch, &ends[0]),
                chains::point_of(sketch, &ends[1]),
            ) {
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
                let value = &sketch.algebra.mechanism.lets[*index].value;
                let frames = frames::frames_of(sketch, Name::Let(*index));
                sketch::within(sketch, frames, |sketch| look_for_rods(sketch, value, title));
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
            .map(|term| weights::weight_of(sketch, term))
            .sum::<f64>()
    };
    let ends = [weight(&plus), weight(&minus)];
    let is_point = ends.contains(&1.0) || !plus.is_empty() && !minus.is_empty();
    if !is_point || ends.iter().any(|weight| ![0.0, 1.0].contains(weight)) {
        return;
    }
    if let (Some(to), Some(from)) = (chains::chain(sketch, plus), chains::chain(sketch, minus)) {
        sketch.segment(from, to, title, Shape::Distance);
    }
}

/// True if a mass stands at a derived point.
fn is_mass_centre(mechanism: &Mechanism, index: usize) -> bool {
    let masses = mechanism.bodies.iter().flat_map(|body| &body.masses);
    let mut centres = masses.map(|(_, at)| at);
    centres.any(|at| at.as_name() == Some(Name::Let(index)))
}
