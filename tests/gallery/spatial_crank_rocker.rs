//! Spatial crank-rocker with an arbitrarily tilted rocker: one crank, a coupler with two ball joints (RSSR).
//!
//! It is written in turns about axes, a distance that is kept, and a frame on the coupler whose z axis has given angles to
//! the coupler and to the pin of the crank. Everything is compared with a solution in 60 digits, a second linkage
//! with published figures; with parallel axes that one is the four-bar of the plane, to the last digits.

use crate::check::Check;
use linkage::Vector3;
use std::error::Error;

include!("../../mechanisms/spatial_crank_rocker.rs");

/// Derivatives by the 13 dimensions.
const DIMENSIONS: usize = SpatialCrankRocker::PARAMETERS.len();

type Outcome = Result<(), Box<dyn Error>>;

#[test]
fn known_answers_are_met() -> Outcome {
    let mut check = Check::default();
    let linkage = SpatialCrankRocker::default().assemble()?;
    println!("{}", SpatialCrankRocker::STRUCTURE);
    print_tool(&linkage);
    println!("Against the solution in 60 digits, 24 positions:");
    compare(&mut check, &linkage, &references());
    println!("The coupler's frame over a turn:");
    pose(&mut check, &linkage);
    println!("Published figures:");
    figures(&mut check)?;
    println!("Parallel axes, against the four-bar of the plane:");
    parallel(&mut check)?;
    check.finish()
}

fn print_tool(linkage: &SpatialCrankRockerAssembly) {
    println!("Tool point and rocker:");
    println!("  phi, deg      x, mm      y, mm      z, mm   psi, deg     margin");
    for degrees in (0..360).step_by(30).map(f64::from) {
        let phi = degrees.to_radians();
        let Motion { psi, tip, .. } = linkage.motion(phi);
        let margin = linkage.pose(phi).margin;
        println!(
            "  {degrees:8.0} {:10.4} {:10.4} {:10.4} {:10.4} {margin:10.4}",
            tip.x,
            tip.y,
            tip.z,
            psi.to_degrees()
        );
    }
}

fn compare(check: &mut Check, linkage: &SpatialCrankRockerAssembly, references: &[Reference]) {
    let found: Vec<Motion> = references.iter().map(|r| linkage.motion(r.phi)).collect();
    let rows = || found.iter().zip(references);
    check.holds("24 positions are known", references.len() == 24);
    check.all_near("rocker, rad", rows().map(|(m, r)| (m.psi, r.psi[0])), 4e-15);
    check.all_near(
        "its first derivative",
        rows().map(|(m, r)| (m.dpsi, r.psi[1])),
        1e-15,
    );
    check.all_near(
        "its second derivative",
        rows().map(|(m, r)| (m.ddpsi, r.psi[2])),
        1e-14,
    );
    type Rate = (&'static str, fn(&Motion) -> Vector3<f64>, f64);
    let rates: [Rate; 3] = [
        ("tool, mm", |m| m.tip, 1e-13),
        ("its first derivative", |m| m.v, 1e-13),
        ("its second derivative", |m| m.a, 1e-12),
    ];
    for (order, (what, of, tolerance)) in rates.into_iter().enumerate() {
        let misses = rows().map(|(m, r)| ((of(m) - r.tool[order]).norm(), 0.0));
        check.all_near(what, misses, tolerance);
    }
    let accuracy: Vec<Accuracy> = references.iter().map(|r| linkage.accuracy(r.phi)).collect();
    for (i, parameter) in SpatialCrankRocker::PARAMETERS.iter().enumerate() {
        let rows = accuracy.iter().zip(references);
        let misses = rows.map(|(found, r)| ((found.e[i] - r.dimensions[i]).norm(), 0.0));
        let lever = if parameter.unit == "rad" { 100.0 } else { 1.0 };
        check.all_near(
            &format!("derivative by {}", parameter.name),
            misses,
            2e-15 * lever,
        );
    }
    // Euler: points grow with all lengths.
    let sums = accuracy.iter().map(|found| {
        let all = SpatialCrankRocker::PARAMETERS.iter().zip(&found.e);
        let lengths = all.filter(|(parameter, _)| parameter.unit == "mm");
        let sum: Vector3<f64> = lengths.map(|(parameter, e)| e * parameter.nominal).sum();
        ((sum - found.tip).norm(), 0.0)
    });
    check.all_near("sum of r d tool / d r - tool, mm", sums, 1e-12);
}

/// The frame is a rotation, and the tool point stands still in it.
fn pose(check: &mut Check, linkage: &SpatialCrankRockerAssembly) {
    let poses: Vec<(Pose, f64)> = (0..360)
        .map(|i| f64::from(i).to_radians())
        .map(|phi| (linkage.pose(phi), phi))
        .collect();
    let lengths = poses.iter().map(|(p, _)| ((p.p3 - p.p2).norm(), 130.0));
    check.all_near("coupler, mm", lengths, 1e-13);
    let levers = poses.iter().map(|(p, _)| {
        let arm = p.p3 - Vector3::new(110.0, 30.0, -50.0);
        (arm.dot(&p.axis), 0.0)
    });
    check.all_near("the rocker stays at a right angle, mm", levers, 1e-13);
    let along = poses.iter().map(|(p, _)| {
        let x = p.coupler.x;
        (
            (x - (p.p3 - p.p2) / 130.0).norm() + p.coupler.z.x.abs(),
            0.0,
        )
    });
    check.all_near("x along the coupler, z across the pin", along, 1e-14);
    let tool = Vector3::new(90.0, 15.0, -25.0);
    let carried = poses.iter().map(|(p, phi)| {
        let isometry = p.coupler.isometry();
        let known = linkage.motion(*phi).tip;
        let point = isometry.rotation * tool + isometry.translation.vector;
        ((point - known).norm(), 0.0)
    });
    check.all_near("the isometry carries the tool point, mm", carried, 1e-12);
    let smallest = poses.iter().map(|(p, _)| p.margin).fold(1.0, f64::min);
    println!("       smallest margin {smallest:.4}");
    check.holds("no dead point", smallest > 0.5);
}

/// One position of the tool, from the solution in 60 digits.
struct Reference {
    phi: f64,
    psi: [f64; 3],
    /// Position, first and second derivative.
    tool: [Vector3<f64>; 3],
    dimensions: [Vector3<f64>; DIMENSIONS],
}

/// The references; a line that cannot be read becomes NaN and fails its comparisons.
fn references() -> Vec<Reference> {
    let lines = include_str!("../../mechanisms/spatial_crank_rocker/reference.csv").lines();
    let read = |line: &str| {
        let cells = line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN));
        let numbers: Vec<f64> = cells.collect();
        let at = |i: usize| numbers.get(i).copied().unwrap_or(f64::NAN);
        let vector = |i: usize| Vector3::new(at(i), at(i + 1), at(i + 2));
        Reference {
            phi: at(0),
            psi: [at(1), at(2), at(3)],
            tool: std::array::from_fn(|k| vector(4 + 3 * k)),
            dimensions: std::array::from_fn(|i| vector(13 + 3 * i)),
        }
    };
    lines
        .filter(|line| !line.starts_with('#'))
        .map(read)
        .collect()
}

// A spatial crank-rocker with published figures, and the four-bar that it is with parallel axes.

include!("../../mechanisms/spatial_crank_rocker_published.rs");

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
fn figures(check: &mut Check) -> Result<(), Box<dyn Error>> {
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
fn parallel(check: &mut Check) -> Result<(), Box<dyn Error>> {
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
