//! All derivatives of one number by parameters in a single sweep backwards through its formula, the
//! loops and their rates.
//!
//! Each operation hands its weight, the derivative of the result by it, to its operands; a system
//! of loops or rates gathers the weights of its unknowns, turns them into multipliers, and hands
//! those to its coefficients. Everything is visited once, after all that depends on it.

use linkage_symbolic::lookup::{Map, Set};
use linkage_symbolic::{Ex, Node, NodeId, SymbolId, Vector, pull_back};

use crate::algebra::context::Algebra;
use crate::algebra::derivatives::adjoint;
use crate::algebra::derivatives::by_rule::GroupRates;
use crate::algebra::rules::{AngleRule, DerivativeRule, RotatingFrame};
use crate::algebra::solutions::Solutions;
use crate::algebra::systems::System;

/// An item that a sweep visits.
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

/// Returns the derivatives of a number by the nodes at which a sweep ends: inputs, and values known
/// before the input.
pub(crate) fn gradient<'m>(algebra: &mut Algebra<'m>, root: Ex<'m>) -> Vec<(Ex<'m>, Ex<'m>)> {
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
                    _ if is_end(&algebra.solutions, x) => gradient.push((x, weight)),
                    Node::Symbol(symbol) => {
                        symbol_back(&algebra.solutions, &mut weights, symbol, weight)
                    }
                    _ => {
                        for (operand, share) in pull_back(x, weight) {
                            add_to_node(&mut weights, operand, share);
                        }
                    }
                }
            }
            Item::System(system) => system_back(algebra, &mut weights, &system),
        }
    }
    gradient
}

/// True where a sweep ends: all that follows is known before the input, and its derivatives, too.
fn is_end(solutions: &Solutions, x: Ex) -> bool {
    match x.node() {
        Node::Symbol(symbol) => solutions.rule(symbol).is_none(),
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

/// Returns the items that an item is computed from.
fn below(algebra: &mut Algebra<'_>, item: &Item) -> Vec<Item> {
    match item {
        Item::Node(id) => below_node(&algebra.solutions, algebra.graph.ex(*id)),
        Item::System(system) => {
            let solution = &algebra.solutions.groups[system.group];
            let mut all: Vec<Ex> = Vec::new();
            if system.by.is_empty() {
                let coefficients = solution.terms.iter().map(|term| &term.coefficient);
                all.extend(coefficients.flatten());
            } else {
                all.extend(solution.jacobian.iter().flatten());
                all.extend(algebra.rates(system.group, system.by.clone()).right);
            }
            all.into_iter().map(|x| Item::Node(x.id())).collect()
        }
    }
}

fn below_node(solutions: &Solutions, x: Ex) -> Vec<Item> {
    let Node::Symbol(symbol) = x.node() else {
        return if is_end(solutions, x) {
            Vec::new()
        } else {
            x.node().operands().map(Item::Node).collect()
        };
    };
    let system = |group: usize, by: &[SymbolId]| Item::System(System::new(group, by.to_vec()));
    match solutions.rule(symbol) {
        None => Vec::new(),
        Some(DerivativeRule::Follow(equal)) => vec![Item::Node(equal.id())],
        Some(DerivativeRule::Rotation(rotation)) => vec![Item::Node(rotation.equal.id())],
        Some(DerivativeRule::TurnedVector(turning)) => {
            let z = turning.z.ids().map(Item::Node);
            [&z[..], &[system(turning.group, &[])]].concat()
        }
        Some(DerivativeRule::ToFrame(to_frame)) => {
            let vector = to_frame.vector.ids().map(Item::Node);
            [&vector[..], &below_frame(to_frame.link_frame)].concat()
        }
        Some(DerivativeRule::FromFrame(from_frame)) => {
            let [vector, base] =
                [from_frame.vector, from_frame.base].map(|vector| vector.ids().map(Item::Node));
            [&vector[..], &base[..], &below_frame(from_frame.link_frame)].concat()
        }
        Some(DerivativeRule::Axis(axis)) => below_frame(axis.0),
        Some(
            DerivativeRule::Cosine(rule) | DerivativeRule::Sine(rule) | DerivativeRule::Value(rule),
        ) => {
            let mut below = vec![system(rule.group, &[])];
            below.extend(rule.link_frame.into_iter().flat_map(below_frame));
            below
        }
        Some(DerivativeRule::Unknown { group, .. }) => vec![system(*group, &[])],
        Some(DerivativeRule::Rate { group, by, .. }) => vec![system(*group, by)],
    }
}

/// Hands the weight of a symbol to the operands of its rule.
fn symbol_back<'m>(
    solutions: &Solutions<'m>,
    weights: &mut Weights<'m>,
    symbol: SymbolId,
    weight: Ex<'m>,
) {
    let Some(rule) = solutions.rule(symbol).cloned() else {
        return;
    };
    match rule {
        DerivativeRule::Follow(equal) => add_to_node(weights, equal.id(), weight),
        DerivativeRule::Rotation(rotation) => add_to_node(weights, rotation.equal.id(), weight),
        DerivativeRule::Cosine(rule) => {
            add_to_angle(solutions, weights, rule, -(rule.unit[1] * weight))
        }
        DerivativeRule::Sine(rule) => add_to_angle(solutions, weights, rule, rule.unit[0] * weight),
        DerivativeRule::Value(rule) => add_to_angle(solutions, weights, rule, weight),
        DerivativeRule::TurnedVector(turning) => {
            // The component of `z' u + rate perp(z u)`.
            let component = turning.component;
            let [c, s] = turning.unit.0;
            let factors = Vector([[c, -s], [s, c]][component]);
            for (z, factor) in turning.z.components().zip(factors.components()) {
                add_to_node(weights, z.id(), factor * weight);
            }
            let share = turning.vector.perp()[component] * weight;
            let system = System::new(turning.group, Vec::new());
            add_to_system(solutions, weights, system, turning.position, share);
        }
        DerivativeRule::ToFrame(to_frame) => {
            let [x, y] = to_frame.link_frame.axis.0;
            let factors = [[x, y], [-y, x]][to_frame.component];
            for (x, factor) in to_frame.vector.components().zip(factors) {
                add_to_node(weights, x.id(), factor * weight);
            }
            let share = -(to_frame.in_frame.perp()[to_frame.component] * weight);
            add_to_frame(weights, to_frame.link_frame, share);
        }
        DerivativeRule::FromFrame(from_frame) => {
            let component = from_frame.component;
            add_to_node(weights, from_frame.base[component].id(), weight);
            let [x, y] = from_frame.link_frame.axis.0;
            let factors = [[x, -y], [y, x]][component];
            for (x, factor) in from_frame.vector.components().zip(factors) {
                add_to_node(weights, x.id(), factor * weight);
            }
            let turned = from_frame.vector.turned(from_frame.link_frame.axis).perp();
            let share = turned[component] * weight;
            add_to_frame(weights, from_frame.link_frame, share);
        }
        DerivativeRule::Axis(axis) => {
            let (link_frame, component) = *axis;
            let share = link_frame.axis.perp()[component] * weight;
            add_to_frame(weights, link_frame, share);
        }
        DerivativeRule::Unknown { group, position } => {
            add_to_system(
                solutions,
                weights,
                System::new(group, Vec::new()),
                position,
                weight,
            );
        }
        DerivativeRule::Rate {
            group,
            position,
            by,
        } => add_to_system(solutions, weights, System::new(group, by), position, weight),
    }
}

/// Hands the multipliers of a system to its coefficients: `-l . F` for loops, `-l . (J r - right)`
/// for rates.
fn system_back<'m>(algebra: &mut Algebra<'m>, weights: &mut Weights<'m>, system: &System) {
    let Some(found) = weights.systems.get(system).cloned() else {
        return;
    };
    let multipliers =
        adjoint::solve_transposed(algebra.graph, &mut algebra.solutions, system.group, &found);
    let solution = algebra.solutions.groups[system.group].clone();
    let rates = if system.by.is_empty() {
        None
    } else {
        Some(algebra.rates(system.group, system.by.clone()))
    };
    for (row, multiplier) in multipliers.into_iter().enumerate() {
        let minus = -multiplier;
        match &rates {
            None => {
                for term in &solution.terms {
                    let share = minus * term.factor;
                    add_to_node(weights, term.coefficient[row].id(), share);
                }
            }
            Some(rates) => {
                for (column, &rate) in solution.jacobian.iter().zip(&rates.rates) {
                    add_to_node(weights, column[row].id(), minus * rate);
                }
                add_to_node(weights, rates.right[row].id(), multiplier);
            }
        }
    }
}

