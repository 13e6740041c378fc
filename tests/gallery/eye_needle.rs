//! Eye-needle drive of a warp-knitting machine: a six-bar whose links cannot be computed one after the
//! other.
//!
//! The crank 1-2 moves the ternary link 3-4-5 through the coupler 2-3; the rockers 6-4 and 7-5 hold
//! it. These three legs on one link are a triad, a group of class III: two loops
//! whose four angles must be solved together. The needle 7-8 is part of the rocker 7-5. It dwells for a third of the
//! cycle, while the dyad behind its rocker passes a toggle twice: a solution by dyads, with another link
//! as the driver, would be singular there.
//!
//! Everything is compared with a solution in 60 digits.

use crate::check::Check;
use linkage::summary::{Curve, minimise};
use std::error::Error;
use std::f64::consts::TAU;

include!("../../mechanisms/eye_needle.rs");

/// Derivatives by the 13 dimensions.
const DIMENSIONS: usize = EyeNeedle::PARAMETERS.len();

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let linkage = EyeNeedle::default().assemble()?;
    println!("{}", EyeNeedle::STRUCTURE);
    print_needle(&linkage);

    let mut check = Check::default();
    println!("\nAgainst the solution in 60 digits:");
    compare(&linkage, &references(), &mut check);
    println!("\nThe dwell:");
    compare_dwell(&linkage, &mut check)?;
    println!("\nAll assemblies:");
    compare_assemblies(&linkage, &mut check)?;
    check.finish()
}

fn print_needle(linkage: &EyeNeedleAssembly) {
    println!("Needle point:");
    println!(
        "  phi, deg      x, mm      y, mm   x', mm/rad  y', mm/rad  x\", mm/rad2  y\", mm/rad2"
    );
    for degrees in (0..=360).step_by(15).map(f64::from) {
        let Motion { p8, v, a } = linkage.motion(degrees.to_radians());
        println!(
            "  {degrees:8.0} {:10.4} {:10.4} {:12.5} {:11.5} {:12.5} {:12.5}",
            p8.x, p8.y, v.x, v.y, a.x, a.y
        );
    }
}

/// The largest error and the largest value of a quantity, over all positions and both components.
#[derive(Clone, Copy, Default)]
struct Errors {
    error: f64,
    largest: f64,
}

impl Errors {
    fn add(&mut self, value: f64, known: f64) {
        let error = (value - known).abs();
        // Not `f64::max`, which would let a NaN pass.
        if error.is_nan() || error > self.error {
            self.error = error;
        }
        self.largest = self.largest.max(known.abs());
    }

    fn relative(&self) -> f64 {
        self.error / self.largest
    }
}

fn compare(linkage: &EyeNeedleAssembly, references: &[Reference], check: &mut Check) {
    let mut position = Errors::default();
    let mut rates = [Errors::default(); 2];
    let mut dimensions = [Errors::default(); DIMENSIONS];
    for r in references {
        let (found, needle) = (linkage.accuracy(r.phi), linkage.needle(r.phi));
        for k in 0..2 {
            for p8 in [found.p8, needle.p8] {
                position.add((p8[k] - r.position[k]) - r.beyond[k], 0.0);
            }
            rates[0].add(found.v[k], r.first[k]);
            rates[1].add(found.a[k], r.second[k]);
            for (i, errors) in dimensions.iter_mut().enumerate() {
                errors.add(found.e[i][k], r.dimensions[i][k]);
            }
        }
    }
    let [first, second] = rates.map(|rate| rate.relative());
    check.holds("141 positions of the whole cycle", references.len() == 141);
    check.near(
        "position, error in 1e-13 mm",
        1e13 * position.error,
        0.0,
        1.5,
    );
    check.near(
        "first derivative, in 1e-12 of its maximum",
        1e12 * first,
        0.0,
        1.0,
    );
    check.near("second derivative", 1e12 * second, 0.0, 1.0);
    for (parameter, errors) in EyeNeedle::PARAMETERS.iter().zip(dimensions) {
        let what = format!("derivative by {}", parameter.name);
        check.near(&what, 1e12 * errors.relative(), 0.0, 1.0);
    }
}

