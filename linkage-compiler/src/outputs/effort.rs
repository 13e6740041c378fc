//! Estimates of the work of each direction of sensitivities, before one of them is built.
//!
//! Forward solves each group for each parameter that acts on it or on its inputs; backwards solves
//! each group for each number that is differentiated. In long chains one of the two grows with the
//! square of the number of groups while the results grow with the number. Such a direction cannot
//! cost least, and is not built.

use std::collections::{BTreeMap, BTreeSet};

use linkage_symbolic::lookup::{Map, Set};
use linkage_symbolic::{SymbolId, program::Source};

use crate::algebra::derivatives::{acting, mentioned};
use crate::algebra::{Algebra, Direction};
use crate::model::{EvaluatorDef, Expr, ExprKind, Name, Shape, Variable};
use crate::solve::Formulation;

/// Up to this number of systems, every direction is solved: some hundredths of a second.
const FEW: usize = 4000;

/// A direction that solves this many times as many systems as another one, results counted, is not
/// built. The programs differ by much less than the numbers of systems: the part that is solved for
/// one variable is shared.
const MUCH: usize = 4;

/// Systems that the derivatives of a function solve.
#[derive(Default)]
struct Effort {
    forward: usize,
    backward: usize,
    results: usize,
}

/// Returns the directions in which the derivatives by parameters of a function are worth building,
/// in order.
pub(super) fn directions<'m>(
    algebra: &mut Algebra<'m>,
    formulation: &Formulation<'m>,
    definition: &EvaluatorDef,
) -> Vec<Direction> {
    let effort = effort(algebra, formulation, definition);
    let too_much = |work: usize, other: usize| {
        work > FEW && work / MUCH > other.saturating_add(effort.results)
    };
    let [forward, backward] = [
        too_much(effort.forward, effort.backward),
        too_much(effort.backward, effort.forward),
    ];
    let all = Direction::ALL.into_iter();
    let worth = all.filter(|direction| match direction {
        Direction::Forward => !forward,
        Direction::FromResults | Direction::FromUnknowns | Direction::Gradient => !backward,
    });
    worth.collect()
}

/// The differentiated quantities and their parameters.
struct Asked<'a> {
    of: &'a Expr,
    parameters: Vec<usize>,
    /// The number of times it is differentiated by parameters.
    order: u32,
    /// The number of its components.
    width: usize,
}

fn effort<'m>(
    algebra: &mut Algebra<'m>,
    formulation: &Formulation<'m>,
    definition: &EvaluatorDef,
) -> Effort {
    let quantities = definition.quantities.iter();
    let parts = quantities.flat_map(|quantity| quantity.value.parts());
    let all: Vec<Asked> = parts.filter_map(asked).collect();
    let results = all
        .iter()
        .map(|request| request.width * request.parameters.len())
        .sum();
    let groups = formulation.groups.len();
    let most = |request: &Asked| {
        let forward = request.parameters.len().saturating_pow(request.order);
        forward.max(request.width).saturating_mul(groups)
    };
    // Most functions are small, even if every parameter acts on every group.
    if all.iter().map(most).fold(0, usize::saturating_add) <= FEW {
        return Effort {
            results,
            ..Effort::default()
        };
    }
    let mut before = Before::new(algebra, formulation);
    let mut places: Map<SymbolId, usize> = Map::new();
    for source in all.iter().flat_map(|request| &request.parameters) {
        if let Some(symbol) = before.algebra.graph.find_source(Source::Parameter(*source)) {
            let next = places.len();
            places.entry(symbol).or_insert(next);
        }
    }
    // Rates are shared by all quantities.
    let mut solved: BTreeMap<usize, Bits> = BTreeMap::new();
    let mut backward = 0;
    for request in &all {
        let below = before.below(request.of);
        backward += request.width * below.len();
        let sources = request
            .parameters
            .iter()
            .map(|&parameter| Source::Parameter(parameter));
        let graph = before.algebra.graph;
        let symbols = sources.filter_map(|source| graph.find_source(source));
        let mask = Bits::new(symbols.filter_map(|symbol| places.get(&symbol).copied()));
        for group in below {
            let acting = before.acting(group, &places).and(&mask);
            solved.entry(group).or_default().add(&acting);
        }
    }
    let order = all.iter().map(|request| request.order).max().unwrap_or(1);
    let forward = solved
        .values()
        .map(|bits| bits.count().saturating_pow(order));
    Effort {
        forward: forward.fold(0, usize::saturating_add),
        backward,
        results,
    }
}

