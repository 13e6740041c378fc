//! Eye-needle drive of a warp-knitting machine: a six-bar whose links cannot be computed one after the
//! other.
//!
//! The crank 1-2 moves the ternary link 3-4-5 through the coupler 2-3; the rockers 6-4 and 7-5 hold
//! it. These three legs on one link are a triad, a group of class III: two loops
//! whose four angles must be solved together. The needle 7-8 is part of the rocker 7-5. It dwells for a third of the
//! cycle.
//!
//! Positions are compared with a solution in 60 digits. The exit status is 1 if an error is too large.

mod check;

use check::Check;
use linkage::summary::{Curve, minimise};
use std::error::Error;
use std::f64::consts::TAU;

include!("../mechanisms/eye_needle.rs");

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let linkage = EyeNeedle::default().assemble()?;
    println!("{}", EyeNeedle::STRUCTURE);

    println!("Needle point:");
    println!("  phi, deg      x, mm      y, mm   x', mm/rad  y', mm/rad");
    for degrees in (0..=360).step_by(15).map(f64::from) {
        let Motion { p8, v, .. } = linkage.motion(degrees.to_radians());
        println!(
            "  {degrees:8.0} {:10.4} {:10.4} {:12.5} {:11.5}",
            p8.x, p8.y, v.x, v.y
        );
    }

    println!("The solution in 60 digits:");
    let rows = references();
    check.holds("141 positions of the whole cycle", rows.len() == 141);
    let found: Vec<Motion> = rows.iter().map(|row| linkage.motion(row[0])).collect();
    let mut compare = |name: &str, columns: [usize; 2], of: fn(&Motion) -> [f64; 2], most: f64| {
        let pairs = found.iter().zip(&rows).flat_map(|(motion, row)| {
            let [x, y] = of(motion);
            [(x, row[columns[0]]), (y, row[columns[1]])]
        });
        check.all_near(name, pairs, most);
    };
    compare("position, mm", [1, 3], |m| m.p8.into(), 2e-13);
    compare("first derivative, mm", [5, 6], |m| m.v.into(), 5e-11);
    compare("second derivative, mm", [7, 8], |m| m.a.into(), 5e-10);

    println!("The dwell, where the needle stays within 0.2 mm of its arc:");
    let radius = linkage.mechanism().l78;
    let arc = Curve::new((0.0, TAU), 360, |phi| {
        let Rocker { phi75, v, a } = linkage.rocker(phi);
        [phi75, v, a].map(|angle| radius * angle)
    })?;
    print!("{}", arc.describe("mm", "rad"));
    let dwell = arc.longest_dwell(0.2).ok_or("no dwell")?;
    check.near(
        "degrees of the crank",
        dwell.interval.range.to_degrees(),
        116.0,
        1.0,
    );
    let smallest = minimise((0.0, TAU), 360, |phi| linkage.posture(phi).margin)?;
    check.holds("no position is near singular", smallest.value > 0.1);

    println!("All assemblies:");
    let circuits = linkage.mechanism().circuits()?;
    println!("{circuits}");
    let whole = circuits.branches.iter().filter(|branch| branch.is_whole());
    check.holds("two run through the whole cycle", whole.count() == 2);
    check.holds(
        "two more meet at turning points",
        circuits.branches.len() == 4,
    );
    check.finish()
}

/// Lines of numbers: the crank's angle, x and y, each with the part of it that a double misses, both derivatives. A cell
/// that is no number fails its comparison.
fn references() -> Vec<[f64; 9]> {
    let lines = include_str!("../mechanisms/eye_needle/reference.csv").lines();
    let rows = lines.filter(|line| !line.starts_with('#')).map(|line| {
        let mut cells = line.split(',');
        [(); 9].map(|()| {
            cells
                .next()
                .and_then(|cell| cell.parse().ok())
                .unwrap_or(f64::NAN)
        })
    });
    rows.collect()
}
