//! A double wishbone by the travel of the wheel and the shift of the rack: two arms, a tie rod, and a wheel carrier as an unknown body.
//!
//! The wheel, its toe and camber with first and second derivatives by both inputs, and the sensitivities to rods and points, against solutions in
//! 80 digits.
//!
//! A page with the usual curves over the travel is in `target/double_wishbone`.

use crate::check::Check;
use crate::digits::number;
use crate::suspension;
use linkage::report::Report;
use serde_json::Value;
use std::error::Error;

include!("../../mechanisms/double_wishbone.rs");

/// The reference's names of the dimensions, in the order of the sensitivities.
const DIMENSIONS: [&str; 14] = [
    "Luf",
    "Lur",
    "Llf",
    "Llr",
    "Ltie",
    "upper_front.x",
    "upper_front.y",
    "upper_front.z",
    "upper_rear.x",
    "upper_rear.y",
    "upper_rear.z",
    "tie_inner.x",
    "tie_inner.y",
    "tie_inner.z",
];

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let wishbone = DoubleWishbone::default().assemble()?;
    println!("{}", DoubleWishbone::<f64>::STRUCTURE);
    check.near("share of the ranges served", wishbone.served(), 1.0, 1e-3);
    let references = serde_json::from_str(include_str!(
        "../../mechanisms/double_wishbone/reference.json"
    ))?;
    let references: Vec<Value> = references;
    check.holds("positions with all figures", references.len() == 25);
    let angles =
        serde_json::from_str(include_str!("../../mechanisms/double_wishbone/angles.json"))?;
    let angles: Vec<Value> = angles;
    check.holds("positions with angles", angles.len() == 60);
    for known in &references {
        compare(&mut check, &wishbone, known, &["x", "y", "toe", "camber"])?;
    }
    for known in &angles {
        compare(&mut check, &wishbone, known, &["toe", "camber"])?;
    }
    let travel = suspension::travels(&DoubleWishbone::<f64>::INPUTS[0]);
    let wheel = wishbone.wheel_sweep(&travel, &[0.0]);
    let lengths = [("x", wheel.x()), ("y", wheel.y())];
    suspension::write(&report()?, &lengths, "double_wishbone")?;
    check.finish()
}

/// The page: the rack in the middle.
pub(crate) fn report() -> Result<Report, Box<dyn Error>> {
    let wishbone = DoubleWishbone::default().assemble()?;
    let input = &DoubleWishbone::<f64>::INPUTS[0];
    let travel = suspension::travels(input);
    let about = "A wheel between two arms over its travel. x and y are where its centre is.";
    Ok(suspension::of("Double wishbone", about, input, &travel)
        .structure(DoubleWishbone::<f64>::STRUCTURE)
        .dimensions(wishbone.mechanism())
        .table(&wishbone.wheel_sweep(&travel, &[0.0]))
        .table(&wishbone.motion_sweep(&travel, &[0.0]))
        .table(&wishbone.picture_sweep(&travel, &[0.0])))
}

fn compare(
    check: &mut Check,
    wishbone: &DoubleWishboneAssembly,
    known: &Value,
    names: &[&str],
) -> Result<(), Box<dyn Error>> {
    let [travel, rack] = [number(&known["z"])?, number(&known["u"])?];
    println!("Travel {travel} mm, rack {rack} mm:");
    let (w, m) = (wishbone.wheel(travel, rack), wishbone.motion(travel, rack));
    let s = wishbone.adjustment(travel, rack);
    // Angles are small numbers of a radian, lengths some hundred millimetres.
    let quantities = [
        ("x", w.x, m.x, m.x_bends, s.x, 1e-12),
        ("y", w.y, m.y, m.y_bends, s.y, 1e-12),
        ("toe", w.toe, m.toe, m.toe_bends, s.toe, 2e-15),
        (
            "camber",
            w.camber,
            m.camber,
            m.camber_bends,
            s.camber,
            2e-15,
        ),
    ];
    let quantities = quantities.into_iter();
    for (name, value, by, bends, by_dimensions, tolerance) in
        quantities.filter(|own| names.contains(&own.0))
    {
        check.near(name, value, number(&known["value"][name])?, tolerance);
        let pairs = [
            (by[0], number(&known["d_dz"][name])?),
            (by[1], number(&known["d_du"][name])?),
            (bends[0][0], number(&known["d2_dz2"][name])?),
            (bends[0][1], number(&known["d2_dzdu"][name])?),
            (bends[1][1], number(&known["d2_du2"][name])?),
        ];
        check.all_near("  by travel and rack, once and twice", pairs, tolerance);
        let known = DIMENSIONS.map(|dimension| &known["sensitivity"][dimension][name]);
        let known = crate::digits::all(known)?;
        check.all_near(
            "  by all dimensions",
            by_dimensions.into_iter().zip(known),
            tolerance,
        );
    }
    Ok(())
}
