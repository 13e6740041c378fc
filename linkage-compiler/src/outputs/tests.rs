//! Sensitivities are the same in every direction, for every kind of group.

mod about;
mod alone;
mod forces;
mod space;
mod units;

use linkage_core::numeric::continuation::Terms;
use linkage_random::Random;
use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, evaluate};
use proc_macro2::TokenStream;

use crate::algebra::derivatives::preaccumulation;
use crate::algebra::{Algebra, Direction, Nominal, Shortcuts};
use crate::assembly::assemble_reference;
use crate::diagnostic::{Diagnostics, Reporter};
use crate::forces::Forces;
use crate::machine::Reference;
use crate::model::{Library, Model};
use crate::solve::Formulation;
use crate::{lower, model, solve, structure, syntax};

use super::quantity::{Strategy, request};
use super::state::State;

const ITEMS: &str =
    "unit mm; param a = 40mm; param b = 120mm; param c = 80mm; param d = 100mm; param e = 7mm;
    param lift = 25deg; input phi = 40deg in 0deg..80deg at omega, epsilon;";

/// Compares all quantities of a function `f` in all directions.
#[track_caller]
fn expect_agreement(items: &str, function: &str) {
    let text = format!("pub struct M {{ {ITEMS} {items} }} impl M {{ pub fn {function} }}");
    let tokens: TokenStream = text.parse().expect("tokens");
    let mut diagnostics = Diagnostics::default();
    let definition = syntax::parse(tokens, &mut diagnostics).pop();
    let definition = definition.expect("a mechanism");
    let library = Library::default();
    let model = model::resolve(&definition, &library, &mut diagnostics);
    let messages = diagnostics.texts();
    assert!(messages.is_empty(), "{messages:?}");
    let Model { mechanism, origins } = model.expect("it resolves");

    let graph = Graph::new();
    let mut algebra = Algebra::new(&mechanism, &graph);
    let mut nominal = Nominal::from_mechanism(&mut algebra.names);
    let mut reporter = Reporter::new(&origins, &mut diagnostics);
    let structure = structure::decompose(
        &mut algebra.names,
        &nominal,
        &structure::Scope::all(&mechanism),
        reporter.reborrow(),
    );
    let formulation = solve::formulate(&mut algebra, &nominal, structure, Terms::Polynomials);
    let mut forces = Forces::new(&mut algebra);
    let others = [(false, false), (true, false), (false, true)];
    let ways = others.map(|(other_sides, products)| {
        Direction::ALL.map(|direction| Strategy {
            direction,
            other_sides,
            shortcuts: Shortcuts {
                products,
                turns: false,
            },
        })
    });
    let results = ways.as_flattened().iter().map(|&way| {
        let function = &mechanism.evaluators[0];
        let mut state = State {
            algebra: &mut algebra,
            forces: &mut forces,
            formulation: &formulation,
            drawn: Vec::new(),
        };
        let requested = request(&mut state, function, way);
        assert!(!requested.sensed.is_empty());
        // Forward is the first.
        preaccumulation::find_intermediates(&mut algebra, &requested.sensed);
        requested.scalars
    });
    let results: Vec<Vec<Ex>> = results.collect();
    let closure = lower::closure_programs(&mut algebra, &formulation, &nominal);
    let reference = assemble_reference(
        &algebra,
        &formulation,
        closure,
        &mut nominal,
        Vec::new(),
        reporter,
    );
    let (reference, _) = reference.expect("polynomials serve");
    let messages = diagnostics.texts();
    assert!(
        reference.closed || formulation.prepared().count() == 0,
        "{messages:?}"
    );
    let mut random = Random::new(1);
    let mut compared = 0;
    for _ in 0..8 {
        let position = random_position(&nominal, &mut random);
        let states = states(&formulation, &reference, &position);
        let at = At { position, states };
        compared += compare(&results, &at, &mut random);
    }
    assert!(compared > 0, "the mechanism never closes: {items}");
}

/// A random position of a random mechanism near the nominal one.
struct Position {
    parameters: Vec<f64>,
    inputs: Vec<f64>,
    /// Speeds and loads.
    arguments: Vec<f64>,
    modes: Vec<f64>,
}

fn random_position(nominal: &Nominal, random: &mut Random) -> Position {
    let vary = |values: &[f64], random: &mut Random| -> Vec<f64> {
        let varied = values
            .iter()
            .map(|x| x + 0.05 * random.between(-1.0, 1.0) * x.abs());
        varied.collect()
    };
    Position {
        parameters: vary(&nominal.parameters, random),
        inputs: vary(&nominal.inputs, random),
        arguments: (0..4).map(|_| 5.0 * random.between(-1.0, 1.0)).collect(),
        modes: (0..8).map(|_| random.between(-1.0, 1.0).signum()).collect(),
    }
}

