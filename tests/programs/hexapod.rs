//! A platform on six legs, both ways: the lengths of the legs from a pose in closed form, the pose from the lengths by a follower, which goes
//! from position to position.
//!
//! Poses, Jacobian and condition along a path against solutions in 80 digits, computed apart from this project; a path of 10,000 poses there and back; and a slice of
//! the workspace as a picture, `target/hexapod/workspace.svg`. At last all 40 assemblies of the
//! platform that has the most real ones, and of this one at both ends of the path, each certified; without optimisation that takes long, and is left out
//! but with `LINKAGE_LONG=1`.

mod geometry;
mod platform;
mod workspace;

use crate::check::Check;
use crate::digits::{number, numbers};
use crate::folders;
use linkage::jacobian::Jacobian;
use nalgebra::{Rotation3, Vector3};
use serde_json::Value;
use std::error::Error;
use std::f64::consts::TAU;

include!("../../mechanisms/hexapod.rs");

/// A path of so many poses, there and back.
const POSES: u32 = 10_000;
/// Roll, pitch and yaw in the middle of the path and in the slice of the workspace.
const TURN: [f64; 3] = [0.08, -0.05, 0.35];
/// Millimetres that count as much as a radian: about the platform's radius.
const RADIUS: f64 = 100.0;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let to_pose = ToPose::default().assemble()?;
    let to_legs = ToLegs::default().assemble()?;
    println!("{}", ToPose::STRUCTURE);
    let [a, b, c, d, e, f] = std::array::from_fn(|k| ToPose::INPUTS[k].reference);
    let start = to_pose.follower(a, b, c, d, e, f)?;
    println!("A path with solutions in 80 digits:");
    along_known(&mut check, start, &to_legs)?;
    println!("{POSES} poses:");
    there_and_back(&mut check, start, &to_legs)?;
    println!("Workspace:");
    workspace::show(&mut check, start, &to_legs, &folders::target("hexapod"))?;
    if !cfg!(debug_assertions) || std::env::var_os("LINKAGE_LONG").is_some() {
        println!("All assemblies:");
        workspace::show_assemblies(&mut check)?;
    }
    check.finish()
}

fn along_known(
    check: &mut Check,
    mut at: ToPoseFollower<'_>,
    to_legs: &ToLegsAssembly,
) -> Result<(), Box<dyn Error>> {
    let path: Vec<Value> =
        serde_json::from_str(include_str!("../../mechanisms/hexapod/reference.json"))?;
    check.holds("all positions", path.len() == 20);
    for known in &path {
        let legs = numbers::<6>(&known["legs"])?;
        let [a, b, c, d, e, f] = legs;
        at.follow(a, b, c, d, e, f)?;
        let body = at.pose().body;
        let p = numbers::<3>(&known["p"])?;
        check.all_near("origin", body.origin.into_iter().copied().zip(p), 4e-12);
        let mut matrix = Vec::new();
        let mut rows = [[0.0; 3]; 3];
        for row in 0..3 {
            rows[row] = numbers::<3>(&known["R"][row])?;
            let found = [body.x[row], body.y[row], body.z[row]];
            matrix.extend(found.into_iter().zip(rows[row]));
        }
        // A roundoff of the lengths times the condition, which is up to 155.
        check.all_near("directions", matrix, 2e-14);
        // R = Rx Ry Rz, so the angles stand in its last column and first row.
        let pitch = rows[0][2].asin();
        let (roll, yaw) = (
            (-rows[1][2]).atan2(rows[2][2]),
            (-rows[0][1]).atan2(rows[0][0]),
        );
        let back = to_legs.legs(p[0], p[1], p[2], roll, pitch, yaw);
        check.all_near(
            "legs from the pose",
            listed(&back).into_iter().zip(legs),
            1e-12,
        );
        let jacobian = jacobian(&at);
        let mut entries = Vec::new();
        for (row, found) in jacobian.rows().into_iter().enumerate() {
            entries.extend(
                found
                    .into_iter()
                    .zip(numbers::<6>(&known["jacobian"][row])?),
            );
        }
        check.all_near("Jacobian", entries, 1e-11);
        // The other way round: what the legs do when the platform is shifted.
        let by = to_legs.shifts(p[0], p[1], p[2], roll, pitch, yaw);
        let by = [by.l1, by.l2, by.l3, by.l4, by.l5, by.l6];
        let inverse = jacobian.inverse().rows();
        let pairs = inverse.into_iter().zip(by);
        let shifts = pairs.flat_map(|(row, by)| (0..3).map(move |k| (row[k], by[k])));
        check.all_near("its inverse, shifts", shifts, 1e-12);
        let condition = number(&known["condition"])?;
        check.near("condition", jacobian.condition() / condition, 1.0, 1e-11);
        let scaled = number(&known["scaled"])?;
        check.near("condition with 100 mm", even(&at) / scaled, 1.0, 1e-11);
    }
    Ok(())
}

