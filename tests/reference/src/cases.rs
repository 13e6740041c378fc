//! The cases every mechanism goes through.

use crate::{Big, Case, Kind, Random, System};
use core::f64::consts::TAU;

/// What to make cases of.
#[derive(Clone, Copy)]
pub struct Plan {
    /// A random geometry that closes at the reference input in the assembly mode of the mechanism
    /// as written, its lengths within the given ratio of each other.
    pub geometry: fn(&mut Random, f64) -> Vec<f64>,
    /// Data to change until a dead point is near, and the factor by which they may change.
    pub dead_points: &'static [(usize, f64)],
}

/// How many of so many geometries are tried: a third, since 154 digits take long, but three, so that both assembly modes are among them; for
/// `LINKAGE_LONG=0` all, for `LINKAGE_LONG=1` five times as many, ten times for `LINKAGE_LONG=2`.
pub fn tried(geometries: usize) -> usize {
    match times() {
        Some(times) => times * geometries,
        None => geometries.div_ceil(3).max(geometries.min(3)),
    }
}

/// How many positions must be compared at least, of so many that all geometries have.
pub(crate) fn wanted(positions: usize) -> usize {
    match times() {
        Some(_) => positions,
        // Not a third: of few geometries a larger part may not close.
        None => positions.div_ceil(4),
    }
}

/// How many times all geometries are tried, in long runs.
fn times() -> Option<usize> {
    let long = std::env::var("LINKAGE_LONG").ok()?;
    let times = long.parse::<usize>().ok()?;
    Some(if times == 0 { 1 } else { 5 * times })
}

/// Positions all over the cycle, of the mechanism as written and of random geometries.
pub fn cycle_cases(system: &System, plan: &Plan, geometries: usize, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let steps = linkage_random::one_in(3, 0..12);
    let inputs = steps
        .map(|k| input_at(system, f64::from(k) / 12.0))
        .collect();
    let mut cases = vec![Case::new(system.default_geometry(), inputs)];
    for _ in 0..tried(geometries) {
        let geometry = (plan.geometry)(&mut random, 6.0);
        let inputs = (0..4)
            .map(|_| input_at(system, random.between(-1.0, 2.0)))
            .collect();
        cases.push(Case::new(geometry, inputs));
    }
    cases
}

/// The input so many turns from the reference; a length grows by a quarter for each.
fn input_at(system: &System, turns: f64) -> f64 {
    let reference = system.reference_input();
    match system.data[system.input()].kind {
        Kind::Length => reference * (1.0 + turns / 4.0),
        _ => reference + TAU * turns,
    }
}

/// Geometries near a dead point at the reference input, at relative distances from 1e-1 to 1e-15, in
/// both assembly modes.
pub fn dead_point_cases(system: &System, plan: &Plan, geometries: usize, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let input = system.reference_input();
    let mut cases = Vec::new();
    for number in 0..tried(geometries) {
        let geometry = (plan.geometry)(&mut random, 4.0);
        for &(changed, factor) in plan.dead_points {
            for decade in (1..=15).skip(number % 2).step_by(2) {
                let distance = 10f64.powi(-decade);
                let near = approach(system, &geometry, input, changed, factor, distance);
                let case = near.map(|geometry| Case::new(geometry, vec![input]));
                cases.extend(case.map(|case| if number % 4 < 2 { case } else { case.flipped() }));
            }
        }
    }
    cases
}

/// Geometries with lengths in ratios up to 1e8.
pub fn proportion_cases(system: &System, plan: &Plan, geometries: usize, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let input = system.reference_input();
    let mut case = |_| {
        let geometry = (plan.geometry)(&mut random, 1e8);
        let near = input + random.ratio(1e-8, 1.0) * if input == 0.0 { 1.0 } else { input };
        Case::new(geometry, vec![input, near])
    };
    (0..tried(geometries)).map(&mut case).collect()
}

/// Random geometries of sizes from 1e-150 to 1e150, for mechanisms whose lengths are all
/// parameters.
pub fn scale_cases(system: &System, plan: &Plan, geometries: usize, seed: u64) -> Vec<Case> {
    scaled(system, plan, (6.0, [-150, -80, 60, 150]), geometries, seed)
}

