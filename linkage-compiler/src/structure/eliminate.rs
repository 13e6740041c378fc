//! Bringing a coupled set of loops to known forms: unknowns that are explicit expressions of others go, distances become
//! links, a sum of angles becomes an angle.

use linkage_symbolic::{NodeId, SymbolId, collect};

use crate::algebra::{Atom, Scalar};

use super::equations::{Coordinate, CoordinateKind, Equation};
use super::{Analysis, Explicit};

type System = (Vec<Equation>, Vec<Coordinate>);

impl Analysis<'_, '_> {
    /// An angle relation (`psi = theta + 30deg`) shows which vectors turn together.
    fn eliminate_relation(
        &mut self,
        equations: &[Equation],
        coordinates: &[Coordinate],
    ) -> Option<System> {
        let (place, angle) = self.find_relation(equations, coordinates)?;
        let value = self.solved_relation(&equations[place], angle)?;
        self.replace_angle(angle, &value);
        let mut equations = equations.to_vec();
        self.replace_in_relations(&mut equations, angle, &value);
        let gone: Vec<Coordinate> = coordinates
            .iter()
            .filter(|c| c.kind == CoordinateKind::Angle(angle))
            .cloned()
            .collect();
        Some(self.without(&equations, coordinates, place, &gone))
    }

    /// A relation between angles that contains no other unknown, and the angle it is best solved for: one that other
    /// loops use too, after whose removal the rest counts in whole multiples.
    fn find_relation(
        &self,
        equations: &[Equation],
        coordinates: &[Coordinate],
    ) -> Option<(usize, usize)> {
        equations.iter().enumerate().find_map(|(place, equation)| {
            let relation = equation.relation.as_ref()?;
            if coordinates.iter().any(|c| self.contains(relation.rest, c)) {
                return None;
            }
            let used_elsewhere = |c: &Coordinate| {
                let others = equations.iter().enumerate().filter(|(k, _)| *k != place);
                others
                    .flat_map(|(_, e)| &e.rows)
                    .any(|&row| self.contains(row, c))
            };
            let angles: Vec<usize> = coordinates
                .iter()
                .filter_map(|c| match c.kind {
                    CoordinateKind::Angle(index) => Some((c, index)),
                    CoordinateKind::Length(_) => None,
                })
                .filter(|(_, index)| relation.coefficient(Atom::Angle(*index)) != 0.0)
                .filter(|(c, _)| used_elsewhere(c))
                .map(|(_, index)| index)
                .collect();
            let whole = |index: &&usize| {
                let own = relation.coefficient(Atom::Angle(**index));
                let mut others = relation
                    .terms
                    .iter()
                    .filter(|(a, _)| matches!(a, Atom::Angle(_)));
                others.all(|(_, k)| (k / own).fract() == 0.0)
            };
            let angle = *angles.iter().rev().find(whole).or(angles.last())?;
            Some((place, angle))
        })
    }

    /// Relations between angles stay linear forms when one of their angles is replaced.
    fn replace_in_relations(&mut self, equations: &mut [Equation], angle: usize, value: &Scalar) {
        for equation in equations {
            let Some(mut relation) = equation.relation.clone() else {
                continue;
            };
            let factor = relation.coefficient(Atom::Angle(angle));
            if factor != 0.0 {
                relation
                    .terms
                    .retain(|(atom, _)| *atom != Atom::Angle(angle));
                let share = self.algebra.scale(value, factor);
                let relation = self.algebra.combine(&relation, &share, 1.0);
                equation.rows = vec![self.algebra.node(&relation)];
                equation.relation = Some(relation);
            }
        }
    }

    /// An angle relation solved for one angle.
    pub(super) fn solved_relation(&mut self, equation: &Equation, angle: usize) -> Option<Scalar> {
        let relation = equation.relation.clone()?;
        let own = relation.coefficient(Atom::Angle(angle));
        let symbols = &self.algebra.angles[angle];
        let own_symbols = [symbols.cos, symbols.sin, symbols.value];
        let present = self.algebra.graph.symbols_of(&[relation.rest]);
        if own == 0.0 || own_symbols.iter().any(|s| present.contains(s)) {
            return None;
        }
        let mut value = relation;
        value.terms.retain(|(atom, _)| *atom != Atom::Angle(angle));
        Some(self.algebra.scale(&value, -1.0 / own))
    }

    /// Makes an angle an explicit expression of others.
    pub(super) fn replace_angle(&mut self, angle: usize, value: &Scalar) {
        let [cos, sin] = self.algebra.direction(value);
        let node = self.algebra.node(value);
        let symbols = self.algebra.angles[angle].clone();
        for (symbol, value) in [
            (symbols.cos, cos),
            (symbols.sin, sin),
            (symbols.value, node),
        ] {
            self.make_explicit(symbol, value);
        }
    }

    fn make_explicit(&mut self, symbol: SymbolId, value: NodeId) {
        self.substitutions.insert(symbol, value);
        self.structure.explicit.push(Explicit { symbol, value });
    }

