//! Geared five-bar: one crank turns twice as fast as the other, and their phase can be set.
//!
//! The phase is a second input, so that the coupler point is a function of two variables and has
//! two first and three second derivatives.

mod check;

use check::Check;
use std::error::Error;

include!("../mechanisms/geared_five_bar.rs");

fn main() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let mechanism = GearedFiveBar::default();
    let linkage = mechanism.assemble()?;
    println!("{}", GearedFiveBar::STRUCTURE);
    check.holds(
        "two degrees of freedom",
        GearedFiveBar::STRUCTURE.mobility == 2,
    );

    println!("At phi = 70, phase = 25 degrees:");
    let (phi, phase) = (70f64.to_radians(), 25f64.to_radians());
    let m = linkage.motion(phi, phase);
    let (x, y) = (|v: [f64; 2]| v[0], |v: [f64; 2]| v[1]);
    for (name, value, known) in [
        ("point, mm", m.point, [76.732715851032, 88.865801375255]),
        ("d/dphi", m.v[0], [36.755092835630, -60.890406720016]),
        ("d/dphase", m.v[1], [30.622597082348, -33.548379496750]),
        ("d2/dphi2", m.a[0][0], [-188.907579296230, 14.571612618458]),
        (
            "d2/dphi dphase",
            m.a[0][1],
            [-56.533577734894, -10.183862477803],
        ),
        (
            "d2/dphase dphi",
            m.a[1][0],
            [-56.533577734894, -10.183862477803],
        ),
        (
            "d2/dphase2",
            m.a[1][1],
            [-18.860460931408, -13.342270332526],
        ),
    ] {
        check.near(&format!("{name}, x"), value.x, x(known), 1e-9);
        check.near(&format!("{name}, y"), value.y, y(known), 1e-9);
    }
    check.near("alpha, deg", m.alpha.to_degrees(), 42.389490086662, 1e-10);
    check.near("d2 alpha/dphi dphase", m.mixed, 0.339905342303, 1e-11);

    println!("Over the whole range of both inputs:");
    let grid =
        (0..=72).flat_map(|i| (-6..=6).map(move |j| (5.0 * f64::from(i), 10.0 * f64::from(j))));
    let grid: Vec<(f64, f64)> = grid
        .map(|(phi, phase)| (phi.to_radians(), phase.to_radians()))
        .collect();
    let rods = grid.iter().flat_map(|&(phi, phase)| {
        let p = linkage.points(phi, phase);
        [
            ((p.point - p.pin_1).norm(), mechanism.rod_1),
            ((p.point - p.pin_2).norm(), mechanism.rod_2),
        ]
    });
    check.all_near("the rods keep their lengths, mm", rods, 1e-12);

    check.finish()
}
