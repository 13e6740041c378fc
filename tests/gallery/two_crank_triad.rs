//! Straight-line drive with two counter-rotating cranks: a triad with a slider.
//!
//! The cranks 1-2 and 7-6 turn against each other. Their couplers 2-3 and 6-4 hold a ternary link 3-4-5,
//! whose point 5 slides on a straight guide: legs RR, RR and PR on one link, class III. The working
//! point 8 belongs to the slider.
//!
//! The publication states how well point 8 keeps to its straight line: 3e-8 nm. That is the rounding of
//! one sum, since the guide is straight in any position. An error along the guide, or a position of
//! another assembly, does not show in it: both are printed beside it.

use crate::check::Check;
use linkage::{BranchEnd, Vector2};
use std::error::Error;
use std::f64::consts::TAU;

include!("../../mechanisms/two_crank_triad.rs");

/// The straight line, in mm: the guide stands upright at x = 28, and point 8 lies 40 from point 5 at 120 degrees.
const LINE: f64 = 8.0;
/// A nanometre in mm.
const NANOMETRE: f64 = 1e-6;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let linkage = TwoCranks::default().assemble()?;
    println!("{}", TwoCranks::STRUCTURE);

    let mut check = Check::default();
    println!("As published, every 0.5 degrees:");
    let deviation = straightness(&linkage);
    println!(
        "  straight-line deviation of point 8: {:.1e} nm",
        deviation / NANOMETRE
    );
    check.near(
        "in 1e-8 nm (published: 3)",
        deviation / NANOMETRE * 1e8,
        0.0,
        3.0,
    );

    println!("\nWhat that figure cannot see:");
    compare(&linkage, &references(), &mut check);
    compare_assemblies(&linkage, &mut check)?;
    check.finish()
}

/// The largest distance of point 8 from its line over the cycle, in mm.
fn straightness(linkage: &TwoCranksAssembly) -> f64 {
    let angles: Vec<f64> = (0..720).map(|i| TAU * f64::from(i) / 720.0).collect();
    let columns = linkage.working_point_sweep(&angles);
    let [x, _] = columns.p8();
    largest(x.iter().map(|x| x - LINE))
}

/// The largest magnitude; NaN if there is one.
fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let more = |most: f64, x: f64| {
        if most.is_nan() || x.abs() <= most {
            most
        } else {
            x.abs()
        }
    };
    numbers.into_iter().fold(0.0, more)
}

fn compare(linkage: &TwoCranksAssembly, references: &[Reference], check: &mut Check) {
    let found: Vec<Motion> = references.iter().map(|r| linkage.motion(r.phi)).collect();
    let pairs = || found.iter().zip(references);
    let along = largest(pairs().map(|(m, r)| (m.s - r.s[0]) - r.s[1]));
    let above = largest(pairs().map(|(m, r)| m.p8.y - (r.s[0] + 40.0 * 120f64.to_radians().sin())));
    let points = pairs().flat_map(|(m, r)| [m.p3 - r.p3, m.p4 - r.p4]);
    let points = largest(points.map(|miss| miss.norm()));
    check.holds("133 positions of the whole cycle", references.len() == 133);
    let nanometres = |x: f64| x / NANOMETRE * 1e8;
    check.near(
        "along the guide, slide, in 1e-8 nm",
        nanometres(along),
        0.0,
        15.0,
    );
    check.near("along the guide, point 8", nanometres(above), 0.0, 15.0);
    check.near(
        "of the assembly, points 3 and 4",
        nanometres(points),
        0.0,
        15.0,
    );

    type Rate = (&'static str, fn(&Motion) -> f64, fn(&Reference) -> f64);
    let rates: [Rate; 5] = [
        ("velocity of the slide", |m| m.ds, |r| r.rates[0]),
        ("acceleration of the slide", |m| m.dds, |r| r.rates[1]),
        ("angle of the ternary link", |m| m.phi34, |r| r.phi34),
        ("its velocity", |m| m.dphi34, |r| r.rates[2]),
        ("its acceleration", |m| m.ddphi34, |r| r.rates[3]),
    ];
    for (what, of, known) in rates {
        let error = largest(pairs().map(|(m, r)| of(m) - known(r)));
        let size = largest(references.iter().map(known));
        check.near(
            &format!("{what}, in 1e-12 of its maximum"),
            1e12 * error / size,
            0.0,
            1.0,
        );
    }
}

/// Every other assembly keeps to the straight line just as well, and is somewhere else.
fn compare_assemblies(
    linkage: &TwoCranksAssembly,
    check: &mut Check,
) -> Result<(), Box<dyn Error>> {
    for (degrees, number) in [(0.0_f64, 4), (178.0, 4), (179.0, 6), (277.0, 6), (278.0, 4)] {
        let phi = degrees.to_radians();
        let found = linkage.mechanism().assemblies_at(phi)?;
        let straight = |other: &TwoCranksAssembly| other.working_point(phi).p8.x - LINE;
        let off = largest(found.iter().map(straight)) / NANOMETRE;
        let slide = |other: &TwoCranksAssembly| other.motion(phi).s - linkage.motion(phi).s;
        let wrong: Vec<f64> = found.iter().map(slide).collect();
        let farthest = largest(wrong.iter().copied());
        println!(
            "  at {degrees} degrees: off the line by {off:.1e} nm, along the guide by {farthest:.0} mm"
        );
        check.holds(&format!("{number} assemblies"), found.len() == number);
        check.holds("all of them straight to 1e-7 nm", off < 1e-7);
    }
    let circuits = linkage.mechanism().circuits()?;
    println!("\n{circuits}");
    let whole = circuits
        .branches
        .iter()
        .filter(|branch| branch.is_whole() && branch.closed);
    check.holds("three run through the whole cycle", whole.count() == 3);
    // From a solution in 40 digits.
    let known = [178.281_494_131_002_46, 277.643_514_578_648_53];
    let ends = circuits.branches.iter().flat_map(|branch| branch.ends);
    let turning: Vec<f64> = ends
        .filter(|end| matches!(end, BranchEnd::TurningPoint(_)))
        .map(|end| end.x().to_degrees())
        .collect();
    check.holds(
        "two assemblies meet at either turning point",
        turning.len() == 4,
    );
    for end in turning {
        let nearest = if end < 230.0 { known[0] } else { known[1] };
        check.near(
            "turning point, degrees",
            end,
            nearest,
            1e-9_f64.to_degrees(),
        );
    }
    Ok(())
}

/// One position, from a solution in 60 digits.
struct Reference {
    phi: f64,
    /// The slide, and what its double misses.
    s: [f64; 2],
    /// Derivatives of the slide and of the ternary link's angle: first, second of each.
    rates: [f64; 4],
    p3: Vector2<f64>,
    p4: Vector2<f64>,
    phi34: f64,
}

/// The references; a line that cannot be read becomes NaN and fails its comparisons.
fn references() -> Vec<Reference> {
    let lines = include_str!("../../mechanisms/two_crank_triad/reference.csv").lines();
    let read = |line: &str| {
        let numbers: Vec<f64> = line
            .split(',')
            .map(|cell| cell.parse().unwrap_or(f64::NAN))
            .collect();
        let at = |i: usize| numbers.get(i).copied().unwrap_or(f64::NAN);
        Reference {
            phi: at(0),
            s: [at(1), at(2)],
            rates: [at(3), at(4), at(10), at(11)],
            p3: Vector2::new(at(5), at(6)),
            p4: Vector2::new(at(7), at(8)),
            phi34: at(9),
        }
    };
    lines
        .filter(|line| !line.starts_with('#'))
        .map(read)
        .collect()
}
