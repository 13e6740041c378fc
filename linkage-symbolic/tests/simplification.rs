//! What constructors simplify, how values move to the time when they are known, and what polynomials see.

use linkage_symbolic::lookup::Map;

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::passes::reciprocals;
use linkage_symbolic::program::{Binary, Instruction, Source, Ternary, Unary, Value};
use linkage_symbolic::schedule::{Slots, schedule, schedule_whole};
use linkage_symbolic::{
    Binding, Ex, Graph, NodeId, collect, evaluate, share_common_factors, substitute,
};

struct Names {
    g: Graph,
    x: NodeId,
    y: NodeId,
    p: NodeId,
    q: NodeId,
}

fn names() -> Names {
    let g = Graph::new();
    let [x, y] = [0, 1].map(|k| g.source(Source::Input(k)));
    let [p, q] = [0, 1].map(|k| g.source(Source::Parameter(k)));
    Names { g, x, y, p, q }
}

#[test]
fn neutral_elements_and_equal_terms_vanish() {
    let Names { g, x, y, p, .. } = names();
    let (zero, one) = (g.zero(), g.one());
    assert_eq!(g.add(x, zero), x);
    assert_eq!(g.mul(one, x), x);
    assert_eq!(g.sub(x, x), zero);
    assert_eq!(g.div(x, x), one);
    let sum = g.add(x, y);
    assert_eq!(g.sub(sum, x), y);
    let difference = g.sub(x, y);
    assert_eq!(g.add(difference, y), x);
    let opposite = g.sub(y, x);
    assert_eq!(g.add(difference, opposite), zero);
    let negative = g.neg(x);
    assert_eq!(g.neg(negative), x);
    // A link's length cancels against the solution for that link.
    let direction = g.div(x, p);
    assert_eq!(g.mul(p, direction), x);
    assert_eq!(g.hypot(p, zero), g.unary(Unary::Abs, p));
}

#[test]
fn equal_operations_are_one_node() {
    let Names { g, x, y, .. } = names();
    assert_eq!(g.add(x, y), g.add(y, x));
    assert_eq!(g.mul(x, y), g.mul(y, x));
    let minus_y = g.neg(y);
    assert_eq!(g.sub(x, y), g.add(x, minus_y));
    assert_eq!(g.constant(-0.0), g.constant(0.0));
}

#[test]
fn parameters_gather_before_inputs() {
    let Names { g, x, p, q, .. } = names();
    let inner = g.mul(q, x);
    let product = g.mul(p, inner);
    let factor = g.mul(p, q);
    assert_eq!(product, g.mul(factor, x), "p (q x) = (p q) x");
    assert_eq!(g.binding(factor), Binding::Parameter);
    let quotient = g.div(x, p);
    let program = schedule(&g, &[quotient], &mut Slots::default());
    let divides = |i: &Instruction| matches!(i, Instruction::Binary(Binary::Div, ..));
    assert!(
        !program.instructions.iter().any(divides),
        "1/p is prepared\n{program}"
    );
}

#[test]
fn a_slice_contains_what_its_outputs_need() {
    let Names { g, x, y, p, q } = names();
    let first = g.mul(x, p);
    let parameter_only = g.add(p, q);
    let second = g.mul(first, y);
    let wanted = g.mul(parameter_only, x);
    let mut slots = Slots::default();
    assert_eq!(schedule(&g, &[first], &mut slots).instructions.len(), 3);
    let program = schedule(&g, &[wanted], &mut slots);
    assert!(
        program
            .instructions
            .contains(&Instruction::Load(Source::Prepared(0)))
    );
    assert!(
        !program
            .instructions
            .contains(&Instruction::Load(Source::Input(1)))
    );
    assert_eq!(slots.prepare().outputs.len(), 1);
    let staged = schedule_whole(&g, &[first, second]);
    // A prefix computes the first output.
    assert_eq!(staged.outputs, [Value(2), Value(4)]);
}

#[test]
fn three_divisions_by_one_divisor_share_a_reciprocal() {
    let Names { g, x, y, p, q } = names();
    let divisor = g.add(x, y);
    let quotients = |g: &Graph, over: &[NodeId]| -> Vec<NodeId> {
        over.iter().map(|&n| g.div(n, divisor)).collect()
    };
    let count = |g: &Graph, outputs: &[NodeId]| {
        let divides = |i: &&Instruction| matches!(i, Instruction::Binary(Binary::Div, ..));
        reciprocals::share(schedule_whole(g, outputs))
            .instructions
            .iter()
            .filter(divides)
            .count()
    };
    let two = quotients(&g, &[p, q]);
    assert_eq!(count(&g, &two), 2);
    let three = quotients(&g, &[p, q, x]);
    assert_eq!(count(&g, &three), 1);
}

