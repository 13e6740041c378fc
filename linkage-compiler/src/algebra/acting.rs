//! The parameters that act on expressions directly: those whose partial derivative may differ from zero where unknowns and
//! rates are held.
//!
//! A sweep backwards visits every system of a chain, and each system has a few parameters of its own. With these lists each
//! parameter costs its own systems only, so that the work grows with the number of systems and not with its square.

use crate::algebra::adjoint;
use crate::algebra::implicit;
use std::collections::BTreeSet;
use std::rc::Rc;

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, NodeId, SymbolId};

use super::partial::System;
use super::{Algebra, Carrier, Rule};

/// The symbols without a rule: parameters and inputs.
pub(crate) type Given = Rc<BTreeSet<SymbolId>>;

/// What acts on symbols and systems, as far as it has been found.
#[derive(Clone, Debug, Default)]
pub(super) struct Acting {
    on_symbols: Map<SymbolId, Given>,
    on_systems: Map<System, Given>,
}

/// Places in a list by the parameters that act on what is there.
#[derive(Clone, Debug, Default)]
pub(super) struct ByParameter(Map<SymbolId, Vec<usize>>);

impl ByParameter {
    /// Adds a place, which is not before those added already.
    pub(super) fn add(&mut self, place: usize, acting: &BTreeSet<SymbolId>) {
        for &symbol in acting {
            let places = self.0.entry(symbol).or_default();
            if places.last() != Some(&place) {
                places.push(place);
            }
        }
    }

    /// The places that a parameter acts on, in order.
    pub(super) fn of(&self, parameter: SymbolId) -> &[usize] {
        self.0.get(&parameter).map_or(&[], Vec::as_slice)
    }
}

/// What acts on the equations of a group.
pub(crate) fn acting_on_group(algebra: &mut Algebra<'_>, group: usize) -> Given {
    acting_on_system(algebra, &System::new(group, Vec::new()))
}

/// The groups whose unknowns the equations of a group mention.
pub(crate) fn groups_before(algebra: &mut Algebra<'_>, group: usize) -> BTreeSet<usize> {
    let mentioned = adjoint::mentioned_by(algebra, &System::new(group, Vec::new()));
    mentioned.into_iter().map(|own| own.system.group).collect()
}

/// What acts on expressions.
pub(super) fn acting_in<'m>(algebra: &mut Algebra<'m>, all: &[Ex<'m>]) -> BTreeSet<SymbolId> {
    let nodes: Vec<NodeId> = all.iter().map(|x| x.id()).collect();
    let mut acting = BTreeSet::new();
    for symbol in algebra.graph.symbols_of(&nodes) {
        match algebra.solutions.rule(symbol) {
            None => _ = acting.insert(symbol),
            Some(_) => acting.extend(acting_on_symbol(algebra, symbol).iter()),
        }
    }
    acting
}

/// What acts on the equations of a system.
pub(super) fn acting_on_system<'m>(algebra: &mut Algebra<'m>, system: &System) -> Given {
    if let Some(known) = algebra.derivatives.partials.acting.on_systems.get(system) {
        return Rc::clone(known);
    }
    let solution = algebra.solutions.groups[system.group].clone();
    let mut all: Vec<Ex<'m>> = Vec::new();
    if system.by.is_empty() {
        let coefficients = solution.terms.iter().map(|term| &term.coefficient);
        all.extend(coefficients.flatten());
        all.extend(solution.links.iter().flatten().flat_map(|link| link.z.0));
        let written = solution.rows.iter().filter_map(|own| own.links.as_ref());
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
        all.extend(implicit::rates(algebra, system.group, system.by.clone()).right);
    }
    let acting = Rc::new(acting_in(algebra, &all));
    let known = &mut algebra.derivatives.partials.acting.on_systems;
    known.insert(system.clone(), Rc::clone(&acting));
    acting
}

/// What acts on a symbol with a rule: on all that the rule differentiates.
fn acting_on_symbol<'m>(algebra: &mut Algebra<'m>, symbol: SymbolId) -> Given {
    if let Some(known) = algebra.derivatives.partials.acting.on_symbols.get(&symbol) {
        return Rc::clone(known);
    }
    let differentiated: Vec<Ex<'m>> = match algebra.solutions.rule(symbol) {
        None | Some(Rule::Unknown { .. } | Rule::Rate { .. }) => Vec::new(),
        Some(Rule::Follow(equal)) => vec![*equal],
        Some(Rule::Turn(own)) => vec![own.equal],
        Some(Rule::Turning(turning)) => turning.z.0.to_vec(),
        Some(Rule::Seen(seen)) => [&seen.vector.0[..], &parts_of(seen.carrier)].concat(),
        Some(Rule::Shown(shown)) => {
            [&shown.vector.0[..], &shown.base.0, &parts_of(shown.carrier)].concat()
        }
        Some(Rule::Axis(own)) => parts_of(own.0).to_vec(),
        Some(Rule::Cosine(rule) | Rule::Sine(rule) | Rule::Value(rule)) => {
            rule.carrier.iter().copied().flat_map(parts_of).collect()
        }
    };
    let acting = Rc::new(acting_in(algebra, &differentiated));
    let known = &mut algebra.derivatives.partials.acting.on_symbols;
    known.insert(symbol, Rc::clone(&acting));
    acting
}

/// What the turning of a carrier is differentiated by.
fn parts_of(carrier: Carrier) -> [Ex; 3] {
    let [x, y] = carrier.start.0;
    [carrier.angle, x, y]
}
