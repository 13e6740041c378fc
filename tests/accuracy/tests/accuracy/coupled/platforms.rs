//! Two ternary links on a common pin, each on two legs: six unknowns in three loops.

use crate::coupled::{LIMITS, cases};
use linkage_reference::{
    Big, Datum, Depth, Form, Output, Plane, Position, System, Unknown, compare, forms,
};

fn first(p: &Position) -> Plane {
    p.polar("crank", "phi") + p.polar("l1", "x1")
}

fn pin(p: &Position) -> Plane {
    first(p) + p.polar("c", "one").turned(&p.direction("at_c"))
}

const PLATFORMS: System = System {
    name: "two platforms, three loops",
    data: &[
        Datum::length("crank", 10.0),
        Datum::length("a2.x", 109.0),
        Datum::length("a2.y", 1.0),
        Datum::length("a3.x", 195.0),
        Datum::length("a3.y", 20.0),
        Datum::length("a4.x", 105.0),
        Datum::length("a4.y", 172.0),
        Datum::length("l1", 60.0),
        Datum::length("l2", 73.0),
        Datum::length("l3", 61.0),
        Datum::length("l4", 84.0),
        Datum::length("b", 80.0),
        Datum::length("c", 90.0),
        Datum::degrees("at_c", 75.0),
        Datum::length("d", 96.0),
        Datum::length("e", 80.0),
        Datum::degrees("at_e", 90.0),
        Datum::degrees("phi", 30.0),
    ],
    parameters: 17,
    unknowns: &[
        Unknown::angle("x1", 92.0),
        Unknown::angle("x2", -172.0),
        Unknown::angle("x3", -153.0),
        Unknown::angle("x4", -43.0),
        Unknown::angle("one", -68.0),
        Unknown::angle("two", -62.0),
    ],
    residual: |p| {
        let second = first(p) + p.polar("b", "one") - p.point("a2") - p.polar("l2", "x2");
        let third = pin(p) + p.polar("d", "two") - p.point("a3") - p.polar("l3", "x3");
        let fourth = pin(p) + p.polar("e", "two").turned(&p.direction("at_e"))
            - p.point("a4")
            - p.polar("l4", "x4");
        vec![second.x, second.y, third.x, third.y, fourth.x, fourth.y]
    },
    outputs: |p| {
        let names = ["x1", "x2", "x3", "x4", "one", "two"];
        let angles = names.map(|name| Output::Angle(p.direction(name)));
        let pin = pin(p);
        angles
            .into_iter()
            .chain([pin.x, pin.y].map(Output::Value))
            .collect()
    },
    gap: |_| Big::one(),
    turned: |_| Big::one(),
    pairs: &[],
    linear: false,
    margin: None,
};

linkage_reference::form! {
    plain(phi) -> [x1, x2, x3, x4, one, two, pin];
    fields |g| {
        crank: g[0], a2: [g[1], g[2]], a3: [g[3], g[4]], a4: [g[5], g[6]],
        l1: g[7], l2: g[8], l3: g[9], l4: g[10], b: g[11], c: g[12], at_c: g[13], d: g[14], e: g[15],
        at_e: g[16]
    }
    {
        unit mm;
        param crank = 10mm;
        param a2 = (109mm, 1mm);
        param a3 = (195mm, 20mm);
        param a4 = (105mm, 172mm);
        param l1 = 60mm;
        param l2 = 73mm;
        param l3 = 61mm;
        param l4 = 84mm;
        param b = 80mm;
        param c = 90mm;
        param at_c = 75deg;
        param d = 96mm;
        param e = 80mm;
        param at_e = 90deg;
        input phi = 30deg in 0deg..360deg;
        unknown x1 = 92deg;
        unknown x2 = -172deg;
        unknown x3 = -153deg;
        unknown x4 = -43deg;
        unknown one = -68deg;
        unknown two = -62deg;
        let e1 = polar(crank, phi) + polar(l1, x1);
        let pin = e1 + polar(c, one + at_c);
        loop e1 + polar(b, one) = a2 + polar(l2, x2);
        loop pin + polar(d, two) = a3 + polar(l3, x3);
        loop pin + polar(e, two + at_e) = a4 + polar(l4, x4);
    }
}

const FORMS: &[Form] = forms![plain];

#[test]
fn cycle() {
    compare(
        &PLATFORMS,
        FORMS,
        &cases(&PLATFORMS, 0.003, 4, 80),
        Depth::Usual,
    )
    .check("cycle", &LIMITS);
}