#[test]
fn polynomials_see_through_the_way_of_writing() {
    let g = Graph::new();
    let (c, cos) = g.unknown("cos");
    let (s, sin) = g.unknown("sin");
    let p = g.source(Source::Parameter(0));
    let symbols = [c, s];
    let pairs = [(0, 1)];
    // p (cos + 2) - 2 p = p cos
    let two = g.constant(2.0);
    let sum = g.add(cos, two);
    let product = g.mul(p, sum);
    let twice = g.mul(two, p);
    let root = g.sub(product, twice);
    let found = collect(g.ex(root), &symbols, &pairs).expect("a polynomial");
    assert_eq!(
        found.into_iter().collect::<Vec<_>>(),
        [(vec![1, 0], g.ex(p))]
    );
    // cos^2 + sin^2 = 1
    let (cos2, sin2) = (g.square(cos), g.square(sin));
    let unit = g.add(cos2, sin2);
    let found = collect(g.ex(unit), &symbols, &pairs).expect("a polynomial");
    assert_eq!(
        found.into_iter().collect::<Vec<_>>(),
        [(vec![0, 0], g.number(1.0))]
    );
    let not_one = g.unary(Unary::Sqrt, cos);
    assert!(collect(g.ex(not_one), &symbols, &pairs).is_none());
    let inverse = g.div(p, sum);
    assert!(collect(g.ex(inverse), &symbols, &pairs).is_none());
}

#[test]
fn substitution_simplifies() {
    let Names { g, x, y, .. } = names();
    let (symbol, unknown) = g.unknown("u");
    let sum = g.add(unknown, x);
    let negative = g.neg(x);
    let value = g.add(y, negative);
    let map = Map::from([(symbol, g.ex(value))]);
    assert_eq!(substitute(&[g.ex(sum)], &map), [g.ex(y)]);
}

/// A guard against a root that cannot be taken goes where the value contains the root anyway, and only there: whether
/// it does may depend on what a definition turns out to be.
#[test]
fn guards_stay_where_the_root_drops_out() {
    let Names { g, x, p, q, .. } = names();
    let (direction, factor) = g.unknown("direction");
    let root = g.ternary(Ternary::GuardedSqrt, x, p, p);
    let along = g.mul(factor, root);
    let value = g.add(along, q);
    let guarded = g.ternary(Ternary::Select, root, value, root);
    let one = g.one();
    let zero = g.zero();
    for (definition, guards) in [(one, 0), (zero, 1)] {
        g.define(direction, definition);
        let mut inliner = Inliner::default();
        let copy = inliner.copy(&g, guarded);
        let program = schedule_whole(&inliner.target, &[copy]);
        let is_guard = |i: &&Instruction| matches!(i, Instruction::Ternary(Ternary::Select, ..));
        assert_eq!(program.instructions.iter().filter(is_guard).count(), guards);
        let load = |source| match source {
            Source::Input(_) => -10.0,
            _ => 2.0,
        };
        assert!(evaluate(&[inliner.target.ex(copy)], load)[0].is_nan());
    }
}

/// `p x + q y` times factors known early, in all signs.
fn turned(g: &Graph, factors: &[NodeId], signs: [f64; 2]) -> NodeId {
    let [x, y] = [0, 1].map(|k| g.source(Source::Input(k)));
    let [p, q] = [0, 1].map(|k| g.source(Source::Parameter(k)));
    let [p, q] = [(p, signs[0]), (q, signs[1])].map(|(factor, sign)| {
        let sign = g.constant(sign);
        let signed = g.mul(sign, factor);
        factors.iter().fold(signed, |product, &x| g.mul(x, product))
    });
    let [left, right] = [g.mul(p, x), g.mul(q, y)];
    g.add(left, right)
}

#[test]
fn signs_of_early_factors_do_not_hide_equal_sums() {
    let g = Graph::new();
    let sum = turned(&g, &[], [1.0, 1.0]);
    let opposite = turned(&g, &[], [-1.0, -1.0]);
    assert_eq!(g.neg(opposite), sum);
    let difference = turned(&g, &[], [1.0, -1.0]);
    let reverse = turned(&g, &[], [-1.0, 1.0]);
    assert_eq!(g.neg(reverse), difference);
}

#[test]
fn multiples_of_a_sum_are_products() {
    let g = Graph::new();
    let [r, s] = [2, 3].map(|k| g.source(Source::Parameter(k)));
    let one = g.one();
    let inverse = g.div(one, s);
    let outputs = [
        turned(&g, &[inverse, r], [1.0, 1.0]),
        turned(&g, &[inverse], [-1.0, -1.0]),
        turned(&g, &[r, inverse, r], [-2.0, -2.0]),
        turned(&g, &[r], [1.0, -1.0]),
    ];
    let shared = share_common_factors(&g, &outputs);
    let count = |outputs: &[NodeId]| {
        let program = schedule(&g, outputs, &mut Slots::default());
        let sums = program.instructions.iter().filter(|instruction| {
            matches!(
                instruction,
                Instruction::Binary(Binary::Add | Binary::Sub, ..) | Instruction::Fused(..)
            )
        });
        sums.count()
    };
    assert_eq!((count(&outputs), count(&shared)), (4, 2));
    // A factor may be 0.
    let load = |source| match source {
        Source::Parameter(2) => 0.0,
        Source::Parameter(k) => 1.5 + k as f64,
        Source::Input(k) => 0.7 - k as f64,
        _ => f64::NAN,
    };
    let value = |all: &[NodeId]| {
        let all: Vec<Ex> = all.iter().map(|&id| g.ex(id)).collect();
        evaluate(&all, load)
    };
    let (before, after) = (value(&outputs), value(&shared));
    for (a, b) in before.iter().zip(&after) {
        assert!((a - b).abs() <= 1e-15 * a.abs(), "{before:?} {after:?}");
    }
}
