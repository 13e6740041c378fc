//! Sums of vectors as chains: from a point, each term is a step to the next.

use linkage_symbolic::unordered::Set;

use linkage_symbolic::Vn;

use crate::algebra::{Algebra, Translate};
use crate::diagnostic::OriginId;
use crate::model::{Expr, ExprKind, JointKind, Name, Type};

use super::parts::{Part, Slide, Turn};
use super::roles::{Moves, Roles};

/// Points and what lies between them, as they are found; several may be one and the same.
pub(super) struct Sketch<'a, 'm> {
    pub(super) algebra: &'a mut Algebra<'m>,
    pub(super) roles: Roles,
    pub(super) dimension: usize,
    pub(super) points: Vec<Spot<'m>>,
    pub(super) segments: Vec<Segment<'m>>,
    pub(super) means: Vec<Mean>,
    /// Guides that are no terms of a chain.
    pub(super) lines: Vec<Line<'m>>,
    /// In space: points and directions of axes.
    pub(super) axes: Vec<(usize, Vn<'m>)>,
    /// In space: what turns the steps that end in points.
    turns: Vec<(usize, Turn<'m>)>,
    /// Points at which the program has joints.
    pub(super) joints: Vec<(usize, JointKind)>,
    /// Links that the user named, each by its points.
    pub(super) asked: Vec<Asked>,
    /// Added to the ranks of names: those in loops are better.
    pub(super) remoteness: u8,
    /// Loops that are not drawn, by number from 1.
    pub(super) undrawn: Vec<usize>,
    /// Derived names in which rods have been looked for.
    pub(super) searched: Set<usize>,
}

/// A point of a chain.
#[derive(Clone, Debug)]
pub(super) struct Spot<'m> {
    pub(super) at: Vn<'m>,
    pub(super) name: Option<Title>,
    /// Whether it is more than a corner on the way along a link: it has a name, a loop closes there, or the user lists it.
    pub(super) wanted: bool,
}

/// A name, and how good it is: the lowest rank wins, the first of equal ones.
#[derive(Clone, Debug)]
pub(super) struct Title {
    pub(super) rank: u8,
    pub(super) text: String,
}

/// From one point to another.
#[derive(Clone, Debug)]
pub(super) struct Segment<'m> {
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) title: Option<Title>,
    pub(super) shape: Shape<'m>,
    /// The vector from one to the other, as it is written.
    pub(super) step: Vn<'m>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Shape<'m> {
    /// A term of a sum with its sign: if it is no link, it may be a slide.
    Term(f64, &'m Expr),
    /// A part of a term.
    Part(f64, Option<Slide<'m>>),
    /// A distance: if it is no link, its ends slide along each other.
    Distance,
    /// Two points of a body, of which declarations have numbers.
    Body(Option<usize>),
}

/// A point that is computed from others, by a mean or in a frame: it may belong to their link.
#[derive(Clone, Debug)]
pub(super) struct Mean {
    pub(super) point: usize,
    pub(super) of: Vec<usize>,
}

/// A point that stays on a line.
#[derive(Clone, Debug)]
pub(super) struct Line<'m> {
    pub(super) slider: usize,
    /// A point of what carries the line; `None` is the frame.
    pub(super) carrier: Option<usize>,
    /// Whether the line goes through that point.
    pub(super) through: bool,
    pub(super) along: Vn<'m>,
    pub(super) name: String,
}

/// A list in `picture([p, q])`.
#[derive(Clone, Debug)]
pub(super) struct Asked {
    pub(super) points: Vec<usize>,
    pub(super) origin: OriginId,
}

/// A term of a sum.
pub(super) struct Term<'m> {
    pub(super) sign: f64,
    pub(super) expr: &'m Expr,
    /// The name that it goes by.
    pub(super) name: Option<String>,
    /// If it is only a part of the expression.
    pub(super) part: Option<Part<'m>>,
}

/// Longer sums are not looked at.
pub(super) const MANY_TERMS: usize = 200;

impl<'a, 'm> Sketch<'a, 'm> {
    pub(super) fn new(algebra: &'a mut Algebra<'m>, dimension: usize) -> Self {
        let roles = Roles::of(algebra.mechanism);
        Self {
            algebra,
            roles,
            dimension,
            points: Vec::new(),
            segments: Vec::new(),
            means: Vec::new(),
            lines: Vec::new(),
            axes: Vec::new(),
            turns: Vec::new(),
            joints: Vec::new(),
            undrawn: Vec::new(),
            asked: Vec::new(),
            remoteness: 0,
            searched: Set::new(),
        }
    }

    /// The point that an expression stands for, its chain recorded; `None` if it is no point.
    pub(super) fn point_of(&mut self, expr: &'m Expr) -> Option<usize> {
        if !self.is_vector(expr) {
            return None;
        }
        let mut terms = Vec::new();
        self.terms(expr, 1.0, None, &mut terms);
        self.chain(terms)
    }

