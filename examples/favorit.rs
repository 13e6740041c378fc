//! Hook-needle drive of the Favorit warp-knitting machine, against its published tables.
//!
//! Two cranks drive the needle: the main crank 1-2 swings the rocker 3-4-5-6 through the coupler
//! 2-3 (dyad RRR); the guide 5-6 is fixed on that rocker, and a slider on it is moved by the second
//! crank 7-8 through the rod 8-9 (dyad RRP on a moving guide). The needle 9-10 is part of the
//! slider. The second crank turns backwards at half the speed, so that one cycle takes two turns.
//!
//! The exit status is 1 if a published column of the needle or of a link does not agree to its last digit.

mod check;

use check::Check;
use linkage::{true_acceleration, true_velocity};
use std::error::Error;
use std::f64::consts::TAU;

include!("../mechanisms/favorit.rs");

/// 1000 revolutions per minute, clockwise.
const MACHINE_SPEED: f64 = -1000.0 * TAU / 60.0;

fn main() -> Result<(), Box<dyn Error>> {
    let linkage = Favorit::default().assemble()?;
    println!("{}", Favorit::STRUCTURE);
    print_needle(&linkage);

    println!("\nThe publication, 25 positions:");
    let mut check = Check::default();
    // The tables take the nominal speed, -104.72 rad/s, for degrees per second, and give rates in 1e-5 m.
    let speed = MACHINE_SPEED.to_radians();
    let (first, second) = (100.0 * speed, 100.0 * speed * speed);
    // Row i is at -90 + 150 i degrees. Two turns are one cycle.
    let rows = (0..25).map(|row| (150.0 * f64::from(row) % 720.0 - 90.0).to_radians());
    let rows: Vec<Motion> = rows.map(|phi12| linkage.motion(phi12)).collect();
    for (axis, i) in [("X", 0), ("Y", 1)] {
        let mut compare = |name: &str, value: &dyn Fn(&Motion) -> f64| {
            let printed = column(&format!("{name}{axis}"));
            let pairs = rows.iter().map(value).zip(printed);
            check.all_near(&format!("{name}{axis}"), pairs, 0.005 + 1e-9);
        };
        compare("P3", &|m| m.p3[i]);
        compare("V3", &|m| first * m.v3[i]);
        compare("A3", &|m| second * m.a3[i]);
        compare("P10", &|m| m.p10[i]);
        compare("V10", &|m| first * m.v10[i]);
        compare("A10", &|m| second * m.a10[i]);
    }
    let mut compare = |name: &str, angle: fn(&Motion) -> f64| {
        // Printed angles are reduced to one turn.
        let pairs = rows.iter().zip(column(name)).map(|(m, printed)| {
            let difference = angle(m).to_degrees() - printed;
            (difference - 360.0 * (difference / 360.0).round(), 0.0)
        });
        check.all_near(name, pairs, 0.005 + 1e-9);
    };
    compare("phi23", |m| m.phi23);
    compare("phi43", |m| m.phi43);
    compare("phi89", |m| m.phi89);
    check.finish()
}

/// The needle over one cycle, in the direction in which the machine turns, at its real speed.
fn print_needle(linkage: &FavoritAssembly) {
    println!("  phi12, deg    x, mm    y, mm   vx, m/s   vy, m/s  ax, m/s2  ay, m/s2");
    for step in 0..=24 {
        let degrees = 630.0 - 30.0 * f64::from(step);
        let n = linkage.needle(degrees.to_radians());
        let v = true_velocity(n.v, MACHINE_SPEED) * 1e-3;
        let a = true_acceleration(n.v, n.a, MACHINE_SPEED, 0.0) * 1e-3;
        println!(
            "  {degrees:10.0} {:8.3} {:8.3} {:9.4} {:9.4} {:9.2} {:9.2}",
            n.p10.x, n.p10.y, v.x, v.y, a.x, a.y
        );
    }
}

/// A printed column: the line `name,unit,25 values`. A cell that is no number fails its comparison, as a missing column does.
fn column(name: &str) -> [f64; 25] {
    let mut lines = include_str!("../mechanisms/favorit/tables.csv").lines();
    let line = lines.find(|line| line.split(',').next() == Some(name));
    let mut cells = line.unwrap_or_default().split(',').skip(2);
    [(); 25].map(|()| {
        cells
            .next()
            .and_then(|cell| cell.parse().ok())
            .unwrap_or(f64::NAN)
    })
}
