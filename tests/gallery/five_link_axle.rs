//! A wheel on five rods: a wheel carrier as an unknown body, by the travel of the wheel and the shift of a rack on the fifth rod.
//!
//! Toe, camber, track, wheel base and roll centre with derivatives by travel and rack, and their sensitivities to all rods and to all points of
//! the chassis and of the carrier, against solutions in 60 digits. The axis of the screw on which the carrier moves is found against what rods do,
//! and against poses beside it.
//!
//! A page with the usual curves over the travel is in `target/five_link_axle`.

use crate::check::Check;
use crate::digits::number;
use crate::suspension;
use linkage::Screw;
use linkage::report::Report;
use nalgebra::Vector3;
use serde_json::Value;
use std::error::Error;

include!("../../mechanisms/five_link_axle.rs");

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let axle = FiveLinkAxle::default().assemble()?;
    println!("{}", FiveLinkAxle::<f64>::STRUCTURE);
    check.near("share of the ranges served", axle.served(), 1.0, 1e-3);
    let references = serde_json::from_str(include_str!(
        "../../mechanisms/five_link_axle/reference.json"
    ))?;
    let references: Vec<Value> = references;
    for known in &references {
        compare(&mut check, &axle, known)?;
    }
    let travel = suspension::travels(&FiveLinkAxle::<f64>::INPUTS[0]);
    let (wheel, roll) = (
        axle.wheel_sweep(&travel, &[0.0]),
        axle.roll_sweep(&travel, &[0.0]),
    );
    let lengths = [
        ("track", wheel.track()),
        ("base", wheel.base()),
        ("roll centre", roll.roll_centre()),
    ];
    suspension::write(&report()?, &lengths, "five_link_axle")?;
    check.finish()
}

/// The page: the rack in the middle.
pub(crate) fn report() -> Result<Report, Box<dyn Error>> {
    let axle = FiveLinkAxle::default().assemble()?;
    let input = &FiveLinkAxle::<f64>::INPUTS[0];
    let travel = suspension::travels(input);
    let about = "A wheel carrier on five rods over the travel of the wheel. Base is where the wheel stands on the road, forwards.";
    Ok(suspension::of("Five-link axle", about, input, &travel)
        .structure(FiveLinkAxle::<f64>::STRUCTURE)
        .dimensions(axle.mechanism())
        .table(&axle.wheel_sweep(&travel, &[0.0]))
        .table(&axle.roll_sweep(&travel, &[0.0]))
        .table(&axle.motion_sweep(&travel, &[0.0]))
        .table(&axle.picture_sweep(&travel, &[0.0])))
}

fn compare(
    check: &mut Check,
    axle: &FiveLinkAxleAssembly,
    known: &Value,
) -> Result<(), Box<dyn Error>> {
    let [travel, rack] = [number(&known["z"])?, number(&known["u"])?];
    println!("Travel {travel} mm, rack {rack} mm:");
    let (w, m) = (axle.wheel(travel, rack), axle.motion(travel, rack));
    let s = axle.adjustment(travel, rack);
    // Angles are small numbers of a radian, lengths are a hundred thousand times larger.
    let quantities = [
        ("toe", w.toe, m.toe, m.toe_bends, s.toe, 1e-15),
        (
            "camber",
            w.camber,
            m.camber,
            m.camber_bends,
            s.camber,
            1e-15,
        ),
        ("track", w.track, m.track, m.track_bends, s.track, 1e-12),
        ("base", w.base, m.base, m.base_bends, s.base, 1e-12),
    ];
    for (name, value, by, bends, by_dimensions, tolerance) in quantities {
        check.near(name, value, number(&known["value"][name])?, tolerance);
        let pairs = [
            (by[0], number(&known["d_dz"][name])?),
            (by[1], number(&known["d_du"][name])?),
            (bends[0][0], number(&known["d2_dz2"][name])?),
        ];
        check.all_near("  by travel and rack, twice by travel", pairs, tolerance);
        let known = known["sensitivity"][name].as_array().ok_or("a list")?;
        check.holds("  every dimension", known.len() == by_dimensions.len());
        let known = crate::digits::all(known)?;
        check.all_near(
            "  by all dimensions",
            by_dimensions.into_iter().zip(known),
            tolerance,
        );
    }
    let roll = axle.roll(travel, rack);
    let pairs = [
        (roll.roll_centre, number(&known["roll_centre"])?),
        (roll.shift[0], number(&known["roll_centre_dz"])?),
        (roll.shift[1], number(&known["roll_centre_du"])?),
    ];
    check.all_near("roll centre, by travel and rack", pairs, 1e-10);
    let by_dimensions = known["roll_centre_sensitivity"]
        .as_array()
        .ok_or("a list")?;
    let by_dimensions: Vec<f64> = by_dimensions.iter().map(number).collect::<Result<_, _>>()?;
    check.holds(
        "  every dimension",
        by_dimensions.len() == roll.by_dimensions.len(),
    );
    let pairs = roll.by_dimensions.into_iter().zip(by_dimensions);
    check.all_near("  by all dimensions", pairs, 1e-10);
    screw(check, axle, travel, rack);
    Ok(())
}

/// The axis about which the carrier turns and along which it shifts while the wheel travels, the rack at rest.
fn screw(check: &mut Check, axle: &FiveLinkAxleAssembly, travel: f64, rack: f64) {
    let body = axle.body(travel, rack);
    let screw: Screw = Screw::of(body.w[0], body.v[0], body.carrier.origin);
    let Screw {
        direction, point, ..
    } = screw;
    println!(
        "       screw axis through ({:.3}, {:.3}, {:.3}) mm along ({:.6}, {:.6}, {:.6}), {:.3} mm/deg",
        point.x,
        point.y,
        point.z,
        direction.x,
        direction.y,
        direction.z,
        screw.pitch().to_radians(),
    );
    // Five rods leave one screw, the one that moves no ball along its rod (Ball's reciprocal screw); the travel says how fast.
    let of = axle.mechanism();
    let steered = of.inner5 + Vector3::y() * rack;
    let rods = [
        (of.outer1, of.inner1),
        (of.outer2, of.inner2),
        (of.outer3, of.inner3),
        (of.outer4, of.inner4),
        (of.outer5, steered),
    ];
    let along_rods = rods.map(|(outer, inner)| {
        let ball = body.carrier.point(outer);
        (ball - inner).normalize().dot(&screw.velocity(ball))
    });
    check.all_near(
        "balls along their rods by the screw",
        along_rods.map(|speed| (speed, 0.0)),
        2e-15,
    );
    let rise = screw.velocity(body.carrier.origin).z;
    check.near("  and the travel", rise, 1.0, 1e-14);
    // Points of the carrier on the axis move along it: by poses half a millimetre and a millimetre up and down, where the ranges have them.
    const STEP: f64 = 0.5;
    if travel.abs() + 2.0 * STEP > 80.0 {
        return;
    }
    for along in [0.0, 400.0] {
        let on_axis = body.carrier.coordinates(point + direction * along);
        let at = |steps: f64| {
            let beside = axle.body(travel + steps * STEP, rack);
            beside.carrier.point(on_axis)
        };
        let (near, far) = (at(1.0) - at(-1.0), at(2.0) - at(-2.0));
        let speed: Vector3<f64> = (near * 8.0 - far) / (12.0 * STEP);
        let off = speed - direction * screw.shift;
        check.all_near(
            "points of the axis along it by poses",
            off.iter().map(|off| (*off, 0.0)),
            1e-10,
        );
    }
}
