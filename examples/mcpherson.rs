//! A McPherson strut by the travel of the wheel: a lower arm, a tie rod, and a damper whose axis is fixed on the wheel carrier and goes through
//! the top mount.
//!
//! The wheel, its toe and camber and the length of the strut with first and second derivatives, and the sensitivities to rods and points, against
//! solutions in 80 digits.
//!
//! `cargo run --release --example mcpherson` writes a page with the usual curves over the travel to `target/mcpherson`, or to the folder that is
//! given behind `--`.

mod check;
#[path = "check/digits.rs"]
mod digits;
#[path = "suspension/page.rs"]
mod page;

use check::Check;
use digits::number;
use linkage::mechanism;
use linkage::report::Report;
use serde_json::Value;
use std::error::Error;

mechanism! {
    /// A left wheel: x points forwards, y outwards, z up. An arm is two rods from its ball joint.
    pub struct McPherson {
        unit mm;
        param front_rod = 346.04912945996555419mm;
        param rear_rod  = 446.84896777322872092mm;
        param tie_rod   = 350.19423182000014205mm;
        param top_mount = (-25mm, 580mm, 850mm);
        param front = (15mm, 380mm, 215mm);
        param rear  = (-300mm, 400mm, 222mm);
        param tie   = (-130mm, 350mm, 288mm);

        input travel = 0mm in -80mm..80mm;
        unknown carrier = frame((0mm, 760mm, 310mm), (1, 0, 0), (0, 0, 1));
        let ball = point_in(carrier, (5mm, -35mm, -120mm));
        loop distance(ball, front) = front_rod;
        loop distance(ball, rear) = rear_rod;
        loop distance(point_in(carrier, (-140mm, -60mm, -28mm)), tie) = tie_rod;
        // The damper's axis has the direction (-17, -72, 450) on the carrier; these two are perpendicular to it.
        let strut = top_mount - point_in(carrier, (-8mm, -108mm, 90mm));
        loop dot(strut, carrier.x + 17 / 450 * carrier.z) = 0;
        loop dot(strut, carrier.y + 72 / 450 * carrier.z) = 0;
        loop carrier.origin.z = 310mm + travel;

        let x = carrier.origin.x;
        let y = carrier.origin.y;
        let spindle = unit(0.0017 * carrier.x + carrier.y + 0.0087 * carrier.z);
        let toe = atan2(spindle.x, spindle.y);
        let camber = atan2(-spindle.z, norm((spindle.x, spindle.y)));
        let strut_length = norm(strut);
    }

    impl McPherson {
        pub fn wheel(travel) -> Wheel { toe, camber, x, y, strut_length }
        pub fn motion(travel) -> Motion {
            x: d(x, travel), y: d(y, travel), toe: d(toe, travel), camber: d(camber, travel),
            strut_length: d(strut_length, travel),
        }
        pub fn bends(travel) -> Bends {
            x: acceleration(x), y: acceleration(y), toe: acceleration(toe), camber: acceleration(camber),
            strut_length: acceleration(strut_length),
        }
        pub fn adjustment(travel) -> Adjustment {
            x: sensitivity(x), y: sensitivity(y), toe: sensitivity(toe), camber: sensitivity(camber),
        }
        pub fn picture(travel) -> Picture { shape: picture() }
    }
}

/// The reference's names of the dimensions, in the order of the sensitivities.
const DIMENSIONS: [&str; 15] = [
    "Llf",
    "Llr",
    "Ltie",
    "top_mount.x",
    "top_mount.y",
    "top_mount.z",
    "lower_front.x",
    "lower_front.y",
    "lower_front.z",
    "lower_rear.x",
    "lower_rear.y",
    "lower_rear.z",
    "tie_inner.x",
    "tie_inner.y",
    "tie_inner.z",
];

/// Where the page is written if no folder is given.
const FOLDER: &str = "target/mcpherson";

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let strut = McPherson::default().assemble()?;
    println!("{}", McPherson::<f64>::STRUCTURE);
    let references: Vec<Value> = serde_json::from_str(include_str!("mcpherson/reference.json"))?;
    check.holds("all positions", references.len() == 17);
    for known in &references {
        compare(&mut check, &strut, known)?;
    }
    let travel = page::travels(&McPherson::<f64>::INPUTS[0]);
    let wheel = strut.wheel_sweep(&travel);
    let lengths = [
        ("x", wheel.x()),
        ("y", wheel.y()),
        ("strut", wheel.strut_length()),
    ];
    page::write(&report()?, &lengths, FOLDER)?;
    check.finish()
}

/// The page, which computes, too.
pub(crate) fn report() -> Result<Report, Box<dyn Error>> {
    let strut = McPherson::default().assemble()?;
    let input = &McPherson::<f64>::INPUTS[0];
    let travel = page::travels(input);
    let about = "A wheel on an arm, a tie rod and a strut over its travel. x and y are where its centre is.";
    Ok(page::of("McPherson strut", about, input, &travel)
        .structure(McPherson::<f64>::STRUCTURE)
        .dimensions(strut.mechanism())
        .programs(McPherson::<f64>::PROGRAMS)
        .table(&strut.wheel_sweep(&travel))
        .table(&strut.motion_sweep(&travel))
        .table(&strut.picture_sweep(&travel)))
}

fn compare(
    check: &mut Check,
    strut: &McPhersonAssembly,
    known: &Value,
) -> Result<(), Box<dyn Error>> {
    let travel = number(&known["z"])?;
    println!("Travel {travel} mm:");
    let (w, m, b) = (
        strut.wheel(travel),
        strut.motion(travel),
        strut.bends(travel),
    );
    let s = strut.adjustment(travel);
    // Angles are small numbers of a radian, lengths some hundred millimetres.
    let quantities = [
        ("x", w.x, m.x, b.x, 1e-12),
        ("y", w.y, m.y, b.y, 1e-12),
        ("toe", w.toe, m.toe, b.toe, 1e-15),
        ("camber", w.camber, m.camber, b.camber, 1e-15),
        (
            "strut_length",
            w.strut_length,
            m.strut_length,
            b.strut_length,
            1e-12,
        ),
    ];
    for (name, value, by, bends, tolerance) in quantities {
        check.near(name, value, number(&known["value"][name])?, tolerance);
        let pairs = [
            (by, number(&known["d_dz"][name])?),
            (bends, number(&known["d2_dz2"][name])?),
        ];
        check.all_near("  by travel, once and twice", pairs, tolerance);
    }
    let by_dimensions = [
        ("x", s.x, 1e-12),
        ("y", s.y, 1e-12),
        ("toe", s.toe, 1e-15),
        ("camber", s.camber, 1e-15),
    ];
    for (name, found, tolerance) in by_dimensions {
        let known = DIMENSIONS.map(|dimension| &known["sensitivity"][dimension][name]);
        let known = digits::all(known)?;
        let what = format!("{name} by all dimensions");
        check.all_near(&what, found.into_iter().zip(known), tolerance);
    }
    Ok(())
}
