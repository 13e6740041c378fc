//! Equations and coordinates: the two sides of the bipartite graph.

use crate::algebra::scalar;
use crate::algebra::translate;
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

/// Loops as equations, unknowns as coordinates.
pub(super) fn equations<'m>(
    analysis: &mut Analysis<'_, 'm>,
    scope: &Scope,
) -> (Vec<Equation<'m>>, Vec<Coordinate>) {
    let mechanism = analysis.algebra.mechanism;
    translate::translate_these_lets(analysis.algebra, |index| scope.lets[index]);
    let loops = mechanism.loops.iter().enumerate();
    let equations = loops
        .filter(|(index, _)| scope.loops[*index])
        .map(|(index, item)| equation(analysis, index, item))
        .collect();
    let mut coordinates = Vec::new();
    let bound = analysis.algebra.names.bound.iter().enumerate();
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

fn equation<'m>(analysis: &mut Analysis<'_, 'm>, index: usize, item: &Loop) -> Equation<'m> {
    let left = analysis.algebra.translate(&item.left);
    let right = analysis.algebra.translate(&item.right);
    let (rows, relation) = match (&left, &right) {
        (Value::Scalar(a), Value::Scalar(b)) => {
            let relation = a.combined(b, -1.0);
            (
                vec![scalar::value_of(analysis.algebra, &relation)],
                Some(relation),
            )
        }
        _ => {
            let (a, b) = (
                translate::vector(analysis.algebra, &left),
                translate::vector(analysis.algebra, &right),
            );
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
pub(super) fn symbols(analysis: &Analysis<'_, '_>, coordinate: &Coordinate) -> Vec<SymbolId> {
    match coordinate.kind {
        CoordinateKind::Length(symbol) => vec![symbol],
        CoordinateKind::Angle(index) => analysis.algebra.names.angles[index].symbols().to_vec(),
    }
}

/// Which coordinates an equation contains.
pub(super) fn incidence<'m>(
    analysis: &Analysis<'_, 'm>,
    equation: &Equation<'m>,
    coordinates: &[Coordinate],
) -> Vec<usize> {
    let present = symbols_of(analysis, &equation.rows);
    (0..coordinates.len())
        .filter(|&k| {
            symbols(analysis, &coordinates[k])
                .iter()
                .any(|s| present.contains(s))
        })
        .collect()
}

pub(super) fn contains<'m>(
    analysis: &Analysis<'_, 'm>,
    x: Ex<'m>,
    coordinate: &Coordinate,
) -> bool {
    let present = symbols_of(analysis, &[x]);
    symbols(analysis, coordinate)
        .iter()
        .any(|s| present.contains(s))
}

/// Replaces eliminated symbols in an equation.
pub(super) fn substituted<'m>(
    analysis: &mut Analysis<'_, 'm>,
    equation: &Equation<'m>,
) -> Equation<'m> {
    let graph = analysis.algebra.graph;
    graph.substitute_lengths(&equation.rows, &analysis.substitutions);
    let rows = substitute(&equation.rows, &analysis.substitutions);
    let relation = equation.relation.clone().filter(|_| rows == equation.rows);
    Equation {
        rows,
        relation,
        ..equation.clone()
    }
}

/// The symbols that expressions are made of.
pub(super) fn symbols_of<'m>(analysis: &Analysis<'_, 'm>, all: &[Ex<'m>]) -> Vec<SymbolId> {
    let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    analysis.algebra.graph.symbols_of(&nodes)
}
