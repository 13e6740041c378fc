//! The eye-needle drive as the reference sees it: three binary legs on a ternary link that is given by its
//! sides.

use linkage_reference::{Big, Datum, Output, Plane, Position, System, Unknown};

fn third(p: &Position) -> Plane {
    p.polar("l12", "phi") + p.polar("l23", "phi23")
}

/// The unit vector of the angle between the sides 34 and 35.
fn corner(p: &Position) -> Plane {
    let [a, b, c] = ["l34", "l35", "l45"].map(|name| p.value(name));
    let cosine = (a * a + b * b - c * c) / (a * b * 2.0);
    let sine = (Big::one() - &cosine * &cosine).sqrt();
    Plane { x: cosine, y: sine }
}

pub(crate) const EYE_NEEDLE: System = System {
    name: "eye-needle drive, RR-RR-RR",
    data: &[
        Datum::length("l12", 50.0),
        Datum::length("l23", 272.5),
        Datum::length("l34", 81.0),
        Datum::length("l45", 104.5),
        Datum::length("l35", 174.0),
        Datum::length("l46", 104.5),
        Datum::length("l57", 261.0),
        Datum::length("l78", 136.8),
        Datum::degrees("angle_578", -25.0),
        Datum::length("p6.x", 195.0),
        Datum::length("p6.y", 226.0),
        Datum::length("p7.x", 46.0),
        Datum::length("p7.y", 533.0),
        Datum::degrees("phi", 0.0),
    ],
    parameters: 13,
    unknowns: &[
        Unknown::angle("phi23", 62.0),
        Unknown::angle("phi34", 146.0),
        Unknown::angle("phi64", 144.0),
        Unknown::angle("phi75", -99.0),
    ],
    residual: |p| {
        let fourth = third(p) + p.polar("l34", "phi34") - p.point("p6") - p.polar("l46", "phi64");
        let fifth = third(p) + p.polar("l35", "phi34").turned(&corner(p))
            - p.point("p7")
            - p.polar("l57", "phi75");
        vec![fourth.x, fourth.y, fifth.x, fifth.y]
    },
    outputs: |p| {
        let needle = p.point("p7") + p.polar("l78", "phi75").turned(&p.direction("angle_578"));
        let angles =
            ["phi23", "phi34", "phi64", "phi75"].map(|name| Output::Angle(p.direction(name)));
        angles
            .into_iter()
            .chain([needle.x, needle.y].map(Output::Value))
            .collect()
    },
    gap: |_| Big::one(),
    turned: |_| Big::one(),
    pairs: &[(1, 3), (4, 4)],
    linear: false,
    margin: None,
};
