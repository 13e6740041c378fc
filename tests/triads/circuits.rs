//! `circuits()`: every assembly is there, a turning point ends two of them, and both belong to one circuit.

use crate::kinds::{self, Kind};
use crate::legs::poses;
use linkage::{Branch, BranchEnd, Circuits};
use linkage_random::Random;
use std::f64::consts::TAU;

/// Mechanisms of all kinds together.
const MECHANISMS: usize = 60;

/// Ends that are one turning point agree to this part of the range.
const TOGETHER: f64 = 1e-9;

/// Inputs at which assemblies are counted in another way.
const COUNTED: usize = 25;

/// Nearer to an end than this, in radians, assemblies are not counted.
pub(crate) const BESIDE: f64 = 1e-3;

/// How many mechanisms are looked at.
fn mechanisms() -> usize {
    match crate::effort() {
        1 => MECHANISMS,
        more => 3 * MECHANISMS * more,
    }
}

/// A ternary link farther out than this, in mm, is not looked at: guides are parallel to some 1e-5 there, and assemblies ten thousand times
/// as far out as links are long come in pieces with lost ends.
const FAR: f64 = 1e6;

/// What is wrong with the circuits of some mechanisms.
#[derive(Debug, Default)]
struct Faults {
    mechanisms: usize,
    refused: usize,
    ends: usize,
    alone: usize,
    lost: usize,
    counted: usize,
    miscounted: usize,
}

/// Input, side and circuit of every turning point.
pub(crate) fn turning<A>(circuits: &Circuits<A>) -> Vec<(f64, usize, usize)> {
    let branches = circuits.branches.iter();
    let ends = branches.flat_map(|branch| {
        let ends = branch.ends.into_iter().enumerate();
        ends.filter_map(|(side, end)| match end {
            BranchEnd::TurningPoint(x) => Some((x, side, branch.circuit)),
            _ => None,
        })
    });
    ends.collect()
}

/// How many ends at turning points have no partner in their circuit. Where other groups are assembled in several ways, several pairs end
/// together.
pub(crate) fn alone(turning: &[(f64, usize, usize)]) -> usize {
    let ends = turning.iter().enumerate();
    let alone = ends.filter(|&(one, &(x, side, circuit))| {
        let others = turning.iter().enumerate();
        let partners = others.filter(|&(other, &(y, of, number))| {
            let here = (x - y).abs() <= TOGETHER * TAU;
            other != one && here && of == side && number == circuit
        });
        partners.count() % 2 != 1
    });
    alone.count()
}

pub(crate) fn covers<A>(branch: &Branch<A>, phi: f64) -> bool {
    let [low, high] = branch.ends.map(BranchEnd::x);
    low <= phi && phi <= high
}

/// Whether slides run off to where guides are almost parallel, and the mechanism is none.
fn is_endless(kind: &Kind, dimensions: &kinds::Dimensions) -> bool {
    let at = (0..COUNTED).map(|row| TAU * row as f64 / COUNTED as f64);
    let known: Vec<_> = at
        .filter_map(|phi| poses(&kind.legs(dimensions, phi)))
        .collect();
    // So far out poses cannot be told apart from none, anywhere.
    known.is_empty()
        || known
            .iter()
            .flatten()
            .any(|pose| pose.x.hypot(pose.y) > FAR)
}

fn look(
    kind: &'static Kind,
    dimensions: &kinds::Dimensions,
    random: &mut Random,
    faults: &mut Faults,
) {
    faults.mechanisms += 1;
    let circuits = match kind.circuits(dimensions) {
        Ok(circuits) => circuits,
        Err(why) => {
            println!("{}: {dimensions:?}\n    {why}", kind.name);
            faults.refused += 1;
            return;
        }
    };
    let before = (faults.alone, faults.lost, faults.miscounted);
    let turning = turning(&circuits);
    let lost = circuits.branches.iter().flat_map(|branch| branch.ends);
    faults.lost += lost.filter(|end| matches!(end, BranchEnd::Lost(_))).count();
    faults.ends += turning.len();
    faults.alone += alone(&turning);
    for _ in 0..COUNTED {
        let phi = random.between(0.0, TAU);
        let ends = circuits.branches.iter().flat_map(|branch| branch.ends);
        let beside = ends.map(BranchEnd::x).any(|x| (x - phi).abs() < BESIDE);
        let (false, Some(poses)) = (beside, poses(&kind.legs(dimensions, phi))) else {
            continue;
        };
        let here = circuits
            .branches
            .iter()
            .filter(|branch| covers(branch, phi));
        faults.counted += 1;
        faults.miscounted += usize::from(here.count() != poses.len());
    }
    if before != (faults.alone, faults.lost, faults.miscounted) {
        println!("{}: {dimensions:?}\n{circuits}", kind.name);
    }
}

fn run(mechanisms: usize) -> Faults {
    let mut random = Random::new(16);
    let mut faults = Faults::default();
    let kinds = kinds::KINDS.iter().cycle();
    for (number, kind) in kinds.take(mechanisms).enumerate() {
        let part = [0.05, 0.2, 0.5][number / kinds::KINDS.len() % 3];
        let dimensions = random.near(kind.dimensions(), part);
        if is_endless(kind, &dimensions) {
            continue;
        }
        look(kind, &dimensions, &mut random, &mut faults);
    }
    println!("{faults:?}");
    faults
}

#[test]
fn a_turning_point_ends_two_assemblies() {
    let faults = run(mechanisms());
    let Faults {
        refused,
        alone,
        lost,
        miscounted,
        ..
    } = faults;
    assert_eq!((refused, alone, lost, miscounted), (0, 0, 0, 0));
}