/// Parameters and inputs are multiplied by `noise`.
fn load(position: &Position, source: Source, states: &[Vec<f64>], noise: &[f64]) -> f64 {
    match source {
        Source::Parameter(k) => position.parameters[k] * noise[k],
        Source::Input(k) => {
            let all = position.inputs.iter().chain(&position.arguments);
            all.copied().nth(k).unwrap_or(f64::NAN) * noise[39 - k]
        }
        Source::Mode(k) => position.modes[k],
        Source::Centre(_) => 0.3,
        Source::Winding(..) => 0.0,
        Source::State(group, component) => states[group][component],
        Source::Limit => 1e-7,
        Source::Prepared(_) | Source::Carried(_) => f64::NAN,
    }
}

/// The states of the coupled groups there, from those of the nominal mechanism.
fn states(formulation: &Formulation, reference: &Reference, position: &Position) -> Vec<Vec<f64>> {
    let mut states = reference.machine.states(&position.inputs);
    for prepared in formulation.prepared() {
        for _ in 0..8 {
            let load = |source| load(position, source, &states, &[1.0; 40]);
            let stepped = evaluate(&prepared.step, load);
            let state = &mut states[prepared.number];
            state[..prepared.size].copy_from_slice(&stepped[..prepared.size]);
            state[prepared.size] = stepped[prepared.size + 1] / 2.0;
        }
    }
    states
}

/// A position and the states of the coupled groups there.
struct At {
    position: Position,
    states: Vec<Vec<f64>>,
}

/// Returns the number of results that are numbers.
#[track_caller]
fn compare(results: &[Vec<Ex>], at: &At, random: &mut Random) -> usize {
    let run = |scalars: &[Ex], noise: f64, random: &mut Random| {
        let noise = [0; 40].map(|_| 1.0 + noise * random.between(-1.0, 1.0));
        evaluate(scalars, |source| {
            load(&at.position, source, &at.states, &noise)
        })
    };
    let (forward, others) = results.split_first().expect("several ways");
    let expected = run(forward, 0.0, random);
    // The effect of 256 roundoffs of the data.
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
                "result {k}: forward {x:e}, another way {y:e}, spread {spread:e}"
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
fn slides_on_links_that_turn() {
    let end = "let q = (2 * d, e) + polar(b + c, u);";
    for (guide, carried) in [
        // On a rocker, also mirrored; on the crank; on a link that turns by two angles.
        ("dir(p + 90deg + lift)", "k + polar(e, p)"),
        ("dir(lift - p)", "(e, d) + polar(e, -p)"),
        ("dir(phi / 2 + lift) * 2", "polar(a, phi / 2)"),
        ("dir(t + p)", "polar(a, phi) + polar(e, lift + p + t)"),
    ] {
        let items = format!(
            "{RRR} {PIN} unknown u = 150deg; unknown s = 60mm; {end}
             loop q = {carried} + s * {guide};"
        );
        expect_all(&items, &["q - polar(e, p)", "s", "u", "polar(d, t) - q"]);
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
    // Through narrow places one behind the other, and beside them.
    for quantities in [
        "sensitivity(f), w: sensitivity(k + polar(s, v - t)), v: sensitivity(polar(b, v + t))",
        "sensitivity(velocity(k + polar(s, v))), w: sensitivity(acceleration(f))",
    ] {
        expect_agreement(&items, &format!("f(phi) -> R {{ s: {quantities} }}"));
    }
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

#[test]
fn coupled_groups() {
    let triad = "unknown t1 = 20deg; unknown t2 = 100deg; unknown t3 = 290deg; unknown u = 10deg;
        let k = polar(3 * e, phi) + polar(d / 2, t1);
        loop k + polar(c - 20mm, u) = (b, 0) + polar(d / 2, t2);
        loop k + polar(c - 20mm, u + 60deg) = (b / 2, d + 10mm) + polar(d / 2, t3);";
    expect_all(triad, &["k", "u", "t2", "k.x * sin(t3)"]);
    let guides = "unknown t1 = 20deg; unknown x = 30mm; unknown y = 60mm; unknown u = 10deg;
        let k = polar(3 * e, phi) + polar(d / 2, t1);
        loop k + polar(c, u) = (b, 0) + x * dir(100deg + phi / 5);
        loop k + polar(y, u + 60deg) = (b / 2, d);";
    expect_all(guides, &["k", "x", "y", "u"]);
    let contour =
        "unknown t1 = -50deg; unknown t2 = 50deg; unknown t3 = 20deg; unknown t4 = 170deg;
        let k = polar(e, phi);
        loop k + polar(c, t1) + polar(d, t2) = (2 * d, 0) + polar(c, t4);
        loop k + polar(d / 2, t1 + lift) + polar(b, t3) = (2 * d, 0) + polar(d / 2, t4 - lift);
        unknown v = 90deg; unknown w = 140deg;
        loop polar(a, t1) + polar(b, v) = (d, e) + polar(b, w);";
    expect_agreement(
        contour,
        "f(phi) -> R { s: sensitivity(velocity(t4)), w: sensitivity(v) }",
    );
}