    /// Substitutes in all equations; those that change also answer for the eliminated loop and unknown.
    fn substitute_all(
        &mut self,
        equations: &mut [Equation],
        eliminated: &Equation,
        coordinate: &Coordinate,
    ) {
        for equation in equations {
            let mut changed = self.substituted(equation);
            if changed.rows != equation.rows {
                changed.loops.extend(&eliminated.loops);
                changed.loops.sort_unstable();
                changed.loops.dedup();
                changed.eliminated.extend(&eliminated.eliminated);
                changed.eliminated.extend(coordinate.unknown);
                *equation = changed;
            }
        }
    }

    /// One step towards known forms; `None` if there is none.
    pub(super) fn reduce(
        &mut self,
        equations: &[Equation],
        coordinates: &[Coordinate],
    ) -> Option<System> {
        self.eliminate_relation(equations, coordinates)
            .or_else(|| self.eliminate_point(equations, coordinates))
            .or_else(|| self.eliminate_slide(equations, coordinates))
            .or_else(|| self.join_rows(equations, coordinates))
            .or_else(|| self.distance_to_link(equations, coordinates))
            .or_else(|| self.split_along_guide(equations, coordinates))
            .or_else(|| self.relative_angle(equations, coordinates))
    }

    /// `p + ... = 0` in one of several vector loops gives the unknown point `p`.
    fn eliminate_point(
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
            .filter(|(_, e)| e.rows.len() == 2)
        {
            for pair in coordinates.windows(2) {
                let [
                    Coordinate {
                        kind: CoordinateKind::Length(x),
                        unknown: first,
                    },
                    Coordinate {
                        kind: CoordinateKind::Length(y),
                        unknown: second,
                    },
                ] = *pair
                else {
                    continue;
                };
                if first != second {
                    continue;
                }
                let Some(values) = self.solve_point(equation, [x, y]) else {
                    continue;
                };
                for (symbol, value) in [x, y].into_iter().zip(values) {
                    self.make_explicit(symbol, value);
                }
                return Some(self.without(equations, coordinates, place, pair));
            }
        }
        None
    }

    /// Both components of a point that enters an equation as `k (x, y)` with a constant `k`.
    fn solve_point(&mut self, equation: &Equation, point: [SymbolId; 2]) -> Option<[NodeId; 2]> {
        let graph = &mut self.algebra.graph;
        let mut values = [graph.zero(); 2];
        for row in 0..2 {
            let mut terms = collect(graph, equation.rows[row], &point, &[])?;
            let mut own = vec![0, 0];
            own[row] = 1;
            let factor = terms.remove(&own)?;
            let rest = terms.remove(&vec![0, 0]).unwrap_or(graph.zero());
            if !terms.is_empty() || graph.constant_value(factor).is_none() {
                return None;
            }
            let quotient = graph.div(rest, factor);
            values[row] = graph.neg(quotient);
        }
        Some(values)
    }

    /// A scalar loop that is linear in a slide, with a constant factor, gives that slide.
    fn eliminate_slide(
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
            for (k, coordinate) in coordinates.iter().enumerate() {
                let CoordinateKind::Length(symbol) = coordinate.kind else {
                    continue;
                };
                let graph = &mut self.algebra.graph;
                let Some(mut terms) = collect(graph, equation.rows[0], &[symbol], &[]) else {
                    continue;
                };
                let (factor, rest) = (terms.remove(&vec![1]), terms.remove(&vec![0]));
                let (Some(factor), true) = (factor, terms.is_empty()) else {
                    continue;
                };
                if graph.constant_value(factor).is_none() {
                    continue;
                }
                let rest = rest.unwrap_or(graph.zero());
                let quotient = graph.div(rest, factor);
                let value = graph.neg(quotient);
                self.make_explicit(symbol, value);
                return Some(self.without(equations, coordinates, place, &coordinates[k..=k]));
            }
        }
        None
    }

    /// What remains when one equation has given some coordinates.
    fn without(
        &mut self,
        equations: &[Equation],
        coordinates: &[Coordinate],
        place: usize,
        gone: &[Coordinate],
    ) -> System {
        let mut equations = equations.to_vec();
        let eliminated = equations.remove(place);
        self.substitute_all(&mut equations, &eliminated, &gone[0]);
        let kept = coordinates
            .iter()
            .filter(|c| !gone.contains(c))
            .cloned()
            .collect();
        (equations, kept)
    }

    /// Two scalar loops, the components of one vector loop.
    fn join_rows(&mut self, equations: &[Equation], coordinates: &[Coordinate]) -> Option<System> {
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
    fn distance_to_link(
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
    fn split_along_guide(
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
    fn relative_angle(
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
                self.algebra.angles[sum].estimate = self.sum_estimate(base, relative, sign);
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
    fn sum_estimate(&self, base: usize, relative: usize, sign: f64) -> Option<f64> {
        let estimate = |angle: usize| {
            let angle = &self.algebra.angles[angle];
            angle
                .unknown
                .map_or(angle.estimate, |u| Some(self.nominal.estimates[u][0]))
        };
        Some(estimate(relative)? + sign * estimate(base)?)
    }
}

fn sorted(a: &[usize], b: &[usize]) -> Vec<usize> {
    let mut all: Vec<usize> = a.iter().chain(b).copied().collect();
    all.sort_unstable();
    all.dedup();
    all
}
