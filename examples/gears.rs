//! Mechanisms without a loop, and a structure without an input.
//!
//! A planet of half the ring's size draws a straight line (the Tusi couple); a bracket is a
//! triangle with sides 3, 4, 5, whose functions take no argument.

mod check;

use check::Check;
use linkage::mechanism;
use std::error::Error;
use std::f64::consts::{PI, TAU};

mechanism! {
    /// Planet gear in a fixed ring, its carrier driven through a pair of gears.
    pub struct TusiCouple {
        unit mm;

        const pinion = 17;                        // teeth
        const wheel  = 51;
        param ring   = 80mm +- 10um;              // pitch radii
        param planet = 40mm +- 10um;

        input motor = 0deg in 0deg..1080deg;
        let carrier = -motor * pinion / wheel;
        let spin    = -carrier * (ring - planet) / planet;
        let centre  = polar(ring - planet, carrier);
        let point   = centre + polar(planet, spin);
    }

    impl TusiCouple {
        /// A point on the planet's pitch circle.
        pub fn point(motor) -> TusiPoint { point, carrier, v: velocity(point) }
        /// How far the point leaves its line when the planet is too large.
        pub fn accuracy(motor) -> TusiAccuracy { e: sensitivity(point, [planet]) }
    }
}

mechanism! {
    /// Two bars on a wall, pinned together.
    pub struct Bracket {
        unit mm;

        param base  = 50mm +- 0.1mm;
        param left  = 30mm +- 0.1mm;
        param right = 40mm +- 0.1mm;

        unknown apex = (20mm, 20mm);
        loop distance(apex, (0, 0)) = left;
        loop distance(apex, (base, 0)) = right;
    }

    impl Bracket {
        /// Where the bars meet, and what their lengths do to it.
        pub fn apex() -> Apex { apex, height: apex.y, e: sensitivity(apex) }
    }
}

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();

    println!("Tusi couple, three turns of the motor:");
    let linkage = TusiCouple::default().assemble()?;
    let turns = (0..=1080).map(|degrees| linkage.point(f64::from(degrees).to_radians()));
    let points: Vec<TusiPoint> = turns.collect();
    check.holds("no group to solve", TusiCouple::STRUCTURE.groups.is_empty());
    check.near(
        "carrier turns back once, rad",
        points[1080].carrier,
        -TAU,
        1e-13,
    );
    check.all_near(
        "straight line: y = 0, mm",
        points.iter().map(|p| (p.point.y, 0.0)),
        1e-13,
    );
    check.all_near(
        "x = 80 cos carrier",
        points.iter().map(|p| (p.point.x, 80.0 * p.carrier.cos())),
        1e-12,
    );
    check.all_near(
        "dx/dmotor",
        points.iter().map(|p| (p.v.x, 80.0 / 3.0 * p.carrier.sin())),
        1e-12,
    );
    // With the spin s = -c (R - r) / r at the carrier angle c = 60 degrees and R = 2 r, by hand:
    // dx/dr = cos s - cos c - (c R / r) sin s, dy/dr = sin s - sin c + (c R / r) cos s.
    let e = linkage.accuracy(-PI).e[0];
    check.near("dx/dplanet = pi / sqrt 3", e.x, PI / 3f64.sqrt(), 1e-13);
    check.near(
        "dy/dplanet = pi / 3 - sqrt 3",
        e.y,
        PI / 3.0 - 3f64.sqrt(),
        1e-13,
    );

    println!("Bracket:");
    let bracket = Bracket::default().assemble()?.apex();
    check.near("x, mm", bracket.apex.x, 18.0, 1e-13);
    check.near("y, mm", bracket.height, 24.0, 1e-13);
    let known = [
        ("base", 0.64, -0.48),
        ("left", 0.6, 0.8),
        ("right", -0.8, 0.6),
    ];
    for (s, (name, x, y)) in bracket.e.iter().zip(known) {
        check.near(&format!("dx/d{name}"), s.x, x, 1e-13);
        check.near(&format!("dy/d{name}"), s.y, y, 1e-13);
    }
    check.finish()
}
