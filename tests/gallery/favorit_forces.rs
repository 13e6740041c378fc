//! Forces in the hook-needle drive of the Favorit warp-knitting machine: the reactions of its joints beside the
//! published ones, the driving torque, pins, and counterweights.
//!
//! The mechanism is that of the program `favorit`; bodies, joints and gravity are nine lines more. The published
//! reactions contain three errors:
//!
//! - Two angles of centres of mass were converted to radians twice.
//! - The inertia forces of the rod and the slider were computed with the rocker's mass.
//! - What the slider does to the rocker was left out.
//!
//! Other values of the parameters reproduce them from the same text: all 200 published numbers are met, but for three
//! misprints. Beside them stand the forces that the drive has at that speed, and those at its real one.

mod counterweights;
mod design;
mod published;

use crate::check::Check;
use linkage::Vector2;
use std::error::Error;
use std::f64::consts::TAU;

include!("../../mechanisms/favorit_forces.rs");

/// 1000 revolutions per minute, clockwise.
const MACHINE_SPEED: f64 = -1000.0 * TAU / 60.0;

/// The joints by the numbers of their points, in the order of the tables.
const JOINTS: [&str; 8] = ["R1", "R2", "R3", "R4", "R7", "R8", "R9", "R11"];

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let drive = Favorit::default().assemble()?;
    println!("{}", Favorit::STRUCTURE);
    let mut check = Check::default();
    print_cost(&mut check);

    let cycle: Vec<Forces> = cycle()
        .map(|phi12| drive.forces(phi12, MACHINE_SPEED))
        .collect();
    published::compare(&drive, &cycle, &mut check)?;
    check_balance(&drive, &mut check);
    design::print_torque(&drive, &mut check);
    design::print_pins(&cycle, &mut check)?;
    counterweights::print(&mut check)?;
    check.finish()
}

/// Crank angles of one cycle, two turns, every half degree.
fn cycle() -> impl Iterator<Item = f64> {
    (0..1440).map(|i| (0.5 * f64::from(i) - 90.0).to_radians())
}

/// The reactions in the order of `JOINTS`: their sizes, in newtons.
fn sizes(forces: &Forces) -> [f64; 8] {
    let f = forces;
    [f.r1, f.r2, f.r3, f.r4, f.r7, f.r8, f.r9, f.r11].map(|reaction| reaction.norm())
}

/// All forces against the accelerations alone.
fn print_cost(check: &mut Check) {
    let cost = |name: &str| {
        let mut functions = Favorit::STRUCTURE.functions.iter();
        let function = functions.find(|function| function.name == name);
        function.map_or(f64::NAN, |function| f64::from(function.operations.total()))
    };
    let (forces, accelerations) = (cost("forces"), cost("accelerations"));
    let ratio = forces / accelerations;
    println!("Forces take {ratio:.2} times the operations of the accelerations alone.");
    check.holds("forces within 3 times the accelerations", ratio <= 3.0);
}

/// What the frame takes is the weight and what the masses resist.
fn check_balance(drive: &FavoritAssembly, check: &mut Check) {
    println!("\nForces on the whole drive, 1000 rpm:");
    let given = Favorit::default();
    let mass = given.m1 + given.m2 + given.m3 + given.m4 + given.m5 + given.m6;
    let weight = Vector2::new(0.0, -9.80665 * mass);
    let left = cycle().map(|phi12| {
        let forces = drive.forces(phi12, MACHINE_SPEED);
        let shaking = drive.shaking(phi12, MACHINE_SPEED).force;
        let sum = forces.r1 + forces.r4 + forces.r7 + weight + shaking;
        (sum.norm(), 0.0)
    });
    check.all_near("pivots, weight and inertia add up to 0, N", left, 1e-10);
}
