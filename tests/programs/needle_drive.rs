//! Needle drive of a sewing machine in space: the arm shaft drives a tilted rocker, the rocker the needle bar.
//!
//! The crank on the arm shaft moves the short arm of a rocker through a rod with two ball joints (RSSR), the
//! long arm of the same rocker moves the needle bar through a link with two ball joints (RSSP). The rocker's axis is
//! tilted towards the shaft, which makes the needle fall faster than it rises.

use crate::check::Check;
use linkage::Vector3;
use std::error::Error;

include!("../../mechanisms/needle_drive.rs");

/// Shaft angle in degrees, needle's height in mm, both derivatives: from a solution in 60 digits.
const KNOWN: [(f64, f64, f64, f64); 5] = [
    (
        0.0,
        -154.34873768909958,
        -18.24710017754014,
        4.481011784279957,
    ),
    (
        50.0,
        -166.28439192065966,
        -7.44260449755097,
        15.681444629907437,
    ),
    (
        130.0,
        -163.96861152237642,
        9.153958026353942,
        8.97688311205179,
    ),
    (
        250.0,
        -137.14901274300612,
        7.4560917888496725,
        -15.841952366777738,
    ),
    (
        300.0,
        -137.74825620993573,
        -9.278390645349653,
        -18.69619702142162,
    ),
];
/// Angle and height of the dead centres, and how long the needle stays within 1 mm of the lower one.
const LOWER: (f64, f64) = (80.09191248487983, -168.15973621173066);
const UPPER: (f64, f64) = (273.3809431956774, -135.56885234141143);
const DWELL: f64 = 45.95293803021729;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let drive = NeedleDrive::default().assemble()?;
    println!("{}", NeedleDrive::STRUCTURE);
    let groups = NeedleDrive::STRUCTURE.groups;
    check.holds("two groups, one after the other", groups.len() == 2);

    println!("Needle's point:");
    println!("  phi, deg      z, mm   z', mm/rad  z\", mm/rad2     margin");
    for degrees in (0..360).step_by(30).map(f64::from) {
        let Motion { z, v, a, margin } = drive.motion(degrees.to_radians());
        println!("  {degrees:8.0} {z:10.4} {v:12.5} {a:12.5} {margin:10.4}");
    }
    println!("Against the solution in 60 digits:");
    for (degrees, z, v, a) in KNOWN {
        let m = drive.motion(degrees.to_radians());
        check.near(&format!("z at {degrees} deg, mm"), m.z, z, 1e-12);
        check.near("z'", m.v, v, 1e-12);
        check.near("z\"", m.a, a, 1e-11);
    }
    stroke(&mut check, &drive);
    links(&mut check, &drive);
    errors(&mut check, &drive);
    check.finish()
}

