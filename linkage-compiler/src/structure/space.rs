//! Recognising groups in space: distances to a point that turns or slides, loops of three rows.

use linkage_symbolic::program::{Binary, Ternary, Unary};
use linkage_symbolic::{Node, NodeId, SymbolId, collect};

use super::eliminate::System;
use super::equations::{Coordinate, CoordinateKind, Equation};
use super::{Analysis, Form};

/// A row `|vector| = length`.
pub(super) struct Distance {
    pub(super) vector: Vec<NodeId>,
    pub(super) length: NodeId,
}

pub(super) type Vector = [NodeId; 3];

impl Analysis<'_, '_> {
    /// A row `|v| - l` or `v . v - l^2` (or its negative) with a known `l`.
    pub(super) fn distance(&mut self, row: NodeId, coordinates: &[Coordinate]) -> Option<Distance> {
        self.measured(row, coordinates)
            .or_else(|| self.written_squares(row, coordinates))
    }

    /// A length or its square on one side, known numbers on the other.
    fn measured(&mut self, row: NodeId, coordinates: &[Coordinate]) -> Option<Distance> {
        let mut sides = (row, self.algebra.graph.zero());
        loop {
            // Squares of what is known may belong to the vector: one term after the other.
            sides = self.without_term(sides, coordinates)?;
            let (measured, given) = self.without_factors(sides.0, sides.1, coordinates);
            if let Some(vector) = self.algebra.norms.get(&measured).cloned() {
                // No distance is negative.
                let graph = &mut self.algebra.graph;
                let nan = graph.constant(f64::NAN);
                let length = graph.ternary(Ternary::Select, given, given, nan);
                return Some(Distance { vector, length });
            }
            let squared = self.algebra.squares.get(&measured).cloned();
            if let Some(vector) = squared.filter(|v| v.len() == 3) {
                let length = self.algebra.graph.sqrt(given);
                return Some(Distance { vector, length });
            }
        }
    }

    /// Both sides of an equation less a known term of the first.
    fn without_term(
        &mut self,
        (side, other): (NodeId, NodeId),
        coordinates: &[Coordinate],
    ) -> Option<(NodeId, NodeId)> {
        let known = |analysis: &Self, x| !coordinates.iter().any(|c| analysis.contains(x, c));
        let node = self.algebra.graph.node(side);
        let (knows_first, knows_second) = match node {
            Node::Binary(_, a, b) => (known(self, a), known(self, b)),
            _ => (false, false),
        };
        let graph = &mut self.algebra.graph;
        Some(match node {
            Node::Unary(Unary::Neg, a) => (a, graph.neg(other)),
            Node::Binary(Binary::Add, a, b) if knows_second => (a, graph.sub(other, b)),
            Node::Binary(Binary::Add, a, b) if knows_first => (b, graph.sub(other, a)),
            Node::Binary(Binary::Sub, a, b) if knows_second => (a, graph.add(other, b)),
            Node::Binary(Binary::Sub, a, b) if knows_first => (b, graph.sub(a, other)),
            _ => return None,
        })
    }

    /// Both sides divided by the known factors of the first.
    fn without_factors(
        &mut self,
        mut measured: NodeId,
        mut given: NodeId,
        coordinates: &[Coordinate],
    ) -> (NodeId, NodeId) {
        loop {
            let node = self.algebra.graph.node(measured);
            let known = |analysis: &Self, x| !coordinates.iter().any(|c| analysis.contains(x, c));
            match node {
                Node::Binary(Binary::Div, a, b) if known(self, b) => {
                    measured = a;
                    given = self.algebra.graph.mul(given, b);
                }
                Node::Binary(Binary::Mul, a, b) if a != b && (known(self, a) || known(self, b)) => {
                    let (factor, rest) = if known(self, a) { (a, b) } else { (b, a) };
                    measured = rest;
                    given = self.algebra.graph.div(given, factor);
                }
                _ => return (measured, given),
            }
        }
    }

    /// `x x + y y + z z - ...` with a known rest.
    fn written_squares(&mut self, row: NodeId, coordinates: &[Coordinate]) -> Option<Distance> {
        let unknown =
            |analysis: &Self, node| coordinates.iter().any(|c| analysis.contains(node, c));
        let terms = self.summands(row);
        let sign = terms.iter().find(|(_, x)| unknown(self, *x))?.0;
        let mut vector = Vec::new();
        let mut wanted = self.algebra.graph.zero();
        for (own, term) in terms {
            match self.algebra.graph.node(term) {
                Node::Binary(Binary::Mul, a, b) if a == b && own == sign => vector.push(a),
                _ if unknown(self, term) => return None,
                _ if own == sign => wanted = self.algebra.graph.sub(wanted, term),
                _ => wanted = self.algebra.graph.add(wanted, term),
            }
        }
        let length = self.algebra.graph.sqrt(wanted);
        (vector.len() == 3).then_some(Distance { vector, length })
    }

    /// The terms of a sum; false for those that are subtracted.
    fn summands(&self, node: NodeId) -> Vec<(bool, NodeId)> {
        let mut found = Vec::new();
        let mut open = vec![(true, node)];
        while let Some((sign, node)) = open.pop() {
            match self.algebra.graph.node(node) {
                Node::Unary(Unary::Neg, x) => open.push((!sign, x)),
                Node::Binary(Binary::Add, a, b) => open.extend([(sign, b), (sign, a)]),
                Node::Binary(Binary::Sub, a, b) => open.extend([(!sign, b), (sign, a)]),
                _ => found.push((sign, node)),
            }
        }
        found
    }

