//! The dyads as equations, for the reference.

use linkage_reference::{Big, Datum, Output, Plane, Position, System, Unknown, reach_gap};

fn given_point(p: &Position) -> Plane {
    Plane::new(p.value("x").clone(), p.value("y").clone())
}

fn nothing_turned(_: &Position) -> Big {
    Big::one()
}

/// Two links between the origin and a given point.
pub(crate) const TWO_LINKS: System = System {
    name: "two links",
    data: &[
        Datum::length("left", 60.0),
        Datum::length("right", 80.0),
        Datum::length("x", 100.0),
        Datum::length("y", 30.0),
    ],
    parameters: 3,
    unknowns: &[Unknown::angle("theta", 66.0), Unknown::angle("psi", 162.0)],
    residual: |p| {
        let miss = p.polar("left", "theta") - given_point(p) - p.polar("right", "psi");
        vec![miss.x, miss.y]
    },
    outputs: |p| {
        let pin = p.polar("left", "theta");
        let angles = ["theta", "psi"].map(|name| Output::Angle(p.direction(name)));
        angles
            .into_iter()
            .chain([pin.x, pin.y].map(Output::Value))
            .collect()
    },
    gap: |p| {
        let [left, right] = ["left", "right"].map(|name| p.value(name).abs());
        let distance = given_point(p).norm();
        let stretched = &left + &right - &distance;
        let folded = distance - (&left - &right).abs();
        let nearer = if stretched < folded {
            stretched
        } else {
            folded
        };
        nearer / if left < right { left } else { right } * 0.5
    },
    turned: nothing_turned,
    pairs: &[],
    linear: false,
    margin: Some(|_| linkage_reference::Big::one()),
};

/// A rod between a given point and a line through the origin.
pub(crate) const ROD_AND_GUIDE: System = System {
    name: "rod and guide",
    data: &[
        Datum::length("rod", 100.0),
        Datum::degrees("gamma", 10.0),
        Datum::length("x", 20.0),
        Datum::length("y", 30.0),
    ],
    unknowns: &[Unknown::angle("theta", -5.0), Unknown::slide("s", 121.0)],
    residual: |p| {
        let slider = p.direction("gamma").times(p.slide("s"));
        let miss = given_point(p) + p.polar("rod", "theta") - slider;
        vec![miss.x, miss.y]
    },
    outputs: |p| {
        vec![
            Output::Angle(p.direction("theta")),
            Output::Value(p.slide("s").clone()),
        ]
    },
    gap: |p| reach_gap(p.value("rod"), &p.direction("gamma").cross(&given_point(p))),
    ..TWO_LINKS
};

/// A given point on a line that turns with a link.
pub(crate) const TURNING_GUIDE: System = System {
    name: "turning guide",
    data: &[
        Datum::length("offset", 30.0),
        Datum::degrees("beta", 60.0),
        Datum::length("x", 80.0),
        Datum::length("y", 40.0),
    ],
    unknowns: &[Unknown::angle("psi", 10.0), Unknown::slide("s", 71.0)],
    residual: |p| {
        let miss = corner(p) + p.direction("psi").times(p.slide("s")) - given_point(p);
        vec![miss.x, miss.y]
    },
    outputs: |p| {
        let corner = corner(p);
        vec![
            Output::Angle(p.direction("psi")),
            Output::Value(p.slide("s").clone()),
            Output::Value(corner.x),
            Output::Value(corner.y),
        ]
    },
    gap: |p| reach_gap(&given_point(p).norm(), &p.polar("offset", "beta").y),
    ..TWO_LINKS
};

fn corner(p: &Position) -> Plane {
    p.polar("offset", "psi").turned(&p.direction("beta"))
}
