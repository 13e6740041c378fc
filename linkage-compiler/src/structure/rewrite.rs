//! Bringing a coupled set of loops to known forms: distances become links, components become vectors, a sum of angles
//! becomes an angle.

use linkage_symbolic::{NodeId, SymbolId, collect};

use crate::algebra::Atom;

use super::Analysis;
use super::eliminate::System;
use super::equations::{Coordinate, CoordinateKind, Equation};

impl Analysis<'_, '_> {
    /// `dot(p, n) = c` keeps the unknown point `p` on a line: it is the line's foot and a slide along it.
    pub(super) fn point_on_line(
        &mut self,
        equations: &[Equation],
        coordinates: &[Coordinate],
    ) -> Option<System> {
        if equations.len() < 2 {
            return None;
        }
        for (place, equation) in equations
            .iter()
            .enumerate()
            .filter(|(_, e)| e.rows.len() == 1)
        {
            for pair in coordinates.windows(2) {
                let (CoordinateKind::Length(x), CoordinateKind::Length(y)) =
                    (pair[0].kind, pair[1].kind)
                else {
                    continue;
                };
                let same_point = pair[0].unknown == pair[1].unknown;
                let Some((normal, known)) =
                    self.line(equation.rows[0], [x, y]).filter(|_| same_point)
                else {
                    continue;
                };
                let fixed = [normal[0], normal[1], known];
                if coordinates
                    .iter()
                    .any(|c| fixed.iter().any(|&node| self.contains(node, c)))
                {
                    continue;
                }
                let slide = self.slide_along(normal, known, [x, y]);
                let (equations, mut kept) = self.without(equations, coordinates, place, pair);
                kept.push(Coordinate {
                    kind: CoordinateKind::Length(slide),
                    unknown: None,
                });
                return Some((equations, kept));
            }
        }
        None
    }

    /// `n` and `c` of a row `n.x x + n.y y + c`.
    fn line(&mut self, row: NodeId, point: [SymbolId; 2]) -> Option<([NodeId; 2], NodeId)> {
        let graph = &mut self.algebra.graph;
        let mut terms = collect(graph, row, &point, &[])?;
        let zero = graph.zero();
        let normal = [terms.remove(&vec![1, 0])?, terms.remove(&vec![0, 1])?];
        let known = terms.remove(&vec![0, 0]).unwrap_or(zero);
        terms.is_empty().then_some((normal, known))
    }

    /// Expresses a point on the line `n.p + c = 0` by a new slide along it.
    fn slide_along(
        &mut self,
        normal: [NodeId; 2],
        known: NodeId,
        point: [SymbolId; 2],
    ) -> SymbolId {
        let (length, unit) = if self.algebra.is_unit(normal) {
            (self.algebra.graph.one(), normal)
        } else {
            let length = self.algebra.length(&normal);
            (length, normal.map(|n| self.algebra.graph.div(n, length)))
        };
        self.algebra.mark_unit(unit);
        let graph = &mut self.algebra.graph;
        let (symbol, slide) = graph.unknown("along the line");
        let distance = graph.div(known, length);
        let along = [graph.neg(unit[1]), unit[0]];
        for k in 0..2 {
            let graph = &mut self.algebra.graph;
            let foot = graph.mul(distance, unit[k]);
            let moved = graph.mul(slide, along[k]);
            let value = graph.sub(moved, foot);
            self.make_explicit(point[k], value);
        }
        symbol
    }

    /// Two scalar loops, the components of one vector loop.
    pub(super) fn join_rows(
        &mut self,
        equations: &[Equation],
        coordinates: &[Coordinate],
    ) -> Option<System> {
        let [a, b] = equations else { return None };
        if a.rows.len() != 1 || b.rows.len() != 1 {
            return None;
        }
        let orders = [(a, b), (b, a)];
        let joined = orders.map(|(first, second)| Equation {
            rows: vec![first.rows[0], second.rows[0]],
            relation: None,
            loops: sorted(&first.loops, &second.loops),
            eliminated: sorted(&first.eliminated, &second.eliminated),
        });
        joined
            .into_iter()
            .find(|equation| self.classify(equation, coordinates).is_some())
            .map(|equation| (vec![equation], coordinates.to_vec()))
    }

    /// `distance(a, b) = l` is a link of length `l` between `a` and `b`, at an angle of its own.
    pub(super) fn distance_to_link(
        &mut self,
        equations: &[Equation],
        coordinates: &[Coordinate],
    ) -> Option<System> {
        for (place, equation) in equations
            .iter()
            .enumerate()
            .filter(|(_, e)| e.rows.len() == 1)
        {
            let Some((vector, length)) = self.distance(equation.rows[0]) else {
                continue;
            };
            let mut equations = equations.to_vec();
            let mut coordinates = coordinates.to_vec();
            let angle = self.algebra.add_angle("link", None);
            let unit = [
                self.algebra.angles[angle].cos_node,
                self.algebra.angles[angle].sin_node,
            ];
            let graph = &mut self.algebra.graph;
            let rows = (0..2).map(|k| {
                let along = graph.mul(length, unit[k]);
                graph.sub(vector[k], along)
            });
            equations[place].rows = rows.collect();
            equations[place].relation = None;
            coordinates.push(Coordinate {
                kind: CoordinateKind::Angle(angle),
                unknown: None,
            });
            return Some((equations, coordinates));
        }
        None
    }

