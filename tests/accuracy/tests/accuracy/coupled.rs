//! Coupled groups: triads of several kinds, a closed contour of four links, two platforms on a pin.
//!
//! Errors are multiples of what one roundoff in the data does, as everywhere; a group of four or six
//! unknowns adds up more roundings than a dyad.

mod contour;
mod eye_needle;
mod platforms;

use linkage_reference::{
    Big, Case, Datum, Depth, Form, Kind, Limits, Output, Plane, Position, Random, System, Unknown,
    compare, forms, rescaled, tried,
};

const LIMITS: Limits = Limits::new([10.0, 5.0, 5.0], [10.0, 10.0, 10.0]);

/// The mechanism as written all over the cycle, and with all dimensions changed by up to a part of
/// themselves.
fn cases(system: &System, part: f64, geometries: usize, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let turn = |k: i32| system.reference_input() + f64::from(k) * std::f64::consts::TAU / 12.0;
    let written = Case::new(system.default_geometry(), (0..12).map(turn).collect());
    let changed = (0..tried(geometries)).map(|_| {
        let near = |x: f64| x * random.between(1.0 - part, 1.0 + part);
        let geometry = system.default_geometry().into_iter().map(near).collect();
        Case::new(
            geometry,
            (0..3)
                .map(|_| random.between(0.0, std::f64::consts::TAU))
                .collect(),
        )
    });
    [written]
        .into_iter()
        .chain(changed.collect::<Vec<_>>())
        .collect()
}

/// The mechanism, slightly changed, in sizes from 1e-150 to 1e150.
fn sizes(system: &System, part: f64, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let mut cases = Vec::new();
    for exponent in [-150, -100, -50, -20, 20, 50, 100, 150] {
        let near = |x: f64| x * random.between(1.0 - part, 1.0 + part);
        let geometry: Vec<f64> = system.default_geometry().into_iter().map(near).collect();
        let scale = 10f64.powi(exponent) / system.size(&geometry);
        let inputs = vec![
            random.between(0.0, std::f64::consts::TAU),
            system.reference_input(),
        ];
        cases.push(Case::new(rescaled(system, &geometry, scale), inputs));
    }
    assert!(system.data.iter().any(|datum| datum.kind == Kind::Length));
    cases
}

// Triads with sliders on the frame and on the ternary link.

/// One leg: whether its unknown is an angle; its vector by the names of dimension and unknown.
type Leg = fn(&Position, &str, &str) -> Plane;

const RR: Leg = |p, q, x| p.polar(q, x);
const PR: Leg = |p, q, x| p.direction(q).times(p.slide(x));
const RP: Leg = |p, q, x| {
    p.direction("theta")
        .turned(&p.direction(q))
        .times(p.slide(x))
};

fn first(p: &Position, leg: Leg) -> Plane {
    p.polar("crank", "phi") + leg(p, "q1", "x1")
}

fn misses(p: &Position, legs: [Leg; 3]) -> Vec<Big> {
    let first = first(p, legs[0]);
    let second = first.clone() + p.polar("b", "theta") - p.point("a2") - legs[1](p, "q2", "x2");
    let third = first + p.polar("c", "theta").turned(&p.direction("kappa"))
        - p.point("a3")
        - legs[2](p, "q3", "x3");
    vec![second.x, second.y, third.x, third.y]
}

fn third(p: &Position, leg: Leg) -> Vec<Output> {
    let third = first(p, leg) + p.polar("c", "theta").turned(&p.direction("kappa"));
    Output::lengths([third.x, third.y])
}

