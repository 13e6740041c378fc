//! A function computes what its quantities need and nothing else: seen in the operation counts of `STRUCTURE`.

use linkage::{Operations, Structure, mechanism};

mechanism! {
    /// One dyad.
    pub struct One {
        unit mm;
        param crank = 40mm;
        param coupler = 120mm;
        param rocker = 80mm;
        param frame = 100mm;
        param arm = 60mm;
        param lift = 30deg;
        input phi = 40deg in 30deg..50deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }
    impl One {
        pub fn crank_pin(phi) -> OnePin { a }
        pub fn point(phi) -> OnePoint { tracer }
        pub fn point_margin(phi) -> OnePointMargin { tracer, margin: margin() }
        pub fn motion(phi) -> OneMotion { tracer, v: velocity(tracer), a: acceleration(tracer) }
        pub fn angle(phi) -> OneAngle { psi }
        pub fn errors(phi) -> OneErrors { e: sensitivity(tracer, [crank, coupler, rocker]) }
    }
}

mechanism! {
    /// The same dyad, a second one driven by it, and a second input with a point of its own.
    pub struct Two {
        unit mm;
        param crank = 40mm;
        param coupler = 120mm;
        param rocker = 80mm;
        param frame = 100mm;
        param arm = 60mm;
        param lift = 30deg;
        param rod = 90mm;
        param lever = 70mm;
        param pivot = (150mm, 90mm);
        input phi = 40deg in 30deg..50deg;
        input beta = 10deg in 0deg..20deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
        unknown chi = 50deg;
        unknown eta = 170deg;
        loop tracer + polar(rod, chi) = pivot + polar(lever, eta);
        let second = pivot + polar(lever, eta);
        let free = polar(rod, beta);
    }
    impl Two {
        pub fn crank_pin(phi) -> TwoPin { a }
        pub fn point(phi) -> TwoPoint { tracer }
        pub fn point_margin(phi) -> TwoPointMargin { tracer, margin: margin() }
        pub fn motion(phi) -> TwoMotion { tracer, v: velocity(tracer), a: acceleration(tracer) }
        pub fn angle(phi) -> TwoAngle { psi }
        pub fn errors(phi) -> TwoErrors { e: sensitivity(tracer, [crank, coupler, rocker]) }

        pub fn second(phi) -> TwoSecond { second }
        pub fn twice(phi) -> TwoTwice { tracer, again: tracer, x: tracer.x }
        pub fn component(phi) -> TwoComponent { x: tracer.x }
        pub fn velocity_alone(phi) -> TwoVelocity { v: velocity(tracer) }
        pub fn with_velocity(phi) -> TwoWithVelocity { tracer, v: velocity(tracer) }
        pub fn rate(phi) -> TwoRate { r: d(psi, phi) }
        pub fn foreign(phi) -> TwoForeign { tracer, e: sensitivity(tracer, [rod, lever, pivot.x]) }
        pub fn lengths() -> TwoLengths { sum: crank + coupler, reach: norm(pivot), s: sin(lift) }
        pub fn free(beta) -> TwoFree { free, v: velocity(free), a: acceleration(free), j: jerk(free) }
    }
}

mechanism! {
    /// Scotch yoke: `x = crank cos phi`.
    pub struct Yoke {
        unit mm;
        param crank = 35mm;
        input phi = 20deg;
        unknown x = 35mm;
        unknown slot = 12mm;
        loop polar(crank, phi) = (x, 0) + (0, slot);
    }
    impl Yoke {
        pub fn x(phi) -> YokeX { x }
        pub fn motion(phi) -> YokeMotion { x, v: velocity(x), a: acceleration(x), j: jerk(x) }
        pub fn error(phi) -> YokeError { e: d(x, crank) }
    }
}

const NONE: Operations = Operations {
    add: 0,
    mul: 0,
    div: 0,
    sqrt: 0,
    sin_cos: 0,
    atan2: 0,
    other: 0,
};

fn cost(structure: &Structure, name: &str) -> Operations {
    let function = structure.functions.iter().find(|f| f.name == name);
    function.expect("the function is listed").operations
}

fn one(name: &str) -> Operations {
    cost(One::STRUCTURE, name)
}

fn two(name: &str) -> Operations {
    cost(Two::STRUCTURE, name)
}

#[test]
fn later_groups_cost_nothing() {
    for name in [
        "crank_pin",
        "point",
        "point_margin",
        "motion",
        "angle",
        "errors",
    ] {
        assert_eq!(one(name), two(name), "{name}");
    }
    assert!(two("second").total() > two("point").total());
}

#[test]
fn a_crank_pin_is_two_products() {
    let expected = Operations {
        mul: 2,
        sin_cos: 1,
        ..NONE
    };
    assert_eq!(one("crank_pin"), expected);
    // r cos, r sin, -r sin, -r cos: the third derivative is minus the first one, computed already.
    let expected = Operations {
        mul: 4,
        sin_cos: 1,
        ..NONE
    };
    assert_eq!(two("free"), expected);
}

#[test]
fn the_yoke_is_a_product_by_a_cosine() {
    assert_eq!(
        cost(Yoke::STRUCTURE, "x"),
        Operations {
            mul: 1,
            sin_cos: 1,
            ..NONE
        }
    );
    // r cos, -r sin, -r cos, r sin
    assert_eq!(
        cost(Yoke::STRUCTURE, "motion"),
        Operations {
            mul: 4,
            sin_cos: 1,
            ..NONE
        }
    );
    assert_eq!(
        cost(Yoke::STRUCTURE, "error"),
        Operations { sin_cos: 1, ..NONE }
    );
}

#[test]
fn what_depends_on_parameters_alone_is_computed_once() {
    assert_eq!(two("lengths"), NONE);
}

#[test]
fn equal_quantities_are_computed_once() {
    assert_eq!(two("twice"), two("point"));
    assert!(two("component").total() < two("point").total());
}

#[test]
fn only_the_derivatives_asked_for_are_computed() {
    let [point, alone, with, motion] =
        ["point", "velocity_alone", "with_velocity", "motion"].map(|name| two(name).total());
    assert!(
        point < with && alone <= with && with < motion,
        "{point} {alone} {with} {motion}"
    );
    // Foreign parameters have derivative zero.
    assert_eq!(two("foreign"), two("point"));
}

#[test]
fn arctangents_are_for_angles_that_were_asked_for() {
    assert_eq!(two("angle").atan2, 1);
    for name in [
        "point",
        "motion",
        "errors",
        "rate",
        "second",
        "point_margin",
    ] {
        assert_eq!(two(name).atan2, 0, "{name}");
        // One sine and cosine for the one driving angle, one square root and at most two divisors for each dyad.
        assert_eq!(two(name).sin_cos, 1, "{name}");
    }
    assert_eq!((two("point").sqrt, two("second").sqrt), (1, 2));
}