    /// A row `|v| - l` (or its negative): `v` and `l`.
    fn distance(&self, row: NodeId) -> Option<([NodeId; 2], NodeId)> {
        use linkage_symbolic::Node;
        use linkage_symbolic::program::{Binary, Unary};
        let row = match self.algebra.graph.node(row) {
            Node::Unary(Unary::Neg, inner) => inner,
            _ => row,
        };
        let Node::Binary(Binary::Sub, a, b) = self.algebra.graph.node(row) else {
            return None;
        };
        [(a, b), (b, a)]
            .into_iter()
            .find_map(|(norm, length)| self.algebra.norms.get(&norm).map(|v| (*v, length)))
    }

    /// An angle whose vectors do not simply turn, with a slide: the equation across the guide contains the angle alone.
    pub(super) fn split_along_guide(
        &mut self,
        equations: &[Equation],
        coordinates: &[Coordinate],
    ) -> Option<System> {
        let ([equation], [a, b]) = (equations, coordinates) else {
            return None;
        };
        let (angle, slide) = match (a.kind, b.kind) {
            (CoordinateKind::Angle(_), CoordinateKind::Length(slide)) => (a, slide),
            (CoordinateKind::Length(slide), CoordinateKind::Angle(_)) => (b, slide),
            _ => return None,
        };
        let [x, y] = equation.rows[..] else {
            return None;
        };
        let graph = &mut self.algebra.graph;
        let mut guide = [graph.zero(); 2];
        for (row, direction) in [x, y].into_iter().zip(&mut guide) {
            let terms = collect(graph, row, &[slide], &[])?;
            if terms.keys().any(|exponents| exponents[0] > 1) {
                return None;
            }
            *direction = terms.get(&vec![1]).copied().unwrap_or(graph.zero());
        }
        if guide.iter().any(|&g| self.contains(g, angle)) {
            return None;
        }
        let across = self.algebra.cross(guide, [x, y]);
        let along = self.algebra.dot(&guide, &[x, y]);
        let clean = self.linear_part(across, slide)?;
        let row = |node| Equation {
            rows: vec![node],
            relation: None,
            ..equation.clone()
        };
        Some((vec![row(clean), row(along)], coordinates.to_vec()))
    }

    /// `row` without the terms in `slide`, which cancel.
    fn linear_part(&mut self, row: NodeId, slide: SymbolId) -> Option<NodeId> {
        let terms = collect(&mut self.algebra.graph, row, &[slide], &[])?;
        let cancelled = terms.keys().all(|exponents| exponents[0] == 0);
        terms.get(&vec![0]).copied().filter(|_| cancelled)
    }

    /// Angles measured from link to link: their sum is the angle of the second link.
    pub(super) fn relative_angle(
        &mut self,
        equations: &[Equation],
        coordinates: &[Coordinate],
    ) -> Option<System> {
        let ([equation], [a, b]) = (equations, coordinates) else {
            return None;
        };
        let (CoordinateKind::Angle(first), CoordinateKind::Angle(second)) = (a.kind, b.kind) else {
            return None;
        };
        for (base, relative, kept) in [(first, second, a), (second, first, b)] {
            for sign in [1.0, -1.0] {
                let sum = self.algebra.add_angle("sum", None);
                self.algebra.angles[sum].stands_for = self.sum_of(base, relative, sign);
                let mut value = self.algebra.atom(Atom::Angle(sum));
                value.terms.insert(0, (Atom::Angle(base), -sign));
                value.terms.sort_by_key(|(atom, _)| *atom);
                let saved = (self.substitutions.clone(), self.structure.explicit.len());
                self.replace_angle(relative, &value);
                let mut changed = self.substituted(equation);
                changed
                    .eliminated
                    .extend([a, b].iter().filter_map(|c| c.unknown));
                let summed = Coordinate {
                    kind: CoordinateKind::Angle(sum),
                    unknown: None,
                };
                let coordinates = vec![kept.clone(), summed];
                if self.classify(&changed, &coordinates).is_some() {
                    return Some((vec![changed], coordinates));
                }
                self.substitutions = saved.0;
                self.structure.explicit.truncate(saved.1);
            }
        }
        None
    }
}

impl Analysis<'_, '_> {
    /// The sum of an angle and the one it is measured from stands for the former.
    fn sum_of(&self, base: usize, relative: usize, sign: f64) -> Option<(usize, f64)> {
        let [base, relative] = [base, relative].map(|k| &self.algebra.angles[k]);
        let estimate = relative.estimate(self.nominal) + sign * base.estimate(self.nominal);
        relative.meant().map(|unknown| (unknown, estimate))
    }
}

fn sorted(a: &[usize], b: &[usize]) -> Vec<usize> {
    let mut all: Vec<usize> = a.iter().chain(b).copied().collect();
    all.sort_unstable();
    all.dedup();
    all
}
