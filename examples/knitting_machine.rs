//! A warp-knitting machine: hook needle, eye needle, sinkers and press on one shaft, with phases as parameters.
//!
//! The four drives are parts of one mechanism. A cyclogram has the dwells of both needles. The clearance is the least
//! distance of their points, and a search finds the phase that makes it largest.

mod check;

use check::Check;
use linkage::Vector2;
use linkage::clearance::{Clearance, Phases};
use linkage::cyclogram::{Band, Cyclogram, Member};
use linkage::summary::Curve;
use std::error::Error;
use std::f64::consts::TAU;

include!("../mechanisms/knitting_machine.rs");

/// A turn of the shaft.
const CYCLE: (f64, f64) = (0.0, TAU);
/// Roots are searched between positions every five degrees.
const POSITIONS: usize = 73;

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let machine = KnittingMachine::default().assemble()?;
    println!("{}", KnittingMachine::STRUCTURE);

    println!("Motions and dwells of both needles:");
    let hook = Curve::new(CYCLE, POSITIONS, |x| {
        let m = machine.hook(x);
        [m.tip.y, m.v.y, m.a.y]
    })?;
    let eye = Curve::new(CYCLE, POSITIONS, |x| {
        let m = machine.eye_way(x);
        [m.way, m.v, m.a]
    })?;
    let hook = Member::new("hook", &hook, &[Band::Top(0.1), Band::Bottom(0.1)])?.unit("mm");
    let eye = Member::new("eye", &eye, &[Band::Top(0.1), Band::Bottom(0.5)])?.unit("mm");
    let cyclogram = Cyclogram::new([hook, eye])?;
    println!("{cyclogram}");
    let together = cyclogram.together(|motions| motions.iter().all(|motion| motion.is_dwell()));
    for interval in together {
        let [from, range] = [interval.from, interval.range].map(f64::to_degrees);
        println!("both dwell from {from:.3} deg, for {range:.3} deg");
    }

    println!("Positions at which the needles are nearest, by a solution in 60 digits:");
    let clearance = Clearance::new(CYCLE, POSITIONS, |x| {
        (hook_point(&machine, x), eye_point(&machine, x))
    })?;
    let known = [
        (60.21437854841854, 6.910331732960811),
        (169.7750332336603, 7.700556961650112),
    ];
    check.holds("two of them", clearance.minima().len() == 2);
    for (nearest, (shaft, distance)) in clearance.minima().iter().zip(known) {
        check.near("shaft, deg", nearest.at.to_degrees(), shaft, 1e-10);
        check.near("distance, mm", nearest.distance, distance, 1e-12);
    }

    println!("The lead of the eye needle with the largest distance, from -30 to 30 deg:");
    let even = KnittingMachine {
        eye_lead: 0.0,
        ..KnittingMachine::default()
    };
    let even = even.assemble()?;
    let phases = Phases::new(
        CYCLE,
        POSITIONS,
        |x| hook_point(&even, x),
        |x| eye_point(&even, x),
    )?;
    let best = phases.best((-TAU / 12.0, TAU / 12.0))?;
    check.near(
        "lead, deg",
        best.phase.to_degrees(),
        -0.1460417741759689,
        1e-10,
    );
    check.near("distance, mm", best.distance, 7.253288209986386, 1e-12);
    check.finish()
}

/// The point of the hook needle with its first two derivatives.
fn hook_point(machine: &KnittingMachineAssembly, shaft: f64) -> [[Vector2<f64>; 3]; 1] {
    let m = machine.hook(shaft);
    [[m.tip, m.v, m.a]]
}

/// The point of the eye needle with its first two derivatives.
fn eye_point(machine: &KnittingMachineAssembly, shaft: f64) -> [[Vector2<f64>; 3]; 1] {
    let m = machine.eye(shaft);
    [[m.tip, m.v, m.a]]
}
