//! Margins in space against their meaning, and parallel axes against the four-bar of the plane.

use crate::space::points::three_distances;
use crate::space::{rssp, rssr};
use linkage_reference::{Form, Plan, Random, Variant};
use nalgebra::{Matrix3, Vector3};

// Margins by their meaning: the determinant of the loops over its largest value, from positions
// that the programs themselves give.

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

// RSSR with parallel axes is the four-bar of the plane.

/// A mechanism as a module with a function that gives all its numbers.
macro_rules! four_bar {
    ($name:ident { $($items:tt)* } $pivot:expr $(, $extra:ident)?) => {
        mod $name {
            linkage_interpreted::interpreted! {
                pub struct Mechanism {
                    unit mm;
                    param crank = 50mm;
                    param coupler = 120mm;
                    param rocker = 100mm;
                    input phi = 30deg in 0deg..360deg;
                    unknown psi = 80deg;
                    $($items)*
                }

                impl Mechanism {
                    pub fn values(phi) -> Values { psi, margin: margin() }
                    pub fn first(phi) -> First {
                        psi: velocity(psi), by: sensitivity(psi, [crank, coupler, rocker, pivot.x]),
                    }
                    pub fn second(phi) -> Second {
                        psi: acceleration(psi),
                        by: sensitivity(velocity(psi), [crank, coupler, rocker, pivot.x]),
                    }
                }
            }

            pub(super) fn numbers([crank, coupler, rocker, x, y]: [f64; 5], phi: f64) -> Vec<f64> {
                let pivot = $pivot(x, y);
                let mechanism = Mechanism { crank, coupler, rocker, pivot, $($extra: 0.0)? };
                let linkage = mechanism.assemble().expect("closes");
                let (v, first, second) =
                    (linkage.values(phi), linkage.first(phi), linkage.second(phi));
                let scalars = [v.psi, v.margin, first.psi, second.psi];
                [&scalars[..], &first.by, &second.by].concat()
            }
        }
    };
}

four_bar!(plane {
    param pivot = (140mm, 3mm);
    unknown theta = 40deg;
    loop polar(crank, phi) + polar(coupler, theta) = pivot + polar(rocker, psi);
} |x, y| [x, y].into());

four_bar!(flat {
    param pivot = (140mm, 3mm, 0mm);
    let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
    loop distance(pin, (pivot.x, pivot.y, 0mm) + turn((rocker, 0mm, 0mm), (0, 0, 1), psi)) = coupler;
} |x, y| [x, y, 0.0].into());

four_bar!(heights {
    param pivot = (140mm, 3mm, 0mm);
    let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
    loop distance(pin, pivot + turn((rocker, 0mm, 0mm), (0, 0, 1), psi)) = coupler;
} |x, y| [x, y, 0.0].into());

four_bar!(untilted {
    param pivot = (140mm, 3mm, 0mm);
    param gamma = 0deg;
    let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
    let axis = turn((0, 0, 1), (1, 2, 0), gamma);
    let x = turn((1, 0, 0), (1, 2, 0), gamma);
    let end = pivot + rocker * turn(x, axis, psi);
    loop distance(pin, end) = coupler;
} |x, y| [x, y, 0.0].into(), gamma);

/// What the numbers are: values (the angle and the margin), first and second derivatives.
const ORDERS: [usize; 12] = [0, 0, 1, 2, 1, 1, 1, 1, 2, 2, 2, 2];

/// Two lists of numbers as often as they were computed.
#[derive(Default)]
struct Pairs(Vec<[Vec<f64>; 2]>);

impl Pairs {
    /// The largest difference for each order, in units of the last place of the largest number of
    /// its kind.
    fn largest(&self) -> [f64; 3] {
        let mut largest = [0.0f64; 3];
        for (k, order) in ORDERS.into_iter().enumerate() {
            let pairs = || self.0.iter().map(|[a, b]| (a[k], b[k]));
            let size = pairs().fold(0.0f64, |size, (a, b)| size.max(a.abs()).max(b.abs()));
            let error = pairs().fold(0.0f64, |error, (a, b)| error.max((a - b).abs()));
            largest[order] = largest[order].max(error / (size * f64::EPSILON));
        }
        largest
    }
}

#[test]
fn parallel_axes() {
    let mut random = Random::new(311);
    let mut compared = [0; 3].map(|_| Pairs::default());
    for _ in 0..400 {
        let geometry = [50.0, 120.0, 100.0, 140.0, 3.0].map(|x| x * random.between(0.97, 1.03));
        let phi = random.angle();
        let expected = plane::numbers(geometry, phi);
        assert_eq!(expected.len(), ORDERS.len());
        let forms = [flat::numbers, heights::numbers, untilted::numbers];
        for (pairs, form) in compared.iter_mut().zip(forms) {
            pairs.0.push([form(geometry, phi), expected.clone()]);
        }
    }
    let [flat, heights, untilted] = compared.map(|pairs| pairs.largest());
    println!(
        "RSSR with parallel axes against the four-bar, largest difference of values, first and \
         second derivatives in units of the last place of the largest one:\n\
         flat {flat:.2?}, with heights {heights:.2?}, axis computed {untilted:.2?}\n"
    );
    for found in [flat, heights] {
        assert!(found[0] == 0.0 && found[1] < 4.0 && found[2] < 8.0);
    }
    assert!(untilted.iter().all(|&largest| largest < 16.0));
}
