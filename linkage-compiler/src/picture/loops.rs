//! What loops, derived names, bodies and joints are made of.

use linkage_symbolic::{Ex, NodeId};

use crate::model::{Expr, ExprKind, Function, Let, Loop, Mechanism, Name, Type};

use super::chains::Sketch;
use super::marks::{Asked, Shape, Term, Title};

/// Names in derived quantities stand behind those in loops, and where no loop uses the quantity behind all others.
const LET: [u8; 2] = [3, 6];

impl<'m> Sketch<'_, 'm> {
    /// All that the program says of points and links.
    pub(super) fn collect(&mut self) {
        self.look_at_lets();
        self.look_at_unknowns();
        for (index, own) in self.algebra.mechanism.loops.iter().enumerate() {
            if self.is_anywhere(own) {
                self.undrawn.push(index + 1);
            } else {
                let frames = self.frames_of_loop(index);
                self.within(frames, |sketch| sketch.look_at_loop(own));
            }
        }
        self.look_at_bodies();
    }

    /// Named points, those aside that are centres of mass only.
    fn look_at_lets(&mut self) {
        let mechanism = self.algebra.mechanism;
        let loops: Vec<usize> = (0..mechanism.loops.len()).collect();
        let usage = mechanism.usage(&loops);
        for (index, own) in mechanism.lets.iter().enumerate() {
            let is_centre = !usage.lets[index] && is_mass_centre(mechanism, index);
            if self.roles.is_step(Name::Let(index)) || is_centre {
                continue;
            }
            self.remoteness = LET[usize::from(!usage.lets[index])];
            let frames = self.frames_of(Name::Let(index));
            self.within(frames, |sketch| sketch.look_at_let(own));
        }
        self.remoteness = 0;
    }

    fn look_at_let(&mut self, own: &'m Let) {
        if let Some(point) = self.point_of(&own.value) {
            let at = self.vector(&own.value);
            let named = self.point(at);
            for point in [point, named] {
                let text = own.name.clone();
                self.call(point, Title { rank: 0, text });
            }
            self.points[named].wanted = true;
        }
    }

    /// Unknown points.
    fn look_at_unknowns(&mut self) {
        let mechanism = self.algebra.mechanism;
        for (index, own) in mechanism.unknowns.iter().enumerate() {
            let Type::Vector(count, dimension) = own.ty else {
                continue;
            };
            let is_point = count == self.dimension && dimension.half_lengths == 2;
            if is_point && !self.roles.is_step(Name::Unknown(index)) {
                let numbers = self.algebra.names.numbers_of(index).into_iter();
                let numbers: Vec<NodeId> = numbers.map(Ex::id).collect();
                let at = self.algebra.graph.components(&numbers);
                let frames = self.frames_of(Name::Unknown(index));
                let point = self.within(frames, |sketch| sketch.point(at));
                let text = own.name.clone();
                self.call(point, Title { rank: 1, text });
                self.points[point].wanted = true;
            }
        }
    }

    /// The links that `picture` lists.
    pub(super) fn add_lists(&mut self, lists: &'m [Vec<Expr>]) {
        for list in lists {
            let points: Vec<usize> = list
                .iter()
                .map(|expr| {
                    let at = self.vector(expr);
                    let found = self.point_of(expr);
                    let point = self.point(at);
                    self.name(point, 0, expr);
                    self.points[point].wanted = true;
                    found.unwrap_or(point)
                })
                .collect();
            let origin = list[0].origin;
            self.asked.push(Asked { points, origin });
        }
    }

    fn look_at_loop(&mut self, own: &'m Loop) {
        match own.left.ty {
            Type::Vector(..) => {
                let is_flat = self.is_flat(&own.left) && self.is_flat(&own.right);
                for side in self.sides(own) {
                    if let Some(end) = self.chain(side) {
                        self.points[end].wanted = true;
                        if is_flat {
                            self.axis(end, self.axis_of(2));
                        }
                    }
                }
            }
            _ => {
                for (side, other) in [(&own.left, &own.right), (&own.right, &own.left)] {
                    let title = self.spoken(other).map(|text| Title { rank: 2, text });
                    self.look_for_rods(side, title);
                    self.look_for_line(side, other);
                }
            }
        }
    }

    /// Whether a loop is one of the plane made of components of vectors of space: it is not known where in space it lies.
    fn is_anywhere(&self, own: &Loop) -> bool {
        let sides = [&own.left, &own.right];
        let is_vector = matches!(own.left.ty, Type::Vector(..));
        is_vector
            && sides.iter().all(|side| self.is_flat(side))
            && sides.iter().any(|side| self.is_projection(side))
    }

    /// Whether it lies in a plane of a mechanism of space.
    fn is_flat(&self, expr: &Expr) -> bool {
        self.dimension == 3 && matches!(expr.ty, Type::Vector(2, _) | Type::Zero(_))
    }

    /// Whether a vector of the plane has components of vectors of space: it may lie in any plane.
    pub(super) fn is_projection(&self, expr: &Expr) -> bool {
        expr.parts().any(|part| match &part.kind {
            ExprKind::Component(vector, _) => matches!(vector.ty, Type::Vector(3, _)),
            ExprKind::Name(name) => {
                let value = self.algebra.mechanism.value_of(*name);
                value.is_some_and(|value| self.is_projection(value))
            }
            _ => false,
        })
    }

    /// The two ways from one point to another that a vector loop consists of, each in the order in which it is written.
    fn sides(&mut self, own: &'m Loop) -> [Vec<Term<'m>>; 2] {
        let [left, right] = [&own.left, &own.right].map(|side| {
            let mut terms = Vec::new();
            self.terms(side, 1.0, None, &mut terms);
            terms.into_iter().partition(|term| term.sign > 0.0)
        });
        let ((left, left_minus), (right, right_minus)) = (left, right);
        [(left, right_minus), (right, left_minus)].map(|(own, moved)| self.side(own, moved))
    }

    /// What one side adds, and what the other one subtracts: a way to where the difference begins, unless this side has a point to
    /// begin with.
    fn side(&self, own: Vec<Term<'m>>, moved: Vec<Term<'m>>) -> Vec<Term<'m>> {
        let moved = moved.into_iter().map(|term| Term { sign: 1.0, ..term });
        let is_start = |term: &Term| self.weight_of(term) == 1.0;
        let mut all: Vec<Term> = match own.iter().any(is_start) {
            true => own.into_iter().chain(moved).collect(),
            false => moved.chain(own).collect(),
        };
        all.sort_by_key(|term| !is_start(term));
        all
    }

    /// Distances between points.
    fn look_for_rods(&mut self, expr: &'m Expr, title: Option<Title>) {
        match &expr.kind {
            ExprKind::Call(Function::Distance, ends) => {
                if let (Some(from), Some(to)) = (self.point_of(&ends[0]), self.point_of(&ends[1])) {
                    self.segment(from, to, title, Shape::Distance);
                }
            }
            ExprKind::Call(Function::Norm, vector) => self.look_for_rod(&vector[0], title),
            ExprKind::Call(Function::Dot, vectors) => {
                let both = (self.vector(&vectors[0]), self.vector(&vectors[1]));
                if both.0 == both.1 {
                    self.look_for_rod(&vectors[0], title);
                }
            }
            ExprKind::Name(Name::Let(index)) => {
                if self.searched.insert(*index) {
                    let own = &self.algebra.mechanism.lets[*index].value;
                    let frames = self.frames_of(Name::Let(*index));
                    self.within(frames, |sketch| sketch.look_for_rods(own, title));
                }
            }
            _ => {
                for operand in expr.operands() {
                    self.look_for_rods(operand, title.clone());
                }
            }
        }
    }

    /// `q - p`, a rod between two points; a point alone is as far from the origin.
    fn look_for_rod(&mut self, vector: &'m Expr, title: Option<Title>) {
        let mut terms = Vec::new();
        self.terms(vector, 1.0, None, &mut terms);
        let (plus, mut minus): (Vec<_>, Vec<_>) =
            terms.into_iter().partition(|term| term.sign > 0.0);
        minus.iter_mut().for_each(|term| term.sign = 1.0);
        let weight = |side: &[Term]| side.iter().map(|term| self.weight_of(term)).sum::<f64>();
        let ends = [weight(&plus), weight(&minus)];
        let is_point = ends.contains(&1.0) || !plus.is_empty() && !minus.is_empty();
        if !is_point || ends.iter().any(|weight| ![0.0, 1.0].contains(weight)) {
            return;
        }
        if let (Some(to), Some(from)) = (self.chain(plus), self.chain(minus)) {
            self.segment(from, to, title, Shape::Distance);
        }
    }
}

/// Whether a mass stands at a derived point.
fn is_mass_centre(mechanism: &Mechanism, index: usize) -> bool {
    let masses = mechanism.bodies.iter().flat_map(|body| &body.masses);
    let mut centres = masses.map(|(_, at)| at);
    centres.any(|at| at.as_name() == Some(Name::Let(index)))
}
