//! Discs hold what they must, double-double numbers have their digits, certificates fail where there is no solution.

use super::super::ball::{Ball, Bound};
use super::super::certificate::{self, Point, System};
use super::super::complex::{Complex, Ring};
use super::super::double::Double;
use super::super::polynomial::roots;
use linkage_random::Random;

/// Whole numbers as large as plain numbers hold them exactly when multiplied: rounding is known then.
fn whole(random: &mut Random) -> f64 {
    random.between(-1e9, 1e9).round()
}

#[test]
fn double_double_products_are_exact_to_their_digits() {
    let mut random = Random::new(8);
    for _ in 0..1000 {
        let [a, b, c, d] = [(); 4].map(|()| whole(&mut random));
        let (left, right) = (Double::from(a) * b.into(), Double::from(c) * d.into());
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
    let wide = Double::difference(2f64.powi(60), -1.0);
    for product in [wide * 3.0.into(), Double::from(3.0) * wide] {
        assert_eq!(
            product.high as i128 + product.low as i128,
            3 * ((1 << 60) + 1)
        );
    }
    let difference = Double::difference(1.0, 1e-30);
    assert_eq!([difference.high, difference.low], [1.0, -1e-30]);
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
        let bound = polynomial(numbers.map(|number| Bound::of(number.wide())));
        assert!(exact.narrow().size() <= bound.0);
        assert!(
            way <= disc.radius && disc.radius < 1e-14 * bound.0,
            "{way} {disc:?} {bound:?}"
        );
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
        let discs = point.map(Ball::of);
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

#[test]
fn roots_of_polynomials() {
    let known = [
        Complex::new(1.0, 2.0),
        Complex::new(-3.0, 0.5),
        Complex::new(0.25, 0.0),
        Complex::new(1e3, 1.0),
    ];
    let mut coefficients = alloc::vec![Complex::new(2.0, -1.0)];
    for root in known {
        let mut next = alloc::vec![Complex::new(0.0, 0.0)];
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
            .map(|own| (*own - root).size())
            .fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-12 * root.size().max(1.0), "{nearest}");
    }
    coefficients.push(Complex::new(1e-30, 0.0));
    assert_eq!(roots(&coefficients).len(), 4);
}
