//! Coupled groups: triads of several kinds, a closed contour of four links, two platforms on a pin.
//!
//! Errors are multiples of what one roundoff in the data does, as everywhere; a group of four or six
//! unknowns adds up more roundings than a dyad.

mod contour;
pub(crate) mod drive;
mod eye_needle;
mod platforms;
mod triads;
mod two_cranks;

use linkage_reference::{Case, Kind, Limits, Random, System, rescaled, tried};

const LIMITS: Limits = Limits {
    condition: 10.0,
    value: 5.0,
    margin: 5.0,
    first: 10.0,
    second: 10.0,
    third: 10.0,
};

/// The mechanism as written all over the cycle, and with all dimensions changed by up to a part of
/// themselves.
fn cases(system: &System, part: f64, geometries: usize, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let turn = |k: i32| system.reference_input() + f64::from(k) * std::f64::consts::TAU / 12.0;
    let written = Case::new(system.default_geometry(), (0..12).map(turn).collect());
    let changed = (0..tried(geometries)).map(|_| {
        let near = |x: f64| x * random.between(1.0 - part, 1.0 + part);
        let geometry = system.default_geometry().into_iter().map(near).collect();
        Case::new(
            geometry,
            (0..3)
                .map(|_| random.between(0.0, std::f64::consts::TAU))
                .collect(),
        )
    });
    [written]
        .into_iter()
        .chain(changed.collect::<Vec<_>>())
        .collect()
}

/// The mechanism, slightly changed, in sizes from 1e-150 to 1e150.
fn sizes(system: &System, part: f64, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let mut cases = Vec::new();
    for exponent in [-150, -100, -50, -20, 20, 50, 100, 150] {
        let near = |x: f64| x * random.between(1.0 - part, 1.0 + part);
        let geometry: Vec<f64> = system.default_geometry().into_iter().map(near).collect();
        let scale = 10f64.powi(exponent) / system.size(&geometry);
        let inputs = vec![
            random.between(0.0, std::f64::consts::TAU),
            system.reference_input(),
        ];
        cases.push(Case::new(rescaled(system, &geometry, scale), inputs));
    }
    assert!(system.data.iter().any(|datum| datum.kind == Kind::Length));
    cases
}
