//! Derivatives against differences at many places, and what operands contribute to them.

use linkage_random::Random;
use linkage_symbolic::program::{Binary, Source, Ternary, Unary};
use linkage_symbolic::{
    Calculus, DerivativeMemo, Ex, Graph, NodeId, SymbolId, differentiate, pull_back, rules,
};

use crate::{assert_near, inputs, value, values};

/// Three operands at a place where `of` has a derivative.
fn place(random: &mut Random, name: &str) -> [f64; 3] {
    let mut numbers = [0; 3].map(|_| random.ratio(0.2, 3.0) * [1.0, -1.0][random.below(2)]);
    match name {
        "sqrt" => numbers[0] = numbers[0].abs(),
        "root" => numbers = numbers.map(f64::abs),
        "asin" | "acos" => numbers[0] = random.between(-0.9, 0.9),
        // Not where the next power of two begins.
        "inverse_scale" => numbers[0] = random.between(1.1, 1.9) * [0.5, -4.0][random.below(2)],
        // Not where the next whole number begins.
        "whole" => numbers[0] = random.between(-0.4, 0.4) + 3.0,
        "tan" => numbers[0] = random.between(-1.2, 1.2),
        // Not where it jumps to the next turn.
        "angle_near" => numbers[2] = numbers[0].atan2(numbers[1]) + random.between(-3.0, 3.0),
        _ => {}
    }
    numbers
}

/// The slope of a function from differences, to about twelve digits: errors of second and fourth order cancel.
fn slope(f: impl Fn(f64) -> f64) -> f64 {
    let half = |step: f64| (f(step) - f(-step)) / (2.0 * step);
    let [wide, middle, narrow] = [4e-3, 2e-3, 1e-3].map(half);
    let [wide, narrow] = [(4.0 * middle - wide) / 3.0, (4.0 * narrow - middle) / 3.0];
    (16.0 * narrow - wide) / 15.0
}

/// Each operation of the three operands.
fn operations<'g>([a, b, c]: [Ex<'g>; 3]) -> Vec<(&'static str, Ex<'g>)> {
    let unary = Unary::ALL.iter().map(|&op| (op.row().name, a.unary(op)));
    let binary = Binary::ALL
        .iter()
        .map(|&op| (op.row().name, a.binary(op, b)));
    let ternary = Ternary::ALL
        .iter()
        .map(|&op| (op.row().name, a.ternary(op, b, c)));
    unary.chain(binary).chain(ternary).collect()
}

/// What each operand contributes is the weight times the slope of the operation by it.
#[test]
fn operands_contribute_their_slopes() {
    let graph = Graph::new();
    let [a, b, c, weight] = inputs(&graph);
    let mut random = Random::new(51);
    for (name, operation) in operations([a, b, c]) {
        let contributions = pull_back(operation, weight);
        let operands: Vec<NodeId> = contributions.iter().map(|own| own.0).collect();
        assert_eq!(
            operands,
            operation.node().operands().collect::<Vec<_>>(),
            "{name}"
        );
        for _ in 0..20 {
            let [x, y, z] = place(&mut random, name);
            let at = [x, y, z, random.between(-2.0, 2.0)];
            let found = values(contributions.iter().map(|own| own.1), &graph, &at);
            let differences: Vec<f64> = operands
                .iter()
                .map(|&operand| {
                    let k = [a, b, c].iter().position(|own| own.id() == operand);
                    let k = k.expect("one of the three");
                    let moved = |step: f64| {
                        let mut at = at;
                        at[k] += step;
                        value(operation, &at)
                    };
                    at[3] * slope(moved)
                })
                .collect();
            let size = differences.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
            // Not where a step crosses to the other formula.
            if (x - y).abs() > 0.01 {
                assert!(name != "min" && name != "max" || found.contains(&0.0));
                assert_near(&found, &differences, 1e-8 * size);
            }
        }
    }
}

/// Inputs alone are independent.
struct Plain<'g> {
    graph: &'g Graph,
    memo: DerivativeMemo,
}

