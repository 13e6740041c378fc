//! Derivatives of the geared five-bar by differences, and by its lengths; the example `geared_five_bar` has values.

use crate::check::Check;
use std::error::Error;

include!("../../mechanisms/geared_five_bar.rs");

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let linkage = GearedFiveBar::default().assemble()?;
    let (phi, phase) = (70f64.to_radians(), 25f64.to_radians());
    println!("Over the whole range of both inputs:");
    let grid =
        (0..=72).flat_map(|i| (-6..=6).map(move |j| (5.0 * f64::from(i), 10.0 * f64::from(j))));
    let grid: Vec<(f64, f64)> = grid
        .map(|(phi, phase)| (phi.to_radians(), phase.to_radians()))
        .collect();
    // Central differences of the velocities, against the second derivatives.
    let h = 1e-5;
    let second = grid.iter().flat_map(|&(phi, phase)| {
        let a = linkage.motion(phi, phase).a;
        let v = |dphi: f64, dphase: f64| linkage.motion(phi + dphi, phase + dphase).v;
        let by_phi = (v(h, 0.0)[1] - v(-h, 0.0)[1]) / (2.0 * h);
        let by_phase = (v(0.0, h)[1] - v(0.0, -h)[1]) / (2.0 * h);
        [
            (a[0][1].x, by_phi.x),
            (a[0][1].y, by_phi.y),
            (a[1][1].x, by_phase.x),
            (a[1][1].y, by_phase.y),
        ]
    });
    check.all_near("mixed and phase derivatives", second, 1e-5);

    println!("Euler's identity for the lengths:");
    let accuracy = linkage.accuracy(phi, phase);
    let lengths = GearedFiveBar::PARAMETERS.iter().map(|p| p.nominal);
    check.near(
        "beta, deg",
        accuracy.beta.to_degrees(),
        75.779324820318,
        1e-10,
    );
    check.near(
        "sum of r dbeta/dr",
        lengths.zip(accuracy.e).map(|(r, s)| r * s).sum(),
        0.0,
        1e-12,
    );
    check.finish()
}
