//! The two-crank drive: two binary legs and a slider on the frame.

use crate::coupled::{LIMITS, cases, sizes};
use linkage_reference::{
    Big, Datum, Depth, Form, Output, Plane, Position, System, Unknown, compare, forms,
};

fn third(p: &Position) -> Plane {
    let back = Plane::direction(&-p.value("phi"));
    back.times(p.value("l12")) + p.polar("l23", "phi23")
}

const TWO_CRANKS: System = System {
    name: "two cranks, RR-RR-PR",
    data: &[
        Datum::length("l12", 13.0),
        Datum::length("l67", 11.0),
        Datum::length("p7.x", 82.0),
        Datum::length("p7.y", 22.0),
        Datum::length("l23", 68.0),
        Datum::length("l64", 85.0),
        Datum::length("l34", 66.0),
        Datum::length("l35", 40.0),
        Datum::degrees("angle_435", -65.0),
        Datum::length("n1.x", 28.0),
        Datum::degrees("guide", 90.0),
        Datum::length("l58", 40.0),
        Datum::degrees("angle_58", 30.0),
        Datum::degrees("phi", 0.0),
    ],
    parameters: 13,
    unknowns: &[
        Unknown::angle("phi23", 105.0),
        Unknown::angle("phi34", 29.0),
        Unknown::angle("phi64", 118.0),
        Unknown::slide("s", 42.0),
    ],
    residual: |p| {
        let sixth = p.point("p7") + p.polar("l67", "phi");
        let fourth = third(p) + p.polar("l34", "phi34") - sixth - p.polar("l64", "phi64");
        let fifth =
            third(p) + p.polar("l35", "phi34").turned(&p.direction("angle_435")) - on_the_guide(p);
        vec![fourth.x, fourth.y, fifth.x, fifth.y]
    },
    outputs: |p| {
        let beyond = p.polar("l58", "guide").turned(&p.direction("angle_58"));
        let working = on_the_guide(p) + beyond;
        let angles = ["phi23", "phi34", "phi64"].map(|name| Output::Angle(p.direction(name)));
        let lengths = [p.slide("s").clone(), working.x, working.y].map(Output::Value);
        angles.into_iter().chain(lengths).collect()
    },
    gap: |_| Big::one(),
    turned: |_| Big::one(),
    pairs: &[(4, 7), (8, 10)],
    linear: false,
    margin: None,
};

fn on_the_guide(p: &Position) -> Plane {
    let foot = Plane {
        x: p.value("n1.x").clone(),
        y: Big::zero(),
    };
    foot + p.direction("guide").times(p.slide("s"))
}

macro_rules! two_cranks {
    ($name:ident [$($pairs:tt)*] { $($items:tt)* }) => {
        linkage_reference::form! {
            $name(phi) -> [phi23, phi34, phi64, s, p8];
            $($pairs)*
            fields |g| {
                l12: g[0], l67: g[1], p7: [g[2], g[3]], l23: g[4], l64: g[5], l34: g[6],
                l35: g[7], angle_435: g[8], n1: g[9], guide: g[10], l58: g[11], angle_58: g[12]
            }
            {
                unit mm;
                param l12 = 13mm;
                param l67 = 11mm;
                param p7 = (82mm, 22mm);
                param l23 = 68mm;
                param l64 = 85mm;
                param l34 = 66mm;
                param l35 = 40mm;
                param angle_435 = -65deg;
                param n1 = 28mm;
                param guide = 90deg;
                param l58 = 40mm;
                param angle_58 = 30deg;
                input phi = 0deg in 0deg..360deg;
                unknown phi23 = 105deg;
                unknown phi34 = 29deg;
                unknown phi64 = 118deg;
                unknown s = 42mm;
                let p3 = polar(l12, -phi) + polar(l23, phi23);
                let p4 = p7 + polar(l67, phi) + polar(l64, phi64);
                let p5 = (n1, 0) + polar(s, guide);
                let p8 = p5 + polar(l58, guide + angle_58);
                $($items)*
            }
        }
    };
}

two_cranks!(plain [pairs l23 l35, angle_435 guide;] {
    loop p3 + polar(l34, phi34) = p4;
    loop p3 + polar(l35, phi34 + angle_435) = p5;
});

// Both loops end on the slider.
two_cranks!(from_the_slider [] {
    loop p4 - polar(l34, phi34) + polar(l35, phi34 + angle_435) = p5;
    loop p5 - rotate(polar(l35, phi34), angle_435) - p3 = 0;
});

const FORMS: &[Form] = forms![plain, from_the_slider];

#[test]
fn cycle() {
    compare(
        &TWO_CRANKS,
        FORMS,
        &cases(&TWO_CRANKS, 0.03, 6, 73),
        Depth::Full,
    )
    .check("cycle", &LIMITS);
}

#[test]
fn all_sizes() {
    compare(
        &TWO_CRANKS,
        FORMS,
        &sizes(&TWO_CRANKS, 0.01, 74),
        Depth::Usual,
    )
    .check("sizes", &LIMITS);
}
