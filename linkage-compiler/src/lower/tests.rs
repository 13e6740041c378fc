//! Sensitivities are the same in every direction, for every kind of group.

use linkage_symbolic::interpret::evaluate;
use linkage_symbolic::program::Source;
use linkage_symbolic::{Graph, NodeId};
use proc_macro2::TokenStream;

use super::quantity::request;
use crate::algebra::{Algebra, Direction, Nominal};
use crate::diagnostic::{Diagnostics, Origins};
use crate::{formulate, model, structure, syntax};

const ITEMS: &str =
    "unit mm; param a = 40mm; param b = 120mm; param c = 80mm; param d = 100mm; param e = 7mm;
    param lift = 25deg; input phi = 40deg in 0deg..80deg;";

struct Random(u64);

impl Random {
    /// Between -1 and 1.
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// Compares all quantities of a function `f` in all directions.
#[track_caller]
fn expect_agreement(items: &str, function: &str) {
    let text = format!("pub struct M {{ {ITEMS} {items} }} impl M {{ pub fn {function} }}");
    let tokens: TokenStream = text.parse().expect("tokens");
    let mut diagnostics = Diagnostics::default();
    let mut origins = Origins::default();
    let definition = syntax::parse(tokens, &mut diagnostics).expect("a mechanism");
    let mechanism = model::resolve(&definition, &mut origins, &mut diagnostics);
    let messages: Vec<&String> = diagnostics.iter().map(|d| &d.message).collect();
    assert!(messages.is_empty(), "{messages:?}");
    let mechanism = mechanism.expect("it resolves");

    let mut algebra = Algebra::new(&mechanism);
    let nominal = Nominal::of(&mut algebra);
    let structure = structure::decompose(&mut algebra, &nominal, &origins, &mut diagnostics);
    let formulation = formulate::formulate(&mut algebra, structure);
    let directions = [
        Direction::Forward,
        Direction::FromResults,
        Direction::FromUnknowns,
    ];
    let results = directions.map(|direction| {
        let function = &mechanism.evaluators[0];
        let requested = request(&mut algebra, &formulation, function, direction);
        assert!(requested.by_parameters);
        requested.nodes
    });
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let compared: usize = (0..8)
        .map(|_| compare(&algebra.graph, &results, &nominal, &mut random))
        .sum();
    assert!(compared > 0, "the mechanism never closes: {items}");
}

/// At a random position of a random mechanism near the nominal one. Returns the number of results that are numbers.
#[track_caller]
fn compare(
    graph: &Graph,
    results: &[Vec<NodeId>; 3],
    nominal: &Nominal,
    random: &mut Random,
) -> usize {
    let vary = |values: &[f64], random: &mut Random| -> Vec<f64> {
        let varied = values.iter().map(|x| x + 0.05 * random.next() * x.abs());
        varied.collect()
    };
    let parameters = vary(&nominal.parameters, random);
    let inputs = vary(&nominal.inputs, random);
    let modes: Vec<f64> = (0..8).map(|_| random.next().signum()).collect();
    let run = |nodes: &[NodeId], noise: f64, random: &mut Random| {
        let noise = [0; 40].map(|_| 1.0 + noise * random.next());
        evaluate(graph, nodes, |source| match source {
            Source::Parameter(k) => parameters[k] * noise[k],
            Source::Input(k) => inputs[k] * noise[39 - k],
            Source::Mode(k) => modes[k],
            Source::Centre(_) => 0.3,
            Source::Winding(..) => 0.0,
            _ => f64::NAN,
        })
    };
    let [forward, others @ ..] = results;
    let expected = run(forward, 0.0, random);
    // What 256 roundoffs of the data do.
    let noise = 256.0 * f64::EPSILON;
    let disturbed: Vec<Vec<f64>> = (0..4).map(|_| run(forward, noise, random)).collect();
    for other in others {
        let found = run(other, 0.0, random);
        for (k, (&x, &y)) in expected.iter().zip(&found).enumerate() {
            let spread = disturbed
                .iter()
                .map(|results| (results[k] - x).abs())
                .fold(noise * x.abs() + 1e-14, f64::max);
            let agree = (x - y).abs() <= 2.0 * spread || x.is_nan() && y.is_nan();
            assert!(
                agree,
                "result {k}: forward {x:e}, backwards {y:e}, spread {spread:e}"
            );
        }
    }
    expected.iter().filter(|x| !x.is_nan()).count()
}

/// All sensitivities of values, velocities and accelerations.
#[track_caller]
fn expect_all(items: &str, quantities: &[&str]) {
    for q in quantities {
        for wrapped in [
            (*q).to_owned(),
            format!("velocity({q})"),
            format!("acceleration({q})"),
        ] {
            expect_agreement(
                items,
                &format!("f(phi) -> R {{ s: sensitivity({wrapped}) }}"),
            );
        }
    }
}

const RRR: &str = "unknown t = 20deg; unknown p = 57deg;
    loop polar(a, phi) + polar(b, t) = (d, 0) + polar(c, p);";
const PIN: &str = "let k = polar(a, phi) + polar(d / 2, t + lift);";

#[test]
fn two_links() {
    let items = format!("{RRR} {PIN}");
    expect_all(&items, &["k", "t", "p", "k.x * k.y", "sin(2 * p)"]);
    let mirrored = "unknown t = -20deg; unknown p = -57deg;
        loop polar(a, phi) + polar(b, -t) = (d, 0) + polar(c, -p);";
    expect_all(mirrored, &["t", "polar(b, -t)"]);
    let points = "unknown q = (150mm, 60mm);
        loop distance(polar(a, phi), q) = b; loop distance((d, 0), q) = c;";
    expect_all(points, &["q"]);
    // Lengths that depend on the input.
    let cylinder = "unknown p = 57deg; let l = b + e * sin(phi);
        loop distance(polar(a, phi), (d, 0) + polar(c, p)) = l;";
    expect_all(cylinder, &["p", "polar(c, p)"]);
}

#[test]
fn links_and_slides() {
    for (items, quantities) in [
        (
            "unknown t = -20deg; unknown x = 150mm;
             loop polar(a, phi) + polar(b, t) = x * dir(lift - phi / 3) + (e, e);",
            ["t", "x", "polar(x, t)"],
        ),
        (
            "unknown t = -20deg; unknown x = 75mm; loop polar(a, phi) + polar(b, t) = x * (2, 0.1);",
            ["t", "x", "polar(x, t)"],
        ),
        (
            "unknown t = 170deg; unknown s = 70mm; loop polar(a, phi) = (d, 0) + rotate((s, e), t);",
            ["t", "s", "rotate((s, e), t)"],
        ),
        (
            "unknown t = 170deg; unknown s = 35mm;
             loop polar(a, phi) = (d, 0) + dir(t) * (2 * s + e);",
            ["t", "s", "polar(s, t)"],
        ),
        (
            "unknown x = 30mm; unknown y = 25mm;
             loop x * dir(lift) + y * dir(phi + 90deg) = polar(a, phi);",
            ["x", "y", "x * y"],
        ),
    ] {
        expect_all(items, &quantities);
    }
}

#[test]
fn scalar_loops() {
    for (items, quantities) in [
        (
            "unknown t = -20deg; unknown x = 150mm; let q = polar(a, phi) + polar(b, t);
             loop q.y = e; loop q.x = x;",
            &["t", "x", "q"][..],
        ),
        (
            "unknown x = 150mm; let v = (x, 0) - polar(a, phi); loop dot(v, v) = b * b;",
            &["x"],
        ),
        (
            "unknown x = 40mm; loop x * cos(phi) = a + e * sin(phi);",
            &["x", "x * x"],
        ),
        (
            "unknown t = 60deg; unknown s = -20deg; loop t + s = phi + lift; loop t - s = 2 * phi;",
            &["t", "polar(a, s)"],
        ),
    ] {
        expect_all(items, quantities);
    }
}

#[test]
fn chains() {
    let items = format!(
        "{RRR} {PIN} unknown x = 200mm; unknown u = -20deg; unknown v = 100deg; unknown s = 90mm;
         let f = (2 * d, 0) + x * dir(lift + t / 4);
         loop k + polar(2 * b, u) = f;
         loop f = k + (e, -d) + rotate((s, e), v + p);"
    );
    expect_all(&items, &["x", "s", "v", "k + polar(s, v - t)"]);
}

#[test]
fn several_inputs_and_mixed_derivatives() {
    let items = format!(
        "input h = 60deg in 20deg..80deg; {RRR} {PIN}
         unknown g = 20deg; unknown n = 90deg;
         loop k + polar(b, g) = (2 * d, 0) + polar(a, h) + polar(c, n);"
    );
    for quantities in [
        "sensitivity(g), w: sensitivity(velocity(polar(c, n)))",
        "sensitivity(d(p, phi, phi)), w: sensitivity(acceleration(n))",
        "d(n, a, b), w: d(n, b), v: d(g, phi, c), u: d(velocity(g), a, c)",
        "velocity(sensitivity(n, [a, c])), w: sensitivity(sensitivity(g, [b, d]), [a, b])",
    ] {
        expect_agreement(&items, &format!("f(phi, h) -> R {{ s: {quantities} }}"));
    }
}