    /// A row that is a distance in space.
    pub(super) fn space_distance(
        &mut self,
        row: NodeId,
        coordinates: &[Coordinate],
    ) -> Option<(Vector, NodeId)> {
        let Distance { vector, length } = self.distance(row, coordinates)?;
        let &[x, y, z] = &vector[..] else { return None };
        Some(([x, y, z], length))
    }

    /// A link with two ball joints to a point that turns about an axis (RSSR) or slides along a line (RSSP).
    pub(super) fn classify_distance(
        &mut self,
        row: NodeId,
        coordinate: &Coordinate,
    ) -> Option<Form> {
        let own = std::slice::from_ref(coordinate);
        let (vector, length) = self.space_distance(row, own)?;
        let mut rest = self.polynomials(&vector, own)?;
        let zero = self.algebra.graph.zero();
        match coordinate.kind {
            CoordinateKind::Angle(angle) => {
                let symbols = self.algebra.angles[angle].clone();
                let cosine = rest.take_space(&[symbols.cos], zero);
                let sine = rest.take_space(&[symbols.sin], zero);
                let known = rest.take_space(&[], zero);
                let is_circle = self.algebra.is_turned(&cosine, &sine);
                (rest.is_exhausted() && is_circle).then_some(Form::LinkToRotor {
                    angle,
                    cosine,
                    sine,
                    known,
                    length,
                })
            }
            CoordinateKind::Length(slide) => {
                let guide = rest.take_space(&[slide], zero);
                let known = rest.take_space(&[], zero);
                rest.is_exhausted().then_some(Form::LinkToSlide {
                    slide,
                    guide,
                    known,
                    length,
                })
            }
        }
    }

    /// A row that is linear in some symbols: their factors and the rest.
    pub(super) fn linear_row(
        &mut self,
        row: NodeId,
        symbols: &[SymbolId],
    ) -> Option<(Vec<NodeId>, NodeId)> {
        let graph = &mut self.algebra.graph;
        let zero = graph.zero();
        let mut terms = collect(graph, row, symbols, &[])?;
        let factors = (0..symbols.len())
            .map(|k| {
                let mut monomial = vec![0; symbols.len()];
                monomial[k] = 1;
                terms.remove(&monomial).unwrap_or(zero)
            })
            .collect();
        let rest = terms.remove(&vec![0; symbols.len()]).unwrap_or(zero);
        terms.is_empty().then_some((factors, rest))
    }

    /// A vector loop with three slides.
    pub(super) fn classify_three_slides(
        &mut self,
        equation: &Equation,
        coordinates: &[Coordinate],
    ) -> Option<Form> {
        let [x, y, z] = equation.rows[..] else {
            return None;
        };
        let mut slides = Vec::new();
        for coordinate in coordinates {
            match coordinate.kind {
                CoordinateKind::Length(symbol) => slides.push(symbol),
                CoordinateKind::Angle(_) => return None,
            }
        }
        let slides: [SymbolId; 3] = slides.try_into().ok()?;
        let (guides, known) = self.guides([x, y, z], &slides)?;
        Some(Form::ThreeSlides {
            slides,
            guides: guides.try_into().ok()?,
            known,
        })
    }

    /// Three rows that are linear in slides: the guide of each, and the rest.
    fn guides(&mut self, rows: Vector, slides: &[SymbolId]) -> Option<(Vec<Vector>, Vector)> {
        let zero = self.algebra.graph.zero();
        let mut guides = vec![[zero; 3]; slides.len()];
        let mut known = [zero; 3];
        for (row, node) in rows.into_iter().enumerate() {
            let (factors, rest) = self.linear_row(node, slides)?;
            known[row] = rest;
            for (guide, factor) in guides.iter_mut().zip(factors) {
                guide[row] = factor;
            }
        }
        Some((guides, known))
    }

    /// Two slides and an angle in a loop of three rows: the equation across both guides contains the angle alone, those across
    /// one of them the other slide.
    pub(super) fn split_across_guides(
        &mut self,
        equations: &[Equation],
        coordinates: &[Coordinate],
    ) -> Option<System> {
        let ([equation], [_, _, _]) = (equations, coordinates) else {
            return None;
        };
        let [x, y, z] = equation.rows[..] else {
            return None;
        };
        let slides: Vec<SymbolId> = coordinates
            .iter()
            .filter_map(|c| match c.kind {
                CoordinateKind::Length(symbol) => Some(symbol),
                CoordinateKind::Angle(_) => None,
            })
            .collect();
        let (guides, rest) = self.guides([x, y, z], &slides)?;
        let &[first, second] = &guides[..] else {
            return None;
        };
        let mut across = self.algebra.cross3(first, second);
        let turns = |x: &NodeId| coordinates.iter().any(|c| self.contains(*x, c));
        if !across.iter().any(turns) {
            across = self.algebra.unit_vector(across);
        }
        let angle_alone = self.algebra.dot(&across, &rest);
        let mut rows = vec![angle_alone];
        for (slide, guide, other) in [(0, first, second), (1, second, first)] {
            let direction = self.algebra.cross3(other, across);
            let factor = self.algebra.dot(&direction, &guide);
            let slide = self.algebra.graph.symbol_node(slides[slide]);
            let moved = self.algebra.graph.mul(factor, slide);
            let known = self.algebra.dot(&direction, &rest);
            rows.push(self.algebra.graph.add(moved, known));
        }
        let angle = coordinates
            .iter()
            .find(|c| matches!(c.kind, CoordinateKind::Angle(_)))?;
        let row = |node| Equation {
            rows: vec![node],
            relation: None,
            ..equation.clone()
        };
        let rows: Vec<Equation> = rows.into_iter().map(row).collect();
        self.classify(&rows[0], std::slice::from_ref(angle))?;
        Some((rows, coordinates.to_vec()))
    }
}
