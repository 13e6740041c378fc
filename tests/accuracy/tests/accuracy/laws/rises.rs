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

/// The largest value of speed times acceleration, where it is known.
const DYNAMIC: [(&str, f64); 6] = [
    ("poly345", 6.694_268_727_495_788),
    ("poly4567", 10.750_226_164_026_47),
    ("cycloidal", 8.162_097_139_053_98),
    ("harmonic", 3.875_784_585_037_477_5),
    ("modified_sine", 5.457_752_762_719_378_5),
    ("modified_trapezoid", 8.089_980_982_313_15),
];

/// The largest magnitude of something about a law on [0, 1): where it is among so many places, then by smaller and smaller steps about there.
fn largest(law: usize, of: impl Fn(&[[f64; 8]; 4], usize) -> f64) -> f64 {
    let at = |x: f64| of(&laws(x.clamp(0.0, 1.0_f64.next_down())), law).abs();
    let places = 0..=400;
    let found = places.map(|k| f64::from(k) / 400.0);
    let mut best = found.fold(0.0, |best, x| if at(x) > at(best) { x } else { best });
    let mut step = 1.0 / 400.0;
    while step > 1e-10 {
        for next in [best - step, best + step] {
            if at(next) > at(best) {
                best = next;
            }
        }
        step *= 0.7;
    }
    at(best)
}

/// The table of laws in the documentation says how large they become, and so does the table that errors are measured by.
#[test]
fn the_largest_values_are_those_of_the_documentation() {
    let page = include_str!("../../../../../docs/language/expressions.md");
    for (law, (name, sizes)) in LAWS.iter().enumerate() {
        let row = format!("| `{name}` |");
        let line = page.lines().find(|line| line.starts_with(&row));
        let line = line.expect("each law has a row").trim_end_matches(" |");
        let (_, told) = line.rsplit_once("| ").expect("columns");
        let told: Vec<f64> = told
            .split([',', ';'])
            .map(|own| own.trim().parse().expect("a number"))
            .collect();
        let found = [1, 2, 3].map(|order| largest(law, |own, law| own[order][law]));
        let product = largest(law, |own, law| own[1][law] * own[2][law]);
        for (told, found) in told.iter().zip(found.iter().chain([&product])) {
            assert!(
                (told - found).abs() <= 0.0051 * told.max(1.0),
                "{name}: {told} and {found}"
            );
        }
        assert_eq!(told.len(), 4, "{line}");
        for (size, found) in sizes.iter().zip(found) {
            assert!(
                (size - found).abs() < 1e-4 * found.max(1.0),
                "{name}: {size} and {found}"
            );
        }
        if let Some((_, known)) = DYNAMIC.iter().find(|own| own.0 == *name) {
            assert!((product - known).abs() < 1e-14 * known, "{name}: {product}");
        }
    }
}
