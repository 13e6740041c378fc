//! Mechanisms without a loop, and a structure without an input.
//!
//! A planet of half the ring's size draws a straight line (the Tusi couple); a bracket is a
//! triangle with sides 3, 4, 5, whose functions take no argument.

mod check;

use check::Check;
use std::error::Error;
use std::f64::consts::{PI, TAU};

include!("../mechanisms/gears.rs");

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
