//! Vectors written by their components, `(d + c * cos(psi), c * sin(psi))`: the sum of what does not move, of a point, and of steps, each
//! with a length of its own.

use crate::algebra::translate;
use crate::picture::drives;
use crate::picture::guides;
use crate::picture::terms;
use crate::picture::titles;
use std::collections::BTreeSet;

use linkage_symbolic::{Ex, NodeId, Vn};

use crate::algebra::Translate;
use crate::model::{BinaryOp, Expr, ExprKind, Name, Type};

use super::chains::Sketch;
use super::marks::Title;
use super::parts::{Part, Slide, Turn};
use super::point_or_vector::Moves;

/// A product within a component.
#[derive(Clone)]
struct Summand<'m> {
    sign: f64,
    factors: Vec<&'m Expr>,
    divisors: Vec<&'m Expr>,
}

/// What summands of different components have in common if they belong together.
#[derive(Clone, PartialEq)]
enum Step<'m> {
    Fixed,
    Point(&'m Expr),
    /// The lengths in it, and how many summands of its component with the same ones stand before it.
    Long(Vec<&'m Expr>, usize),
}

/// What a literal consists of.
pub(super) enum Piece<'m> {
    Point(&'m Expr),
    Part(Part<'m>),
}

struct Group<'m> {
    step: Step<'m>,
    /// With the component that each belongs to.
    summands: Vec<(usize, Summand<'m>)>,
}

/// The points and steps that a literal is the sum of; nothing if it is one of them.
pub(super) fn pieces<'m>(sketch: &mut Sketch<'_, 'm>, components: &'m [Expr]) -> Vec<Piece<'m>> {
    let mut groups: Vec<Group<'m>> = Vec::new();
    for (component, own) in components.iter().enumerate() {
        let mut steps: Vec<Step> = Vec::new();
        for summand in expanded(sketch, own) {
            let step = step_of_summand(sketch, component, &summand, &steps);
            steps.push(step.clone());
            let summand = (component, summand);
            match groups.iter_mut().find(|group| group.step == step) {
                Some(group) => group.summands.push(summand),
                None => groups.push(Group {
                    step,
                    summands: vec![summand],
                }),
            }
        }
    }
    let is_whole = |group: &Group| match group.step {
        // A point of the plane may stand in a vector of space.
        Step::Point(Expr {
            ty: Type::Vector(count, _),
            ..
        }) => group.summands.len() == *count,
        Step::Point(_) => false,
        Step::Fixed | Step::Long(..) => true,
    };
    let is_point = |group: &Group| matches!(group.step, Step::Point(_));
    let is_step = groups.len() < 2 && !groups.iter().any(is_point);
    if is_step || !groups.iter().all(is_whole) {
        return Vec::new();
    }
    groups.sort_by_key(|group| match group.step {
        Step::Point(_) => 0,
        Step::Fixed => 1,
        Step::Long(..) => 2,
    });
    let pieces = groups.into_iter().map(|group| match group.step {
        Step::Point(point) => Piece::Point(point),
        Step::Fixed | Step::Long(..) => Piece::Part(part(sketch, &group, components.len())),
    });
    pieces.collect()
}

/// The products that a number is the sum of.
fn expanded<'m>(sketch: &Sketch<'_, 'm>, expr: &'m Expr) -> Vec<Summand<'m>> {
    let negative = |own: Summand<'m>| Summand {
        sign: -own.sign,
        ..own
    };
    match &expr.kind {
        ExprKind::Number(0.0) => Vec::new(),
        ExprKind::Negate(a) => expanded(sketch, a).into_iter().map(negative).collect(),
        ExprKind::Binary(BinaryOp::Add, a, b) => {
            let both = [expanded(sketch, a), expanded(sketch, b)];
            both.concat()
        }
        ExprKind::Binary(BinaryOp::Sub, a, b) => {
            let mut all = expanded(sketch, a);
            all.extend(expanded(sketch, b).into_iter().map(negative));
            all
        }
        ExprKind::Binary(BinaryOp::Mul, a, b) => {
            let (a, b) = (expanded(sketch, a), expanded(sketch, b));
            let products = a.iter().flat_map(|a| {
                b.iter().map(|b| Summand {
                    sign: a.sign * b.sign,
                    factors: [&a.factors[..], &b.factors].concat(),
                    divisors: [&a.divisors[..], &b.divisors].concat(),
                })
            });
            products.collect()
        }
        ExprKind::Binary(BinaryOp::Div, a, b) => {
            let all = expanded(sketch, a).into_iter();
            let divided = all.map(|mut own| {
                own.divisors.push(b);
                own
            });
            divided.collect()
        }
        ExprKind::Name(Name::Let(index)) => {
            let within = expanded(sketch, &sketch.algebra.mechanism.lets[*index].value);
            match within.len() {
                0 | 1 => vec![single(expr)],
                _ => within,
            }
        }
        _ => vec![single(expr)],
    }
}

