//! The elliptic trammel with oblique guides; the example `trammel` has them at a right angle.

use crate::check::Check;
use std::error::Error;

include!("../../mechanisms/trammel.rs");

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let turn: Vec<f64> = (0..=360).map(|i| f64::from(i).to_radians()).collect();
    let mechanism = Trammel::default();
    println!("Guides at 60 degrees:");
    let guide = 60f64.to_radians();
    let oblique = Trammel { guide, ..mechanism }.assemble()?;
    let sliders = turn.iter().map(|&phi| {
        let up = -mechanism.rod * phi.sin() / guide.sin();
        (
            oblique.point(phi),
            up,
            up * guide.cos() + mechanism.rod * phi.cos(),
        )
    });
    let sliders: Vec<_> = sliders.collect();
    check.all_near(
        "second slider, mm",
        sliders.iter().map(|(p, up, _)| (p.up, *up)),
        1e-12,
    );
    check.all_near(
        "first slider, mm",
        sliders.iter().map(|(p, _, x)| (p.across, *x)),
        1e-12,
    );
    check.near(
        "margin = sin 60 deg",
        oblique.point(1.0).margin,
        guide.sin(),
        1e-14,
    );
    check.finish()
}
