//! The hook-needle drive of a warp-knitting machine under forces: steady state, flywheel, run-up by an induction motor.
//!
//! The mechanism is that of the example `favorit`, with its masses. A motor of 1500 rpm turns its main crank by a belt
//! with the ratio 1.5, clockwise. A constant moment stands for the friction of the machine. A cycle takes two turns,
//! since the second crank has half the speed.

mod check;

use check::Check;
use linkage::dynamics::{Machine, Motor, Reduced, flywheel, run_up, steady_state};
use std::error::Error;
use std::f64::consts::TAU;

include!("../mechanisms/favorit_forces.rs");

/// The main crank at the start, rad.
const START: f64 = -0.25 * TAU;
/// Moment of the friction, N*mm.
const FRICTION: f64 = 400.0;
/// Speed of the main crank without load, rad/s.
const NO_LOAD: f64 = 1500.0 / 1.5 * TAU / 60.0;
/// Wished degree of unevenness.
const UNEVENNESS: f64 = 0.01;

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let drive = Favorit::default().assemble()?;
    // The angle grows clockwise from the start. Moments are in N*mm, inertias in N*mm*s^2.
    let equation = |angle: f64, speed: f64, motor: f64| {
        let at = drive.motion(START - angle, -speed);
        let force = motor - FRICTION - at.force;
        Reduced::from_parts(1e-3, [[at.inertia]], [-at.bias], [force])
    };
    let energy = |angle: f64, speed: f64| {
        let at = drive.motion(START - angle, -speed);
        at.kinetic + at.potential
    };
    // 250 W at 1450 rpm: twice the moment there, at a slip of 20 %.
    let motor = Motor::induction(NO_LOAD * 1.5, 3300.0, 0.2).geared(1.5);

    println!("The flywheel for a degree of unevenness of 1 %:");
    let driven = Machine::new(|angle, speed| equation(angle, speed, motor.torque(speed)));
    let driven = driven.period(2.0 * TAU);
    let alone = steady_state(&driven, NO_LOAD)?;
    println!("       without it {:.4}", alone.unevenness());
    let wheel = flywheel(&driven, UNEVENNESS, NO_LOAD)?;
    let (steady, wheel) = (wheel.steady_state, wheel.inertia);
    println!("       {:.0} kg*mm^2", 1000.0 * wheel);
    check.near("unevenness", steady.unevenness(), UNEVENNESS, 1e-8);
    // The textbook's formula: the energy of the drive, which varies at a constant speed, is stored in the wheel.
    let speed = steady.mean_speed();
    let stored = (0..720).map(|i| energy(f64::from(i) / 360.0 * TAU, speed));
    let (low, high) = stored.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), energy| {
        (energy.min(low), energy.max(high))
    });
    let textbook = (high - low) / (UNEVENNESS * speed * speed);
    check.near("flywheel / textbook's", wheel / textbook, 1.0, 0.1);

    println!("Run-up with the flywheel, to 95 % of the speed without load:");
    let machine = Machine::new(|angle, speed| {
        let mut equation = equation(angle, speed, 0.0);
        equation.inertia[0][0] += wheel;
        equation
    });
    let start = run_up(&machine, &motor, 0.95 * NO_LOAD, 10.0)?;
    println!("       {:.3} s, {:.2} turns", start.time, start.angle / TAU);
    println!("       {:.1} J of heat in the motor", start.heat / 1000.0);
    let end = start.motion.end();
    let [angle, speed] = [end.inputs[0], end.speeds[0]];
    let gained = energy(angle, speed) + wheel * speed * speed / 2.0 - energy(0.0, 0.0);
    let work = gained + FRICTION * angle;
    check.near("work of the motor, J", start.work / 1e3, work / 1e3, 1e-6);
    // A motor that accelerates a wheel takes as much heat as the wheel stores at the speed without load, and the slip
    // takes its part of the friction's work.
    let slip = FRICTION * (NO_LOAD * start.time - angle);
    let share = (start.heat - slip) / (wheel * NO_LOAD * NO_LOAD / 2.0);
    check.near("heat / energy of the wheel", share, 1.0, 0.05);
    check.finish()
}
