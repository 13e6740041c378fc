//! Universal joints: one of them does not run evenly, two of them do if they are put together well.
//!
//! A joint holds two fork pins at a right angle to each other. That is one equation between two unit
//! vectors of space, the pin of each fork; `tan(out) = tan(in) cos(bend)` follows from it.

mod check;

use check::Check;
use std::error::Error;
use std::f64::consts::TAU;

include!("../mechanisms/universal_joint.rs");

/// Every degree of three turns.
const STEPS: usize = 1080;

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let linkage = Cardan::default().assemble()?;
    println!("{}", Cardan::STRUCTURE);
    single(&mut check, &linkage);
    double(&mut check, &linkage);
    check.finish()
}

/// Input angles over three turns.
fn turns() -> Vec<f64> {
    let whole = (0..=STEPS).map(|i| (i as f64).to_radians());
    whole.collect()
}

fn single(check: &mut Check, linkage: &CardanAssembly) {
    println!("One joint, bent by 30 degrees:");
    let at = linkage.single(45_f64.to_radians());
    check.near(
        "out(45 deg), deg",
        at.psi.to_degrees(),
        40.893394649131,
        1e-11,
    );
    check.near("speed ratio", at.ratio, 0.989743318610787, 1e-13);
    println!("  in, deg   out, deg   speed ratio");
    for degrees in (0..=180).step_by(15).map(f64::from) {
        let s = linkage.single(degrees.to_radians());
        println!(
            "  {degrees:7.0} {:10.4} {:13.6}",
            s.psi.to_degrees(),
            s.ratio
        );
    }

    println!("Formulas of the textbook, over three turns:");
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let rows: Vec<(Single, f64)> = turns()
        .iter()
        .map(|&phi| (linkage.single(phi), phi))
        .collect();
    let angles = rows.iter().map(|(s, phi)| {
        // The deviation is periodic, so its arc tangent has no jumps.
        let (s2, c2) = (2.0 * phi).sin_cos();
        (
            s.psi,
            phi + ((cos - 1.0) * s2 / 2.0).atan2((1.0 + cos) / 2.0 + (1.0 - cos) * c2 / 2.0),
        )
    });
    check.all_near("out, rad", angles, 1e-13);
    let nominal = |phi: f64| 1.0 - (sin * phi.sin()).powi(2);
    let ratios = rows.iter().map(|(s, phi)| (s.ratio, cos / nominal(*phi)));
    check.all_near("speed ratio", ratios, 1e-14);

    println!("Over a turn:");
    let ratio = rows.iter().map(|(s, _)| s.ratio);
    let (low, high) = ratio.fold((f64::MAX, f64::MIN), |(l, h), r| (l.min(r), h.max(r)));
    check.near("slowest = cos(bend)", low, cos, 1e-14);
    check.near("fastest = 1 / cos(bend)", high, 1.0 / cos, 1e-14);
    check.near("fluctuation = tan sin", high - low, sin * sin / cos, 1e-14);
    let jump = rows.windows(2).map(|w| w[1].0.psi - w[0].0.psi);
    let forward = jump.clone().all(|step| step > 0.0 && step < 0.03);
    check.holds("the angle grows steadily over three turns", forward);
    check.near("turns counted", jump.sum::<f64>() / TAU, 3.0, 1e-14);
}

fn double(check: &mut Check, linkage: &CardanAssembly) {
    println!("Two joints in Z arrangement:");
    let found: Vec<(Double, f64)> = turns()
        .iter()
        .map(|&phi| (linkage.double(phi), phi))
        .collect();
    check.all_near(
        "out = in, rad",
        found.iter().map(|(d, phi)| (d.out, *phi)),
        1e-13,
    );
    check.all_near(
        "speed ratio 1",
        found.iter().map(|(d, _)| (d.ratio, 1.0)),
        1e-14,
    );
}
