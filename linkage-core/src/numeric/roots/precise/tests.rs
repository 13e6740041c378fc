use super::super::complex::{Complex, ZERO};
use super::super::path::Trace;
use super::super::place::Place;
use super::Found;
use super::double::Double;
use super::wide::Wide;

/// A unit in the 31st place.
const DIGITS: f64 = 1e-31;

const fn double(high: f64, low: f64) -> Double {
    Double { high, low }
}

/// The absolute value, to 16 digits.
fn size(value: Double) -> f64 {
    (value.high + value.low).abs()
}

/// `e` and its inverse, from tables: the nearest numbers, and those nearest to what is left.
const E: Double = double(core::f64::consts::E, 1.445_646_891_729_250_2e-16);
const INVERSE: Double = double(0.367_879_441_171_442_33, -1.242_875_367_278_836_3e-17);

#[test]
fn what_sums_and_products_leave_out_is_exact() {
    let small = (0.5_f64).powi(70);
    let sum = Double::new(1.0) + Double::new(small);
    assert_eq!(sum, double(1.0, small));
    assert_eq!(sum - Double::new(1.0), Double::new(small));
    // The larger one second.
    assert_eq!(Double::new(small) + Double::new(1.0), sum);

    let near_one = 1.0 + (0.5_f64).powi(30);
    let square = Double::new(near_one) * Double::new(near_one);
    assert_eq!(square, double(1.0 + (0.5_f64).powi(29), (0.5_f64).powi(60)));
    // All digits of both factors.
    let [above, below] = [1.0 + f64::EPSILON, 1.0 - f64::EPSILON];
    let product = Double::new(above) * Double::new(below);
    assert_eq!(product, double(1.0, -f64::EPSILON * f64::EPSILON));
}

#[test]
fn products_have_the_digits_of_both_parts() {
    assert!(size(E * INVERSE - Double::new(1.0)) < DIGITS);
    assert!(size(-E * INVERSE + Double::new(1.0)) < DIGITS);
    // (a + b)^2 - (a - b)^2 = 4 a b, of which the first two agree in 16 digits.
    let b = INVERSE * Double::new(1e-16);
    let [sum, difference] = [E + b, E - b];
    let four = sum * sum - difference * difference;
    assert!(size(four - Double::new(4e-16)) < 20.0 * DIGITS);
}

#[test]
fn complex_numbers_have_them_too() {
    let z = Wide { re: E, im: INVERSE };
    let one = z * z.inverse();
    assert!(size(one.re - Double::new(1.0)) < DIGITS && size(one.im) < DIGITS);
    let turned = z * Wide::new(Complex::new(0.0, 1.0));
    assert_eq!((turned.re, turned.im), (-INVERSE, E));
    assert_eq!(z.scaled(2.0) - z, z);
    assert_eq!(z.rounded(), Complex::new(E.high, INVERSE.high));
}

#[test]
fn ends_count_if_roundings_move_them_less_than_they_are_apart() {
    let place = |re: f64| Place {
        x: [Complex::new(re, 0.0), ZERO],
        flipped: [false; 2],
    };
    let traces: [Trace<2>; 0] = [];
    let root = |moved: f64, apart: f64| {
        let found = [(0, 0.0, moved), (1, apart, 0.0)];
        let found = found.map(|(path, re, moved)| Found {
            path,
            place: place(re),
            moved,
        });
        found[0].root(&traces, &found)
    };
    let reach = root(1e-5, 1e-3).expect("it is steady").reach;
    assert!(reach > 1e-5 && reach < 1e-3);
    assert!(root(5e-4, 1e-3).is_none());
    // Two paths to the same place, or to places that numbers hardly tell.
    assert!(root(0.0, 0.0).is_none() && root(0.0, 1e-15).is_none());
}