macro_rules! triad {
    (
        $module:ident $name:literal [$leg1:ident $leg2:ident $leg3:ident] seeds $seed:literal
        data $q1:expr, $q2:expr, $q3:expr; unknowns $x1:expr, $x2:expr, $x3:expr, $theta:literal;
        default $crank:literal $a2x:literal $a2y:literal $a3x:literal $a3y:literal $b:literal $c:literal $kappa:literal;
        form [$($pairs:tt)*] { $($items:tt)* }
    ) => {
        mod $module {
            use super::*;

            const SYSTEM: System = System {
                name: $name,
                data: &[
                    Datum::length("crank", $crank),
                    Datum::length("a2.x", $a2x),
                    Datum::length("a2.y", $a2y),
                    Datum::length("a3.x", $a3x),
                    Datum::length("a3.y", $a3y),
                    Datum::length("b", $b),
                    Datum::length("c", $c),
                    Datum::degrees("kappa", $kappa),
                    $q1,
                    $q2,
                    $q3,
                    Datum::degrees("phi", 30.0),
                ],
                parameters: 11,
                unknowns: &[$x1, $x2, $x3, Unknown::angle("theta", $theta)],
                residual: |p| misses(p, [$leg1, $leg2, $leg3]),
                further: |p| third(p, $leg1),
                pairs: &[(5, 8), (7, 10)],
                ..System::PLAIN
            };

            linkage_reference::form! {
                plain(phi) -> [x1, x2, x3, theta, e3];
                $($pairs)*
                fields |g| {
                    crank: g[0], a2: [g[1], g[2]], a3: [g[3], g[4]], b: g[5], c: g[6],
                    kappa: g[7], q1: g[8], q2: g[9], q3: g[10]
                }
                { unit mm; $($items)* }
            }

            const FORMS: &[Form] = forms![plain];

            #[test]
            fn cycle() {
                compare(&SYSTEM, FORMS, &cases(&SYSTEM, 0.02, 4, $seed), Depth::Full).check("cycle", &LIMITS);
            }

            #[test]
            fn all_sizes() {
                compare(&SYSTEM, FORMS, &sizes(&SYSTEM, 0.01, $seed), Depth::Usual).check("sizes", &LIMITS);
            }
        }
    };
}

triad! {
    one_of_each "RR-PR-RP" [RR PR RP] seeds 75
    data Datum::length("q1", 102.0), Datum::degrees("q2", 170.0), Datum::degrees("q3", -35.0);
    unknowns Unknown::angle("x1", -21.0), Unknown::slide("x2", -121.0), Unknown::slide("x3", 153.0), 1.0;
    default 27.0 96.0 -1.0 28.0 84.0 97.0 42.0 30.0;
    form [pairs b q1, kappa q3;] {
        param crank = 27mm;
        param a2 = (96mm, -1mm);
        param a3 = (28mm, 84mm);
        param b = 97mm;
        param c = 42mm;
        param kappa = 30deg;
        param q1 = 102mm;
        param q2 = 170deg;
        param q3 = -35deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = -21deg;
        unknown x2 = -121mm;
        unknown x3 = 153mm;
        unknown theta = 1deg;
        let e1 = polar(crank, phi) + polar(q1, x1);
        let e3 = e1 + polar(c, theta + kappa);
        loop e1 + polar(b, theta) = a2 + polar(x2, q2);
        loop e3 = a3 + polar(x3, theta + q3);
    }
}

triad! {
    three_sliders_on_the_link "RP-RP-RP" [RP RP RP] seeds 76
    data Datum::degrees("q1", 50.0), Datum::degrees("q2", -15.0), Datum::degrees("q3", -70.0);
    unknowns Unknown::slide("x1", 41.0), Unknown::slide("x2", 19.0), Unknown::slide("x3", 12.0), -16.0;
    default 20.0 128.0 17.0 82.0 111.0 96.0 73.0 80.0;
    form [] {
        param crank = 20mm;
        param a2 = (128mm, 17mm);
        param a3 = (82mm, 111mm);
        param b = 96mm;
        param c = 73mm;
        param kappa = 80deg;
        param q1 = 50deg;
        param q2 = -15deg;
        param q3 = -70deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 41mm;
        unknown x2 = 19mm;
        unknown x3 = 12mm;
        unknown theta = -16deg;
        let e1 = polar(crank, phi) + polar(x1, theta + q1);
        let e3 = e1 + polar(c, theta + kappa);
        loop e1 + polar(b, theta) = a2 + polar(x2, theta + q2);
        loop e3 = a3 + x3 * dir(theta + q3);
    }
}

triad! {
    three_sliders_on_the_frame "PR-PR-PR" [PR PR PR] seeds 77
    data Datum::degrees("q1", 5.0), Datum::degrees("q2", -60.0), Datum::degrees("q3", -90.0);
    unknowns Unknown::slide("x1", 99.0), Unknown::slide("x2", -92.0), Unknown::slide("x3", 141.0), 142.0;
    default 35.0 90.0 12.0 68.0 102.0 107.0 89.0 85.0;
    form [] {
        param crank = 35mm;
        param a2 = (90mm, 12mm);
        param a3 = (68mm, 102mm);
        param b = 107mm;
        param c = 89mm;
        param kappa = 85deg;
        param q1 = 5deg;
        param q2 = -60deg;
        param q3 = -90deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 99mm;
        unknown x2 = -92mm;
        unknown x3 = 141mm;
        unknown theta = 142deg;
        let e1 = polar(crank, phi) + polar(x1, q1);
        let e3 = e1 + polar(c, theta + kappa);
        loop e1 + polar(b, theta) = a2 + polar(x2, q2);
        loop e3 = a3 + polar(x3, q3);
    }
}
