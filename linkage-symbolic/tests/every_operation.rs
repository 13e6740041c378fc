//! One expression for each operation, run through everything that must know it: derivative, graph interpreter, inlining,
//! scheduling, program interpreter, text.

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::interpret::{evaluate, run};
use linkage_symbolic::program::{Binary, Source, Ternary, Unary};
use linkage_symbolic::schedule::{Slots, schedule, schedule_whole};
use linkage_symbolic::{Calculus, DerivativeMemo, Graph, NodeId, SymbolId, differentiate};

/// Parameters and inputs only: every other symbol is constant.
#[derive(Default)]
struct Plain {
    graph: Graph,
    memo: DerivativeMemo,
}

impl Calculus for Plain {
    fn graph(&mut self) -> &mut Graph {
        &mut self.graph
    }

    fn memo(&mut self) -> &mut DerivativeMemo {
        &mut self.memo
    }

    fn symbol_derivative(&mut self, _: SymbolId, _: SymbolId) -> NodeId {
        self.graph.zero()
    }
}

/// Expressions in `x` (an input) and `p` (a parameter), smooth near (0.4, 0.7).
fn expressions(g: &mut Graph) -> Vec<(&'static str, NodeId)> {
    let x = g.source(Source::Input(0));
    let p = g.source(Source::Parameter(0));
    let product = g.mul(x, p);
    let sum = g.add(product, p);
    let mut list = Vec::new();
    for (name, op) in [
        ("neg", Unary::Neg),
        ("abs", Unary::Abs),
        ("sqrt", Unary::Sqrt),
        ("sin", Unary::Sin),
        ("cos", Unary::Cos),
        ("tan", Unary::Tan),
        ("asin", Unary::Asin),
        ("acos", Unary::Acos),
        ("atan", Unary::Atan),
        ("sign", Unary::Sign),
        ("inverse_scale", Unary::InverseScale),
    ] {
        let argument = if matches!(op, Unary::Asin | Unary::Acos) {
            product
        } else {
            sum
        };
        list.push((name, g.unary(op, argument)));
    }
    for (name, op) in [
        ("add", Binary::Add),
        ("sub", Binary::Sub),
        ("mul", Binary::Mul),
        ("div", Binary::Div),
        ("atan2", Binary::Atan2),
        ("hypot", Binary::Hypot),
        ("min", Binary::Min),
        ("max", Binary::Max),
        ("root", Binary::Root),
    ] {
        list.push((name, g.binary(op, sum, product)));
    }
    list.push(("of the parameter alone", g.square(p)));
    let five = g.constant(5.0);
    list.push((
        "angle_near",
        g.ternary(Ternary::AngleNear, sum, product, five),
    ));
    list.push(("select", g.ternary(Ternary::Select, product, sum, x)));
    list
}

fn load(x: f64, p: f64) -> impl Fn(Source) -> f64 {
    move |source| match source {
        Source::Input(_) => x,
        _ => p,
    }
}

#[test]
fn derivatives_agree_with_differences() {
    let mut plain = Plain::default();
    let (x, p, step) = (0.4, 0.7, 1e-5);
    for (name, node) in expressions(&mut plain.graph) {
        let value = |g: &Graph, x: f64, p: f64| evaluate(g, &[node], load(x, p))[0];
        for (by, source) in [("x", Source::Input(0)), ("p", Source::Parameter(0))] {
            plain.graph.source(source);
            let variable = plain.graph.find_source(source).expect("there is one");
            let slope = differentiate(&mut plain, node, variable);
            let slope = evaluate(&plain.graph, &[slope], load(x, p))[0];
            let [dx, dp] = if by == "x" { [step, 0.0] } else { [0.0, step] };
            let up = value(&plain.graph, x + dx, p + dp);
            let down = value(&plain.graph, x - dx, p - dp);
            let difference = (up - down) / (2.0 * step);
            assert!(
                (slope - difference).abs() < 1e-8,
                "d {name}/d{by}: {slope} {difference}"
            );
        }
    }
}

#[test]
fn second_derivatives_do_not_depend_on_the_order() {
    let mut plain = Plain::default();
    for (name, node) in expressions(&mut plain.graph) {
        let [x, p] = [Source::Input(0), Source::Parameter(0)]
            .map(|source| plain.graph.find_source(source).expect("there is one"));
        let mixed = |c: &mut Plain, first, second| {
            let once = differentiate(c, node, first);
            differentiate(c, once, second)
        };
        let nodes = [mixed(&mut plain, x, p), mixed(&mut plain, p, x)];
        let values = evaluate(&plain.graph, &nodes, load(0.4, 0.7));
        assert!((values[0] - values[1]).abs() < 1e-13, "{name}: {values:?}");
    }
}

#[test]
fn programs_compute_what_graphs_say() {
    let mut graph = Graph::new();
    let nodes: Vec<NodeId> = expressions(&mut graph)
        .into_iter()
        .map(|(_, node)| node)
        .collect();
    let mut inliner = Inliner::default();
    let copies: Vec<NodeId> = nodes
        .iter()
        .map(|&node| inliner.copy(&graph, node))
        .collect();
    let target = &inliner.target;
    let mut slots = Slots::default();
    let program = schedule(target, &copies, &mut slots);
    let prepare = slots.prepare(target);
    for (x, p) in [(0.4, 0.7), (0.1, -0.3), (-0.2, 0.9)] {
        let expected = evaluate(&graph, &nodes, load(x, p));
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
    for word in ["sqrt", "atan2", "angle_near", "select", "root", "prepared"] {
        assert!(text.contains(word), "{word} is missing in\n{text}");
    }
}

#[test]
fn impossible_positions_are_nan() {
    let mut graph = Graph::new();
    let x = graph.source(Source::Input(0));
    let one = graph.one();
    let root = graph.binary(Binary::Root, x, one);
    let least = graph.binary(Binary::Min, root, one);
    let chosen = graph.ternary(Ternary::Select, root, one, root);
    let value = |x: f64| evaluate(&graph, &[root, least, chosen], |_| x);
    assert_eq!(value(4.0), [2.0, 1.0, 1.0]);
    assert_eq!(
        value(-1e-15),
        [0.0, 0.0, 1.0],
        "rounding below zero is the dead point"
    );
    assert!(value(-1e-14).iter().all(|v| v.is_nan()));
}
