//! Links in loops, derived names, bodies and joints.

use linkage_symbolic::lookup::Set;
use linkage_symbolic::{Ex, NodeId};

use crate::algebra::Algebra;
use crate::model::{Expr, ExprKind, Function, Let, Loop, Mechanism, Name, Type};
use crate::picture::layout::Layout;
use crate::picture::marks::{Shape, Term, Title};
use crate::picture::point_or_vector::Roles;
use crate::picture::sketch::Sketch;
use crate::picture::statement::{ASIDE, Statement};
use crate::picture::{
    arcs, bodies, chains, expressions, frames, layout, listed_links, parts, planes, sketch, terms,
    titles, weights,
};

/// UniqueNames in derived quantities stand behind those in loops, and where no loop uses the
/// quantity behind all others.
const LET: [u8; 2] = [3, ASIDE];

/// Collects all that the program says of points and links. Returns the loops that are not drawn, by
/// number from 1.
pub(super) fn collect<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
) -> Vec<usize> {
    let mut undrawn = Vec::new();
    // Derived names in which rods have been looked for.
    let mut searched = Set::new();
    look_at_lets(algebra, layout, sketch);
    look_at_unknowns(algebra, layout, sketch);
    for (index, equation) in algebra.mechanism.loops.iter().enumerate() {
        if expressions::is_anywhere(algebra.mechanism, layout.dimension, equation) {
            undrawn.push(index + 1);
        } else {
            let frames = frames::frames_of_loop(algebra.mechanism, index);
            let statement = Statement::default().within(&frames);
            look_at_loop(algebra, layout, sketch, statement, &mut searched, equation);
        }
    }
    bodies::look_at_bodies(algebra, layout, sketch);
    arcs::look_at_arcs(algebra, layout, sketch);
    listed_links::add_links(algebra, layout, sketch);
    undrawn
}

/// Named points, those aside that are centres of mass only.
fn look_at_lets<'m>(algebra: &mut Algebra<'m>, layout: &Layout<'m>, sketch: &mut Sketch<'m>) {
    let mechanism = algebra.mechanism;
    let loops: Vec<usize> = (0..mechanism.loops.len()).collect();
    let usage = mechanism.usage(&loops);
    for (index, item) in mechanism.lets.iter().enumerate() {
        let is_centre = !usage.lets[index] && is_mass_centre(mechanism, index);
        if layout.roles.is_step(Name::Let(index)) || is_centre {
            continue;
        }
        let statement = Statement {
            frames: &frames::frames_of(mechanism, Name::Let(index)),
            remoteness: LET[usize::from(!usage.lets[index])],
        };
        look_at_let(algebra, layout, sketch, statement, item);
    }
}

fn look_at_let<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    statement: Statement<'_>,
    item: &'m Let,
) {
    if let Some(point) = chains::point_of(algebra, layout, sketch, statement, &item.value) {
        let at = layout::vector(algebra, layout.dimension, &item.value);
        let named = sketch::point(algebra, layout, &mut sketch.points, statement.frames, at);
        for point in [point, named] {
            let text = item.name.clone();
            titles::call(&mut sketch.points[point], Title { rank: 0, text });
        }
        sketch.points[named].wanted = true;
    }
}

/// Unknown points.
fn look_at_unknowns<'m>(algebra: &mut Algebra<'m>, layout: &Layout<'m>, sketch: &mut Sketch<'m>) {
    let mechanism = algebra.mechanism;
    for (index, unknown) in mechanism.unknowns.iter().enumerate() {
        let Type::Vector(count, dimension) = unknown.ty else {
            continue;
        };
        let is_point = count == layout.dimension && dimension.half_lengths == 2;
        if is_point && !layout.roles.is_step(Name::Unknown(index)) {
            let numbers = algebra.names.numbers_of(index).into_iter();
            let numbers: Vec<NodeId> = numbers.map(Ex::id).collect();
            let at = algebra.graph.components(&numbers);
            let frames = frames::frames_of(algebra.mechanism, Name::Unknown(index));
            let point = sketch::point(algebra, layout, &mut sketch.points, &frames, at);
            let text = unknown.name.clone();
            titles::call(&mut sketch.points[point], Title { rank: 1, text });
            sketch.points[point].wanted = true;
        }
    }
}

fn look_at_loop<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    statement: Statement<'_>,
    searched: &mut Set<usize>,
    equation: &'m Loop,
) {
    match equation.left.ty {
        Type::Vector(..) => {
            let is_flat = expressions::is_flat(layout.dimension, &equation.left)
                && expressions::is_flat(layout.dimension, &equation.right);
            for side in sides(algebra, layout, statement.remoteness, equation) {
                if let Some(end) = chains::chain(algebra, layout, sketch, statement, side) {
                    sketch.points[end].wanted = true;
                    if is_flat {
                        parts::axis(
                            &mut sketch.axes,
                            end,
                            layout::axis_of(algebra.graph, layout.dimension, 2),
                        );
                    }
                }
            }
        }
        _ => {
            for (side, other) in [
                (&equation.left, &equation.right),
                (&equation.right, &equation.left),
            ] {
                let title = expressions::spoken(algebra.mechanism, other)
                    .map(|text| Title { rank: 2, text });
                look_for_rods(algebra, layout, sketch, statement, searched, side, title);
                planes::look_for_line(algebra, layout, sketch, statement, side, other);
            }
        }
    }
}

