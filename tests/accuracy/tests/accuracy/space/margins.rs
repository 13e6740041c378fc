//! Margins by their meaning: the determinant of the loops over its largest value, from positions
//! that the programs themselves give.

use crate::space::points::three_distances;
use crate::space::{rssp, rssr};
use linkage_reference::{Form, Plan, Random, Variant};
use nalgebra::{Matrix3, Vector3};

/// Compares the margins of all forms with a function of geometry and values.
fn check(
    (forms, plan): (&[Form], &Plan),
    input: f64,
    expected: fn(&[f64], &[f64], f64) -> f64,
    seed: u64,
) {
    let mut random = Random::new(seed);
    let mut compared = 0;
    for _ in 0..100 {
        let geometry = (plan.geometry)(&mut random, 6.0);
        let variant = Variant {
            fused: false,
            flipped: random.chance(0.5),
        };
        for form in forms {
            let found = (form.assemble)(&geometry, variant).expect("closes")(input);
            let margin = expected(&geometry, &found.values, input);
            assert!(
                (found.margin - margin).abs() < 1e-13 / margin,
                "{}: {} {margin}",
                form.name,
                found.margin
            );
            assert!(margin > 0.0 && found.margin <= 1.0 + f64::EPSILON);
            compared += 1;
        }
    }
    assert_eq!(compared, 100 * forms.len());
}

/// The coupler's part along the rocker end's path.
#[test]
fn rssr_margin() {
    let expected = |g: &[f64], values: &[f64], phi: f64| {
        let [_, y, _] = rssr::frame_of(g[7], g[8]);
        let [x, _, axis] = rssr::frame_of(g[7], g[8]);
        let pin = g[0] * Vector3::new(phi.cos(), phi.sin(), 0.0);
        let end = Vector3::from_column_slice(&values[1..4]);
        let path = values[0].cos() * y - values[0].sin() * x;
        assert!(path.dot(&axis).abs() < 1e-15);
        (end - pin).dot(&path).abs() / g[1]
    };
    check(
        (rssr::FORMS, &rssr::PLAN),
        60f64.to_radians(),
        expected,
        321,
    );
}

/// The rod's part along the guide.
#[test]
fn rssp_margin() {
    let expected = |g: &[f64], values: &[f64], phi: f64| {
        let pin = g[0] * Vector3::new(phi.cos(), phi.sin(), 0.0);
        let guide = Vector3::from_column_slice(&g[5..8]).normalize();
        let slider = Vector3::from_column_slice(&values[1..4]);
        (slider - pin).dot(&guide).abs() / g[1]
    };
    check(
        (rssp::FORMS, &rssp::PLAN),
        60f64.to_radians(),
        expected,
        322,
    );
}

/// The volume that the legs' directions span.
#[test]
fn three_distances_margin() {
    let expected = |g: &[f64], values: &[f64], phi: f64| {
        let p = Vector3::from_column_slice(&values[..3]);
        let one = g[0] * Vector3::new(phi.cos(), 0.0, -phi.sin());
        let [two, three] = [1, 4].map(|k| Vector3::from_column_slice(&g[k..k + 3]));
        let legs = [one, two, three].map(|foot| (p - foot).normalize());
        Matrix3::from_columns(&legs).determinant().abs()
    };
    let set = (three_distances::FORMS, &three_distances::PLAN);
    check(set, 30f64.to_radians(), expected, 323);
}
