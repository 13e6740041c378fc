//! Discs contain the exact results, double-double numbers have their digits, certificates fail
//! where there is no solution.

use super::super::ball::{Ball, Bound};
use super::super::certificate::{self, Evaluated, Point, System};
use super::super::long::Long;
use super::super::polynomial::roots;
use super::super::real::Real;
use linkage_core::numeric::complex::{Complex, Ring};
use linkage_core::numeric::double_double::DoubleDouble;
use linkage_random::Random;

/// Whole numbers as large as plain numbers hold them exactly when multiplied: rounding is known
/// then.
fn whole(random: &mut Random) -> f64 {
    random.between(-1e9, 1e9).round()
}

#[test]
fn double_double_products_are_exact_to_their_digits() {
    let mut random = Random::new(8);
    for _ in 0..1000 {
        let [a, b, c, d] = [(); 4].map(|()| whole(&mut random));
        let (left, right) = (
            DoubleDouble::from(a) * b.into(),
            DoubleDouble::from(c) * d.into(),
        );
        let sum = left + right;
        let known = a as i128 * b as i128 + c as i128 * d as i128;
        assert_eq!(sum.high as i128 + sum.low as i128, known);
        let difference = sum - right;
        assert_eq!(
            difference.high as i128 + difference.low as i128,
            a as i128 * b as i128
        );
    }
    // Factors with two parts, in either order.
    let wide = DoubleDouble::difference(2f64.powi(60), -1.0);
    for product in [wide * 3.0.into(), DoubleDouble::from(3.0) * wide] {
        assert_eq!(
            product.high as i128 + product.low as i128,
            3 * ((1 << 60) + 1)
        );
    }
    let difference = DoubleDouble::difference(1.0, 1e-30);
    assert_eq!([difference.high, difference.low], [1.0, -1e-30]);
}

/// A random number of 256 digits or fewer, as a sum of plain ones that do not overlap.
fn long(random: &mut Random) -> Long {
    let mut size = 1.0;
    let parts = (0..5).map(|_| {
        let part = Long::exact(random.between(-1.0, 1.0) * size);
        size *= 2f64.powi(-54);
        part
    });
    parts.fold(Long::ZERO, |sum, part| sum + part)
}

/// An error as a part of the larger of two numbers, in units of 2^-253.
fn units(error: Long, of: Long) -> f64 {
    let up = 2f64.powi(126);
    (error * Long::exact(up) * Long::exact(up)).narrow().abs() * 2.0 / of.narrow().abs()
}

fn larger(a: Long, b: Long) -> Long {
    if a.narrow().abs() < b.narrow().abs() {
        b
    } else {
        a
    }
}

#[test]
fn long_numbers_are_exact_to_their_digits() {
    let mut random = Random::new(18);
    for _ in 0..1000 {
        let [a, b, c, d] = [(); 4].map(|()| whole(&mut random));
        let known = a as i128 * b as i128 + c as i128 * d as i128;
        let sum = Long::exact(a) * Long::exact(b) + Long::exact(c) * Long::exact(d);
        let rest = sum - Long::exact(known as f64);
        assert_eq!(rest.narrow() as i128 + known as f64 as i128, known);
        // Sums of numbers far apart are exact, too, as long as their bits have place.
        let (small, large) = (Long::exact(a * 2f64.powi(-170)), Long::exact(b));
        assert_eq!((large + small - large).narrow(), a * 2f64.powi(-170));
        assert_eq!((small - large + large).narrow(), a * 2f64.powi(-170));
        assert_eq!(small - small, Long::ZERO);

        let [a, b, c] = [(); 3].map(|()| long(&mut random));
        assert!(units(a * b - b * a, a * b) == 0.0);
        assert!(units((a + b) - b - a, larger(a, b)) < 8.0);
        let terms = larger(a * c, b * c);
        assert!(units((a + b) * c - (a * c + b * c), terms) < 8.0);
        assert!(units(a * a.inverse() - Long::exact(1.0), Long::exact(1.0)) < 16.0);
    }
    // Less and more than plain numbers with all their digits hold.
    for number in [5e-324, 3e-310, f64::MIN_POSITIVE, 1e-300, f64::MAX, -0.0] {
        assert_eq!(Long::exact(number).narrow(), number);
        assert_eq!(Long::exact(-number).narrow(), -number);
        assert!(Long::exact(number).bound() >= number);
    }
    let tiny = Long::exact(1e-200) * Long::exact(1e-200);
    assert_eq!((tiny.narrow(), tiny == Long::ZERO), (0.0, false));
    assert!(tiny.bound() > 0.0);
    assert_eq!(
        (Long::exact(1e200) * Long::exact(-1e200)).narrow(),
        f64::NEG_INFINITY
    );
    // A product of DoubleDouble's digits.
    let wide = DoubleDouble::difference(1.0, 1e-25);
    let square = wide * wide;
    let rest = Long::from(wide) * Long::from(wide) - Long::from(square);
    assert!(rest.narrow().abs() < 1e-31, "{rest:?}");
    assert!(Ball::<Long>::from(f64::NAN).size().is_nan());
}

