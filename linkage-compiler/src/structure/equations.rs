//! Equations and coordinates: the two sides of the bipartite graph.

use linkage_symbolic::{Ex, Graph, NodeId, SymbolId, substitute};

use crate::algebra::names::Names;
use crate::algebra::translate::Translate;
use crate::algebra::{Bound, Scalar, Value, scalar, translate};
use crate::model::Loop;
use crate::structure::elements::SpaceLink;
use crate::structure::reductions::Substitutions;
use crate::structure::scope::Scope;

/// A loop, or an equation that was made of loops: one to three scalar equations `row = 0`.
#[derive(Clone, Debug)]
pub(crate) struct Equation<'m> {
    pub(crate) rows: Vec<Ex<'m>>,
    /// A scalar loop as a linear form in angles.
    pub(crate) relation: Option<Scalar<'m>>,
    /// A link in space, if the row is about the square of its vector.
    pub(crate) distance: Option<SpaceLink<'m>>,
    /// The loop that its rows were written as.
    pub(crate) written: usize,
    /// The loops it comes from.
    pub(crate) loops: Vec<usize>,
    /// Unknowns of the model that were eliminated into it.
    pub(crate) eliminated: Vec<usize>,
}

impl Equation<'_> {
    /// Takes over the loops and unknowns of an equation that was eliminated into this one.
    pub(crate) fn absorb(&mut self, eliminated: &Equation, gone: &[Coordinate]) {
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
pub(crate) fn equations<'m>(
    names: &mut Names<'m>,
    scope: &Scope,
) -> (Vec<Equation<'m>>, Vec<Coordinate>) {
    let mechanism = names.mechanism;
    translate::translate_these_lets(names, |index| scope.lets[index]);
    let loops = mechanism.loops.iter().enumerate();
    let equations = loops
        .filter(|(index, _)| scope.loops[*index])
        .map(|(index, item)| equation(names, index, item))
        .collect();
    let mut coordinates = Vec::new();
    let bound = names.bound.iter().enumerate();
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

fn equation<'m>(names: &mut Names<'m>, index: usize, item: &Loop) -> Equation<'m> {
    let left = names.translate(&item.left);
    let right = names.translate(&item.right);
    let (rows, relation) = match (&left, &right) {
        (Value::Scalar(a), Value::Scalar(b)) => {
            let relation = a.combined(b, -1.0);
            (vec![scalar::value_of(names, &relation)], Some(relation))
        }
        _ => {
            let (a, b) = (scalar::vector(names, &left), scalar::vector(names, &right));
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
pub(crate) fn symbols(names: &Names<'_>, coordinate: &Coordinate) -> Vec<SymbolId> {
    match coordinate.kind {
        CoordinateKind::Length(symbol) => vec![symbol],
        CoordinateKind::Angle(index) => names.angles[index].symbols().to_vec(),
    }
}

/// Returns the coordinates that an equation contains.
pub(crate) fn incidence<'m>(
    names: &Names<'m>,
    equation: &Equation<'m>,
    coordinates: &[Coordinate],
) -> Vec<usize> {
    let present = symbols_of(names.graph, &equation.rows);
    (0..coordinates.len())
        .filter(|&k| {
            symbols(names, &coordinates[k])
                .iter()
                .any(|s| present.contains(s))
        })
        .collect()
}

pub(crate) fn contains<'m>(names: &Names<'m>, x: Ex<'m>, coordinate: &Coordinate) -> bool {
    let present = symbols_of(names.graph, &[x]);
    symbols(names, coordinate)
        .iter()
        .any(|s| present.contains(s))
}

/// Replaces eliminated symbols in an equation.
pub(crate) fn substituted<'m>(
    graph: &'m Graph,
    substitutions: &Substitutions<'m>,
    equation: &Equation<'m>,
) -> Equation<'m> {
    graph.substitute_lengths(&equation.rows, substitutions);
    let rows = substitute(&equation.rows, substitutions);
    let relation = equation.relation.clone().filter(|_| rows == equation.rows);
    Equation {
        rows,
        relation,
        ..equation.clone()
    }
}

/// The symbols that expressions are made of.
pub(crate) fn symbols_of<'m>(graph: &'m Graph, all: &[Ex<'m>]) -> Vec<SymbolId> {
    let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    graph.symbols_of(&nodes)
}

/// Equations and the coordinates that they are solved for.
pub(crate) type System<'m> = (Vec<Equation<'m>>, Vec<Coordinate>);

/// The symbols of coordinates that are components of one unknown.
pub(crate) fn point_symbols(coordinates: &[Coordinate]) -> Option<Vec<SymbolId>> {
    let first = coordinates.first()?.unknown;
    coordinates
        .iter()
        .map(|c| match c.kind {
            CoordinateKind::Length(symbol) if c.unknown == first => Some(symbol),
            _ => None,
        })
        .collect()
}
