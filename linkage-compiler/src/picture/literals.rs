//! Vectors written by their components, `(d + c * cos(psi), c * sin(psi))`: the sum of a fixed
//! vector, of a point, and of steps, each with a length of its own.

use std::collections::BTreeSet;

use linkage_symbolic::{Ex, NodeId, Vn};

use crate::algebra::{Algebra, Translate, scalar};
use crate::model::{BinaryOp, Expr, ExprKind, Mechanism, Name, Type};
use crate::picture::layout::Layout;
use crate::picture::marks::{Slide, StepPart, Title, Turn};
use crate::picture::point_or_vector::{Moves, Roles};
use crate::picture::{expressions, layout, weights};

/// A product within a component.
#[derive(Clone)]
struct Summand<'m> {
    sign: f64,
    factors: Vec<&'m Expr>,
    divisors: Vec<&'m Expr>,
}

/// The common parts of summands in different components that belong together.
#[derive(Clone, PartialEq)]
enum Step<'m> {
    Fixed,
    Point(&'m Expr),
    /// The lengths in it, and how many summands of its component with the same ones stand before
    /// it.
    Long(Vec<&'m Expr>, usize),
}

/// A piece of a literal.
pub(super) enum Piece<'m> {
    Point(&'m Expr),
    Part(StepPart<'m>),
}

struct Group<'m> {
    step: Step<'m>,
    /// With the component that each belongs to.
    summands: Vec<(usize, Summand<'m>)>,
}

/// The points and steps that a literal is the sum of; nothing if it is one of them.
pub(super) fn pieces<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    components: &'m [Expr],
) -> Vec<Piece<'m>> {
    let mut groups: Vec<Group<'m>> = Vec::new();
    for (component, expr) in components.iter().enumerate() {
        let mut steps: Vec<Step> = Vec::new();
        for summand in expanded(algebra.mechanism, expr) {
            let step = step_of_summand(
                algebra.mechanism,
                &layout.roles,
                component,
                &summand,
                &steps,
            );
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
        Step::Fixed | Step::Long(..) => {
            Piece::Part(part(algebra, layout, remoteness, &group, components.len()))
        }
    });
    pieces.collect()
}

/// The products that a number is the sum of.
fn expanded<'m>(mechanism: &'m Mechanism, expr: &'m Expr) -> Vec<Summand<'m>> {
    let negative = |summand: Summand<'m>| Summand {
        sign: -summand.sign,
        ..summand
    };
    match &expr.kind {
        ExprKind::Number(0.0) => Vec::new(),
        ExprKind::Negate(a) => expanded(mechanism, a).into_iter().map(negative).collect(),
        ExprKind::Binary(BinaryOp::Add, a, b) => {
            let both = [expanded(mechanism, a), expanded(mechanism, b)];
            both.concat()
        }
        ExprKind::Binary(BinaryOp::Sub, a, b) => {
            let mut summands = expanded(mechanism, a);
            summands.extend(expanded(mechanism, b).into_iter().map(negative));
            summands
        }
        ExprKind::Binary(BinaryOp::Mul, a, b) => {
            let (a, b) = (expanded(mechanism, a), expanded(mechanism, b));
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
            let summands = expanded(mechanism, a).into_iter();
            let divided = summands.map(|mut summand| {
                summand.divisors.push(b);
                summand
            });
            divided.collect()
        }
        ExprKind::Name(Name::Let(index)) => {
            let within = expanded(mechanism, &mechanism.lets[*index].value);
            match within.len() {
                0 | 1 => vec![single(expr)],
                _ => within,
            }
        }
        _ => vec![single(expr)],
    }
}