fn polynomial<T: Ring>([a, b, c, d]: [T; 4]) -> T {
    a * b * c - d * a + (b - c) * (d + a) * -b
}

#[test]
fn discs_hold_the_exact_value() {
    let mut random = Random::new(9);
    for _ in 0..2000 {
        let numbers = [(); 4].map(|()| {
            let mut part =
                || random.between(-1.0, 1.0) * 1e3_f64.powf(random.clone().between(-1.0, 1.0));
            Complex::new(part(), part())
        });
        let exact = polynomial(numbers.map(Complex::wide));
        let disc = polynomial(numbers.map(Ball::exact));
        let way = (exact - disc.middle.wide()).narrow().size();
        let bound = polynomial(numbers.map(|number| Bound::from_wide(number.wide())));
        assert!(exact.narrow().size() <= bound.0);
        assert!(
            way <= disc.radius && disc.radius < 1e-14 * bound.0,
            "{way} {disc:?} {bound:?}"
        );
        // With more digits the disc holds the same number, which is not known as exactly.
        let fine = polynomial(numbers.map(Ball::<Long>::from));
        let middle = Ball::exact(fine.middle).narrow();
        assert!(fine.radius < 1e-60 * bound.0 && !middle.is_apart_from(disc));
        // A product alone, whose rounding no other one covers.
        let [a, b, ..] = numbers;
        let disc = Ball::exact(a) * Ball::exact(b);
        let way = (a.wide() * b.wide() - disc.middle.wide()).narrow().size();
        assert!(way <= disc.radius, "{way} {disc:?}");
        // And the values at all points of wider discs.
        let shifted =
            numbers.map(|number| number + Complex::polar(random.between(0.0, 7.0)).scaled(1e-3));
        let wide = polynomial(numbers.map(|number| Ball::exact(number).widened(1.001e-3)));
        let way = polynomial(shifted) - wide.middle;
        assert!(way.size() <= wide.radius);
        let inverse = Ball::exact(numbers[0]).inverse().unwrap();
        let one = inverse * Ball::exact(numbers[0]);
        assert!((one.middle - Complex::new(1.0, 0.0)).size() <= one.radius && one.radius < 1e-14);
    }
    assert!(Ball::new(Complex::new(1.0, 0.0), 1.0).inverse().is_none());
}

/// `x^2 = c` with `y` the conjugate of `x`, of which `c` is a real number.
struct Roots(f64);

impl System<2> for Roots {
    fn values(&self, point: &Point<2>) -> [Ball; 2] {
        let discs = point.map(Ball::from_wide);
        discs.map(|x| x * x - Ball::exact(Complex::new(self.0, 0.0)))
    }

    fn matrix(&self, [x, y]: &[Ball; 2]) -> [[Ball; 2]; 2] {
        let two = Ball::exact(Complex::new(2.0, 0.0));
        [[two * *x, Ball::ZERO], [Ball::ZERO, two * *y]]
    }
}

#[test]
fn certificates_are_given_for_solutions_only() {
    let at =
        |c: f64, x: Complex, y: Complex| certificate::certify(&[x.wide(), y.wide()], &Roots(c));
    let root = Complex::new(2f64.sqrt(), 0.0);
    let real = at(2.0, root, root).unwrap();
    assert_eq!(real.real, Some(true));
    assert!(real.discs[0].radius < 1e-14);
    // Roots of a negative number: real if the second is the conjugate of the first.
    let up = Complex::new(0.0, 2f64.sqrt());
    assert_eq!(at(-2.0, up, up.conjugate()).unwrap().real, Some(true));
    assert_eq!(at(-2.0, up, up).unwrap().real, Some(false));
    assert!(
        !at(-2.0, up, up)
            .unwrap()
            .is_apart_from(&at(-2.0, up, up).unwrap())
    );
    assert!(
        at(-2.0, up, up)
            .unwrap()
            .is_apart_from(&at(-2.0, up, up.conjugate()).unwrap())
    );
    // A double root, and points that are no roots.
    let near = Complex::new(1e-9, 0.0);
    assert!(at(0.0, near, near).is_none());
    let half = Complex::new(0.5, 0.0);
    assert!(at(2.0, half, half).is_none());
}