/// The same from 1e-140 to 1e140, with lengths in ratios up to 1e8.
pub fn wide_scale_cases(system: &System, plan: &Plan, geometries: usize, seed: u64) -> Vec<Case> {
    scaled(system, plan, (1e8, [-140, -70, 70, 140]), geometries, seed)
}

fn scaled(
    system: &System,
    plan: &Plan,
    (spread, exponents): (f64, [i32; 4]),
    geometries: usize,
    seed: u64,
) -> Vec<Case> {
    let mut random = Random::new(seed);
    let mut cases = Vec::new();
    for _ in 0..tried(geometries) {
        let geometry = (plan.geometry)(&mut random, spread);
        let size = system.size(&geometry);
        for exponent in exponents {
            let inputs = vec![
                input_at(system, random.between(0.0, 1.0)),
                system.reference_input(),
            ];
            let geometry = rescaled(system, &geometry, 10f64.powi(exponent) / size);
            cases.push(Case::new(geometry, inputs));
        }
    }
    cases
}

/// Angles of the input up to a million radians, of the mechanism as written and of random
/// geometries.
pub fn far_input_cases(system: &System, plan: &Plan, geometries: usize, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let mut cases = vec![Case::new(system.default_geometry(), vec![1e6, -1e6, 1e5])];
    for _ in 0..tried(geometries) {
        let geometry = (plan.geometry)(&mut random, 6.0);
        let sign = if random.chance(0.5) { 1.0 } else { -1.0 };
        let far = sign * random.ratio(10.0, 1e6);
        cases.push(Case::new(
            geometry,
            vec![far, sign * random.between(0.9e6, 1e6)],
        ));
    }
    cases
}

/// Geometries that a function makes for distances from 1e-1 to 1e-15, at the reference input, in
/// both assembly modes.
pub fn decade_cases(
    system: &System,
    geometry: fn(&mut Random, f64) -> Vec<f64>,
    rounds: usize,
    seed: u64,
) -> Vec<Case> {
    let mut random = Random::new(seed);
    let mut cases = Vec::new();
    for round in 0..tried(rounds) {
        for decade in 1..=15 {
            let geometry = geometry(&mut random, 10f64.powi(-decade));
            let case = Case::new(geometry, vec![system.reference_input()]);
            let other = !system.linear && round % 2 == 1;
            cases.push(if other { case.flipped() } else { case });
        }
    }
    cases
}

/// The mechanism as written with every number changed by up to 3 %, at angles all over the cycle.
pub fn nearby_cases(system: &System, geometries: usize, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let mut case = |_| {
        let near = |x: f64| x * random.between(0.97, 1.03);
        let geometry = system.default_geometry().into_iter().map(near).collect();
        let inputs = (0..3).map(|_| random.angle()).collect();
        Case::new(geometry, inputs)
    };
    (0..tried(geometries)).map(&mut case).collect()
}

// Geometries that are hard on purpose.

/// The geometry with every length multiplied by `factor`.
pub fn rescaled(system: &System, geometry: &[f64], factor: f64) -> Vec<f64> {
    let one = |(datum, &x): (&crate::Datum, &f64)| {
        if datum.kind == Kind::Length {
            x * factor
        } else {
            x
        }
    };
    system.data.iter().zip(geometry).map(one).collect()
}

/// The geometry with one number changed so that its gap at the given input is as near to `gap` as
/// `f64` allows.
///
/// The number is searched between its value and `factor` times its value; `None` if the gap is not
/// reached there.
pub fn approach(
    system: &System,
    geometry: &[f64],
    input: f64,
    changed: usize,
    factor: f64,
    gap: f64,
) -> Option<Vec<f64>> {
    let at = |x: f64| {
        let mut data: Vec<Big> = geometry
            .iter()
            .chain([&input])
            .map(|&x| Big::from(x))
            .collect();
        data[changed] = Big::from(x);
        (system.gap_at(&data) - gap).is_negative()
    };
    let (mut above, mut below) = (geometry[changed], geometry[changed] * factor);
    if at(above) || !at(below) {
        return None;
    }
    for _ in 0..70 {
        let middle = above + (below - above) * 0.5;
        if at(middle) {
            below = middle
        } else {
            above = middle
        }
    }
    let mut result = geometry.to_vec();
    result[changed] = above;
    Some(result)
}