fn add_to_angle<'m>(
    solutions: &Solutions<'m>,
    weights: &mut Weights<'m>,
    rule: AngleRule<'m>,
    share: Ex<'m>,
) {
    let system = System::new(rule.group, Vec::new());
    let share = rule.sensed(share);
    add_to_system(solutions, weights, system, rule.position, share);
    if let Some(link_frame) = rule.link_frame {
        add_to_frame(weights, link_frame, share);
    }
}

/// Hands the weight of a frame's rotation to its angle and to its start.
fn add_to_frame<'m>(weights: &mut Weights<'m>, link_frame: RotatingFrame<'m>, share: Ex<'m>) {
    add_to_node(weights, link_frame.angle.id(), share);
    let across = link_frame.start.perp();
    for (start, factor) in link_frame.start.components().zip(across.components()) {
        add_to_node(weights, start.id(), factor * share);
    }
}

fn add_to_node<'m>(weights: &mut Weights<'m>, node: NodeId, share: Ex<'m>) {
    if share.is_zero() || share.graph().constant_value(node).is_some() {
        return;
    }
    let zero = share.number(0.0);
    *weights.nodes.entry(node).or_insert(zero) += share;
}

fn add_to_system<'m>(
    solutions: &Solutions<'m>,
    weights: &mut Weights<'m>,
    system: System,
    position: usize,
    share: Ex<'m>,
) {
    let count = solutions.groups[system.group].jacobian.len();
    let zero = share.number(0.0);
    let found = weights
        .systems
        .entry(system)
        .or_insert_with(|| vec![zero; count]);
    found[position] += share;
}

/// Returns the nodes that a frame rotates with.
fn below_frame(link_frame: RotatingFrame) -> Vec<Item> {
    let nodes = std::iter::once(link_frame.angle).chain(link_frame.start.components());
    nodes.map(|x| Item::Node(x.id())).collect()
}
