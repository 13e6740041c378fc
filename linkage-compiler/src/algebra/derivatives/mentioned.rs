//! Unknowns and rates that expressions and systems mention.

use std::collections::BTreeSet;

use linkage_symbolic::{Ex, NodeId, SymbolId};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::by_rule::GroupRates;
use crate::algebra::rules::DerivativeRule;
use crate::algebra::systems::{Solved, System};

/// The unknowns and rates that expressions mention.
pub(crate) fn mentioned_in<'m>(algebra: &mut Algebra<'m>, all: &[Ex<'m>]) -> BTreeSet<Solved> {
    let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    let symbols = algebra.graph.symbols_of(&nodes);
    let behind = symbols.into_iter().map(|symbol| behind(algebra, symbol));
    behind.flatten().collect()
}

fn behind(algebra: &mut Algebra<'_>, symbol: SymbolId) -> BTreeSet<Solved> {
    if let Some(known) = algebra.derivatives.partials.mentioned.get(&symbol) {
        return known.clone();
    }
    let result = |group, position, by| Solved {
        system: System::new(group, by),
        position,
    };
    let behind = match algebra.solutions.rule(symbol).cloned() {
        None => BTreeSet::new(),
        Some(DerivativeRule::Follow(equal)) => mentioned_in(algebra, &[equal]),
        Some(DerivativeRule::Rotation(rotation)) => mentioned_in(algebra, &[rotation.equal]),
        Some(DerivativeRule::ToFrame(to_frame)) => {
            let mut behind = mentioned_in(algebra, &to_frame.vector.0);
            behind.extend(mentioned_in(algebra, &[to_frame.link_frame.angle]));
            behind
        }
        Some(DerivativeRule::FromFrame(from_frame)) => {
            let [x, y] = from_frame.vector.0;
            let [base_x, base_y] = from_frame.base.0;
            mentioned_in(
                algebra,
                &[x, y, base_x, base_y, from_frame.link_frame.angle],
            )
        }
        Some(DerivativeRule::Axis(axis)) => mentioned_in(algebra, &[axis.0.angle]),
        Some(DerivativeRule::TurnedVector(turning)) => {
            let mut behind = mentioned_in(algebra, &turning.z.0);
            behind.insert(result(turning.group, turning.position, Vec::new()));
            behind
        }
        Some(
            DerivativeRule::Cosine(rule) | DerivativeRule::Sine(rule) | DerivativeRule::Value(rule),
        ) => {
            let angle = rule.link_frame.map(|link_frame| link_frame.angle);
            let mut behind = angle.map_or_else(BTreeSet::new, |x| mentioned_in(algebra, &[x]));
            behind.insert(result(rule.group, rule.position, Vec::new()));
            behind
        }
        Some(DerivativeRule::Unknown { group, position }) => {
            BTreeSet::from([result(group, position, Vec::new())])
        }
        Some(DerivativeRule::Rate {
            group,
            position,
            by,
        }) => BTreeSet::from([result(group, position, by)]),
    };
    algebra
        .derivatives
        .partials
        .mentioned
        .insert(symbol, behind.clone());
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
    let mentioned = mentioned_in(algebra, &all).into_iter();
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