/// Velocities and angular velocities of the platform by the lengths.
fn jacobian(at: &ToPoseFollower<'_>) -> Jacobian<f64, 6> {
    let rates = at.rates();
    Jacobian::of_inputs(std::array::from_fn(|leg| {
        let (v, w) = (rates.v[leg], rates.w[leg]);
        [v.x, v.y, v.z, w.x, w.y, w.z]
    }))
}

/// The condition with angles as ways at the platform's radius.
fn even(at: &ToPoseFollower<'_>) -> f64 {
    let turn = 1.0 / RADIUS;
    let units = [1.0, 1.0, 1.0, turn, turn, turn];
    jacobian(at).in_units(units, [1.0; 6]).condition()
}

fn listed(legs: &Legs) -> [f64; 6] {
    [legs.l1, legs.l2, legs.l3, legs.l4, legs.l5, legs.l6]
}

/// Each pose gives the legs, the legs give the pose again, which nalgebra's rotations confirm.
fn there_and_back(
    check: &mut Check,
    mut at: ToPoseFollower<'_>,
    to_legs: &ToLegsAssembly,
) -> Result<(), Box<dyn Error>> {
    let (mut shifted, mut turned, mut worst) = (0.0_f64, 0.0_f64, 0.0_f64);
    for k in 0..POSES {
        let t = TAU * f64::from(k) / f64::from(POSES);
        let p = Vector3::new(
            12.0 + 40.0 * t.sin(),
            -18.0 + 35.0 * (2.0 * t).sin(),
            420.0 + 30.0 * (3.0 * t).sin(),
        );
        // About the orientation that the platform holds best, away from its singular positions.
        let [roll, pitch, yaw] = [
            TURN[0] + 0.10 * t.sin(),
            TURN[1] + 0.12 * (2.0 * t).sin(),
            TURN[2] + 0.15 * (3.0 * t).sin(),
        ];
        let legs = to_legs.legs(p.x, p.y, p.z, roll, pitch, yaw);
        let [a, b, c, d, e, f] = listed(&legs);
        at.follow(a, b, c, d, e, f)?;
        let body = at.pose().body;
        let rotation = rotation([roll, pitch, yaw]);
        // `max` lets a NaN pass, which `follow` does not.
        shifted = shifted.max((body.origin - p).norm());
        turned = turned
            .max((body.x - rotation * Vector3::x()).norm())
            .max((body.z - rotation * Vector3::z()).norm());
        if k % 100 == 0 {
            worst = worst.max(even(&at));
        }
    }
    check.near("origin, largest difference", shifted, 0.0, 1e-10);
    check.near("directions, largest difference", turned, 0.0, 1e-12);
    check.holds(
        "every condition is a number",
        worst.is_finite() && worst > 1.0,
    );
    println!("       largest condition with 100 mm {worst:.1}");
    Ok(())
}

/// The orientation with this roll, pitch and yaw.
fn rotation([roll, pitch, yaw]: [f64; 3]) -> Rotation3<f64> {
    Rotation3::from_axis_angle(&Vector3::x_axis(), roll)
        * Rotation3::from_axis_angle(&Vector3::y_axis(), pitch)
        * Rotation3::from_axis_angle(&Vector3::z_axis(), yaw)
}
