//! Two ternary links on a common pin, and two cranks with a slider on the frame.

use crate::coupled::{LIMITS, cases, sizes};
use linkage_reference::{
    Big, Depth, Form, Output, Plane, Position, System, compare, data, forms, unknowns,
};

// Two ternary links on a common pin, each on two legs: six unknowns in three loops.

fn first(p: &Position) -> Plane {
    p.polar("crank", "phi") + p.polar("l1", "x1")
}

fn pin(p: &Position) -> Plane {
    first(p) + p.polar("c", "one").turned(&p.direction("at_c"))
}

const PLATFORMS: System = System {
    name: "two platforms, three loops",
    data: data! {
        length "crank" 10.0, "a2.x" 109.0, "a2.y" 1.0, "a3.x" 195.0, "a3.y" 20.0, "a4.x" 105.0,
            "a4.y" 172.0, "l1" 60.0, "l2" 73.0, "l3" 61.0, "l4" 84.0, "b" 80.0, "c" 90.0;
        degrees "at_c" 75.0;
        length "d" 96.0, "e" 80.0;
        degrees "at_e" 90.0, "phi" 30.0;
    },
    parameters: 17,
    unknowns: unknowns! {
        angle "x1" 92.0, "x2" -172.0, "x3" -153.0, "x4" -43.0, "one" -68.0, "two" -62.0;
    },
    residual: |p| {
        let second = first(p) + p.polar("b", "one") - p.point("a2") - p.polar("l2", "x2");
        let third = pin(p) + p.polar("d", "two") - p.point("a3") - p.polar("l3", "x3");
        let fourth = pin(p) + p.polar("e", "two").turned(&p.direction("at_e"))
            - p.point("a4")
            - p.polar("l4", "x4");
        vec![second.x, second.y, third.x, third.y, fourth.x, fourth.y]
    },
    further: |p| {
        let pin = pin(p);
        Output::lengths([pin.x, pin.y])
    },
    ..System::PLAIN
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

const PLATFORM_FORMS: &[Form] = forms![plain];

#[test]
fn platforms_over_a_cycle() {
    compare(
        &PLATFORMS,
        PLATFORM_FORMS,
        &cases(&PLATFORMS, 0.003, 4, 80),
        Depth::Usual,
    )
    .check("cycle", &LIMITS);
}

// The two-crank drive: two binary legs and a slider on the frame.

fn third(p: &Position) -> Plane {
    let back = Plane::direction(&-p.value("phi"));
    back.times(p.value("l12")) + p.polar("l23", "phi23")
}

const TWO_CRANKS: System = System {
    name: "two cranks, RR-RR-PR",
    data: data! {
        length "l12" 13.0, "l67" 11.0, "p7.x" 82.0, "p7.y" 22.0, "l23" 68.0, "l64" 85.0,
            "l34" 66.0, "l35" 40.0;
        degrees "angle_435" -65.0;
        length "n1.x" 28.0;
        degrees "guide" 90.0;
        length "l58" 40.0;
        degrees "angle_58" 30.0, "phi" 0.0;
    },
    parameters: 13,
    unknowns: unknowns! {
        angle "phi23" 105.0, "phi34" 29.0, "phi64" 118.0;
        slide "s" 42.0;
    },
    residual: |p| {
        let sixth = p.point("p7") + p.polar("l67", "phi");
        let fourth = third(p) + p.polar("l34", "phi34") - sixth - p.polar("l64", "phi64");
        let fifth =
            third(p) + p.polar("l35", "phi34").turned(&p.direction("angle_435")) - on_the_guide(p);
        vec![fourth.x, fourth.y, fifth.x, fifth.y]
    },
    further: |p| {
        let beyond = p.polar("l58", "guide").turned(&p.direction("angle_58"));
        let working = on_the_guide(p) + beyond;
        Output::lengths([working.x, working.y])
    },
    pairs: &[(4, 7), (8, 10)],
    ..System::PLAIN
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

two_cranks!(plain_cranks [pairs l23 l35, angle_435 guide;] {
    loop p3 + polar(l34, phi34) = p4;
    loop p3 + polar(l35, phi34 + angle_435) = p5;
});

// Both loops end on the slider.
two_cranks!(from_the_slider [] {
    loop p4 - polar(l34, phi34) + polar(l35, phi34 + angle_435) = p5;
    loop p5 - rotate(polar(l35, phi34), angle_435) - p3 = 0;
});

const TWO_CRANK_FORMS: &[Form] = forms![plain_cranks, from_the_slider];

#[test]
fn two_cranks_over_a_cycle() {
    compare(
        &TWO_CRANKS,
        TWO_CRANK_FORMS,
        &cases(&TWO_CRANKS, 0.03, 6, 73),
        Depth::Full,
    )
    .check("cycle", &LIMITS);
}

#[test]
fn two_cranks_of_all_sizes() {
    compare(
        &TWO_CRANKS,
        TWO_CRANK_FORMS,
        &sizes(&TWO_CRANKS, 0.01, 74),
        Depth::Usual,
    )
    .check("sizes", &LIMITS);
}
