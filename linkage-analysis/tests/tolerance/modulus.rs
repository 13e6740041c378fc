//! The worst case by modulus against all choices of signs.

use super::{near, ones};
use linkage_random::Random;

fn length(v: [f64; 3]) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}

/// The longest sum by trying all signs.
fn by_enumeration(vectors: &[[f64; 3]]) -> f64 {
    let sum = |signs: u32| {
        let mut sum = [0.0; 3];
        for (i, v) in vectors.iter().enumerate() {
            let sign = if signs >> i & 1 == 1 { -1.0 } else { 1.0 };
            for (total, x) in sum.iter_mut().zip(v) {
                *total += sign * x;
            }
        }
        length(sum)
    };
    (0..1 << vectors.len()).map(sum).fold(0.0, f64::max)
}

fn check_plane<const N: usize>(vectors: [[f64; 2]; N]) {
    let known = by_enumeration(&vectors.map(|[x, y]| [x, y, 0.0]));
    let effects = ones::<N>().effects(&vectors);
    near(effects.worst_modulus(), known, 1e-13 * known);
    let (vector, signs) = effects.worst_vector();
    near(vector[0].hypot(vector[1]), known, 1e-13 * known);
    for k in 0..2 {
        let sum: f64 = vectors.iter().zip(signs).map(|(v, sign)| sign * v[k]).sum();
        near(sum, vector[k], 1e-13 * known);
    }
    let parts = effects.contributions();
    if known > 0.0 {
        near(
            parts.iter().map(|p| p.share_of_worst_case).sum(),
            1.0,
            1e-12,
        );
        near(parts.iter().map(|p| p.share_of_variance).sum(), 1.0, 1e-12);
    }
}

fn check_space<const N: usize>(vectors: [[f64; 3]; N]) {
    let known = by_enumeration(&vectors);
    near(
        ones::<N>().effects(&vectors).worst_modulus(),
        known,
        1e-13 * known,
    );
}

fn plane<const N: usize>(random: &mut Random) -> [[f64; 2]; N] {
    std::array::from_fn(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)])
}

fn space<const N: usize>(random: &mut Random) -> [[f64; 3]; N] {
    std::array::from_fn(|_| std::array::from_fn(|_| random.between(-1.0, 1.0)))
}

#[test]
fn in_the_plane() {
    let mut random = Random::new(1);
    for _ in 0..200 {
        check_plane::<1>(plane(&mut random));
        check_plane::<2>(plane(&mut random));
        check_plane::<5>(plane(&mut random));
    }
    for _ in 0..10 {
        check_plane::<12>(plane(&mut random));
    }
}

#[test]
fn in_space() {
    let mut random = Random::new(2);
    for _ in 0..100 {
        check_space::<1>(space(&mut random));
        check_space::<3>(space(&mut random));
        check_space::<6>(space(&mut random));
    }
    for _ in 0..3 {
        check_space::<12>(space(&mut random));
    }
}

/// Whole numbers from -2 to 2: equal, opposite, parallel and missing vectors, and many in one plane.
#[test]
fn special_positions() {
    let mut random = Random::new(3);
    let mut whole = || random.between(-2.5, 2.5).round();
    for _ in 0..300 {
        check_plane::<8>(std::array::from_fn(|_| [whole(), whole()]));
        check_plane::<6>(std::array::from_fn(|_| [whole(), 0.0]));
        check_space::<7>(std::array::from_fn(|_| std::array::from_fn(|_| whole())));
        check_space::<6>(std::array::from_fn(|_| {
            let (a, b) = (whole(), whole());
            [a + b, a - b, 3.0 * a]
        }));
        check_space::<5>(std::array::from_fn(|_| {
            [1.0, -2.0, 3.0].map(|x| x * whole())
        }));
    }
    check_plane([[0.0, 0.0]; 3]);
}

#[test]
fn any_scale() {
    for scale in [1e-150, 1e-9, 1e9, 1e150] {
        let effects = ones::<3>().effects(&[[3.0 * scale, 0.0], [0.0, -4.0 * scale], [0.0, 0.0]]);
        near(effects.worst_modulus(), 5.0 * scale, 1e-14 * scale);
        near(
            effects.root_sum_square_modulus(),
            5.0 * scale,
            1e-14 * scale,
        );
    }
}

#[test]
fn scalars() {
    let effects = ones::<3>().effects(&[1.0, -3.0, 0.5]);
    assert_eq!(effects.worst_case(), [4.5]);
    assert_eq!(effects.worst_modulus(), 4.5);
    assert_eq!(effects.algebraic_sum(), [-1.5]);
    near(effects.root_sum_square()[0], 10.25_f64.sqrt(), 1e-15);
}

#[test]
fn what_is_not_assembled_is_nan() {
    let effects = ones::<2>().effects(&[[1.0, f64::NAN], [2.0, 1.0]]);
    assert!(effects.worst_modulus().is_nan() && effects.root_sum_square_modulus().is_nan());
    assert_eq!(effects.worst_case()[0], 3.0);
    assert!(effects.worst_case()[1].is_nan() && effects.algebraic_sum()[1].is_nan());
    let infinite = ones::<1>().effects(&[f64::INFINITY]);
    assert!(infinite.worst_modulus().is_nan());
}

/// Long lists stay cheap.
#[test]
fn three_hundred_vectors() {
    let mut random = Random::new(4);
    let parameters = [super::lengths::<1>()[0]; 300];
    let tolerances =
        linkage_analysis::tolerance::Tolerances::declared(&parameters).expect("they are valid");
    let vectors: [[f64; 2]; 300] = plane(&mut random);
    let worst = tolerances.effects(&vectors).worst_modulus();
    // The zonotope's width in a direction is a lower bound; over many directions it is close.
    let width = |i: i32| -> f64 {
        let (sin, cos) = (f64::from(i) * 1e-3).sin_cos();
        vectors
            .iter()
            .map(|v| (v[0] * cos + v[1] * sin).abs())
            .sum()
    };
    let widest = (0..3142).map(width).fold(0.0, f64::max);
    assert!(
        worst >= widest && worst <= widest * (1.0 + 1e-6),
        "{worst} {widest}"
    );
}
