//! A spatial crank-rocker with published figures, and the four-bar that it is with parallel axes.

use crate::check::Check;
use linkage::Vector3;
use std::error::Error;

include!("../../../mechanisms/spatial_crank_rocker_published.rs");

/// Driver, rocker in degrees, its derivatives: both modes.
const PUBLISHED: [[(f64, f64, f64, f64); 2]; 2] = [
    [
        (
            60.0,
            76.040_485_446_35,
            0.358_059_692_624_9,
            0.745_059_650_552,
        ),
        (
            200.0,
            149.885_110_534_3,
            0.202_534_735_093_3,
            -0.479_806_988_609,
        ),
    ],
    [
        (
            60.0,
            -67.830_383_556_07,
            -0.933_594_152_784_3,
            0.472_932_088_408,
        ),
        (
            200.0,
            -98.543_485_235_32,
            0.405_731_134_557_4,
            0.367_678_291_596,
        ),
    ],
];

/// Both assemblies against the figures.
pub(super) fn figures(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let found = Published::default().assemblies()?;
    check.holds("two assemblies", found.len() == 2);
    for (linkage, rows) in found.iter().zip(PUBLISHED) {
        for (theta, psi, v, a) in rows {
            let m = linkage.rocker(theta.to_radians());
            let what = |of: &str| format!("{of} at {theta} deg");
            check.near(&what("psi, deg,"), m.psi.to_degrees(), psi, 1e-10);
            check.near(&what("psi'"), m.v, v, 1e-13);
            check.near(&what("psi\""), m.a, a, 1e-12);
        }
    }
    Ok(())
}

/// A planar four-bar written in space, and in the plane.
pub(super) fn parallel(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let centre = Vector3::new(4.0, 1.0, 0.0);
    let space = Published {
        tilt: 0.0,
        centre,
        ..Published::default()
    }
    .assemble()?;
    let plane = Flat::default().assemble()?;
    let thetas = (0..360).map(|i| f64::from(i).to_radians());
    let rows: Vec<(Rocker, FlatRocker)> = thetas
        .map(|theta| (space.rocker(theta), plane.rocker(theta)))
        .collect();
    check.all_near("psi, rad", rows.iter().map(|(s, p)| (s.psi, p.psi)), 2e-15);
    check.all_near("psi'", rows.iter().map(|(s, p)| (s.v, p.v)), 2e-15);
    check.all_near("psi\"", rows.iter().map(|(s, p)| (s.a, p.a)), 1e-14);
    Ok(())
}
