//! Laws between two values.

use linkage::{Dual, Scalar};
use linkage_random::Random;
use linkage_reference::Fused;
use num_dual::Dual3_64;

use super::{LAWS, Laws, laws, references};

/// Largest errors of all laws against the references, of the largest value of each derivative.
fn worst<T: Scalar>(next: impl Fn(f64, &str) -> T, roundoff: f64) -> f64 {
    let mut worst: f64 = 0.0;
    let mut count = 0;
    for reference in references() {
        let Some(law) = LAWS.iter().position(|own| own.0 == reference.law) else {
            continue;
        };
        let x = next(reference.at / 40.0, reference.side);
        // Fortieths are rounded when they become numbers, and both sides of a border are a number apart.
        let moved = 0.5 * roundoff + (x.lane(0) - reference.at / 40.0).abs();
        let moved = if reference.at % 5.0 == 0.0 && reference.side == "value" {
            0.0
        } else {
            moved
        };
        let found = laws(x);
        let largest = |order: usize| {
            if order == 0 {
                1.0
            } else {
                LAWS[law].1[order - 1]
            }
        };
        for (order, (own, expected)) in found.iter().zip(reference.values).enumerate() {
            let error = (own[law] - expected).abs();
            let of_place = moved * LAWS[law].1[order];
            worst = worst.max((error - of_place) / largest(order));
            count += 1;
        }
    }
    assert!(count > 300, "{count}");
    worst
}

/// The number at a place as it is seen from one side of it.
fn at_side(x: f64, side: &str) -> f64 {
    if side == "left" { x.next_down() } else { x }
}

#[test]
fn laws_have_fifteen_digits_up_to_the_third_derivative() {
    let found = worst(at_side, f64::EPSILON);
    let fused = worst(|x, side| Fused(at_side(x, side)), f64::EPSILON);
    let single = worst(
        |x, side| {
            if side == "left" {
                (x as f32).next_down()
            } else {
                x as f32
            }
        },
        f64::from(f32::EPSILON),
    );
    println!(
        "laws, of their largest values: {found:e}, fused {fused:e}, single precision {single:e}"
    );
    assert!(found <= 1e-15 && fused <= 1e-15 && single <= 5e-7);
}

#[test]
fn laws_rest_outside_and_pass_nan_on() {
    for x in [-1e300, -1.0, -f64::MIN_POSITIVE, 1.0, 2.0, 1e300] {
        let end = if x < 0.0 { 0.0 } else { 1.0 };
        let [values, rates @ ..] = laws(x);
        assert_eq!(values, [end; 8], "{x}");
        assert_eq!(rates, [[0.0; 8]; 3], "{x}");
    }
    assert_eq!(laws(0.0)[0], [0.0; 8]);
    let nowhere = laws(f64::NAN);
    assert!(nowhere[..2].as_flattened().iter().all(|x| x.is_nan()));
    // The line has no acceleration anywhere.
    assert!(
        nowhere[2..]
            .iter()
            .all(|own| own[1..].iter().all(|x| x.is_nan()))
    );
}

/// Every derivative against that of dual numbers, which know nothing of the formulas for slopes.
#[test]
fn derivatives_are_those_of_dual_numbers() {
    let mut random = Random::new(61);
    let linkage = Laws::default()
        .cast::<Dual<Dual3_64>>()
        .assemble()
        .expect("it has no loop");
    for _ in 0..200 {
        let x = random.between(-0.2, 1.2);
        let [_, first, second, third] = laws(x);
        let dual = laws!(linkage.values(Dual(Dual3_64::new(x, 1.0, 0.0, 0.0))));
        for (law, Dual(own)) in dual.into_iter().enumerate() {
            let pairs = [(first, own.v1), (second, own.v2), (third, own.v3)];
            for (order, (found, expected)) in pairs.into_iter().enumerate() {
                let error = (found[law] - expected).abs();
                let allowed = 1e-14 * LAWS[law].1[order].max(1.0);
                assert!(
                    error <= allowed,
                    "{} {order} at {x}: {} {expected}",
                    LAWS[law].0,
                    found[law]
                );
            }
        }
    }
}