    /// The point at the end of a sum; `None` if the sum is no point.
    pub(super) fn chain(&mut self, mut terms: Vec<Term<'m>>) -> Option<usize> {
        let total: f64 = terms.iter().map(|term| self.weight_of(term)).sum();
        let is_weighted = |term: &Term| self.weight_of(term) != 0.0;
        let weighted: Vec<usize> = (0..terms.len())
            .filter(|&k| is_weighted(&terms[k]))
            .collect();
        let start = match weighted[..] {
            _ if terms.len() > MANY_TERMS => return None,
            [] => self.fixed_start(&mut terms),
            [one] if total == 1.0 => {
                let term = terms.remove(one);
                self.start(term.expr)
            }
            // A mean of points is a point without a chain.
            _ if total == 1.0 => return Some(self.sum(&terms)),
            _ => return None,
        };
        Some(
            terms
                .into_iter()
                .fold(start, |from, term| self.step(from, term)),
        )
    }

    /// Where a chain begins that names no point: the sum of what does not move.
    fn fixed_start(&mut self, terms: &mut Vec<Term<'m>>) -> usize {
        let (moving, fixed): (Vec<_>, Vec<_>) = std::mem::take(terms)
            .into_iter()
            .partition(|term| self.moves_of(term) != Moves::Not);
        *terms = moving;
        let point = self.sum(&fixed);
        if let [term] = &fixed[..]
            && term.sign > 0.0
            && term.part.is_none()
            && let ExprKind::Name(Name::Parameter(_) | Name::Const(_)) = term.expr.kind
        {
            self.name(point, 2, term.expr);
        }
        point
    }

    /// The point at the sum of these terms, the origin without any.
    fn sum(&mut self, terms: &[Term<'m>]) -> usize {
        let start = self.algebra.graph.zeros(self.dimension);
        let sum = terms.iter().fold(start, |sum, term| {
            let step = self.step_of(term);
            moved(sum, step, term.sign)
        });
        self.point(sum)
    }

    fn step(&mut self, from: usize, term: Term<'m>) -> usize {
        let step = self.step_of(&term);
        let to = self.point(moved(self.points[from].at, step, term.sign));
        for turn in self.turns_of(&term) {
            // What turns with the step before does not turn against it.
            if !self.turns.contains(&(from, turn)) {
                self.axis(from, turn.along);
            }
            self.turns.push((to, turn));
        }
        let text = |rank: u8| move |text| Title { rank, text };
        let (title, shape) = match (term.name, term.part) {
            (Some(name), None) => (
                Some(text(1 + self.remoteness)(name)),
                Shape::Term(term.sign, term.expr),
            ),
            (None, None) => (self.title(term.expr), Shape::Term(term.sign, term.expr)),
            (name, Some(part)) => {
                let named = name.map(text(1 + self.remoteness));
                let title = named.or(part.title);
                (title, Shape::Part(term.sign, part.slide))
            }
        };
        if from != to {
            self.segments.push(Segment {
                from,
                to,
                title,
                shape,
                step,
            });
        }
        to
    }

    /// What an expression moves with.
    pub(super) fn moves(&self, expr: &Expr) -> Moves {
        self.roles.moves(expr)
    }

    /// Whether it is a vector of the picture's dimension, one of its plane of x and y, or a zero.
    fn is_vector(&self, expr: &Expr) -> bool {
        match &expr.ty {
            Type::Vector(count, dimension) => {
                let is_flat = (*count, self.dimension) == (2, 3);
                let is_drawn = *count == self.dimension || is_flat && !self.is_projection(expr);
                is_drawn && dimension.half_lengths == 2
            }
            Type::Zero(_) => true,
            Type::Scalar(_) | Type::Array(_) | Type::Frame | Type::Error => false,
        }
    }

    pub(super) fn vector(&mut self, expr: &Expr) -> Vn<'m> {
        let value = self.algebra.translate(expr);
        self.algebra.vector(&value).resized(self.dimension)
    }

    /// The point with these coordinates.
    pub(super) fn point(&mut self, at: Vn<'m>) -> usize {
        let known = self.points.iter().position(|point| point.at == at);
        known.unwrap_or_else(|| {
            self.points.push(Spot {
                at,
                name: None,
                wanted: false,
            });
            self.points.len() - 1
        })
    }

    pub(super) fn segment(
        &mut self,
        from: usize,
        to: usize,
        title: Option<Title>,
        shape: Shape<'m>,
    ) {
        if from != to {
            let step = self.points[to].at - self.points[from].at;
            self.segments.push(Segment {
                from,
                to,
                title,
                shape,
                step,
            });
        }
    }
}

/// Where a step leads.
fn moved<'m>(from: Vn<'m>, step: Vn<'m>, sign: f64) -> Vn<'m> {
    if sign > 0.0 { from + step } else { from - step }
}
