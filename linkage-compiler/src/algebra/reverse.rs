//! All derivatives of one number by parameters in a single sweep backwards through its formula, the loops and their rates.
//!
//! Each operation hands its weight, the derivative of the result by it, to its operands; a system of loops or rates gathers the weights of its
//! unknowns, turns them into multipliers, and hands those to its coefficients. Everything is visited once, after all that
//! depends on it.

use crate::algebra::adjoint;
use crate::algebra::implicit;
use linkage_symbolic::lookup::{Map, Set};

use linkage_symbolic::{Ex, Node, NodeId, SymbolId, Vector, pull_back};

use super::partial::System;
use super::{Algebra, AngleRule, Carrier, Rule};

/// What a sweep visits.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Item {
    Node(NodeId),
    System(System),
}

/// Weights during a sweep.
#[derive(Default)]
struct Weights<'m> {
    nodes: Map<NodeId, Ex<'m>>,
    systems: Map<System, Vec<Ex<'m>>>,
}

/// The derivatives of a number by nodes at which a sweep ends: what is known before the input, and inputs.
pub(super) fn gradient<'m>(algebra: &mut Algebra<'m>, root: Ex<'m>) -> Vec<(Ex<'m>, Ex<'m>)> {
    let one = algebra.one();
    let mut weights = Weights::default();
    weights.nodes.insert(root.id(), one);
    let mut gradient = Vec::new();
    for item in order_below(algebra, root).into_iter().rev() {
        match item {
            Item::Node(id) => {
                let Some(&weight) = weights.nodes.get(&id) else {
                    continue;
                };
                let x = algebra.graph.ex(id);
                match x.node() {
                    _ if is_end(algebra, x) => gradient.push((x, weight)),
                    Node::Symbol(symbol) => symbol_back(algebra, &mut weights, symbol, weight),
                    _ => {
                        for (operand, share) in pull_back(x, weight) {
                            add_to_node(algebra, &mut weights, operand, share);
                        }
                    }
                }
            }
            Item::System(system) => system_back(algebra, &mut weights, &system),
        }
    }
    gradient
}

/// True where a sweep ends: what follows is known before the input, and its derivatives, too.
fn is_end<'m>(algebra: &Algebra<'m>, x: Ex<'m>) -> bool {
    match x.node() {
        Node::Symbol(symbol) => algebra.solutions.rule(symbol).is_none(),
        _ => x.is_fixed(),
    }
}

/// Nodes and systems below a node, each before those that are computed from it.
fn order_below<'m>(algebra: &mut Algebra<'m>, root: Ex<'m>) -> Vec<Item> {
    let mut order = Vec::new();
    let mut entered: Set<Item> = Set::new();
    let mut open = vec![(Item::Node(root.id()), false)];
    while let Some((item, left)) = open.pop() {
        if left {
            order.push(item);
            continue;
        }
        if !entered.insert(item.clone()) {
            continue;
        }
        let below = below(algebra, &item);
        open.push((item, true));
        open.extend(below.into_iter().map(|item| (item, false)));
    }
    order
}

/// What an item is computed from.
fn below(algebra: &mut Algebra<'_>, item: &Item) -> Vec<Item> {
    match item {
        Item::Node(id) => below_node(algebra, algebra.graph.ex(*id)),
        Item::System(system) => {
            let solution = &algebra.solutions.groups[system.group];
            let mut all: Vec<Ex> = Vec::new();
            if system.by.is_empty() {
                let coefficients = solution.terms.iter().map(|term| &term.coefficient);
                all.extend(coefficients.flatten());
            } else {
                all.extend(solution.jacobian.iter().flatten());
                all.extend(implicit::rates(algebra, system.group, system.by.clone()).right);
            }
            all.into_iter().map(|x| Item::Node(x.id())).collect()
        }
    }
}

fn below_node<'m>(algebra: &Algebra<'m>, x: Ex<'m>) -> Vec<Item> {
    let Node::Symbol(symbol) = x.node() else {
        return match is_end(algebra, x) {
            true => Vec::new(),
            false => x.node().operands().map(Item::Node).collect(),
        };
    };
    let system = |group: usize, by: &[SymbolId]| Item::System(System::new(group, by.to_vec()));
    match algebra.solutions.rule(symbol) {
        None => Vec::new(),
        Some(Rule::Follow(equal)) => vec![Item::Node(equal.id())],
        Some(Rule::Turn(own)) => vec![Item::Node(own.equal.id())],
        Some(Rule::Turning(turning)) => {
            let z = turning.z.ids().map(Item::Node);
            [&z[..], &[system(turning.group, &[])]].concat()
        }
        Some(Rule::Seen(seen)) => {
            let vector = seen.vector.ids().map(Item::Node);
            [&vector[..], &below_carrier(seen.carrier)].concat()
        }
        Some(Rule::Shown(shown)) => {
            let [vector, base] = [shown.vector, shown.base].map(|own| own.ids().map(Item::Node));
            [&vector[..], &base[..], &below_carrier(shown.carrier)].concat()
        }
        Some(Rule::Axis(own)) => below_carrier(own.0),
        Some(Rule::Cosine(rule) | Rule::Sine(rule) | Rule::Value(rule)) => {
            let mut below = vec![system(rule.group, &[])];
            below.extend(rule.carrier.into_iter().flat_map(below_carrier));
            below
        }
        Some(Rule::Unknown { group, .. }) => vec![system(*group, &[])],
        Some(Rule::Rate { group, by, .. }) => vec![system(*group, by)],
    }
}