fn step_of_summand<'m>(
    mechanism: &Mechanism,
    roles: &Roles,
    component: usize,
    summand: &Summand<'m>,
    before: &[Step<'m>],
) -> Step<'m> {
    let factors = || summand.factors.iter().chain(&summand.divisors);
    if factors().all(|factor| roles.moves(factor) == Moves::Not) {
        return Step::Fixed;
    }
    if let ([factor], []) = (&summand.factors[..], &summand.divisors[..])
        && let ExprKind::Component(point, index) = &factor.kind
        && *index == component
        && summand.sign > 0.0
        && weights::weight(mechanism, roles, point) == Some(1.0)
    {
        return Step::Point(point);
    }
    let parts = factors().flat_map(|factor| factor.parts());
    let lengths = parts.filter(|part| {
        let dimension = part.ty.dimension();
        let is_length = dimension.is_some_and(|dimension| dimension.half_lengths == 2);
        let is_atom = matches!(part.kind, ExprKind::Name(_) | ExprKind::Number(_));
        is_length && is_atom
    });
    let lengths: Vec<&Expr> = lengths.collect();
    let alike = |step: &&Step| matches!(step, Step::Long(other, _) if *other == lengths);
    let number = before.iter().filter(alike).count();
    Step::Long(lengths, number)
}

fn part<'m>(
    algebra: &mut Algebra<'m>,
    layout: &Layout<'m>,
    remoteness: u8,
    group: &Group<'m>,
    count: usize,
) -> StepPart<'m> {
    let summands = || group.summands.iter();
    let factors = || summands().flat_map(|(_, summand)| summand.factors.iter().copied());
    let moves = factors().map(|factor| layout.roles.moves(factor)).max();
    let rank = 2 + remoteness;
    let title = factors().find_map(|factor| expressions::dimension_in(algebra.mechanism, factor));
    let title = title.map(|text| Title { rank, text });
    let at = assembled(algebra, layout.dimension, group, count, None);
    let slides = |factor: &&Expr| {
        let dimension = factor.ty.dimension();
        let is_length = dimension.is_some_and(|dimension| dimension.half_lengths == 2);
        is_length && matches!(factor.as_name(), Some(Name::Unknown(_) | Name::Input(_)))
    };
    let slide = factors().find(slides).map(|length| {
        let along = assembled(algebra, layout.dimension, group, count, Some(length)).unit();
        Slide {
            offset: None,
            along,
            input: expressions::driving(algebra.mechanism, length),
        }
    });
    let components: BTreeSet<usize> = summands().map(|(component, _)| *component).collect();
    let components: Vec<usize> = components.into_iter().collect();
    let slide = match (slide, &components[..]) {
        (None, [component]) => Some(Slide {
            offset: None,
            along: layout::axis_of(algebra.graph, layout.dimension, *component),
            input: None,
        }),
        (slide, _) => slide,
    };
    let third = (0..layout.dimension).filter(|axis| !components.contains(axis));
    let turns = match (slide, &third.collect::<Vec<_>>()[..]) {
        // What turns in the plane of two coordinates turns about the third.
        (None, [third]) if layout.dimension == 3 => vec![Turn {
            along: layout::axis_of(algebra.graph, layout.dimension, *third),
            by: None,
        }],
        _ => Vec::new(),
    };
    StepPart {
        at,
        title,
        slide,
        moves: moves.unwrap_or(Moves::Not),
        turns,
    }
}

/// The vector of a group, without one of its factors.
fn assembled<'m>(
    algebra: &mut Algebra<'m>,
    dimension: usize,
    group: &Group<'m>,
    count: usize,
    without: Option<&Expr>,
) -> Vn<'m> {
    let graph = algebra.graph;
    let mut components = vec![algebra.zero(); count];
    for (component, summand) in &group.summands {
        let mut number = |expr: &Expr| {
            let value = algebra.translate(expr);
            scalar::number(&algebra.names, &value)
        };
        let factors = summand.factors.iter();
        let factors = factors.filter(|factor| without.is_none_or(|other| ***factor != *other));
        let start: Ex<'m> = graph.ex(graph.constant(summand.sign));
        let product = factors.fold(start, |product, factor| product * number(factor));
        let divisors = summand.divisors.iter();
        let quotient = divisors.fold(product, |product, divisor| product / number(divisor));
        components[*component] += quotient;
    }
    let ids: Vec<NodeId> = components.into_iter().map(Ex::id).collect();
    graph.components(&ids).resized(dimension)
}

fn single(expr: &Expr) -> Summand<'_> {
    Summand {
        sign: 1.0,
        factors: vec![expr],
        divisors: Vec::new(),
    }
}
