//! Five path problems of the literature: the four-bar whose coupler point comes nearest to given points.
//!
//! Each search finds the least sum of squares that is known, or less. The crank turns fully and passes the points in
//! their order, which a construction with a pair of compasses confirms.

mod problems;

use crate::check::Check;
use linkage::design::{FoundDesign, Timing};
use problems::{Problem, problems};
use std::error::Error;
use std::f64::consts::TAU;

include!("../../mechanisms/four_bar_paths.rs");

/// A sum of squares of lengths of some ten millimetres that is zero but for rounding.
const ZERO: f64 = 1e-24;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    for problem in problems() {
        // A line that is written anew until the search is done.
        let found = problem
            .design()?
            .starts(problem.few)
            .progress(|progress| eprint!("\r{progress}"))
            .run()?;
        eprintln!();
        let best = found.best();
        println!(
            "{}: {} designs from {} starts",
            problem.name,
            found.designs.len(),
            found.starts
        );
        print!("{best}");
        for parameter in best.parameters() {
            println!(
                "    {:<8} {:>12.6} {}",
                parameter.name, parameter.nominal, parameter.unit
            );
        }
        compare(&mut check, &problem, best)?;
    }
    check.finish()
}

/// What is claimed of a design, found in other ways.
fn compare(
    check: &mut Check,
    problem: &Problem,
    design: &FoundDesign<FourBar, FourBarAssembly>,
) -> Result<(), Box<dyn Error>> {
    let known = problem.known;
    let least = design.sum <= (known * (1.0 + 1e-9)).max(ZERO);
    check.holds(
        &format!(
            "the sum {:.9e} is not above the known one, {known:.9e}",
            design.sum
        ),
        least,
    );

    let m = design.mechanism;
    let inputs = &design.inputs[0];
    let sums = [1.0, -1.0].map(|side| {
        let squares = inputs.iter().zip(problem.points).map(|(&phi, point)| {
            let [x, y] = by_hand(&m, phi, side);
            (x - point[0]).powi(2) + (y - point[1]).powi(2)
        });
        squares.sum::<f64>()
    });
    // All points with the coupler on one side: they are on one circuit.
    let nearer = sums[0].min(sums[1]);
    check.near(
        "the sum with a pair of compasses",
        nearer.sqrt(),
        design.sum.sqrt(),
        1e-11,
    );

    let others = [m.frame, m.coupler, m.rocker];
    let longest = others.iter().copied().fold(0.0, f64::max);
    let turns = others.iter().all(|other| m.crank < *other)
        && 2.0 * (m.crank + longest) < m.crank + others.iter().sum::<f64>();
    check.holds("Grashof: the crank turns fully", turns);
    let closed = m
        .circuits()?
        .whole()
        .any(|branch| branch.closed && branch.margin > 0.0);
    check.holds("an assembly runs through the turn", closed);
    if problem.timing == Timing::InOrder {
        let in_order = inputs.windows(2).all(|pair| pair[0] <= pair[1]);
        let last = inputs[inputs.len() - 1] - inputs[0];
        check.holds(
            "the points are passed in their order in one turn",
            in_order && last < TAU + 1e-9,
        );
    }
    let bounds = [m.frame, m.crank, m.coupler, m.rocker]
        .iter()
        .all(|l| (problem.lengths[0]..=problem.lengths[1]).contains(l))
        && [m.arm.x, m.arm.y].iter().all(|a| a.abs() <= problem.arm)
        && [m.base.x, m.base.y].iter().all(|b| b.abs() <= problem.base);
    check.holds("all bounds are kept", bounds);
    Ok(())
}

/// The coupler point by intersecting circles, with the joint of coupler and rocker on one side or the other.
fn by_hand(m: &FourBar, phi: f64, side: f64) -> [f64; 2] {
    let at = |angle: f64, length: f64| [length * angle.cos(), length * angle.sin()];
    let [cx, cy] = at(phi + m.tilt, m.crank);
    let [fx, fy] = at(m.tilt, m.frame);
    let (dx, dy) = (fx - cx, fy - cy);
    let square = dx * dx + dy * dy;
    let along = (square + m.coupler.powi(2) - m.rocker.powi(2)) / (2.0 * square);
    let across = side * (m.coupler.powi(2) / square - along * along).sqrt();
    // The unit vector along the coupler.
    let [ux, uy] = [along * dx - across * dy, along * dy + across * dx].map(|x| x / m.coupler);
    let [x, y] = [m.arm.x * ux - m.arm.y * uy, m.arm.x * uy + m.arm.y * ux];
    [m.base.x + cx + x, m.base.y + cy + y]
}