/// Hands the weight of a symbol to what its rule is about.
fn symbol_back<'m>(
    algebra: &mut Algebra<'m>,
    weights: &mut Weights<'m>,
    symbol: SymbolId,
    weight: Ex<'m>,
) {
    let Some(rule) = algebra.solutions.rule(symbol).cloned() else {
        return;
    };
    match rule {
        Rule::Follow(equal) => add_to_node(algebra, weights, equal.id(), weight),
        Rule::Turn(own) => add_to_node(algebra, weights, own.equal.id(), weight),
        Rule::Cosine(rule) => add_to_angle(algebra, weights, rule, -(rule.unit[1] * weight)),
        Rule::Sine(rule) => add_to_angle(algebra, weights, rule, rule.unit[0] * weight),
        Rule::Value(rule) => add_to_angle(algebra, weights, rule, weight),
        Rule::Turning(turning) => {
            // The component of `z' u + rate perp(z u)`.
            let component = turning.component;
            let [c, s] = turning.unit.0;
            let factors = Vector([[c, -s], [s, c]][component]);
            for (z, factor) in turning.z.components().zip(factors.components()) {
                add_to_node(algebra, weights, z.id(), factor * weight);
            }
            let share = turning.vector.perp()[component] * weight;
            let system = System::new(turning.group, Vec::new());
            add_to_system(algebra, weights, system, turning.position, share);
        }
        Rule::Seen(seen) => {
            let [x, y] = seen.carrier.axis.0;
            let factors = [[x, y], [-y, x]][seen.component];
            for (own, factor) in seen.vector.components().zip(factors) {
                add_to_node(algebra, weights, own.id(), factor * weight);
            }
            let share = -(seen.own.perp()[seen.component] * weight);
            add_to_carrier(algebra, weights, seen.carrier, share);
        }
        Rule::Shown(shown) => {
            let component = shown.component;
            add_to_node(algebra, weights, shown.base[component].id(), weight);
            let [x, y] = shown.carrier.axis.0;
            let factors = [[x, -y], [y, x]][component];
            for (own, factor) in shown.vector.components().zip(factors) {
                add_to_node(algebra, weights, own.id(), factor * weight);
            }
            let turned = shown.vector.turned(shown.carrier.axis).perp();
            let share = turned[component] * weight;
            add_to_carrier(algebra, weights, shown.carrier, share);
        }
        Rule::Axis(own) => {
            let (carrier, component) = *own;
            let share = carrier.axis.perp()[component] * weight;
            add_to_carrier(algebra, weights, carrier, share);
        }
        Rule::Unknown { group, position } => {
            add_to_system(
                algebra,
                weights,
                System::new(group, Vec::new()),
                position,
                weight,
            );
        }
        Rule::Rate {
            group,
            position,
            by,
        } => add_to_system(algebra, weights, System::new(group, by), position, weight),
    }
}

/// Hands the multipliers of a system to its coefficients: `-l . F` for loops, `-l . (J r - right)` for rates.
fn system_back<'m>(algebra: &mut Algebra<'m>, weights: &mut Weights<'m>, system: &System) {
    let Some(own) = weights.systems.get(system).cloned() else {
        return;
    };
    let multipliers = adjoint::solve_transposed(algebra, system.group, &own);
    let solution = algebra.solutions.groups[system.group].clone();
    let rates = match system.by.is_empty() {
        true => None,
        false => Some(implicit::rates(algebra, system.group, system.by.clone())),
    };
    for (row, multiplier) in multipliers.into_iter().enumerate() {
        let minus = -multiplier;
        match &rates {
            None => {
                for term in &solution.terms {
                    let share = minus * term.factor;
                    add_to_node(algebra, weights, term.coefficient[row].id(), share);
                }
            }
            Some(rates) => {
                for (column, &rate) in solution.jacobian.iter().zip(&rates.rates) {
                    add_to_node(algebra, weights, column[row].id(), minus * rate);
                }
                add_to_node(algebra, weights, rates.right[row].id(), multiplier);
            }
        }
    }
}

fn add_to_angle<'m>(
    algebra: &mut Algebra<'m>,
    weights: &mut Weights<'m>,
    rule: AngleRule<'m>,
    share: Ex<'m>,
) {
    let system = System::new(rule.group, Vec::new());
    let share = rule.sensed(share);
    add_to_system(algebra, weights, system, rule.position, share);
    if let Some(carrier) = rule.carrier {
        add_to_carrier(algebra, weights, carrier, share);
    }
}

/// Hands the weight of a carrier's turning to its angle and to where it starts.
fn add_to_carrier<'m>(
    algebra: &mut Algebra<'m>,
    weights: &mut Weights<'m>,
    carrier: Carrier<'m>,
    share: Ex<'m>,
) {
    add_to_node(algebra, weights, carrier.angle.id(), share);
    let across = carrier.start.perp();
    for (start, factor) in carrier.start.components().zip(across.components()) {
        add_to_node(algebra, weights, start.id(), factor * share);
    }
}

fn add_to_node<'m>(
    algebra: &mut Algebra<'m>,
    weights: &mut Weights<'m>,
    node: NodeId,
    share: Ex<'m>,
) {
    if share.is_zero() || algebra.graph.constant_value(node).is_some() {
        return;
    }
    let zero = algebra.zero();
    *weights.nodes.entry(node).or_insert(zero) += share;
}

fn add_to_system<'m>(
    algebra: &mut Algebra<'m>,
    weights: &mut Weights<'m>,
    system: System,
    position: usize,
    share: Ex<'m>,
) {
    let count = algebra.solutions.groups[system.group].jacobian.len();
    let zero = algebra.zero();
    let own = weights
        .systems
        .entry(system)
        .or_insert_with(|| vec![zero; count]);
    own[position] += share;
}

/// What a carrier turns by.
fn below_carrier(carrier: Carrier) -> Vec<Item> {
    let nodes = std::iter::once(carrier.angle).chain(carrier.start.components());
    nodes.map(|x| Item::Node(x.id())).collect()
}
