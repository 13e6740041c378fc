//! Sums of vectors as chains: from a point, each term is a step to the next.

use crate::algebra::translate;
use crate::picture::frames;
use crate::picture::loops;
use crate::picture::parts;
use crate::picture::starts;
use crate::picture::terms;
use crate::picture::titles;
use linkage_symbolic::lookup::Set;

use linkage_symbolic::Vn;

use crate::algebra::{Algebra, Translate};
use crate::model::{Expr, ExprKind, JointKind, Name, Type};

use super::frames::{Frames, Pose};
use super::marks::{Asked, Line, Mean, Segment, Shape, Spot, Term, Title};
use super::parts::Turn;
use super::planes::Plane;
use super::point_or_vector::{Moves, Roles};

/// Points and what lies between them, as they are found; several may be one and the same.
pub(super) struct Sketch<'a, 'm> {
    pub(super) algebra: &'a mut Algebra<'m>,
    pub(super) roles: Roles<'m>,
    /// Where placed parts stand.
    pub(super) poses: Vec<Pose<'m>>,
    /// The coordinates of what is looked at.
    pub(super) frames: Frames,
    pub(super) dimension: usize,
    pub(super) points: Vec<Spot<'m>>,
    pub(super) segments: Vec<Segment<'m>>,
    pub(super) means: Vec<Mean>,
    /// Guides that are no terms of a chain.
    pub(super) lines: Vec<Line<'m>>,
    /// In space: planes on which points stay, two of which are a guide.
    pub(super) planes: Vec<Plane<'m>>,
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

/// Longer sums are not looked at.
pub(super) const MANY_TERMS: usize = 200;

impl<'a, 'm> Sketch<'a, 'm> {
    pub(super) fn new(algebra: &'a mut Algebra<'m>, dimension: usize) -> Self {
        let roles = Roles::of(algebra.mechanism);
        let placed = algebra.mechanism.placed.iter();
        Self {
            poses: placed.map(|own| Pose::of(own, algebra, &roles)).collect(),
            frames: Frames::new(),
            algebra,
            roles,
            dimension,
            points: Vec::new(),
            segments: Vec::new(),
            means: Vec::new(),
            lines: Vec::new(),
            planes: Vec::new(),
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
        terms::collect_terms(self, expr, 1.0, None, &mut terms);
        self.chain(terms)
    }

    /// The point at the end of a sum; `None` if the sum is no point.
    pub(super) fn chain(&mut self, mut terms: Vec<Term<'m>>) -> Option<usize> {
        let total: f64 = terms.iter().map(|term| terms::weight_of(self, term)).sum();
        let is_weighted = |term: &Term| terms::weight_of(self, term) != 0.0;
        let weighted: Vec<usize> = (0..terms.len())
            .filter(|&k| is_weighted(&terms[k]))
            .collect();
        let start = match weighted[..] {
            _ if terms.len() > MANY_TERMS => return None,
            [] => self.fixed_start(&mut terms),
            [one] if total == 1.0 => {
                let term = terms.remove(one);
                starts::start(self, term.expr)
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
            .partition(|term| parts::moves_of(self, term) != Moves::Not);
        *terms = moving;
        let point = self.sum(&fixed);
        if let [term] = &fixed[..]
            && term.sign > 0.0
            && term.part.is_none()
            && let ExprKind::Name(Name::Parameter(_) | Name::Const(_)) = term.expr.kind
        {
            titles::name(self, point, 2, term.expr);
        }
        frames::carried(self, point);
        point
    }

    /// The point at the sum of these terms, the origin without any.
    fn sum(&mut self, terms: &[Term<'m>]) -> usize {
        let start = self.algebra.graph.zeros(self.dimension);
        let sum = terms.iter().fold(start, |sum, term| {
            let step = parts::step_of(self, term);
            moved(sum, step, term.sign)
        });
        self.point(sum)
    }

    fn step(&mut self, from: usize, term: Term<'m>) -> usize {
        let step = parts::step_of(self, &term);
        let (way, own) = (frames::seen_way(self, step), &self.points[from]);
        let to = self.spot(
            moved(own.at, way, term.sign),
            moved(own.own, step, term.sign),
        );
        for turn in parts::turns_of(self, &term) {
            let along = frames::seen_way(self, turn.along);
            let turn = Turn { along, ..turn };
            // What turns with the step before does not turn against it.
            if !self.turns.contains(&(from, turn)) {
                parts::axis(self, from, turn.along);
            }
            self.turns.push((to, turn));
        }
        let text = |rank: u8| move |text| Title { rank, text };
        let (title, shape) = match (term.name, term.part) {
            (Some(name), None) => (
                Some(text(1 + self.remoteness)(name)),
                Shape::Term(term.sign, term.expr),
            ),
            (None, None) => (
                titles::title(self, term.expr),
                Shape::Term(term.sign, term.expr),
            ),
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
                frames: self.frames.clone(),
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
                let is_drawn =
                    *count == self.dimension || is_flat && !loops::is_projection(self, expr);
                is_drawn && dimension.half_lengths == 2
            }
            Type::Zero(_) => true,
            Type::Scalar(_) | Type::Array(_) | Type::Frame | Type::PlaneFrame | Type::Error => {
                false
            }
        }
    }

    pub(super) fn vector(&mut self, expr: &Expr) -> Vn<'m> {
        let value = self.algebra.translate(expr);
        translate::vector(self.algebra, &value).resized(self.dimension)
    }

    /// The point with these coordinates.
    pub(super) fn point(&mut self, own: Vn<'m>) -> usize {
        let at = frames::seen_point(self, own);
        self.spot(at, own)
    }

    /// The point that is here in the drawing, and there as it is written.
    fn spot(&mut self, at: Vn<'m>, own: Vn<'m>) -> usize {
        let known = self.points.iter().position(|point| point.at == at);
        known.unwrap_or_else(|| {
            self.points.push(Spot {
                at,
                own,
                frames: self.frames.clone(),
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
            self.segments.push(Segment {
                from,
                to,
                title,
                shape,
                step: self.points[from].step_to(&self.points[to]),
                frames: self.frames.clone(),
            });
        }
    }
}

/// Where a step leads.
fn moved<'m>(from: Vn<'m>, step: Vn<'m>, sign: f64) -> Vn<'m> {
    if sign > 0.0 { from + step } else { from - step }
}