impl<'g> Calculus<'g> for Plain<'g> {
    fn graph(&self) -> &'g Graph {
        self.graph
    }

    fn memo(&mut self) -> &mut DerivativeMemo {
        &mut self.memo
    }

    fn symbol_derivative(&mut self, _: SymbolId, _: SymbolId) -> NodeId {
        self.graph.zero()
    }
}

/// Contributions that are gathered backwards give the derivative that is found forwards.
#[test]
fn forwards_and_backwards_agree() {
    let graph = Graph::new();
    let [a, b, c] = inputs(&graph);
    let variables = [a, b, c].map(|own| graph.symbols_of(&[own.id()])[0]);
    let mut random = Random::new(52);
    for (name, inner) in operations([a, b, c]) {
        let root = (inner * b - a.square()) / (c.square() + 1.0);
        let mut weights: Vec<Option<Ex>> = vec![None; root.id().index() + 1];
        weights[root.id().index()] = Some(graph.number(1.0));
        for id in graph.reachable(&[root.id()]).into_iter().rev() {
            let weight = weights[id.index()].expect("all are parts of the root");
            for (operand, contribution) in pull_back(graph.ex(id), weight) {
                let own = &mut weights[operand.index()];
                *own = Some(own.map_or(contribution, |sum| sum + contribution));
            }
        }
        let mut plain = Plain {
            graph: &graph,
            memo: DerivativeMemo::new(),
        };
        let forwards = variables.map(|own| differentiate(&mut plain, root.id(), own));
        // What drops out of the root contributes nothing.
        let zero = graph.number(0.0);
        let backwards = [a, b, c].map(|own| weights[own.id().index()].unwrap_or(zero));
        for _ in 0..5 {
            let at = place(&mut random, name);
            let found = values(backwards, &graph, &at);
            let expected = values(forwards, &graph, &at);
            let size = expected.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
            assert_near(&found, &expected, 1e-13 * size);
        }
    }
}

/// A length joins the direction that it is multiplied by elsewhere; what is known at a call does not, nor does it join another length.
#[test]
fn lengths_join_their_directions_in_rates() {
    let graph = Graph::new();
    let [x, y, z] = inputs(&graph);
    let [p, q, r] = [0, 1, 2].map(|k| graph.ex(graph.source(Source::Parameter(k))));
    let vectors = [p * y, z * y, p * q];
    let rule = &rules::of_rates(Binary::Mul)[0];
    let rewritten = |factor: Ex, rate: Ex| {
        let operands = [factor.id(), rate.id()];
        rule.rewrite(&graph, Binary::Mul, operands)
    };
    assert_eq!(rewritten(p, x * y), Some((x * vectors[0]).id()));
    assert_eq!(rewritten(z, x * y), None);
    assert_eq!(rewritten(p, q * x), None);
    assert_eq!(rewritten(r, x * y), None, "no such vector");
}

/// A slope that is said is taken, and what it is the slope of is followed no further.
#[test]
fn slopes_that_are_said_are_taken() {
    let graph = Graph::new();
    let [x, y, _] = inputs(&graph);
    let argument = x * y;
    // Not its slope, so that one sees which one is taken.
    let value = (argument.square() + 1.0).with_slope(argument, argument.number(7.0));
    let variable = graph.symbols_of(&[x.id()])[0];
    let mut plain = Plain {
        graph: &graph,
        memo: DerivativeMemo::new(),
    };
    let found = [value, value.square()].map(|own| differentiate(&mut plain, own.id(), variable));
    let at = [2.0, 3.0, 0.0];
    assert_near(
        &values(found, &graph, &at),
        &[21.0, 2.0 * 37.0 * 21.0],
        1e-12,
    );
    // A number and a symbol have the slopes that they have.
    let [constant, own] = [x.number(2.0), x].map(|own| own.with_slope(argument, argument));
    let found = [constant, own].map(|own| differentiate(&mut plain, own.id(), variable));
    assert_near(&values(found, &graph, &at), &[0.0, 1.0], 0.0);
}
