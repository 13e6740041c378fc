//! The ankle of a humanoid: two motors in the shank, two rods to the heel, a foot that pitches and rolls on a universal joint.
//!
//! Both ways: from the foot to the motors each rod is a loop of its own in closed form; from the motors to the foot both are solved together.
//! With Jacobians and Hessians of both, in double and in single precision, the way of torques, and where the ankle is singular. The way to the
//! motors is compared with a solution in 60 digits, the way back with it.

#[path = "../../mechanisms/ankle/known.rs"]
mod known;

use crate::check::Check;
use known::{KNOWN, Known};
use linkage::jacobian::{Jacobian, SingularityKind, singularities};
use std::error::Error;

include!("../../mechanisms/ankle.rs");

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let (to_motors, to_foot) = (
        ToMotors::default().assemble()?,
        ToFoot::default().assemble()?,
    );
    println!("{}{}", ToMotors::STRUCTURE, ToFoot::STRUCTURE);
    for known in &KNOWN {
        println!("Foot at {:?} degrees:", known.foot);
        compare(&mut check, &to_motors, known);
        there_and_back(&mut check, &to_motors, &to_foot, known);
    }
    println!("In single precision:");
    single_precision(&mut check)?;
    println!("Torques and singular positions:");
    torques(&mut check, &to_motors);
    singular(&mut check)?;
    check.finish()
}

fn compare(check: &mut Check, to_motors: &ToMotorsAssembly, known: &Known) {
    let [pitch, roll] = known.foot.map(f64::to_radians);
    let m = to_motors.motion(pitch, roll);
    let motors = [m.left, m.right].into_iter().zip(known.motors);
    check.all_near("motors", motors, 1e-15);
    let rows = [m.left_by, m.right_by].into_iter().zip(known.jacobian);
    check.all_near(
        "Jacobian",
        rows.flat_map(|(a, b)| a.into_iter().zip(b)),
        1e-14,
    );
    let bends = [m.left_bends, m.right_bends].into_iter().zip(known.hessian);
    let entries = bends.flat_map(|(h, k)| {
        let [[a, b], [c, d]] = h;
        [(a, k[0]), (b, k[1]), (c, k[1]), (d, k[2])]
    });
    check.all_near("Hessian", entries, 2e-14);
}

/// The foot found again from the motors, and derivatives that undo each other.
fn there_and_back(
    check: &mut Check,
    to_motors: &ToMotorsAssembly,
    to_foot: &ToFootAssembly,
    known: &Known,
) {
    let [pitch, roll] = known.foot.map(f64::to_radians);
    let [left, right] = known.motors;
    let tilt = to_foot.tilt(left, right);
    check.all_near("foot", [(tilt.pitch, pitch), (tilt.roll, roll)], 1e-14);
    let there = to_motors.motion(pitch, roll);
    let there_by = Jacobian::of_results([there.left_by, there.right_by]);
    let back_by = Jacobian::of_results([tilt.pitch_by, tilt.roll_by]);
    let inverse = there_by.inverse().rows();
    let pairs = back_by.rows().into_iter().zip(inverse);
    check.all_near(
        "its Jacobian is the inverse",
        pairs.flat_map(|(a, b)| a.into_iter().zip(b)),
        1e-13,
    );
    // The second derivative of there and back is zero: B'' (A, A) + B' A'' = 0.
    let bends = [tilt.pitch_bends, tilt.roll_bends];
    let columns = [0, 1].map(|k| [there.left_by[k], there.right_by[k]]);
    let mut rest = Vec::new();
    for (bends, back_by) in bends.iter().zip(back_by.rows()) {
        for (i, j) in [(0, 0), (0, 1), (1, 1)] {
            let of_motors = |k: usize| [there.left_bends, there.right_bends][k][i][j];
            let curved: f64 = (0..4)
                .map(|k| bends[k / 2][k % 2] * columns[i][k / 2] * columns[j][k % 2])
                .sum();
            let straight: f64 = (0..2).map(|k| back_by[k] * of_motors(k)).sum();
            rest.push((curved + straight, 0.0));
        }
    }
    check.all_near("and its Hessian fits", rest, 1e-12);
}

