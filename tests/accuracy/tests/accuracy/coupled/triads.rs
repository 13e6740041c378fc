//! Triads with sliders on the frame and on the ternary link.

use crate::coupled::{LIMITS, cases, sizes};
use linkage_reference::{
    Big, Datum, Depth, Form, Output, Plane, Position, System, Unknown, compare, forms,
};

/// One leg: whether its unknown is an angle; its vector by the names of dimension and unknown.
type Leg = (bool, fn(&Position, &str, &str) -> Plane);

const RR: Leg = (true, |p, q, x| p.polar(q, x));
const PR: Leg = (false, |p, q, x| p.direction(q).times(p.slide(x)));
const RP: Leg = (false, |p, q, x| {
    p.direction("theta")
        .turned(&p.direction(q))
        .times(p.slide(x))
});

fn first(p: &Position, leg: Leg) -> Plane {
    p.polar("crank", "phi") + leg.1(p, "q1", "x1")
}

fn misses(p: &Position, legs: [Leg; 3]) -> Vec<Big> {
    let first = first(p, legs[0]);
    let second = first.clone() + p.polar("b", "theta") - p.point("a2") - (legs[1].1)(p, "q2", "x2");
    let third = first + p.polar("c", "theta").turned(&p.direction("kappa"))
        - p.point("a3")
        - (legs[2].1)(p, "q3", "x3");
    vec![second.x, second.y, third.x, third.y]
}

fn outputs(p: &Position, legs: [Leg; 3]) -> Vec<Output> {
    let third = first(p, legs[0]) + p.polar("c", "theta").turned(&p.direction("kappa"));
    let unknown = |(name, (turns, _)): (&str, Leg)| {
        if turns {
            Output::Angle(p.direction(name))
        } else {
            Output::Value(p.slide(name).clone())
        }
    };
    let unknowns = ["x1", "x2", "x3"].into_iter().zip(legs).map(unknown);
    let theta = Output::Angle(p.direction("theta"));
    unknowns
        .chain([theta])
        .chain([third.x, third.y].map(Output::Value))
        .collect()
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
                outputs: |p| outputs(p, [$leg1, $leg2, $leg3]),
                gap: |_| Big::one(),
                turned: |_| Big::one(),
                pairs: &[(5, 8), (7, 10)],
                linear: false,
                margin: None,
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
