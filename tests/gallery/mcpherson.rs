//! A McPherson strut by the travel of the wheel: a lower arm, a tie rod, and a damper whose axis is fixed on the wheel carrier and goes through
//! the top mount.
//!
//! The wheel, its toe and camber and the length of the strut with first and second derivatives, and the sensitivities to rods and points, against
//! solutions in 80 digits.
//!
//! A page with the usual curves over the travel is in `target/mcpherson`.

use crate::check::Check;
use crate::digits::number;
use crate::suspension;
use linkage::report::Report;
use serde_json::Value;
use std::error::Error;

include!("../../mechanisms/mcpherson.rs");

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

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let strut = McPherson::default().assemble()?;
    println!("{}", McPherson::<f64>::STRUCTURE);
    let references: Vec<Value> =
        serde_json::from_str(include_str!("../../mechanisms/mcpherson/reference.json"))?;
    check.holds("all positions", references.len() == 17);
    for known in &references {
        compare(&mut check, &strut, known)?;
    }
    let travel = suspension::travels(&McPherson::<f64>::INPUTS[0]);
    let wheel = strut.wheel_sweep(&travel);
    let lengths = [
        ("x", wheel.x()),
        ("y", wheel.y()),
        ("strut", wheel.strut_length()),
    ];
    suspension::write(&report()?, &lengths, "mcpherson")?;
    check.finish()
}

/// The page, which computes, too.
pub(crate) fn report() -> Result<Report, Box<dyn Error>> {
    let strut = McPherson::default().assemble()?;
    let input = &McPherson::<f64>::INPUTS[0];
    let travel = suspension::travels(input);
    let about = "A wheel on an arm, a tie rod and a strut over its travel. x and y are where its centre is.";
    Ok(suspension::of("McPherson strut", about, input, &travel)
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
        let known = crate::digits::all(known)?;
        let what = format!("{name} by all dimensions");
        check.all_near(&what, found.into_iter().zip(known), tolerance);
    }
    Ok(())
}
