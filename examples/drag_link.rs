//! Drag link: both cranks make whole turns, and half of the driven angle drives a second dyad.
//!
//! The driven crank's angle counts its turns with the input. Without that, half of it would jump by
//! 180 degrees, and the second dyad with it.

mod check;

use check::Check;
use std::error::Error;

include!("../mechanisms/drag_link.rs");

/// Input, driven crank and rocker in degrees, followed in small steps with 40 digits.
const KNOWN: [(f64, f64, f64); 7] = [
    (0.0, 46.567463442210, 66.570027447185),
    (120.0, 179.166679671131, 90.393356548471),
    (240.0, 266.962452167159, 103.722931368788),
    (360.0, 406.567463442210, 92.339094755118),
    (480.0, 539.166679671131, 64.676245556672),
    (600.0, 626.962452167159, 57.618072872171),
    (720.0, 766.567463442210, 66.570027447185),
];

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let linkage = DragLink::default().assemble()?;
    println!("{}", DragLink::STRUCTURE);

    println!("Two turns of the input:");
    for (phi, psi, swing) in KNOWN {
        let angles = linkage.angles(phi.to_radians());
        check.near(
            &format!("driven at {phi} deg"),
            angles.psi.to_degrees(),
            psi,
            1e-9,
        );
        check.near(
            &format!("rocker at {phi} deg"),
            angles.swing.to_degrees(),
            swing,
            1e-9,
        );
    }

    println!("In steps of a tenth of a degree:");
    let inputs: Vec<f64> = (0..=7200)
        .map(|i| (f64::from(i) / 10.0).to_radians())
        .collect();
    let angles: Vec<DragAngles> = inputs.iter().map(|&phi| linkage.angles(phi)).collect();
    let steps = |f: fn(&DragAngles) -> f64| angles.windows(2).map(move |w| f(&w[1]) - f(&w[0]));
    let forward = steps(|a| a.psi).all(|step| step > 0.0 && step < 0.01);
    check.holds("the driven angle always grows, without a jump", forward);
    let smooth = steps(|a| a.swing).all(|step| step.abs() < 0.01);
    check.holds("the rocker's angle has no jump", smooth);
    let turns = (angles[7200].psi - angles[0].psi) / std::f64::consts::TAU;
    check.near("turns of the driven crank", turns, 2.0, 1e-13);
    let margin = inputs
        .iter()
        .map(|&phi| linkage.rates(phi).margin)
        .fold(1.0, f64::min);
    println!("       smallest margin {margin:.6}");
    check.holds("no dead point: the margin stays above 0.48", margin > 0.48);

    // The trapezoidal rule is exact to rounding for a smooth periodic function.
    println!("Mean speed ratios over two turns:");
    let rates = inputs[..7200].iter().map(|&phi| linkage.rates(phi));
    let (driven, rocker) = rates.fold((0.0, 0.0), |(d, r), m| (d + m.driven, r + m.rocker));
    check.near("driven crank", driven / 7200.0, 1.0, 1e-12);
    check.near("rocker", rocker / 7200.0, 0.0, 1e-12);
    check.finish()
}
