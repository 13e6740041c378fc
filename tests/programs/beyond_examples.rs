//! Checks of mechanisms that examples show, beyond those of the examples.

use crate::check::Check;
use std::error::Error;
use std::f64::consts::FRAC_PI_2;

// Derivatives of the geared five-bar by differences, and by its lengths; the example `geared_five_bar` has values.

include!("../../mechanisms/geared_five_bar.rs");

#[test]
fn geared_five_bar_meets_known_answers() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let linkage = GearedFiveBar::default().assemble()?;
    let (phi, phase) = (70f64.to_radians(), 25f64.to_radians());
    println!("Over the whole range of both inputs:");
    let grid =
        (0..=72).flat_map(|i| (-6..=6).map(move |j| (5.0 * f64::from(i), 10.0 * f64::from(j))));
    let grid: Vec<(f64, f64)> = grid
        .map(|(phi, phase)| (phi.to_radians(), phase.to_radians()))
        .collect();
    // Central differences of the velocities, against the second derivatives.
    let h = 1e-5;
    let second = grid.iter().flat_map(|&(phi, phase)| {
        let a = linkage.motion(phi, phase).a;
        let v = |dphi: f64, dphase: f64| linkage.motion(phi + dphi, phase + dphase).v;
        let by_phi = (v(h, 0.0)[1] - v(-h, 0.0)[1]) / (2.0 * h);
        let by_phase = (v(0.0, h)[1] - v(0.0, -h)[1]) / (2.0 * h);
        [
            (a[0][1].x, by_phi.x),
            (a[0][1].y, by_phi.y),
            (a[1][1].x, by_phase.x),
            (a[1][1].y, by_phase.y),
        ]
    });
    check.all_near("mixed and phase derivatives", second, 1e-5);

    println!("Euler's identity for the lengths:");
    let accuracy = linkage.accuracy(phi, phase);
    let lengths = GearedFiveBar::PARAMETERS.iter().map(|p| p.nominal);
    check.near(
        "beta, deg",
        accuracy.beta.to_degrees(),
        75.779324820318,
        1e-10,
    );
    check.near(
        "sum of r dbeta/dr",
        lengths.zip(accuracy.e).map(|(r, s)| r * s).sum(),
        0.0,
        1e-12,
    );
    check.finish()
}

// The boom on a cylinder by the law of cosines, and its sensitivities; the example `hydraulic_cylinder` has positions.

include!("../../mechanisms/hydraulic_cylinder.rs");

#[test]
fn hydraulic_cylinder_meets_known_answers() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = Boom::default();
    let linkage = mechanism.assemble()?;
    println!("Law of cosines, over the stroke:");
    let side = mechanism.foot.norm();
    let angles = (0..=60).map(|i| {
        let stroke = 0.01 * f64::from(i);
        let length = mechanism.closed + stroke;
        let opening =
            (side * side + mechanism.arm.powi(2) - length * length) / (2.0 * side * mechanism.arm);
        let foot = mechanism.foot.y.atan2(mechanism.foot.x);
        (linkage.position(stroke).lift, foot + opening.acos())
    });
    check.all_near("boom, rad", angles, 1e-13);

    println!("Dimensions at stroke 0.3 m:");
    let accuracy = linkage.accuracy(0.3);
    for (parameter, s) in Boom::PARAMETERS.iter().zip(accuracy.e) {
        println!(
            "       {:<8} {s:>10.5} rad/{}",
            parameter.name, parameter.unit
        );
    }
    // The stroke adds to the closed length; it is a length, too, and so takes part in Euler's sum.
    let dclosed = accuracy.e[Boom::INDEX_CLOSED];
    check.near(
        "d lift/d closed - d lift/d stroke",
        dclosed - accuracy.dstroke,
        0.0,
        1e-13,
    );
    let shares = Boom::PARAMETERS
        .iter()
        .zip(accuracy.e)
        .filter(|(p, _)| p.unit == "m");
    let sum: f64 = shares.map(|(p, s)| p.nominal * s).sum();
    check.near(
        "sum of r d lift/d r",
        sum + 0.3 * accuracy.dstroke,
        0.0,
        1e-13,
    );
    check.finish()
}

// Quick return of a shaper: two positions with derivatives; the example `quick_return` has the other checks.

include!("../../mechanisms/quick_return.rs");

#[test]
fn quick_return_meets_known_answers() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let linkage = QuickReturn::default().assemble()?;
    println!("The ram at 40 and at 300 degrees:");
    for (degrees, ram, v, a) in [
        (40f64, 341.930680727791, -146.636274408555, -67.709559126460),
        (300.0, 375.561565667032, 228.487084786513, -493.841510119317),
    ] {
        let s = linkage.stroke(degrees.to_radians());
        check.near("ram, mm", s.ram, ram, 1e-10);
        check.near("d ram / d phi, mm", s.v, v, 1e-10);
        check.near("d2 ram / d phi2, mm", s.a, a, 1e-9);
    }
    check.finish()
}

// Universal joints in W arrangement, with errors of the installation, and with the usual mistake; the example
// `universal_joint` has a single joint and two of them in Z arrangement.

include!("../../mechanisms/universal_joint.rs");

/// Every degree of three turns.
const STEPS: usize = 1080;

#[test]
fn universal_joint_meets_known_answers() -> Result<(), Box<dyn Error>> {
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
