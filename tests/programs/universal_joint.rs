//! Universal joints in W arrangement, with errors of the installation, and with the usual mistake; the example
//! `universal_joint` has a single joint and two of them in Z arrangement.

use crate::check::Check;
use std::error::Error;
use std::f64::consts::FRAC_PI_2;

include!("../../mechanisms/universal_joint.rs");

/// Every degree of three turns.
const STEPS: usize = 1080;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let linkage = Cardan::default().assemble()?;
    println!("{}", Cardan::STRUCTURE);
    single(&mut check, &linkage);
    double(&mut check)?;
    errors(&mut check, &linkage);
    check.finish()
}

/// Input angles over three turns.
fn turns() -> Vec<f64> {
    let whole = (0..=STEPS).map(|i| (i as f64).to_radians());
    whole.collect()
}

fn single(check: &mut Check, linkage: &CardanAssembly) {
    println!("Acceleration behind one joint, over three turns:");
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let nominal = |phi: f64| 1.0 - (sin * phi.sin()).powi(2);
    let pairs = turns().into_iter().map(|phi| {
        let known = cos * sin * sin * (2.0 * phi).sin() / nominal(phi).powi(2);
        (linkage.single(phi).rise, known)
    });
    check.all_near("derivative of the speed ratio", pairs, 1e-14);
}

fn double(check: &mut Check) -> Result<(), Box<dyn Error>> {
    println!("W arrangement, the third shaft bent by 60 degrees against the first:");
    let folded = Cardan {
        back: -30_f64.to_radians(),
        ..Cardan::default()
    }
    .assemble()?;
    let out = turns().into_iter().map(|phi| (folded.double(phi).out, phi));
    check.all_near("out = in, rad", out, 1e-13);

    println!("Forks of the middle shaft at a right angle, the usual mistake:");
    let wrong = Cardan {
        twist: FRAC_PI_2,
        ..Cardan::default()
    }
    .assemble()?;
    let ratio = turns().into_iter().map(|phi| wrong.double(phi).ratio);
    let (low, high) = ratio.fold((f64::MAX, f64::MIN), |(l, h), r| (l.min(r), h.max(r)));
    check.near("slowest = cos(bend)^2", low, 0.75, 1e-14);
    check.near("fastest = 1 / cos(bend)^2", high, 4.0 / 3.0, 1e-14);
    Ok(())
}

fn errors(check: &mut Check, linkage: &CardanAssembly) {
    println!("What errors of the installation do, largest over a turn:");
    let mut largest = [0.0_f64; 3];
    for phi in turns() {
        for (most, e) in largest.iter_mut().zip(linkage.accuracy(phi).e) {
            *most = most.max(e.abs());
        }
    }
    for (parameter, e) in Cardan::PARAMETERS.iter().zip(largest) {
        let arcmin = 60.0 * (e * parameter.tolerance).to_degrees();
        println!(
            "  {:<6} {e:8.5} rad/rad, {arcmin:6.3} arcmin",
            parameter.name
        );
    }
    // psi = atan(tan(phi) cos(bend)) by its bend.
    let known = |phi: f64| {
        let (sin, cos) = 30_f64.to_radians().sin_cos();
        -sin * phi.sin() * phi.cos() / (phi.cos().powi(2) + (cos * phi.sin()).powi(2))
    };
    let pairs = turns()
        .into_iter()
        .map(|phi| (linkage.bending(phi).by_bend, known(phi)));
    check.all_near("d psi / d bend by hand", pairs, 1e-14);
}