/// Stroke, time ratio and dwell.
fn stroke(check: &mut Check, drive: &NeedleDriveAssembly) {
    println!("Stroke:");
    let still = |lo: f64, hi: f64| bisect(lo, hi, |phi| drive.motion(phi).v);
    let (lower, upper) = (still(60.0, 100.0), still(250.0, 300.0));
    let [low, high] = [lower, upper].map(|phi| drive.needle(phi).z);
    check.near(
        "lower dead centre at, deg",
        lower.to_degrees(),
        LOWER.0,
        1e-10,
    );
    check.near(
        "upper dead centre at, deg",
        upper.to_degrees(),
        UPPER.0,
        1e-10,
    );
    check.near("stroke, mm", high - low, UPPER.1 - LOWER.1, 1e-12);
    let rise = (upper - lower).to_degrees();
    let known = (UPPER.0 - LOWER.0) / (360.0 - UPPER.0 + LOWER.0);
    check.near(
        "time ratio, rise to fall",
        rise / (360.0 - rise),
        known,
        1e-11,
    );

    // The loop of thread forms while the needle is down.
    let at_height = |lo: f64, hi: f64| bisect(lo, hi, |phi| drive.needle(phi).z - low - 1.0);
    let dwell = at_height(80.0, 140.0) - at_height(20.0, 80.0);
    check.near(
        "within 1 mm of the bottom for, deg",
        dwell.to_degrees(),
        DWELL,
        1e-10,
    );

    let turn: Vec<f64> = (0..3600)
        .map(|i| (f64::from(i) / 10.0).to_radians())
        .collect();
    let cycle = drive.motion_sweep(&turn);
    let largest = cycle.a().iter().fold(0.0_f64, |most, a| most.max(a.abs()));
    // 4000 stitches a minute.
    let omega = 4000.0 / 60.0 * std::f64::consts::TAU;
    println!(
        "       largest acceleration at 4000 stitches a minute: {:.0} m/s2",
        largest * omega * omega / 1e3
    );
    let margin = cycle.margin().iter().copied().fold(1.0, f64::min);
    println!("       smallest margin {margin:.4}");
    check.holds("no position is near a dead point", margin > 0.3);
    let mean = cycle.v().iter().sum::<f64>() / 3600.0;
    check.near("mean of z'", mean, 0.0, 1e-12);
}

/// Every link keeps its length, both arms stay at a right angle to the rocker's axis.
fn links(check: &mut Check, drive: &NeedleDriveAssembly) {
    println!("Links over a turn, mm:");
    let joints: Vec<Joints> = (0..360)
        .map(|i| drive.joints(f64::from(i).to_radians()))
        .collect();
    type Length = (&'static str, fn(&Joints) -> f64, f64);
    let lengths: [Length; 7] = [
        ("rod", |j| (j.ball - j.pin).norm(), 48.0),
        ("short arm", |j| (j.ball - j.pivot).norm(), 38.0),
        ("long arm", |j| (j.eye - j.pivot).norm(), 62.0),
        ("lever", |j| (j.eye - j.ball).norm(), 100.0),
        ("link", |j| (j.joint - j.eye).norm(), 28.0),
        (
            "along the rocker's axis",
            |j| (j.eye - j.pivot).dot(&j.axis),
            0.0,
        ),
        (
            "off the needle bar",
            |j| (j.point - Vector3::new(104.0, 0.0, j.point.z)).norm(),
            0.0,
        ),
    ];
    for (what, of, known) in lengths {
        check.all_near(what, joints.iter().map(|j| (of(j), known)), 1e-13);
    }
}

/// What the dimensions do to the needle in its lower dead centre.
fn errors(check: &mut Check, drive: &NeedleDriveAssembly) {
    println!("Errors of the needle's lower dead centre, um:");
    let found = drive.accuracy(LOWER.0.to_radians()).e;
    let mut variance = 0.0;
    for (parameter, e) in NeedleDrive::PARAMETERS.iter().zip(found) {
        let share = 1e3 * e * parameter.tolerance;
        if share != 0.0 {
            println!("       {:<10} {share:8.2}", parameter.name);
        }
        variance += share * share;
    }
    println!("       root sum square {:.2}", variance.sqrt());
    let lengths = NeedleDrive::PARAMETERS
        .iter()
        .zip(found)
        .filter(|(p, _)| p.unit == "mm");
    let sum: f64 = lengths.map(|(parameter, e)| parameter.nominal * e).sum();
    check.near("sum of r dz/dr - z, mm", sum - LOWER.1, 0.0, 1e-12);
}

/// Where `f` changes its sign between two angles in degrees, in radians.
fn bisect(lo: f64, hi: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut lo, mut hi) = (lo.to_radians(), hi.to_radians());
    let rising = f(hi) > f(lo);
    for _ in 0..60 {
        let middle = 0.5 * (lo + hi);
        if (f(middle) > 0.0) == rising {
            hi = middle;
        } else {
            lo = middle;
        }
    }
    0.5 * (lo + hi)
}