/// `9 x^2 - 6 x + 1 = c`, of real `x`: a third of 1 and of the roots of `c`.
struct Close(f64);

impl Close {
    fn evaluated<R: Real>(&self, [x]: &[Ball<R>; 1]) -> ([Ball<R>; 1], [[Ball<R>; 1]; 1]) {
        let number = |number: f64| Ball::from(number);
        let value = number(9.0) * *x * *x - number(6.0) * *x + number(1.0) - number(self.0);
        ([value], [[number(18.0) * *x - number(6.0)]])
    }
}

impl System<1> for Close {
    fn partner(i: usize) -> usize {
        i
    }

    fn values(&self, point: &Point<1>) -> [Ball; 1] {
        self.evaluated(&point.map(Ball::from_wide)).0
    }

    fn matrix(&self, discs: &[Ball; 1]) -> [[Ball; 1]; 1] {
        self.evaluated(discs).1
    }

    fn long(&self, discs: &[Ball<Long>; 1]) -> Option<Evaluated<1>> {
        Some(self.evaluated(discs))
    }
}

#[test]
fn certificates_of_more_digits_tell_solutions_that_are_next_to_each_other() {
    let third = 1.0 / 3.0;
    let shown = |c: f64, re: f64, im: f64| {
        // Next to the solution, as far as 32 digits say.
        let third = DoubleDouble::difference(third, third.mul_add(3.0, -1.0) / 3.0);
        let near = Complex::new(third + re.into(), im.into());
        assert!(certificate::certify(&[near], &Close(c)).is_none());
        let start = Complex::new(third.high + 1.3 * re, 1.3 * im);
        certificate::certify_long(&[start], &Close(c))
    };
    let [first, second] = [1e-15, -1e-15].map(|re| shown(9e-30, re, 0.0).unwrap());
    assert!(first.is_apart_from(&second));
    for (one, root) in [(first, 1e-15), (second, -1e-15)] {
        assert_eq!(one.real, Some(true));
        let [disc] = one.discs;
        let known = DoubleDouble::difference(third, third.mul_add(3.0, -1.0) / 3.0) + root.into();
        let way = (known - disc.middle.re.into()).high.abs();
        assert!(
            way <= disc.radius + 1e-30 && disc.radius < 1e-16,
            "{disc:?}"
        );
    }
    let [first, second] = [1e-15, -1e-15].map(|im| shown(-9e-30, 0.0, im).unwrap());
    assert_eq!((first.real, second.real), (Some(false), Some(false)));
    assert!(first.is_apart_from(&second));
    // Near a double solution there is nothing to show, and far away neither.
    assert!(shown(0.0, 1e-15, 0.0).is_none());
    assert!(shown(9e-30, f64::NAN, 0.0).is_none());
}

#[test]
fn roots_of_polynomials() {
    let known = [
        Complex::new(1.0, 2.0),
        Complex::new(-3.0, 0.5),
        Complex::new(0.25, 0.0),
        Complex::new(1e3, 1.0),
    ];
    let mut coefficients = std::vec![Complex::new(2.0, -1.0)];
    for root in known {
        let mut next = std::vec![Complex::new(0.0, 0.0)];
        next.extend(&coefficients);
        for (next, &coefficient) in next.iter_mut().zip(&coefficients) {
            *next = *next - root * coefficient;
        }
        coefficients = next;
    }
    let found = roots(&coefficients);
    assert_eq!(found.len(), 4);
    for root in known {
        let nearest = found
            .iter()
            .map(|other| (*other - root).size())
            .fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-12 * root.size().max(1.0), "{nearest}");
    }
    coefficients.push(Complex::new(1e-30, 0.0));
    assert_eq!(roots(&coefficients).len(), 4);
}
