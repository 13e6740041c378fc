//! The parameters that act on expressions directly: those whose partial derivative may differ from
//! zero where unknowns and rates are held.
//!
//! A sweep backwards visits every system of a chain, and each system has a few parameters of its
//! own. With these lists each parameter costs its own systems only, so that the work grows with the
//! number of systems and not with its square.

use std::collections::BTreeSet;
use std::rc::Rc;

use linkage_symbolic::{Ex, Graph, NodeId, SymbolId};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::by_rule::GroupRates;
use crate::algebra::memo::{Acting, Given};
use crate::algebra::rules::{DerivativeRule, RotatingFrame};
use crate::algebra::solutions::Solutions;
use crate::algebra::systems::System;

/// Returns the parameters that act on the equations of a group.
pub(crate) fn acting_on_group(algebra: &mut Algebra<'_>, group: usize) -> Given {
    acting_on_system(algebra, &System::new(group, Vec::new()))
}

/// Returns the parameters that act on expressions.
pub(crate) fn acting_in(
    graph: &Graph,
    solutions: &Solutions,
    memo: &mut Acting,
    all: &[Ex],
) -> BTreeSet<SymbolId> {
    let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    let mut acting = BTreeSet::new();
    for symbol in graph.symbols_of(&nodes) {
        match solutions.rule(symbol) {
            None => _ = acting.insert(symbol),
            Some(_) => acting.extend(acting_on_symbol(graph, solutions, memo, symbol).iter()),
        }
    }
    acting
}

/// Returns the parameters that act on the equations of a system.
pub(crate) fn acting_on_system<'m>(algebra: &mut Algebra<'m>, system: &System) -> Given {
    if let Some(known) = algebra.derivatives.partials.acting.on_systems.get(system) {
        return Rc::clone(known);
    }
    let solution = algebra.solutions.groups[system.group].clone();
    let mut all: Vec<Ex<'m>> = Vec::new();
    if system.by.is_empty() {
        let coefficients = solution.terms.iter().map(|term| &term.coefficient);
        all.extend(coefficients.flatten());
        all.extend(solution.links.iter().flatten().flat_map(|link| link.z.0));
        let written = solution.rows.iter().filter_map(|row| row.links.as_ref());
        for links in written {
            for distance in [Some(&links.first), links.less.as_ref()]
                .into_iter()
                .flatten()
            {
                all.extend(distance.vector.0);
                all.push(distance.length);
            }
        }
    } else {
        all.extend(solution.jacobian.iter().flatten());
        all.extend(algebra.rates(system.group, system.by.clone()).right);
    }
    let memo = &mut algebra.derivatives.partials.acting;
    let acting = Rc::new(acting_in(algebra.graph, &algebra.solutions, memo, &all));
    memo.on_systems.insert(system.clone(), Rc::clone(&acting));
    acting
}

/// Returns the parameters that act on a symbol with a rule: on all that the rule differentiates.
fn acting_on_symbol(
    graph: &Graph,
    solutions: &Solutions,
    memo: &mut Acting,
    symbol: SymbolId,
) -> Given {
    if let Some(known) = memo.on_symbols.get(&symbol) {
        return Rc::clone(known);
    }
    let differentiated: Vec<Ex> = match solutions.rule(symbol) {
        None | Some(DerivativeRule::Unknown { .. } | DerivativeRule::Rate { .. }) => Vec::new(),
        Some(DerivativeRule::Follow(equal)) => vec![*equal],
        Some(DerivativeRule::Rotation(rotation)) => vec![rotation.equal],
        Some(DerivativeRule::TurnedVector(turning)) => turning.z.0.to_vec(),
        Some(DerivativeRule::ToFrame(to_frame)) => {
            [&to_frame.vector.0[..], &parts_of(to_frame.link_frame)].concat()
        }
        Some(DerivativeRule::FromFrame(from_frame)) => [
            &from_frame.vector.0[..],
            &from_frame.base.0,
            &parts_of(from_frame.link_frame),
        ]
        .concat(),
        Some(DerivativeRule::Axis(axis)) => parts_of(axis.0).to_vec(),
        Some(
            DerivativeRule::Cosine(rule) | DerivativeRule::Sine(rule) | DerivativeRule::Value(rule),
        ) => rule.link_frame.iter().copied().flat_map(parts_of).collect(),
    };
    let acting = Rc::new(acting_in(graph, solutions, memo, &differentiated));
    memo.on_symbols.insert(symbol, Rc::clone(&acting));
    acting
}

/// Returns the expressions whose derivatives give the rotation of a frame.
fn parts_of(link_frame: RotatingFrame) -> [Ex; 3] {
    let [x, y] = link_frame.start.0;
    [link_frame.angle, x, y]
}