/// The longest part of the cycle in which the needle stays within 0.2 mm of its arc.
fn compare_dwell(linkage: &EyeNeedleAssembly, check: &mut Check) -> Result<(), Box<dyn Error>> {
    let radius = linkage.mechanism().l78;
    let arc = Curve::new((0.0, TAU), 360, |phi| {
        let Rocker { phi75, v, a } = linkage.rocker(phi);
        [phi75, v, a].map(|angle| radius * angle)
    })?;
    print!("{}", arc.describe("mm", "rad"));
    let dwell = arc.longest_dwell(0.2).ok_or("no dwell")?;
    let degrees = dwell.interval.range.to_degrees();
    check.near("degrees of the crank for 0.2 mm", degrees, 116.0, 1.0);

    let smallest = minimise((0.0, TAU), 360, |phi| linkage.posture(phi).margin)?;
    println!("  smallest margin of the cycle: {:.3}", smallest.value);
    let clear = smallest.value > 0.1 && smallest.missing == 0;
    check.holds("no position of the cycle is near singular", clear);
    Ok(())
}

/// How many ways there are to put the links together, and how far each of them reaches.
fn compare_assemblies(
    linkage: &EyeNeedleAssembly,
    check: &mut Check,
) -> Result<(), Box<dyn Error>> {
    let circuits = linkage.mechanism().circuits()?;
    println!("{circuits}");
    let (whole, others): (Vec<_>, Vec<_>) = circuits
        .branches
        .iter()
        .partition(|branch| branch.is_whole());
    let closed = whole.iter().all(|branch| branch.closed);
    check.holds(
        "two run through the whole cycle",
        whole.len() == 2 && closed,
    );
    let apart =
        whole.first().map(|branch| branch.circuit) != whole.last().map(|branch| branch.circuit);
    check.holds("neither reaches the other", apart);
    check.holds("two more meet at two turning points", others.len() == 2);
    for branch in others {
        // From a solution in 40 digits.
        for (end, known) in branch
            .ends
            .iter()
            .zip([34.219_206_596_774_63, 57.443_932_699_239_71])
        {
            check.near(
                "turning point, degrees",
                end.x().to_degrees(),
                known,
                1e-9_f64.to_degrees(),
            );
        }
    }
    let mut right = true;
    for degrees in (0..360).step_by(15).map(f64::from) {
        let found = linkage.mechanism().assemblies_at(degrees.to_radians())?;
        right &= found.len() == if degrees == 45.0 { 4 } else { 2 };
    }
    check.holds("four at 45 degrees, two at 0, 15, 30, 60, ...", right);
    Ok(())
}

/// One position, to more digits than a double has.
struct Reference {
    phi: f64,
    position: [f64; 2],
    /// What `position` misses.
    beyond: [f64; 2],
    first: [f64; 2],
    second: [f64; 2],
    dimensions: [[f64; 2]; DIMENSIONS],
}

/// The references; a line that cannot be read becomes NaN and fails its comparisons.
fn references() -> Vec<Reference> {
    let lines = include_str!("../../mechanisms/eye_needle/reference.csv").lines();
    let read = |line: &str| {
        let numbers: Vec<f64> = line
            .split(',')
            .map(|cell| cell.parse().unwrap_or(f64::NAN))
            .collect();
        let at = |i: usize| numbers.get(i).copied().unwrap_or(f64::NAN);
        let pair = |i: usize| [at(i), at(i + 1)];
        Reference {
            phi: at(0),
            position: [at(1), at(3)],
            beyond: [at(2), at(4)],
            first: pair(5),
            second: pair(7),
            dimensions: std::array::from_fn(|i| pair(9 + 2 * i)),
        }
    };
    lines
        .filter(|line| !line.starts_with('#'))
        .map(read)
        .collect()
}
