//! Two drives with nothing but slides to find: the elliptic trammel and the Scotch yoke.
//!
//! A rod whose ends run on two guides draws an ellipse with each of its points. The yoke turns a
//! crank into an exact harmonic motion, `x = crank cos phi`.

use crate::check::Check;
use std::error::Error;

include!("../../mechanisms/trammel.rs");

fn turn() -> Vec<f64> {
    (0..=360).map(|i| f64::from(i).to_radians()).collect()
}

#[test]
fn guides_at_a_right_angle_draw_ellipses() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let turn = turn();
    let mechanism = Trammel::default();
    let linkage = mechanism.assemble()?;
    // Half axes: the tracer's distances from the two sliders.
    let (a, b) = (mechanism.arm, mechanism.arm - mechanism.rod);
    let points: Vec<TrammelPoint> = turn.iter().map(|&phi| linkage.point(phi)).collect();
    let on_ellipse = points
        .iter()
        .map(|p| ((p.tracer.x / a).powi(2) + (p.tracer.y / b).powi(2), 1.0));
    check.all_near("(x/160)^2 + (y/60)^2 = 1", on_ellipse, 1e-14);
    check.all_near(
        "x = 160 cos phi",
        points
            .iter()
            .zip(&turn)
            .map(|(p, phi)| (p.tracer.x, a * phi.cos())),
        1e-12,
    );
    check.all_near(
        "guides at right angles: margin 1",
        points.iter().map(|p| (p.margin, 1.0)),
        1e-15,
    );
    check.finish()
}

#[test]
fn a_yoke_is_harmonic() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = ScotchYoke::default();
    let linkage = mechanism.assemble()?;
    let r = mechanism.crank;
    let yoke: Vec<(Yoke, f64, f64)> = turn()
        .iter()
        .map(|phi| (linkage.yoke(*phi), phi.sin(), phi.cos()))
        .collect();
    check.all_near(
        "x = r cos phi",
        yoke.iter().map(|(y, _, c)| (y.x, r * c)),
        1e-13,
    );
    check.all_near(
        "dx/dphi = -r sin phi",
        yoke.iter().map(|(y, s, _)| (y.v, -r * s)),
        1e-13,
    );
    check.all_near(
        "d2x/dphi2 = -r cos phi",
        yoke.iter().map(|(y, _, c)| (y.a, -r * c)),
        1e-13,
    );
    check.all_near(
        "d3x/dphi3 = r sin phi",
        yoke.iter().map(|(y, s, _)| (y.j, r * s)),
        1e-13,
    );
    let accuracy = linkage.accuracy(0.7);
    check.near("dx/dr = cos 0.7", accuracy.dx, 0.764842187284, 1e-11);
    check.near(
        "d2x/(dphi dr) = -sin 0.7",
        accuracy.dv,
        -0.644217687238,
        1e-11,
    );
    check.finish()
}

#[test]
fn oblique_guides() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let turn = turn();
    let mechanism = Trammel::default();
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
