//! Spatial slider-crank: a crank drives a slide on an oblique line through a rod with two ball joints.
//!
//! The loop is a distance that is kept (RSSP): a quadratic equation for the slide.

mod check;

use check::Check;
use linkage::tolerance::Tolerances;
use std::error::Error;

include!("../mechanisms/spatial_slider_crank.rs");

/// Crank angle in degrees, slide in mm, both derivatives: from a solution in 60 digits.
const KNOWN: [(f64, f64, f64, f64); 4] = [
    (
        0.0,
        115.05202940607874,
        24.648009806863556,
        -33.86894713594242,
    ),
    (
        60.0,
        118.46791544582747,
        -19.011381013579534,
        -38.76961819304232,
    ),
    (
        140.0,
        71.27652607253079,
        -34.857172732481494,
        16.76170319517362,
    ),
    (
        275.0,
        63.56617456075617,
        29.98244658033903,
        22.471602769126477,
    ),
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let linkage = SpatialSlider::default().assemble()?;
    println!("{}", SpatialSlider::STRUCTURE);

    for (degrees, s, v, a) in KNOWN {
        println!("At {degrees} degrees:");
        let m = linkage.stroke(degrees.to_radians());
        check.near("slide, mm", m.s, s, 1e-12);
        check.near("ds/dphi, mm", m.v, v, 1e-12);
        check.near("d2s/dphi2, mm", m.a, a, 1e-11);
    }
    println!("Over a turn:");
    let turn: Vec<f64> = (0..360).map(|i| f64::from(i).to_radians()).collect();
    let lengths = turn.iter().map(|&phi| {
        let Joints { pin, slide } = linkage.joints(phi);
        ((slide - pin).norm(), 150.0)
    });
    check.all_near("the rod keeps its length, mm", lengths, 1e-12);
    let margins = turn.iter().map(|&phi| linkage.stroke(phi).margin);
    let smallest = margins.fold(1.0, f64::min);
    check.holds("no dead point", smallest > 0.5);

    println!("Both assemblies at 60 degrees, where the rod reaches the line:");
    let phi = 60_f64.to_radians();
    let assemblies = SpatialSlider::default().assemblies_at(phi)?;
    check.holds("two of them", assemblies.len() == 2);
    for assembly in &assemblies {
        println!("       slide {:.6} mm", assembly.stroke(phi).s);
    }

    println!("Effects of the tolerances on the slide at 60 degrees:");
    let tolerances = Tolerances::complete(SpatialSlider::PARAMETERS)?;
    let accuracy = linkage.accuracy(phi);
    print!("{}", tolerances.effects(&accuracy.e));
    // Euler: the slide grows with all lengths.
    let parameters = SpatialSlider::PARAMETERS.iter().zip(accuracy.e);
    let lengths = parameters.filter(|(parameter, _)| parameter.unit == "mm");
    let sum: f64 = lengths.map(|(parameter, e)| parameter.nominal * e).sum();
    check.near("sum of r ds/dr, mm", sum, accuracy.s, 1e-12);
    check.finish()
}
