//! The ankle of a humanoid: two motors in the shank, two rods to the heel, a foot that pitches and rolls on a universal joint.
//!
//! Both directions: from the foot to the motors each rod is a loop of its own in closed form; from the motors to the foot
//! both are solved together. The Jacobian gives the torques of the motors, and singular positions.

mod check;
#[path = "../mechanisms/ankle/known.rs"]
mod known;

use check::Check;
use known::KNOWN;
use linkage::jacobian::{Jacobian, SingularityKind, singularities};
use std::error::Error;

include!("../mechanisms/ankle.rs");

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let to_motors = ToMotors::default().assemble()?;
    let to_foot = ToFoot::default().assemble()?;
    println!("{}{}", ToMotors::STRUCTURE, ToFoot::STRUCTURE);

    for known in &KNOWN {
        println!("Foot at {:?} degrees:", known.foot);
        let [pitch, roll] = known.foot.map(f64::to_radians);
        let m = to_motors.motion(pitch, roll);
        let motors = [m.left, m.right].into_iter().zip(known.motors);
        check.all_near("motors", motors, 1e-15);
        let rows = [m.left_by, m.right_by].into_iter().zip(known.jacobian);
        let entries = rows.flat_map(|(row, known)| row.into_iter().zip(known));
        check.all_near("Jacobian", entries, 1e-14);
        let bends = [m.left_bends, m.right_bends].into_iter().zip(known.hessian);
        let entries = bends.flat_map(|(h, k)| [(h[0][0], k[0]), (h[0][1], k[1]), (h[1][1], k[2])]);
        check.all_near("Hessian", entries, 2e-14);
        let [left, right] = known.motors;
        let foot = to_foot.foot(left, right);
        check.all_near("foot", [(foot.pitch, pitch), (foot.roll, roll)], 1e-14);
    }

    println!("In the numbers of a controller:");
    let single = ToMotors::default().cast::<f32>().assemble()?;
    let double = to_motors.motors(-0.2, 0.1);
    let found = single.motors(-0.2, 0.1);
    check.near("left motor", found.left.into(), double.left, 1e-6);
    check.near("right motor", found.right.into(), double.right, 1e-6);

    println!("Torques for moments of 30 N m about the pitch axis and 8 N m about the roll axis:");
    let m = to_motors.motion(-0.2, 0.1);
    let by_foot = Jacobian::of_results([m.left_by, m.right_by]);
    let by_motors = by_foot.inverse();
    let moments = [30.0, 8.0];
    let torques = by_motors.efforts(moments);
    println!(
        "       left {:.3} N m, right {:.3} N m",
        torques[0], torques[1]
    );
    // The same work in any motion of the foot.
    let motion = [0.7, -0.4];
    let rates = by_foot.results_of(motion);
    let work = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let (given, done) = (work(torques, rates), work(moments, motion));
    check.near("work of moments and torques", given, done, 1e-13);
    let condition = by_motors.condition();
    check.holds("the foot moves well in all directions", condition < 1.5);

    println!("A singular position: with cranks of 40 mm, a crank and its rod are in line.");
    let short = ToMotors {
        crank: 40.0,
        ..ToMotors::default()
    };
    let short = short.assemble()?;
    let motors = |pitch: f64| {
        let m = short.motion(pitch, 0.0);
        Jacobian::of_results([m.left_by, m.right_by])
    };
    let found = singularities(motors, [0.0, -1.5], 150);
    let [second] = found[..] else {
        return Err("one singular position is known".into());
    };
    check.holds("of the second kind", second.kind == SingularityKind::Second);
    // A straight line of 270 mm from the shaft to the heel, by the law of cosines.
    let (shaft, heel) = (230.0_f64, 50.0_f64.hypot(10.0));
    let below = (shaft * shaft + heel * heel - 270.0 * 270.0) / (2.0 * shaft * heel);
    let stretched = 50.0_f64.atan2(10.0) - below.acos();
    check.near("pitch", second.at, stretched, 1e-9);
    check.finish()
}