fn step_of_summand<'m>(
    sketch: &Sketch<'_, 'm>,
    component: usize,
    summand: &Summand<'m>,
    before: &[Step<'m>],
) -> Step<'m> {
    let all = || summand.factors.iter().chain(&summand.divisors);
    if all().all(|own| sketch.moves(own) == Moves::Not) {
        return Step::Fixed;
    }
    if let ([factor], []) = (&summand.factors[..], &summand.divisors[..])
        && let ExprKind::Component(point, index) = &factor.kind
        && *index == component
        && summand.sign > 0.0
        && terms::weight(sketch, point) == Some(1.0)
    {
        return Step::Point(point);
    }
    let parts = all().flat_map(|own| own.parts());
    let lengths = parts.filter(|part| {
        let dimension = part.ty.dimension();
        let is_length = dimension.is_some_and(|own| own.half_lengths == 2);
        let is_atom = matches!(part.kind, ExprKind::Name(_) | ExprKind::Number(_));
        is_length && is_atom
    });
    let lengths: Vec<&Expr> = lengths.collect();
    let alike = |own: &&Step| matches!(own, Step::Long(other, _) if *other == lengths);
    let number = before.iter().filter(alike).count();
    Step::Long(lengths, number)
}

fn part<'m>(sketch: &mut Sketch<'_, 'm>, group: &Group<'m>, count: usize) -> Part<'m> {
    let all = || group.summands.iter();
    let factors = || all().flat_map(|(_, own)| own.factors.iter().copied());
    let moves = factors().map(|own| sketch.moves(own)).max();
    let rank = 2 + sketch.remoteness;
    let title = factors().find_map(|own| titles::dimension_in(sketch, own));
    let title = title.map(|text| Title { rank, text });
    let at = assembled(sketch, group, count, None);
    let slides = |own: &&Expr| {
        let dimension = own.ty.dimension();
        let is_length = dimension.is_some_and(|own| own.half_lengths == 2);
        is_length && matches!(own.as_name(), Some(Name::Unknown(_) | Name::Input(_)))
    };
    let slide = factors().find(slides).map(|length| {
        let along = assembled(sketch, group, count, Some(length)).unit();
        Slide {
            offset: None,
            along,
            input: drives::driving(sketch, length),
        }
    });
    let components: BTreeSet<usize> = all().map(|(component, _)| *component).collect();
    let components: Vec<usize> = components.into_iter().collect();
    let slide = match (slide, &components[..]) {
        (None, [component]) => Some(Slide {
            offset: None,
            along: guides::axis_of(sketch, *component),
            input: None,
        }),
        (slide, _) => slide,
    };
    let third = (0..sketch.dimension).filter(|own| !components.contains(own));
    let turns = match (slide, &third.collect::<Vec<_>>()[..]) {
        // What turns in the plane of two coordinates turns about the third.
        (None, [third]) if sketch.dimension == 3 => vec![Turn {
            along: guides::axis_of(sketch, *third),
            by: None,
        }],
        _ => Vec::new(),
    };
    Part {
        at,
        title,
        slide,
        moves: moves.unwrap_or(Moves::Not),
        turns,
    }
}

/// The vector of a group, without one of its factors.
fn assembled<'m>(
    sketch: &mut Sketch<'_, 'm>,
    group: &Group<'m>,
    count: usize,
    without: Option<&Expr>,
) -> Vn<'m> {
    let graph = sketch.algebra.graph;
    let mut components = vec![sketch.algebra.zero(); count];
    for (component, summand) in &group.summands {
        let mut number = |expr: &Expr| {
            let value = sketch.algebra.translate(expr);
            translate::number(sketch.algebra, &value)
        };
        let factors = summand.factors.iter();
        let factors = factors.filter(|own| without.is_none_or(|other| ***own != *other));
        let start: Ex<'m> = graph.ex(graph.constant(summand.sign));
        let product = factors.fold(start, |product, own| product * number(own));
        let divisors = summand.divisors.iter();
        let quotient = divisors.fold(product, |product, own| product / number(own));
        components[*component] += quotient;
    }
    let ids: Vec<NodeId> = components.into_iter().map(Ex::id).collect();
    graph.components(&ids).resized(sketch.dimension)
}

fn single(expr: &Expr) -> Summand<'_> {
    Summand {
        sign: 1.0,
        factors: vec![expr],
        divisors: Vec::new(),
    }
}
