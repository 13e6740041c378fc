//! Andrews' squeezing mechanism: its equation of motion against published numbers.

use crate::check::Check;
use crate::double_double::number::DoubleDouble;
use linkage::Scalar;
use linkage::dynamics::Conservative;
use std::error::Error;
use std::f64::consts::TAU;
use std::str::FromStr;

include!("../../mechanisms/andrews.rs");
include!("../../mechanisms/andrews/decimals.rs");

/// The acceleration of the crank at the start from rest, by the same publication.
const START_ACCELERATION: &str = "14222.4439199541138705911625887";

/// The reference solution after 0.03 s: the angles beta, theta, gamma, phi, delta, Omega, epsilon.
const ANGLES: [f64; 7] = [
    0.1581077119629904e2,
    -0.1575637105984298e2,
    0.4082224013073101e-1,
    -0.5347301163226948,
    0.5244099658805304,
    0.5347301163226948,
    0.1048080741042263e1,
];

/// The speed and the acceleration of beta then.
const SPEED: f64 = 0.1139920302151208e4;
const ACCELERATION: f64 = -0.2463176316945196e5;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = Andrews::default();
    let linkage = mechanism.assemble()?;
    let motor = 0.033;

    println!("At the start, in f64 and with the decimals of the publication in double-double:");
    let [beta, known] = [START, START_ACCELERATION].map(|text| text.parse::<f64>());
    let (beta, known) = (beta?, known?);
    let found = linkage.motion(beta, 0.0, motor).acceleration;
    check.near("acceleration, rad/s^2", found, known, 1e-13 * known);
    let decimals = decimals::<DoubleDouble>(&mechanism)?.assemble()?;
    let [beta, known] = [START, START_ACCELERATION].map(DoubleDouble::from_str);
    let (beta, known) = (beta?, known?);
    let motor_in_decimals = DoubleDouble::from_str("0.033")?;
    let found = decimals.motion(beta, DoubleDouble::from_f64(0.0), motor_in_decimals);
    let difference = (found.acceleration - known).lane(0);
    check.near(
        "difference, rad/s^2",
        difference,
        0.0,
        1e-27 * known.lane(0),
    );

    println!("After 0.03 s:");
    let beta = ANGLES[0];
    let at = linkage.position(beta);
    let angles = [at.theta, at.gamma, at.phi, at.delta, at.omega, at.epsilon];
    check.all_near(
        "angles, rad",
        angles.into_iter().zip(ANGLES[1..].iter().copied()),
        1e-12,
    );
    // The reference solution has ten digits of the angles and fewer of the accelerations.
    let found = linkage.motion(beta, SPEED, motor).acceleration;
    check.near(
        "acceleration, rad/s^2",
        found,
        ACCELERATION,
        1e-6 * ACCELERATION.abs(),
    );
    check.finish()
}

/// The angle after 0.03 s to more than 20 digits: the energy gives the speed, and its integral the time.
#[test]
fn angle_to_twenty_digits() -> Result<(), Box<dyn Error>> {
    let linkage = decimals::<DoubleDouble>(&Andrews::default())?.assemble()?;
    let [start, moment, end, known] = [START, "0.033", "0.03", ANGLE].map(DoubleDouble::from_str);
    let (start, moment, end, known) = (start?, moment?, end?, known?);
    let [zero, one, two] = [0.0, 1.0, 2.0].map(DoubleDouble::from_f64);
    let function = |beta: DoubleDouble| {
        let energy = linkage.energy(beta, one);
        [two * energy.kinetic, moment * beta - energy.potential]
    };
    let energy = Conservative::new(function).start(start, zero);
    let energy = energy.force(|beta| linkage.terms(beta, zero, moment).force);
    let energy = energy.tolerance(1e-26);
    let angle = energy.input(end)?;
    println!("{angle}");
    assert!((angle - known).lane(0).abs() < 1e-23 * known.lane(0));
    assert!((energy.time(angle)? - end).lane(0).abs() < 1e-26);
    Ok(())
}

/// The power of motor, spring and masses balances at any speed and acceleration.
#[test]
fn power_balances() -> Result<(), Box<dyn Error>> {
    let linkage = Andrews::default().assemble()?;
    for step in 0..60 {
        let (beta, speed, motor) = (f64::from(step) / 60.0 * TAU, 1000.0, 0.033);
        let at = linkage.terms(beta, speed, motor);
        let acceleration = linkage.motion(beta, speed, motor).acceleration;
        // d/dt (J w^2 / 2) = Q w, without a weight.
        let rate = at.inertia * speed * acceleration + at.rate / 2.0 * speed.powi(3);
        assert!((rate - at.force * speed).abs() < 1e-11 * (at.force * speed).abs().max(rate.abs()));
        assert!((at.bias - at.rate / 2.0 * speed * speed).abs() < 1e-12 * at.bias.abs().max(1.0));
        let kinetic = linkage.energy(beta, speed).kinetic;
        assert!((kinetic - at.inertia / 2.0 * speed * speed).abs() < 1e-13 * kinetic);
    }
    Ok(())
}
