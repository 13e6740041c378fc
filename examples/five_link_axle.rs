//! A wheel on five rods: a wheel carrier as an unknown body, by the travel of the wheel and the shift of a rack on the fifth rod.
//!
//! Toe, camber, track, wheel base and roll centre with derivatives by travel and rack, and their sensitivities to all rods and to all points of
//! the chassis and of the carrier, against solutions in 60 digits. The axis of the screw on which the carrier moves is found against what rods do,
//! and against poses beside it.
//!
//! `cargo run --release --example five_link_axle` writes a page with the usual curves over the travel to `target/five_link_axle`, or to the
//! folder that is given behind `--`.

mod check;
#[path = "check/digits.rs"]
mod digits;
#[path = "suspension/page.rs"]
mod page;

use check::Check;
use digits::number;
use linkage::report::Report;
use linkage::{Screw, mechanism};
use nalgebra::Vector3;
use serde_json::Value;
use std::error::Error;

mechanism! {
    /// A left wheel: x points forwards, y outwards, z up.
    pub struct FiveLinkAxle {
        unit mm;
        param rod1 = 287.31515797117283314mm;
        param rod2 = 256.75864152935534645mm;
        param rod3 = 318.62987932709637832mm;
        param rod4 = 451.60823730308551581mm;
        param rod5 = 376.15422369023054744mm;
        // On the chassis; the rack shifts the fifth.
        param inner1 = (110mm, 420mm, 430mm);
        param inner2 = (-85mm, 435mm, 440mm);
        param inner3 = (265mm, 480mm, 265mm);
        param inner4 = (-60mm, 255mm, 215mm);
        param inner5 = (-190mm, 316mm, 258mm);
        // On the carrier, from the centre of the wheel.
        param outer1 = (15mm, -70mm, 135mm);
        param outer2 = (-30mm, -75mm, 140mm);
        param outer3 = (40mm, -60mm, -105mm);
        param outer4 = (-25mm, -55mm, -120mm);
        param outer5 = (-150mm, -70mm, -58mm);

        input travel = 0mm in -80mm..80mm;
        input rack   = 0mm in -15mm..15mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        let ball1 = point_in(carrier, outer1);
        let ball2 = point_in(carrier, outer2);
        let ball3 = point_in(carrier, outer3);
        let ball4 = point_in(carrier, outer4);
        let ball5 = point_in(carrier, outer5);
        let steered = inner5 + (0mm, rack, 0mm);
        loop distance(ball1, inner1) = rod1;
        loop distance(ball2, inner2) = rod2;
        loop distance(ball3, inner3) = rod3;
        loop distance(ball4, inner4) = rod4;
        loop distance(ball5, steered) = rod5;
        loop carrier.origin.z = 320mm + travel;

        let spindle = unit(0.0035 * carrier.x + carrier.y + 0.0175 * carrier.z);
        let toe = atan2(spindle.x, spindle.y);
        let camber = atan2(-spindle.z, norm((spindle.x, spindle.y)));
        // Where the wheel of 310 mm stands on the road: its lowest point.
        let up = unit((0, 0, 1) - spindle.z * spindle);
        let contact = carrier.origin - 310mm * up;
        let base = contact.x;
        let track = 2 * contact.y;
    }

    impl FiveLinkAxle {
        pub fn wheel(travel, rack) -> Wheel { toe, camber, track, base }
        pub fn motion(travel, rack) -> Motion {
            toe: velocity(toe), camber: velocity(camber), track: velocity(track), base: velocity(base),
            toe_bends: acceleration(toe), camber_bends: acceleration(camber),
            track_bends: acceleration(track), base_bends: acceleration(base),
        }
        /// The carrier as it moves, for the axis of its screw.
        pub fn body(travel, rack) -> Body { carrier, v: velocity(carrier.origin), w: omega(carrier) }
        /// Height of the roll centre over the road. Seen from the front the wheel turns about a point on the normal to the way of the point of the
        /// carrier that is its point of contact; the body rolls about where that normal meets the middle of the vehicle.
        // Written out three times: a quantity knows the names of the struct block only, and `let` takes no derivatives.
        pub fn roll(travel, rack) -> Roll {
            roll_centre: contact.y * (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).y
                / (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).z,
            shift: velocity(contact.y * (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).y
                / (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).z),
            by_dimensions: sensitivity(contact.y * (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).y
                / (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).z),
        }
        pub fn adjustment(travel, rack) -> Adjustment {
            toe: sensitivity(toe), camber: sensitivity(camber), track: sensitivity(track), base: sensitivity(base),
        }
        pub fn picture(travel, rack) -> Picture { shape: picture() }
    }
}

/// Where the page is written if no folder is given.
const FOLDER: &str = "target/five_link_axle";

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let axle = FiveLinkAxle::default().assemble()?;
    println!("{}", FiveLinkAxle::<f64>::STRUCTURE);
    check.near("share of the ranges served", axle.served(), 1.0, 1e-3);
    let references = serde_json::from_str(include_str!("five_link_axle/reference.json"))?;
    let references: Vec<Value> = references;
    for known in &references {
        compare(&mut check, &axle, known)?;
    }
    let travel = page::travels(&FiveLinkAxle::<f64>::INPUTS[0]);
    let (wheel, roll) = (
        axle.wheel_sweep(&travel, &[0.0]),
        axle.roll_sweep(&travel, &[0.0]),
    );
    let lengths = [
        ("track", wheel.track()),
        ("base", wheel.base()),
        ("roll centre", roll.roll_centre()),
    ];
    page::write(&report()?, &lengths, FOLDER)?;
    check.finish()
}

/// The page: the rack in the middle.
pub(crate) fn report() -> Result<Report, Box<dyn Error>> {
    let axle = FiveLinkAxle::default().assemble()?;
    let input = &FiveLinkAxle::<f64>::INPUTS[0];
    let travel = page::travels(input);
    let about = "A wheel carrier on five rods over the travel of the wheel. Base is where the wheel stands on the road, forwards.";
    Ok(page::of("Five-link axle", about, input, &travel)
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
        let known = digits::all(known)?;
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
