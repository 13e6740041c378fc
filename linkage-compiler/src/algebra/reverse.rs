//! All derivatives of one number by parameters in a single sweep backwards through its formula, the loops and their rates.
//!
//! Each operation hands its weight, the derivative of the result by it, to its operands; a system of loops or rates gathers the weights of its
//! unknowns, turns them into multipliers, and hands those to its coefficients. Everything is visited once, after all that
//! depends on it.

use std::collections::{HashMap, HashSet};

use linkage_symbolic::{Binding, Node, NodeId, SymbolId, pull_back};

use super::Algebra;
use super::implicit::{AngleRule, Rule};
use super::partial::System;

/// What a sweep visits.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Item {
    Node(NodeId),
    System(System),
}

/// Derivatives of a number by nodes at which a sweep ends: what is known before the input, and inputs.
pub(super) type Gradient = Vec<(NodeId, NodeId)>;

/// Weights during a sweep.
#[derive(Default)]
struct Weights {
    nodes: HashMap<NodeId, NodeId>,
    systems: HashMap<System, Vec<NodeId>>,
}

impl Algebra<'_> {
    /// The derivative of a node by a parameter, from the gradient of the node.
    pub(super) fn gradient_by(&mut self, node: NodeId, parameter: SymbolId) -> NodeId {
        if !self.gradients.contains_key(&node) {
            let gradient = self.gradient(node);
            self.gradients.insert(node, gradient);
        }
        let gradient = self.gradients[&node].clone();
        let zero = self.graph.zero();
        gradient.into_iter().fold(zero, |sum, (end, weight)| {
            let slope = self.partial(end, parameter);
            let product = self.graph.mul(slope, weight);
            self.graph.add(sum, product)
        })
    }

    fn gradient(&mut self, root: NodeId) -> Gradient {
        let one = self.graph.one();
        let mut weights = Weights::default();
        weights.nodes.insert(root, one);
        let mut gradient = Gradient::new();
        for item in self.order_below(root).into_iter().rev() {
            match item {
                Item::Node(id) => {
                    let Some(&weight) = weights.nodes.get(&id) else {
                        continue;
                    };
                    match self.graph.node(id) {
                        _ if self.is_end(id) => gradient.push((id, weight)),
                        Node::Symbol(symbol) => {
                            let rule = self.rules[&symbol].clone();
                            self.symbol_back(&mut weights, &rule, weight);
                        }
                        _ => {
                            let [value, weight] = [id, weight].map(|node| self.graph.ex(node));
                            for (operand, share) in pull_back(value, weight) {
                                self.add_to_node(&mut weights, operand, share.id());
                            }
                        }
                    }
                }
                Item::System(system) => self.system_back(&mut weights, &system),
            }
        }
        gradient
    }

    /// True where a sweep ends: what follows is known before the input, and its derivatives, too.
    fn is_end(&self, id: NodeId) -> bool {
        match self.graph.node(id) {
            Node::Symbol(symbol) => !self.rules.contains_key(&symbol),
            _ => self.graph.binding(id) < Binding::Call,
        }
    }

    /// Nodes and systems below a node, each before those that are computed from it.
    fn order_below(&mut self, root: NodeId) -> Vec<Item> {
        let mut order = Vec::new();
        let mut entered: HashSet<Item> = HashSet::new();
        let mut open = vec![(Item::Node(root), false)];
        while let Some((item, left)) = open.pop() {
            if left {
                order.push(item);
                continue;
            }
            if !entered.insert(item.clone()) {
                continue;
            }
            let below = self.below(&item);
            open.push((item, true));
            open.extend(below.into_iter().map(|item| (item, false)));
        }
        order
    }

    /// What an item is computed from.
    fn below(&mut self, item: &Item) -> Vec<Item> {
        let nodes: Vec<NodeId> = match item {
            Item::Node(id) if self.is_end(*id) => Vec::new(),
            Item::Node(id) => match self.graph.node(*id) {
                Node::Symbol(symbol) => match self.rules.get(&symbol).cloned() {
                    None => Vec::new(),
                    Some(Rule::Follow(node)) => vec![node],
                    Some(Rule::Turning(turning)) => {
                        let own = System::new(turning.group, Vec::new());
                        let z = turning.z.map(Item::Node);
                        return [&z[..], &[Item::System(own)]].concat();
                    }
                    Some(
                        Rule::Cosine(AngleRule { group, .. })
                        | Rule::Sine(AngleRule { group, .. })
                        | Rule::Value(AngleRule { group, .. })
                        | Rule::Unknown { group, .. },
                    ) => return vec![Item::System(System::new(group, Vec::new()))],
                    Some(Rule::Rate { group, by, .. }) => {
                        return vec![Item::System(System::new(group, by))];
                    }
                },
                node => node.operands().collect(),
            },
            Item::System(system) => {
                let solution = &self.solutions[system.group];
                match system.by.is_empty() {
                    true => {
                        let coefficients = solution.terms.iter().map(|term| &term.coefficient);
                        coefficients.flatten().copied().collect()
                    }
                    false => {
                        let mut nodes: Vec<NodeId> =
                            solution.jacobian.iter().flatten().copied().collect();
                        nodes.extend(self.rates(system.group, system.by.clone()).right);
                        nodes
                    }
                }
            }
        };
        nodes.into_iter().map(Item::Node).collect()
    }

    /// Hands the weight of a symbol to what its rule is about.
    fn symbol_back(&mut self, weights: &mut Weights, rule: &Rule, weight: NodeId) {
        match rule {
            Rule::Follow(node) => self.add_to_node(weights, *node, weight),
            Rule::Cosine(rule) => {
                let product = self.graph.mul(rule.sin, weight);
                let share = self.graph.neg(product);
                self.add_to_angle(weights, *rule, share);
            }
            Rule::Sine(rule) => {
                let share = self.graph.mul(rule.cos, weight);
                self.add_to_angle(weights, *rule, share);
            }
            Rule::Value(rule) => self.add_to_angle(weights, *rule, weight),
            Rule::Turning(turning) => {
                // The component of `z' u + rate perp(z u)`.
                let [c, s] = turning.unit;
                let minus = self.graph.neg(s);
                let factors = [[c, minus], [s, c]][turning.component];
                for (z, factor) in turning.z.into_iter().zip(factors) {
                    let share = self.graph.mul(factor, weight);
                    self.add_to_node(weights, z, share);
                }
                let back = self.graph.neg(turning.vector[1]);
                let across = [back, turning.vector[0]][turning.component];
                let share = self.graph.mul(across, weight);
                let system = System::new(turning.group, Vec::new());
                self.add_to_system(weights, system, turning.position, share);
            }
            Rule::Unknown { group, position } => {
                self.add_to_system(weights, System::new(*group, Vec::new()), *position, weight);
            }
            Rule::Rate {
                group,
                position,
                by,
            } => {
                let system = System::new(*group, by.clone());
                self.add_to_system(weights, system, *position, weight);
            }
        }
    }

    /// Hands the multipliers of a system to its coefficients: `-l . F` for loops, `-l . (J r - right)` for rates.
    fn system_back(&mut self, weights: &mut Weights, system: &System) {
        let Some(own) = weights.systems.get(system).cloned() else {
            return;
        };
        let multipliers = self.solve_transposed(system.group, &own);
        let solution = self.solutions[system.group].clone();
        let rates = match system.by.is_empty() {
            true => None,
            false => Some(self.rates(system.group, system.by.clone())),
        };
        for (row, multiplier) in multipliers.into_iter().enumerate() {
            let minus = self.graph.neg(multiplier);
            match &rates {
                None => {
                    for term in &solution.terms {
                        let share = self.graph.mul(minus, term.factor);
                        self.add_to_node(weights, term.coefficient[row], share);
                    }
                }
                Some(rates) => {
                    for (column, &rate) in solution.jacobian.iter().zip(&rates.rates) {
                        let share = self.graph.mul(minus, rate);
                        self.add_to_node(weights, column[row], share);
                    }
                    self.add_to_node(weights, rates.right[row], multiplier);
                }
            }
        }
    }

    fn add_to_angle(&mut self, weights: &mut Weights, rule: AngleRule, share: NodeId) {
        let share = if rule.sense < 0.0 {
            self.graph.neg(share)
        } else {
            share
        };
        let system = System::new(rule.group, Vec::new());
        self.add_to_system(weights, system, rule.position, share);
    }

    fn add_to_node(&mut self, weights: &mut Weights, node: NodeId, share: NodeId) {
        if self.graph.is_zero(share) || self.graph.constant_value(node).is_some() {
            return;
        }
        let zero = self.graph.zero();
        let old = weights.nodes.get(&node).copied().unwrap_or(zero);
        weights.nodes.insert(node, self.graph.add(old, share));
    }

    fn add_to_system(
        &mut self,
        weights: &mut Weights,
        system: System,
        position: usize,
        share: NodeId,
    ) {
        let count = self.solutions[system.group].jacobian.len();
        let zero = self.graph.zero();
        let own = weights
            .systems
            .entry(system)
            .or_insert_with(|| vec![zero; count]);
        own[position] = self.graph.add(own[position], share);
    }
}