fn asked(part: &Expr) -> Option<Asked<'_>> {
    let (of, parameters) = match &part.kind {
        ExprKind::Sensitivity(of, all) => (of, all.iter().map(|parameter| parameter.0).collect()),
        ExprKind::Derivative(of, all) => (of, parameters(all)),
        _ => return None,
    };
    let before = of.parts().filter(|part| is_by_parameters(part));
    Some(Asked {
        order: 1 + before.count() as u32,
        width: Shape::from_type(&of.ty).width(),
        of,
        parameters,
    })
    .filter(|request| !request.parameters.is_empty())
}

fn parameters(all: &[Variable]) -> Vec<usize> {
    let parameter = |variable: &Variable| match variable {
        Variable::Parameter(parameter) => Some(parameter.0),
        Variable::Input(_) => None,
    };
    all.iter().filter_map(parameter).collect()
}

fn is_by_parameters(part: &Expr) -> bool {
    match &part.kind {
        ExprKind::Sensitivity(..) => true,
        ExprKind::Derivative(_, all) => !parameters(all).is_empty(),
        _ => false,
    }
}

/// A set of small numbers.
#[derive(Clone, Debug, Default)]
struct Bits(Vec<u64>);

impl Bits {
    fn new(all: impl IntoIterator<Item = usize>) -> Self {
        let mut bits = Self::default();
        for bit in all {
            let word = bit / 64;
            if bits.0.len() <= word {
                bits.0.resize(word + 1, 0);
            }
            bits.0[word] |= 1 << (bit % 64);
        }
        bits
    }

    fn add(&mut self, other: &Self) {
        if self.0.len() < other.0.len() {
            self.0.resize(other.0.len(), 0);
        }
        let pairs = self.0.iter_mut().zip(&other.0);
        pairs.for_each(|(word, other)| *word |= other);
    }

    fn and(&self, other: &Self) -> Self {
        let pairs = self.0.iter().zip(&other.0);
        Self(pairs.map(|(word, other)| word & other).collect())
    }

    fn count(&self) -> usize {
        self.0.iter().map(|word| word.count_ones() as usize).sum()
    }
}

/// The dependencies of groups.
struct Before<'a, 'm> {
    algebra: &'a mut Algebra<'m>,
    groups: usize,
    /// The groups that find an unknown.
    with: Map<usize, Vec<usize>>,
    /// The parameters that act on a group or on the groups that it depends on.
    acting: Map<usize, Bits>,
}

impl<'a, 'm> Before<'a, 'm> {
    fn new(algebra: &'a mut Algebra<'m>, formulation: &Formulation<'m>) -> Self {
        let mut with: Map<usize, Vec<usize>> = Map::new();
        for (index, solved) in formulation.groups.iter().enumerate() {
            for &unknown in &solved.group.unknowns {
                with.entry(unknown).or_default().push(index);
            }
        }
        Self {
            algebra,
            groups: formulation.groups.len(),
            with,
            acting: Map::new(),
        }
    }

    /// The groups that an expression is made of, in order.
    fn below(&mut self, expr: &Expr) -> BTreeSet<usize> {
        let is_of_all =
            |part: &Expr| matches!(part.kind, ExprKind::Mechanics(_) | ExprKind::Margin);
        if expr.parts().any(is_of_all) {
            return (0..self.groups).collect();
        }
        let mechanism = self.algebra.mechanism;
        let mut found = BTreeSet::new();
        let mut seen = Set::new();
        let mut open = vec![expr];
        while let Some(next) = open.pop() {
            for name in next.parts().filter_map(Expr::as_name) {
                if let Name::Unknown(unknown) = name {
                    found.extend(self.with.get(&unknown).into_iter().flatten());
                }
                if let Name::Let(index) = name
                    && seen.insert(index)
                {
                    open.push(&mechanism.lets[index].value);
                }
            }
        }
        let mut open: Vec<usize> = found.iter().copied().collect();
        while let Some(group) = open.pop() {
            let earlier = mentioned::groups_before(self.algebra, group).into_iter();
            open.extend(earlier.filter(|&earlier| found.insert(earlier)));
        }
        found
    }

    /// Returns the parameters, by their indices, that act on a group or on the groups that it
    /// depends on. The parameters of those groups have been found before.
    fn acting(&mut self, group: usize, places: &Map<SymbolId, usize>) -> Bits {
        if let Some(known) = self.acting.get(&group) {
            return known.clone();
        }
        let symbols = acting::acting_on_group(self.algebra, group);
        let mut acting = Bits::new(
            symbols
                .iter()
                .filter_map(|symbol| places.get(symbol).copied()),
        );
        for earlier in mentioned::groups_before(self.algebra, group) {
            acting.add(self.acting.get(&earlier).unwrap_or(&Bits::default()));
        }
        self.acting.insert(group, acting.clone());
        acting
    }
}
