//! Positions at which methods differ: dead points, upright links, change points, and angles out of reach.

use std::f64::consts::PI;

use with_linkage::FourBar;

use crate::evaluators::{Crate, Dimensions, all};

const U: f64 = 25.0 * PI / 180.0;

/// A crank that is too long to turn fully.
pub(crate) const ROCKING: Dimensions = [200.0, 120.0, 100.0, 140.0, 0.0, 70.0, U];
const PARALLELOGRAM: Dimensions = [50.0, 140.0, 50.0, 140.0, 0.0, 70.0, U];
/// Its rocker is upright at one angle of the crank.
pub(crate) const UPRIGHT: Dimensions = [60.0, 120.0, 100.0, 140.0, 0.0, 70.0, U];

/// The angle of the crank at which coupler and rocker of [`ROCKING`] are in line.
pub(crate) fn dead_point() -> f64 {
    let [a, b, c, dx, ..] = ROCKING;
    ((a * a + dx * dx - (b + c) * (b + c)) / (2.0 * a * dx)).acos()
}

/// The angles of the crank at which the crank and the rocker of [`UPRIGHT`] are upright.
pub(crate) fn upright_angles() -> [f64; 2] {
    let [a, b, c, dx, ..] = UPRIGHT;
    let part = (a * a + dx * dx + c * c - b * b) / (2.0 * a);
    [PI / 2.0, c.atan2(dx) + (part / dx.hypot(c)).acos()]
}

fn show(title: &str, phi: f64, crates: &[Crate]) {
    println!("\n{title}: crank at {:.9} degrees", phi.to_degrees());
    for with in crates {
        print!("  {:<10}", with.name);
        for (name, function) in with.functions() {
            let Some(function) = function else { continue };
            let values = (function.values)(phi);
            let shown = match name {
                "sensitivities" => &values[2..3],
                "motion" => &values[2..],
                _ => &values[..],
            };
            let shown: Vec<String> = shown.iter().map(|value| format!("{value:.6}")).collect();
            print!(" {name} {}", shown.join(" "));
        }
        println!();
    }
}

/// Prints the values of all crates at hard positions.
pub(crate) fn print() {
    for (name, [a, b, c, dx, dy, p, u]) in [("rocking", ROCKING), ("parallelogram", PARALLELOGRAM)]
    {
        match (FourBar {
            a,
            b,
            c,
            dx,
            dy,
            p,
            u,
        })
        .assemble()
        {
            Ok(_) => println!("linkage assembles the {name} mechanism"),
            Err(error) => println!("linkage does not assemble the {name} mechanism: {error}"),
        }
    }
    let dead = dead_point();
    let rocking = all(ROCKING);
    show("1e-6 rad before a dead point", dead - 1e-6, &rocking);
    show("dead point", dead, &rocking);
    show("one roundoff beyond", dead.next_up(), &rocking);
    show("out of reach", PI, &rocking);
    let upright = all(UPRIGHT);
    for (title, phi) in ["upright crank", "upright rocker"]
        .into_iter()
        .zip(upright_angles())
    {
        show(title, phi, &upright);
    }
    let parallel = all(PARALLELOGRAM);
    for degrees in [179.0, 180.0, 181.0] {
        show("parallelogram", f64::to_radians(degrees), &parallel);
    }
}
