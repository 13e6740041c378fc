//! Contact forces against a plain iteration, and joints that jam.

use linkage_random::Random;
use linkage_symbolic::program::Source;
use linkage_symbolic::{Graph, evaluate};

use super::*;

/// The sizes for forces of two components, or of one: for each joint the force without friction,
/// then the shares.
fn solved(joints: &[Vec<Vec<f64>>]) -> Vec<f64> {
    let graph = Graph::new();
    let mut values = Vec::new();
    let mut vector = |numbers: &Vec<f64>| {
        let components = numbers.iter().map(|&number| {
            values.push(number);
            graph.source(Source::Input(values.len() - 1))
        });
        graph.components(&components.collect::<Vec<_>>())
    };
    let surfaces: Vec<Vec<Surface>> = joints
        .iter()
        .map(|vectors| {
            let vectors: Vec<Vn> = vectors.iter().map(&mut vector).collect();
            vec![Surface {
                start: vectors[0],
                shares: vectors[1..].to_vec(),
            }]
        })
        .collect();
    evaluate(&certified(&graph, &surfaces), |source| match source {
        Source::Input(index) => values[index],
        _ => f64::NAN,
    })
}

fn size(numbers: &[f64]) -> f64 {
    numbers.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn sizes_are_those_of_a_plain_iteration() {
    let mut random = Random::new(0xf1);
    for count in [1, 2, 3, 5] {
        for case in 0..40 {
            let components = 1 + (case + count) % 2;
            let mut vector = |size: f64| -> Vec<f64> {
                (0..components)
                    .map(|_| random.between(-size, size))
                    .collect()
            };
            // Each contact force causes friction of up to a third of it, in sum.
            let share = 0.33 / count as f64 / (components as f64).sqrt();
            let joints: Vec<Vec<Vec<f64>>> = (0..count)
                .map(|_| {
                    let shares = (0..count).map(|_| share);
                    std::iter::once(1.0)
                        .chain(shares)
                        .map(&mut vector)
                        .collect()
                })
                .collect();
            let mut expected = vec![0.0; count];
            for _ in 0..100 {
                let force = |vectors: &Vec<Vec<f64>>| {
                    let mut sum = vectors[0].clone();
                    for (share, size) in vectors[1..].iter().zip(&expected) {
                        sum.iter_mut().zip(share).for_each(|(x, y)| *x += y * size);
                    }
                    size(&sum)
                };
                expected = joints.iter().map(force).collect();
            }
            let found = solved(&joints);
            for (found, expected) in found.iter().zip(&expected) {
                assert!(
                    (found - expected).abs() < 1e-13 * (1.0 + expected),
                    "{found} {expected}"
                );
            }
        }
    }
}

#[test]
fn a_guide_jams_at_the_coefficient_one() {
    // The force pushes with 3, and its friction pulls or presses further.
    for share in [-5.0, -0.9, 0.5, 0.999] {
        let found = solved(&[vec![vec![3.0], vec![share]]]);
        assert!((found[0] - 3.0 / (1.0 - share)).abs() < 1e-11, "{found:?}");
    }
    assert!(solved(&[vec![vec![3.0], vec![1.0]]])[0].is_nan());
    assert!(solved(&[vec![vec![3.0], vec![1.5]]])[0].is_nan());
    // A pin as well.
    let pin = |share: f64| solved(&[vec![vec![3.0, 0.0], vec![share, 0.1]]])[0];
    assert!(pin(0.6).is_finite() && pin(1.1).is_nan());
    // Two that cause each other.
    let pair = |share: f64| {
        let first = vec![vec![1.0], vec![0.0], vec![share]];
        solved(&[first, vec![vec![2.0], vec![share], vec![0.0]]])
    };
    assert!((pair(0.5)[0] - 8.0 / 3.0).abs() < 1e-14);
    assert!(pair(1.01).iter().all(|size| size.is_nan()));
    // The second jams by itself. The steps end at sizes that do not follow from small friction.
    let held = [[0.8, -0.4, -0.5], [0.6, -1.2, 1.1]];
    let held = held.map(|numbers| numbers.map(|x| vec![x]).to_vec());
    assert!(solved(&held).iter().all(|size| size.is_nan()));
}

#[test]
fn no_force_has_no_friction() {
    assert_eq!(solved(&[vec![vec![0.0, 0.0], vec![0.2, 0.1]]]), [0.0]);
    assert_eq!(solved(&[vec![vec![0.0], vec![0.2]]]), [0.0]);
}
