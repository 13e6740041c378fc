//! One expression for each operation, run through everything that must know it: derivative, graph interpreter, inlining,
//! scheduling, program interpreter, text.

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::interpret::run;
use linkage_symbolic::program::{Binary, Source, Ternary, Unary};
use linkage_symbolic::schedule::{Slots, schedule, schedule_whole};
use linkage_symbolic::{
    Calculus, DerivativeMemo, Ex, Graph, NodeId, SymbolId, differentiate, evaluate,
};

/// Parameters and inputs only: every other symbol is constant.
struct Plain<'g> {
    graph: &'g Graph,
    memo: DerivativeMemo,
}

impl<'g> Plain<'g> {
    fn new(graph: &'g Graph) -> Self {
        Self {
            graph,
            memo: DerivativeMemo::new(),
        }
    }
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

/// Each operation in `x` (an input) and `p` (a parameter), smooth near (0.4, 0.7).
fn expressions(graph: &Graph) -> Vec<(&'static str, NodeId)> {
    let [x, p] = [Source::Input(0), Source::Parameter(0)].map(|own| graph.ex(graph.source(own)));
    let product = x * p;
    let sum = product + p;
    let five = graph.number(5.0);
    let mut list = vec![("of the parameter alone", p.square())];
    for &op in Unary::ALL {
        let argument = match op {
            // Not defined for numbers above 1.
            Unary::Asin | Unary::Acos => product,
            _ => sum,
        };
        list.push((op.row().name, argument.unary(op)));
    }
    for &op in Binary::ALL {
        list.push((op.row().name, sum.binary(op, x.square())));
    }
    for &op in Ternary::ALL {
        list.push((op.row().name, product.ternary(op, sum, five)));
    }
    let list = list.into_iter();
    list.map(|(name, value)| (name, value.id())).collect()
}

fn load(x: f64, p: f64) -> impl Fn(Source) -> f64 {
    move |source| match source {
        Source::Input(_) => x,
        _ => p,
    }
}

#[test]
fn derivatives_agree_with_differences() {
    let graph = Graph::new();
    let mut plain = Plain::new(&graph);
    let (x, p, step) = (0.4, 0.7, 1e-5);
    for (name, node) in expressions(&graph) {
        let value = |x: f64, p: f64| evaluate(&[graph.ex(node)], load(x, p))[0];
        for (by, source) in [("x", Source::Input(0)), ("p", Source::Parameter(0))] {
            graph.source(source);
            let variable = graph.find_source(source).expect("there is one");
            let slope = differentiate(&mut plain, node, variable);
            let slope = evaluate(&[graph.ex(slope)], load(x, p))[0];
            let [dx, dp] = if by == "x" { [step, 0.0] } else { [0.0, step] };
            let up = value(x + dx, p + dp);
            let down = value(x - dx, p - dp);
            let difference = (up - down) / (2.0 * step);
            assert!(
                (slope - difference).abs() < 1e-8 * difference.abs().max(1.0),
                "d {name}/d{by}: {slope} {difference}"
            );
        }
    }
}

#[test]
fn second_derivatives_do_not_depend_on_the_order() {
    let graph = Graph::new();
    let mut plain = Plain::new(&graph);
    for (name, node) in expressions(&graph) {
        let [x, p] = [Source::Input(0), Source::Parameter(0)]
            .map(|source| graph.find_source(source).expect("there is one"));
        let mixed = |c: &mut Plain, first, second| {
            let once = differentiate(c, node, first);
            differentiate(c, once, second)
        };
        let nodes = [mixed(&mut plain, x, p), mixed(&mut plain, p, x)];
        let values = evaluate(&nodes.map(|id| graph.ex(id)), load(0.4, 0.7));
        let size = values[0].abs().max(1.0);
        assert!(
            (values[0] - values[1]).abs() < 1e-13 * size,
            "{name}: {values:?}"
        );
    }
}

#[test]
fn programs_compute_what_graphs_say() {
    let graph = Graph::new();
    let (names, nodes): (Vec<_>, Vec<NodeId>) = expressions(&graph).into_iter().unzip();
    let own: Vec<Ex> = nodes.iter().map(|&id| graph.ex(id)).collect();
    let mut inliner = Inliner::default();
    let copies: Vec<NodeId> = nodes
        .iter()
        .map(|&node| inliner.copy(&graph, node))
        .collect();
    let target = &inliner.target;
    let mut slots = Slots::default();
    let program = schedule(target, &copies, &mut slots);
    let prepare = slots.prepare();
    for (x, p) in [(0.4, 0.7), (0.1, -0.3), (-0.2, 0.9)] {
        let expected = evaluate(&own, load(x, p));
        let whole = run(&schedule_whole(target, &copies), load(x, p));
        let prepared = run(&prepare, load(x, p));
        let split = run(&program, |source| match source {
            Source::Prepared(slot) => prepared[slot],
            other => load(x, p)(other),
        });
        for (k, &value) in expected.iter().enumerate() {
            let close = |other: f64| {
                (value.is_nan() && other.is_nan()) || (value - other).abs() <= 4e-16 * value.abs()
            };
            assert!(
                close(whole[k]) && close(split[k]),
                "{k}: {value} {} {}",
                whole[k],
                split[k]
            );
        }
    }
    let text = program.to_string();
    // Signs are absorbed by the next operation.
    let words = names.into_iter().skip(1).filter(|name| *name != "neg");
    for word in words.chain(["prepared"]) {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
}

#[test]
fn impossible_positions_are_nan() {
    let graph = Graph::new();
    let x = graph.source(Source::Input(0));
    let one = graph.one();
    let slack = graph.unary(Unary::Slack, one);
    let root = graph.ternary(Ternary::GuardedSqrt, x, slack, one);
    let least = graph.binary(Binary::Min, root, one);
    let chosen = graph.ternary(Ternary::Select, root, one, root);
    let own = [root, least, chosen].map(|id| graph.ex(id));
    let value = |x: f64| evaluate(&own, |_| x);
    assert_eq!(value(4.0), [2.0, 1.0, 1.0]);
    assert_eq!(
        value(-1e-15),
        [0.0, 0.0, 1.0],
        "rounding below zero is the dead point"
    );
    assert!(value(-1e-14).iter().all(|v| v.is_nan()));
}
