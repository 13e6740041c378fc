//! Crank-rocker four-bar: assemblies, a sweep, changed dimensions, sensitivities, tolerances.
//!
//! Crank 40, coupler 120, rocker 80, frame 100 mm, at a crank angle of 40 degrees.

use crate::check::Check;
use std::error::Error;

include!("../../mechanisms/crank_rocker.rs");

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = CrankRocker::default();
    let linkage = mechanism.assemble()?;
    let phi = 40f64.to_radians();

    println!("{}", CrankRocker::STRUCTURE);
    let groups = CrankRocker::STRUCTURE.groups;
    check.holds("one dyad RRR", groups.len() == 1 && groups[0].kind == "RRR");

    println!("Assemblies at 40 degrees:");
    let mut found: Vec<Angles> = mechanism
        .assemblies()?
        .iter()
        .map(|l| l.angles(phi))
        .collect();
    found.sort_by(|a, b| b.psi.total_cmp(&a.psi));
    check.holds("two of them", found.len() == 2);
    for (angles, (theta, psi)) in found
        .iter()
        .zip([(20.297882788, 57.324880070), (-60.977966796, -98.004964078)])
    {
        check.near("theta, deg", angles.theta.to_degrees(), theta, 1e-9);
        check.near("psi, deg", angles.psi.to_degrees(), psi, 1e-9);
    }
    let elsewhere = mechanism.assemblies_at(200f64.to_radians())?;
    check.holds("two at 200 degrees, too", elsewhere.len() == 2);

    println!("Coupler point and margin at 40 degrees:");
    let m = linkage.motion(phi);
    check.near("x, mm", m.tracer.x, 68.969552615300, 1e-10);
    check.near("y, mm", m.tracer.y, 71.874061421707, 1e-10);
    check.near("dx/dphi, mm", m.v.x, -18.102226518192, 1e-10);
    check.near("dy/dphi, mm", m.v.y, 24.323958522574, 1e-10);
    check.near(
        "margin: |sin| of transmission angle",
        m.margin,
        0.602191266564,
        1e-11,
    );

    println!("The rocker over a turn of the crank:");
    let cycle: Vec<f64> = (0..=3600)
        .map(|i| (f64::from(i) / 10.0).to_radians())
        .collect();
    let columns = linkage.angles_sweep(&cycle);
    let psi = columns.psi();
    let swing = psi.iter().map(|psi| psi.to_degrees());
    let lowest = swing.clone().fold(f64::INFINITY, f64::min);
    let highest = swing.fold(f64::NEG_INFINITY, f64::max);
    // At the limits crank and coupler are in line: a triangle with sides 120 +- 40, 80, 100.
    check.near("lower limit, deg", lowest, 54.900367805, 1e-4);
    check.near("upper limit, deg", highest, 128.682187453, 1e-4);

    println!("Other dimensions at run time:");
    let longer = CrankRocker {
        crank: 41.0,
        ..CrankRocker::default()
    }
    .assemble()?;
    check.near(
        "crank 41 mm: psi, deg",
        longer.angles(phi).psi.to_degrees(),
        56.203192375,
        1e-9,
    );
    let impossible = CrankRocker {
        coupler: 300.0,
        ..CrankRocker::default()
    }
    .assemble();
    if let Err(error) = &impossible {
        println!("       coupler 300 mm: {error}");
    }
    check.holds("a coupler of 300 mm is refused", impossible.is_err());

    println!("Sensitivities at 40 degrees:");
    let accuracy = linkage.accuracy(phi);
    let known = [
        -0.019542339369,
        -0.020757524551,
        0.016571808154,
        0.019468518686,
    ];
    for ((parameter, value), known) in CrankRocker::PARAMETERS
        .iter()
        .zip(accuracy.rocker_angle)
        .zip(known)
    {
        check.near(
            &format!("dpsi/d{}, rad/mm", parameter.name),
            value,
            known,
            1e-11,
        );
    }
    // Euler: angles do not change when all lengths grow alike, points grow with them.
    let lengths = CrankRocker::PARAMETERS
        .iter()
        .map(|p| if p.unit == "mm" { p.nominal } else { 0.0 });
    let lengths: Vec<f64> = lengths.collect();
    let angle: f64 = lengths
        .iter()
        .zip(accuracy.rocker_angle)
        .map(|(r, s)| r * s)
        .sum();
    let x: f64 = lengths
        .iter()
        .zip(&accuracy.point)
        .map(|(r, s)| r * s.x)
        .sum();
    let y: f64 = lengths
        .iter()
        .zip(&accuracy.point)
        .map(|(r, s)| r * s.y)
        .sum();
    check.near("sum of r dpsi/dr", angle, 0.0, 1e-12);
    check.near("sum of r dx/dr - x, mm", x - accuracy.tracer.x, 0.0, 1e-11);
    check.near("sum of r dy/dr - y, mm", y - accuracy.tracer.y, 0.0, 1e-11);

    println!("What the tolerances do to the coupler point, in micrometres:");
    let mut worst = 0.0;
    for (parameter, s) in CrankRocker::PARAMETERS.iter().zip(&accuracy.point) {
        let share = 1e3 * s.norm() * parameter.tolerance;
        println!(
            "       {:<8} +- {:<9.3e} {:<4} {share:7.2}",
            parameter.name, parameter.tolerance, parameter.unit
        );
        worst += share;
    }
    println!("       all together, at worst   {worst:7.2}");
    check.finish()
}
