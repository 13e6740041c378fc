//! Unknowns and rates that expressions and systems mention.

use std::collections::BTreeSet;

use linkage_symbolic::{Ex, Graph, NodeId, SymbolId};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::by_rule::GroupRates;
use crate::algebra::memo::Mentioned;
use crate::algebra::rules::DerivativeRule;
use crate::algebra::solutions::Solutions;
use crate::algebra::systems::{Solved, System};

/// The unknowns and rates that expressions mention.
pub(crate) fn mentioned_in(
    graph: &Graph,
    solutions: &Solutions,
    memo: &mut Mentioned,
    all: &[Ex],
) -> BTreeSet<Solved> {
    let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    let symbols = graph.symbols_of(&nodes).into_iter();
    let behind = symbols.map(|symbol| behind(graph, solutions, memo, symbol));
    behind.flatten().collect()
}

fn behind(
    graph: &Graph,
    solutions: &Solutions,
    memo: &mut Mentioned,
    symbol: SymbolId,
) -> BTreeSet<Solved> {
    if let Some(known) = memo.get(&symbol) {
        return known.clone();
    }
    let result = |group: usize, position: usize, by: &[SymbolId]| Solved {
        system: System::new(group, by.to_vec()),
        position,
    };
    let mut mentioned_in = |all: &[Ex]| mentioned_in(graph, solutions, memo, all);
    let behind = match solutions.rule(symbol) {
        None => BTreeSet::new(),
        Some(DerivativeRule::Follow(equal)) => mentioned_in(&[*equal]),
        Some(DerivativeRule::Rotation(rotation)) => mentioned_in(&[rotation.equal]),
        Some(DerivativeRule::ToFrame(to_frame)) => {
            let mut behind = mentioned_in(&to_frame.vector.0);
            behind.extend(mentioned_in(&[to_frame.link_frame.angle]));
            behind
        }
        Some(DerivativeRule::FromFrame(from_frame)) => {
            let [x, y] = from_frame.vector.0;
            let [base_x, base_y] = from_frame.base.0;
            mentioned_in(&[x, y, base_x, base_y, from_frame.link_frame.angle])
        }
        Some(DerivativeRule::Axis(axis)) => mentioned_in(&[axis.0.angle]),
        Some(DerivativeRule::TurnedVector(turning)) => {
            let mut behind = mentioned_in(&turning.z.0);
            behind.insert(result(turning.group, turning.position, &[]));
            behind
        }
        Some(
            DerivativeRule::Cosine(rule) | DerivativeRule::Sine(rule) | DerivativeRule::Value(rule),
        ) => {
            let angle = rule.link_frame.map(|link_frame| link_frame.angle);
            let mut behind = angle.map_or_else(BTreeSet::new, |x| mentioned_in(&[x]));
            behind.insert(result(rule.group, rule.position, &[]));
            behind
        }
        Some(DerivativeRule::Unknown { group, position }) => {
            BTreeSet::from([result(*group, *position, &[])])
        }
        Some(DerivativeRule::Rate {
            group,
            position,
            by,
        }) => BTreeSet::from([result(*group, *position, by)]),
    };
    memo.insert(symbol, behind.clone());
    behind
}

/// Returns the unknowns and rates of earlier systems that the equations of a system mention.
pub(crate) fn mentioned_by<'m>(algebra: &mut Algebra<'m>, system: &System) -> Vec<Solved> {
    let solution = &algebra.solutions.groups[system.group];
    let mut all: Vec<Ex<'m>> = Vec::new();
    if system.by.is_empty() {
        let coefficients = solution.terms.iter().map(|term| &term.coefficient);
        all.extend(coefficients.flatten());
    } else {
        all.extend(solution.jacobian.iter().flatten());
        all.extend(algebra.rates(system.group, system.by.clone()).right);
    }
    let memo = &mut algebra.derivatives.partials.mentioned;
    let mentioned = mentioned_in(algebra.graph, &algebra.solutions, memo, &all).into_iter();
    mentioned
        .filter(|solved| solved.system != *system)
        .collect()
}

/// The groups whose unknowns the equations of a group mention.
pub(crate) fn groups_before(algebra: &mut Algebra<'_>, group: usize) -> BTreeSet<usize> {
    let mentioned = mentioned_by(algebra, &System::new(group, Vec::new()));
    mentioned
        .into_iter()
        .map(|solved| solved.system.group)
        .collect()
}