/// Everything that the drives need, in the numbers of a controller.
fn single_precision(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let to_motors = ToMotors::default().cast::<f32>().assemble()?;
    let to_foot = ToFoot::default().cast::<f32>().assemble()?;
    let [mut motors, mut feet] = [const { Vec::new() }; 2];
    let [mut by_foot, mut bends, mut back, mut torques] = [const { Vec::new() }; 4];
    for known in &KNOWN {
        #[expect(clippy::cast_possible_truncation, reason = "to single precision")]
        let [pitch, roll] = known.foot.map(|angle| angle.to_radians() as f32);
        let m = to_motors.motion(pitch, roll);
        motors.extend(
            [m.left, m.right]
                .map(f64::from)
                .into_iter()
                .zip(known.motors),
        );
        let rows = [m.left_by, m.right_by];
        let pairs = rows.as_flattened().iter().map(|x| f64::from(*x));
        by_foot.extend(pairs.zip(known.jacobian.into_iter().flatten()));
        for (h, k) in [m.left_bends, m.right_bends].iter().zip(known.hessian) {
            let h = h.map(|row| row.map(f64::from));
            bends.extend([
                (h[0][0], k[0]),
                (h[0][1], k[1]),
                (h[1][0], k[1]),
                (h[1][1], k[2]),
            ]);
        }
        let tilt = to_foot.tilt(m.left, m.right);
        feet.extend([(tilt.pitch, pitch), (tilt.roll, roll)].map(|(a, b)| (a.into(), b.into())));
        // What undoes the Jacobian, and torques, by the solution in 60 digits.
        let exact = Jacobian::of_results(known.jacobian).inverse();
        let rows = [tilt.pitch_by, tilt.roll_by];
        let pairs = rows.as_flattened().iter().map(|x| f64::from(*x));
        back.extend(pairs.zip(exact.rows().into_iter().flatten()));
        let own = Jacobian::of_results([m.left_by, m.right_by]).inverse();
        let found = own.efforts([30.0, 8.0]).map(f64::from);
        torques.extend(found.into_iter().zip(exact.efforts([30.0, 8.0])));
    }
    check.all_near("motors", motors, 1e-6);
    check.all_near("their Jacobian", by_foot, 2e-6);
    check.all_near("their Hessian", bends, 5e-6);
    check.all_near("foot", feet, 2e-6);
    check.all_near("its Jacobian", back, 1e-5);
    check.all_near("torques, N m", torques, 5e-5);
    Ok(())
}

/// A push on the foot, and the motors that carry it.
fn torques(check: &mut Check, to_motors: &ToMotorsAssembly) {
    let m = to_motors.motion(-0.2, 0.1);
    let by_foot = Jacobian::of_results([m.left_by, m.right_by]);
    let by_motors = by_foot.inverse();
    // Moments of 30 N m about the pitch axis and 8 N m about the roll axis.
    let moments = [30.0, 8.0];
    let torques = by_motors.efforts(moments);
    println!(
        "       left {:.3} N m, right {:.3} N m",
        torques[0], torques[1]
    );
    // The same work in any motion of the foot.
    let motion = [0.7, -0.4];
    let rates = by_foot.results_of(motion);
    let [done, given] = [(moments, motion), (torques, rates)].map(|([a, b], [c, d])| a * c + b * d);
    check.near("work of moments and torques", given, done, 1e-13);
    println!(
        "       condition {:.3}, manipulability {:.3}",
        by_motors.condition(),
        by_motors.manipulability()
    );
    check.holds(
        "the foot moves well in all directions",
        by_motors.condition() < 1.5,
    );
}

/// Where a motor's crank and its rod are in one line, the foot goes no farther: the motors still move, it does not.
fn singular(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let wide = ToFoot::default().assemble()?;
    let foot = |motor: f64| {
        let tilt = wide.tilt(motor, motor);
        Jacobian::of_results([tilt.pitch_by, tilt.roll_by])
    };
    let found = singularities(foot, [-0.4, 0.6], 50);
    let within = found.iter().filter(|own| own.kind != SingularityKind::End);
    check.holds(
        "no singular position within the motors' range",
        within.count() == 0,
    );
    let short = ToMotors {
        crank: 40.0,
        ..ToMotors::default()
    }
    .assemble()?;
    let motors = |pitch: f64| {
        let m = short.motion(pitch, 0.0);
        Jacobian::of_results([m.left_by, m.right_by])
    };
    let found = singularities(motors, [0.0, -1.5], 150);
    for own in &found {
        println!(
            "       cranks of 40 mm: {:?} at a pitch of {:.3} degrees",
            own.kind,
            own.at.to_degrees()
        );
    }
    // Crank and rod are a straight line of 270 mm from the shaft to the heel: by the law of cosines.
    let (shaft, heel) = (230.0_f64, 50.0_f64.hypot(10.0));
    let below = (shaft * shaft + heel * heel - 270.0 * 270.0) / (2.0 * shaft * heel);
    let stretched = 50.0_f64.atan2(10.0) - below.acos();
    check.holds(
        "one of them",
        found.len() == 1 && found[0].kind == SingularityKind::Second,
    );
    check.near(
        "where crank and rod are in line",
        found[0].at,
        stretched,
        1e-9,
    );
    Ok(())
}