/// The two ways from one point to another that a vector loop consists of, each in the order in
/// which it is written.
fn sides<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    equation: &'m Loop,
) -> [Vec<Term<'m>>; 2] {
    let [left, right] = [&equation.left, &equation.right].map(|side| {
        let terms = terms::terms_of(algebra, layout, remoteness, side);
        terms.into_iter().partition(|term| term.sign > 0.0)
    });
    let ((left, left_minus), (right, right_minus)) = (left, right);
    [(left, right_minus), (right, left_minus)]
        .map(|(added, moved)| side(algebra.mechanism, &layout.roles, added, moved))
}

/// The terms that one side adds and the other one subtracts: a way to the start of the difference,
/// unless this side has a point to begin with.
fn side<'m>(
    mechanism: &Mechanism,
    roles: &Roles,
    added: Vec<Term<'m>>,
    moved: Vec<Term<'m>>,
) -> Vec<Term<'m>> {
    let moved = moved.into_iter().map(|term| Term { sign: 1.0, ..term });
    let is_start = |term: &Term| weights::weight_of(mechanism, roles, term) == 1.0;
    let mut terms: Vec<Term> = if added.iter().any(is_start) {
        added.into_iter().chain(moved).collect()
    } else {
        moved.chain(added).collect()
    };
    terms.sort_by_key(|term| !is_start(term));
    terms
}

/// Distances between points.
fn look_for_rods<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    statement: Statement<'_>,
    searched: &mut Set<usize>,
    expr: &'m Expr,
    title: Option<Title>,
) {
    match &expr.kind {
        ExprKind::Call(Function::Distance, ends) => {
            if let (Some(from), Some(to)) = (
                chains::point_of(algebra, layout, sketch, statement, &ends[0]),
                chains::point_of(algebra, layout, sketch, statement, &ends[1]),
            ) {
                sketch.segment(statement.frames, [from, to], title, Shape::Distance);
            }
        }
        ExprKind::Call(Function::Norm, vector) => {
            look_for_rod(algebra, layout, sketch, statement, &vector[0], title)
        }
        ExprKind::Call(Function::Dot, vectors) => {
            let both = (
                layout::vector(algebra, layout.dimension, &vectors[0]),
                layout::vector(algebra, layout.dimension, &vectors[1]),
            );
            if both.0 == both.1 {
                look_for_rod(algebra, layout, sketch, statement, &vectors[0], title);
            }
        }
        ExprKind::Name(Name::Let(index)) => {
            if searched.insert(*index) {
                let value = &algebra.mechanism.lets[*index].value;
                let frames = frames::frames_of(algebra.mechanism, Name::Let(*index));
                let statement = statement.within(&frames);
                look_for_rods(algebra, layout, sketch, statement, searched, value, title);
            }
        }
        _ => {
            for operand in expr.operands() {
                look_for_rods(
                    algebra,
                    layout,
                    sketch,
                    statement,
                    searched,
                    operand,
                    title.clone(),
                );
            }
        }
    }
}

/// `q - p`, a rod between two points; a point alone is as far from the origin.
fn look_for_rod<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    sketch: &mut Sketch<'m>,
    statement: Statement<'_>,
    vector: &'m Expr,
    title: Option<Title>,
) {
    let terms = terms::terms_of(algebra, layout, statement.remoteness, vector);
    let (plus, mut minus): (Vec<_>, Vec<_>) = terms.into_iter().partition(|term| term.sign > 0.0);
    minus.iter_mut().for_each(|term| term.sign = 1.0);
    let weight = |side: &[Term]| {
        side.iter()
            .map(|term| weights::weight_of(algebra.mechanism, &layout.roles, term))
            .sum::<f64>()
    };
    let ends = [weight(&plus), weight(&minus)];
    let is_point = ends.contains(&1.0) || !plus.is_empty() && !minus.is_empty();
    if !is_point || ends.iter().any(|weight| ![0.0, 1.0].contains(weight)) {
        return;
    }
    if let (Some(to), Some(from)) = (
        chains::chain(algebra, layout, sketch, statement, plus),
        chains::chain(algebra, layout, sketch, statement, minus),
    ) {
        sketch.segment(statement.frames, [from, to], title, Shape::Distance);
    }
}

/// True if a mass stands at a derived point.
fn is_mass_centre(mechanism: &Mechanism, index: usize) -> bool {
    let masses = mechanism.bodies.iter().flat_map(|body| &body.masses);
    let mut centres = masses.map(|(_, at)| at);
    centres.any(|at| at.as_name() == Some(Name::Let(index)))
}
