//! Equations and coordinates: the two sides of the bipartite graph.

use linkage_symbolic::{Ex, NodeId, SymbolId, substitute};

use crate::algebra::{Bound, Scalar, Translate, Value};
use crate::model::Loop;

use super::Analysis;
use super::distance_polynomials::Link;
use super::scope::Scope;

/// A loop, or what became of one: one to three scalar equations `row = 0`.
#[derive(Clone, Debug)]
pub(crate) struct Equation<'m> {
    pub(crate) rows: Vec<Ex<'m>>,
    /// A scalar loop as a linear form in angles.
    pub(crate) relation: Option<Scalar<'m>>,
    /// A link in space, if the row is about the square of its vector.
    pub(crate) distance: Option<Link<'m>>,
    /// The loop that its rows were written as.
    pub(crate) written: usize,
    /// The loops it comes from.
    pub(crate) loops: Vec<usize>,
    /// Unknowns of the model that were eliminated into it.
    pub(crate) eliminated: Vec<usize>,
}

impl Equation<'_> {
    /// Takes over the loops and unknowns of an equation that was eliminated into this one.
    pub(super) fn absorb(&mut self, eliminated: &Equation, gone: &[Coordinate]) {
        self.loops.extend(&eliminated.loops);
        self.loops.sort_unstable();
        self.loops.dedup();
        self.eliminated.extend(&eliminated.eliminated);
        self.eliminated
            .extend(gone.iter().filter_map(|c| c.unknown));
    }
}

/// One scalar unknown.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Coordinate {
    pub(crate) kind: CoordinateKind,
    /// The model's unknown; `None` for one that the compiler introduced.
    pub(crate) unknown: Option<usize>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum CoordinateKind {
    Angle(usize),
    Length(SymbolId),
}

impl<'m> Analysis<'_, 'm> {
    /// Loops as equations, unknowns as coordinates.
    pub(super) fn equations(&mut self, scope: &Scope) -> (Vec<Equation<'m>>, Vec<Coordinate>) {
        let mechanism = self.algebra.mechanism;
        self.algebra.translate_these_lets(|index| scope.lets[index]);
        let loops = mechanism.loops.iter().enumerate();
        let equations = loops
            .filter(|(index, _)| scope.loops[*index])
            .map(|(index, item)| self.equation(index, item))
            .collect();
        let mut coordinates = Vec::new();
        let bound = self.algebra.names.bound.iter().enumerate();
        for (unknown, bound) in bound.filter(|(unknown, _)| scope.unknowns[*unknown]) {
            let kinds: Vec<CoordinateKind> = match bound {
                Bound::Angle(angle) => vec![CoordinateKind::Angle(*angle)],
                Bound::Lengths(symbols) => symbols
                    .iter()
                    .map(|(symbol, _)| CoordinateKind::Length(*symbol))
                    .collect(),
            };
            let named = kinds.into_iter().map(|kind| Coordinate {
                kind,
                unknown: Some(unknown),
            });
            coordinates.extend(named);
        }
        (equations, coordinates)
    }

    fn equation(&mut self, index: usize, item: &Loop) -> Equation<'m> {
        let left = self.algebra.translate(&item.left);
        let right = self.algebra.translate(&item.right);
        let (rows, relation) = match (&left, &right) {
            (Value::Scalar(a), Value::Scalar(b)) => {
                let relation = a.combined(b, -1.0);
                (vec![self.algebra.value_of(&relation)], Some(relation))
            }
            _ => {
                let (a, b) = (self.algebra.vector(&left), self.algebra.vector(&right));
                ((a - b).iter().collect(), None)
            }
        };
        Equation {
            rows,
            relation,
            distance: None,
            written: index,
            loops: vec![index],
            eliminated: Vec::new(),
        }
    }

    /// The symbols of a coordinate.
    pub(super) fn symbols(&self, coordinate: &Coordinate) -> Vec<SymbolId> {
        match coordinate.kind {
            CoordinateKind::Length(symbol) => vec![symbol],
            CoordinateKind::Angle(index) => self.algebra.names.angles[index].symbols().to_vec(),
        }
    }

    /// Which coordinates an equation contains.
    pub(super) fn incidence(
        &self,
        equation: &Equation<'m>,
        coordinates: &[Coordinate],
    ) -> Vec<usize> {
        let present = self.symbols_of(&equation.rows);
        (0..coordinates.len())
            .filter(|&k| {
                self.symbols(&coordinates[k])
                    .iter()
                    .any(|s| present.contains(s))
            })
            .collect()
    }

    pub(super) fn contains(&self, x: Ex<'m>, coordinate: &Coordinate) -> bool {
        let present = self.symbols_of(&[x]);
        self.symbols(coordinate).iter().any(|s| present.contains(s))
    }

    /// Replaces eliminated symbols in an equation.
    pub(super) fn substituted(&mut self, equation: &Equation<'m>) -> Equation<'m> {
        let graph = self.algebra.graph;
        graph.substitute_lengths(&equation.rows, &self.substitutions);
        let rows = substitute(&equation.rows, &self.substitutions);
        let relation = equation.relation.clone().filter(|_| rows == equation.rows);
        Equation {
            rows,
            relation,
            ..equation.clone()
        }
    }

    /// The symbols that expressions are made of.
    pub(super) fn symbols_of(&self, all: &[Ex<'m>]) -> Vec<SymbolId> {
        let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
        self.algebra.graph.symbols_of(&nodes)
    }
}
