//! Random programs: the result meets the conditions that only the minimum of a convex program
//! meets.

use super::{Face, Quadratic};
use linkage_random::Random;
use std::vec;
use std::vec::Vec;

/// A positive definite matrix of any condition up to some thousands, and a gradient.
fn program(random: &mut Random, n: usize) -> (Vec<f64>, Vec<f64>) {
    let root: Vec<f64> = (0..n * n).map(|_| random.between(-1.0, 1.0)).collect();
    let mut gram = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..n {
            gram[i * n + j] = (0..n).map(|k| root[i * n + k] * root[j * n + k]).sum();
        }
        gram[i * n + i] += 1e-2;
    }
    let gradient = (0..n).map(|_| random.between(-2.0, 2.0)).collect();
    (gram, gradient)
}

/// Bounds of all variables and some rows; the origin is within all of them.
fn faces(random: &mut Random, n: usize) -> Vec<Face> {
    let mut faces = Vec::new();
    for j in 0..n {
        for a in [1.0, -1.0] {
            let slack = random.between(0.0, 1.0);
            faces.push(Face {
                normal: vec![(j, a)],
                slack,
                equality: false,
            });
        }
    }
    for _ in 0..random.below(n + 1) {
        let normal = (0..n).map(|j| (j, random.between(-1.0, 1.0))).collect();
        let slack = random.between(0.0, 0.3);
        faces.push(Face {
            normal,
            slack,
            equality: false,
        });
    }
    if n > 2 && random.chance(0.5) {
        let normal = (0..n).map(|j| (j, random.between(-1.0, 1.0))).collect();
        faces.push(Face {
            normal,
            slack: 0.0,
            equality: true,
        });
    }
    faces
}

#[test]
fn minima_meet_the_conditions_of_a_minimum() {
    let mut random = Random::new(1);
    let mut solver = Quadratic::default();
    let mut active = 0;
    for _ in 0..2000 {
        let n = 1 + random.below(8);
        let (gram, gradient) = program(&mut random, n);
        let faces = faces(&mut random, n);
        assert!(
            solver.solve(&gram, &gradient, &faces),
            "the origin is within"
        );
        active += solver.active.len();
        for face in &faces {
            let value = face.value(&solver.d);
            assert!(value > -1e-11, "outside by {value}");
            assert!(
                !face.equality || value < 1e-11,
                "beside the plane by {value}"
            );
        }
        // The gradient is made of the normals of active faces, which are touched, and push inwards.
        let mut left: Vec<f64> = (0..n)
            .map(|i| gradient[i] + (0..n).map(|j| gram[i * n + j] * solver.d[j]).sum::<f64>())
            .collect();
        for (&k, &multiplier) in solver.active.iter().zip(&solver.multipliers) {
            assert!(faces[k].value(&solver.d).abs() < 1e-11);
            assert!(faces[k].equality || multiplier >= -1e-12, "{multiplier}");
            if !faces[k].equality {
                faces[k]
                    .normal
                    .iter()
                    .for_each(|&(j, a)| left[j] -= multiplier * a);
            }
        }
        // The rest is along the normal of the equality.
        let plane: Vec<f64> = match faces.iter().find(|face| face.equality) {
            Some(face) => face.normal.iter().map(|&(_, a)| a).collect(),
            None => vec![0.0; n],
        };
        let size: f64 = plane.iter().map(|a| a * a).sum();
        let along: f64 = left.iter().zip(&plane).map(|(l, a)| l * a).sum();
        for (l, a) in left.iter().zip(&plane) {
            let rest = if size > 0.0 { l - along / size * a } else { *l };
            assert!(rest.abs() < 1e-9, "{rest} of {left:?}");
        }
    }
    assert!(active > 2000, "most programs have active faces: {active}");
}

#[test]
fn faces_that_leave_nothing_are_told() {
    let above = Face {
        normal: vec![(0, 1.0), (1, 1.0)],
        slack: -2.0,
        equality: false,
    };
    let below = Face {
        normal: vec![(0, -1.0), (1, -1.0)],
        slack: 1.0,
        equality: false,
    };
    let gram = [1.0, 0.0, 0.0, 1.0];
    let mut solver = Quadratic::default();
    assert!(!solver.solve(&gram, &[0.0, 0.0], &[above.clone(), below]));
    assert!(solver.solve(&gram, &[0.0, 0.0], &[above]));
    assert!((solver.d[0] - 1.0).abs() < 1e-14 && (solver.d[1] - 1.0).abs() < 1e-14);
    assert!(
        !solver.solve(&[1.0, 0.0, 2.0, 1.0], &[0.0, 0.0], &[]),
        "it is not definite"
    );
}

#[test]
fn an_equality_that_others_imply_is_no_contradiction() {
    let plane = |slack| Face {
        normal: vec![(0, 1.0)],
        slack,
        equality: true,
    };
    let gram = [1.0, 0.0, 0.0, 1.0];
    let mut solver = Quadratic::default();
    assert!(solver.solve(&gram, &[1.0, 1.0], &[plane(-1.0), plane(-1.0)]));
    assert!((solver.d[0] - 1.0).abs() < 1e-14);
    assert!(!solver.solve(&gram, &[1.0, 1.0], &[plane(-1.0), plane(-2.0)]));
}
