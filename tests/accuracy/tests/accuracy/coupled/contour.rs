//! A closed contour of four links, class IV.

use crate::coupled::{LIMITS, cases, sizes};
use linkage_reference::{
    Depth, Form, Output, Plane, Position, System, compare, data, forms, unknowns,
};

/// From the second ternary link's end to the first one's, for each of the binary links.
fn between(p: &Position) -> [Plane; 2] {
    let known = p.polar("crank", "phi") - p.point("base");
    let [two, four] = [("p", "alpha"), ("r", "beta")].map(|(length, angle)| p.polar(length, angle));
    let one = p.polar("q", "alpha").turned(&p.direction("at_q"));
    let three = p.polar("s", "beta").turned(&p.direction("at_s"));
    [known.clone() + two - four, known + one - three]
}

const CONTOUR: System = System {
    name: "contour of four links, class IV",
    data: data! {
        length "crank" 11.0, "base.x" 150.0, "base.y" 27.0, "p" 84.0, "q" 70.0;
        degrees "at_q" 25.0;
        length "r" 73.0, "s" 86.0;
        degrees "at_s" -85.0;
        length "upper" 64.0, "lower" 64.0;
        degrees "phi" 30.0;
    },
    parameters: 11,
    unknowns: unknowns! {
        angle "alpha" -47.0, "beta" -106.0, "gamma" 11.0, "delta" 98.0;
    },
    residual: |p| {
        let [upper, lower] = between(p);
        let upper = upper + p.polar("upper", "gamma");
        let lower = lower + p.polar("lower", "delta");
        vec![upper.x, upper.y, lower.x, lower.y]
    },
    further: |p| {
        let end = p.polar("crank", "phi") + p.polar("p", "alpha");
        Output::lengths([end.x, end.y])
    },
    pairs: &[(3, 9), (5, 6)],
    ..System::PLAIN
};

macro_rules! contour {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [alpha, beta, gamma, delta, end];
            $($pairs)*
            fields |g| {
                crank: g[0], base: [g[1], g[2]], p: g[3], q: g[4], at_q: g[5], r: g[6],
                s: g[7], at_s: g[8], upper: g[9], lower: g[10]
            }
            {
                unit mm;
                param crank = 11mm;
                param base = (150mm, 27mm);
                param p = 84mm;
                param q = 70mm;
                param at_q = 25deg;
                param r = 73mm;
                param s = 86mm;
                param at_s = -85deg;
                param upper = 64mm;
                param lower = 64mm;
                input phi = 30deg in 0deg..360deg;
                unknown alpha = -47deg;
                unknown beta = -106deg;
                unknown gamma = 11deg;
                unknown delta = 98deg;
                let a = polar(crank, phi);
                let end = a + polar(p, alpha);
                $($items)*
            }
        }
    };
}

contour!(plain [pairs p upper, at_q r;] {
    loop end + polar(upper, gamma) = base + polar(r, beta);
    loop a + polar(q, alpha + at_q) + polar(lower, delta) = base + polar(s, beta + at_s);
});

// The second loop goes around the contour.
contour!(around [] {
    loop base + polar(r, beta) - polar(upper, gamma) = end;
    loop polar(upper, gamma) + polar(p, alpha) + polar(s, beta + at_s)
        = polar(lower, delta) + polar(q, alpha + at_q) + polar(r, beta);
});

const FORMS: &[Form] = forms![plain, around];

#[test]
fn cycle() {
    compare(&CONTOUR, FORMS, &cases(&CONTOUR, 0.01, 6, 78), Depth::Full).check("cycle", &LIMITS);
}

#[test]
fn all_sizes() {
    compare(&CONTOUR, FORMS, &sizes(&CONTOUR, 0.003, 79), Depth::Usual).check("sizes", &LIMITS);
}
