//! The boom on a cylinder by the law of cosines, and its sensitivities; the example `hydraulic_cylinder` has positions.

use crate::check::Check;
use std::error::Error;

include!("../../mechanisms/hydraulic_cylinder.rs");

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = Boom::default();
    let linkage = mechanism.assemble()?;
    println!("Law of cosines, over the stroke:");
    let side = mechanism.foot.norm();
    let angles = (0..=60).map(|i| {
        let stroke = 0.01 * f64::from(i);
        let length = mechanism.closed + stroke;
        let opening =
            (side * side + mechanism.arm.powi(2) - length * length) / (2.0 * side * mechanism.arm);
        let foot = mechanism.foot.y.atan2(mechanism.foot.x);
        (linkage.position(stroke).lift, foot + opening.acos())
    });
    check.all_near("boom, rad", angles, 1e-13);

    println!("Dimensions at stroke 0.3 m:");
    let accuracy = linkage.accuracy(0.3);
    for (parameter, s) in Boom::PARAMETERS.iter().zip(accuracy.e) {
        println!(
            "       {:<8} {s:>10.5} rad/{}",
            parameter.name, parameter.unit
        );
    }
    // The stroke adds to the closed length; it is a length, too, and so takes part in Euler's sum.
    let dclosed = accuracy.e[Boom::INDEX_CLOSED];
    check.near(
        "d lift/d closed - d lift/d stroke",
        dclosed - accuracy.dstroke,
        0.0,
        1e-13,
    );
    let shares = Boom::PARAMETERS
        .iter()
        .zip(accuracy.e)
        .filter(|(p, _)| p.unit == "m");
    let sum: f64 = shares.map(|(p, s)| p.nominal * s).sum();
    check.near(
        "sum of r d lift/d r",
        sum + 0.3 * accuracy.dstroke,
        0.0,
        1e-13,
    );
    check.finish()
}
