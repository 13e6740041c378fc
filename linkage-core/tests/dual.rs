//! Derivatives through dual numbers.
#![cfg(feature = "num-dual")]

use linkage_core::{Dual, Scalar};
use linkage_random::Random;
use num_dual::{Dual2_64, Dual64};
use std::f64::consts::{FRAC_PI_2, TAU};

type D = Dual<Dual64>;

fn variable(x: f64) -> D {
    Dual(Dual64::new(x, 1.0))
}

/// Compares the derivative with central differences of the same function on plain numbers.
macro_rules! check_derivative {
    ($x:expr, $function:expr) => {{
        let x: f64 = $x;
        let step = 1e-6;
        let plain = |x: f64| -> f64 { $function(x) };
        let dual: D = $function(variable(x));
        let difference = (plain(x + step) - plain(x - step)) / (2.0 * step);
        // The tangent of num-dual is a quotient, an ulp away from that of the library.
        assert!((dual.lane(0) - plain(x)).abs() <= 2.0 * f64::EPSILON * x.abs().max(1.0));
        let error = (dual.0.eps - difference).abs();
        assert!(
            error < 1e-7 * difference.abs().max(1.0),
            "derivative at {x}: {error:e}"
        );
    }};
}

fn constant<T: Scalar>(x: f64) -> T {
    T::from_f64(x)
}

fn chosen<T: Scalar>(x: T) -> T {
    T::select(x, x * x, -x)
}

fn scale<T: Scalar>(x: T) -> T {
    (T::from_f64(1.5) + x * T::from_f64(0.1)).inverse_scale()
}

#[test]
fn derivatives_pass_through_every_function() {
    let mut random = Random::new(7);
    for _ in 0..500 {
        let x = random.between(-0.95, 0.95);
        if x.abs() < 0.01 {
            continue;
        }
        check_derivative!(x, Scalar::abs);
        check_derivative!(x, Scalar::tan);
        check_derivative!(x, Scalar::asin);
        check_derivative!(x, Scalar::acos);
        check_derivative!(x, Scalar::atan);
        check_derivative!(x, |x| Scalar::sin_cos(x).0);
        check_derivative!(x, |x| Scalar::sin_cos(x).1);
        check_derivative!(x.abs(), Scalar::sqrt);
        check_derivative!(x.abs(), |x| Scalar::root_with::<false>(
            x,
            constant(1e-15),
            constant(3.0)
        ));
        check_derivative!(x, chosen);
        check_derivative!(x, |x| Scalar::min(x, constant(0.0)));
        check_derivative!(x, |x| Scalar::max(x, constant(0.0)));
        check_derivative!(x, Scalar::sign);
        check_derivative!(x, scale);
    }
}

#[test]
fn derivatives_pass_through_lengths_and_angles_in_every_direction() {
    let mut random = Random::new(8);
    for _ in 0..500 {
        let x = random.between(-3.1, 3.1);
        if (x.abs() - FRAC_PI_2).abs() < 1e-3 {
            continue;
        }
        let error = (Scalar::hypot(variable(x), constant::<D>(4.0)).0.eps - x / x.hypot(4.0)).abs();
        assert!(error < 1e-15);
        // The angle of the vector at the angle x is x, whatever its length.
        let (sin, cos) = variable(x).sin_cos();
        let angle = (sin * constant(5.0)).atan2(cos * constant(5.0));
        assert!((angle.lane(0) - x).abs() < 1e-15 && (angle.0.eps - 1.0).abs() < 1e-15);

        let guide = constant::<D>(x + 3.0 * TAU + 1.0);
        let angle = D::angle_near(sin, cos, guide);
        let plain = f64::angle_near(sin.lane(0), cos.lane(0), guide.lane(0));
        assert!((angle.lane(0) - plain).abs() < 1e-14 && (angle.0.eps - 1.0).abs() < 1e-15);
    }
}

#[test]
fn an_angle_on_an_axis_has_a_derivative() {
    for (sin, cos) in [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)] {
        let y = Dual(Dual64::new(sin, cos));
        let x = Dual(Dual64::new(cos, -sin));
        let angle = y.atan2(x);
        assert_eq!((angle.lane(0), angle.0.eps), (sin.atan2(cos), 1.0));
    }
}

#[test]
fn second_derivatives_pass_through_roots_and_angles() {
    let x = Dual(Dual2_64::new(0.6, 1.0, 0.0));
    let one = Dual::<Dual2_64>::from_f64(1.0);
    let y = (one - x * x).root_with::<false>(one.slack(), one);
    // The unit circle: y' = -x / y, y'' = -1 / y^3, and the angle of (x, y) is acos x.
    assert!((y.0.v1 + 0.75).abs() < 1e-15 && (y.0.v2 + 1.0 / 0.512).abs() < 1e-14);
    let (angle, exact) = (Dual::angle_near(y, x, one).0, x.acos().0);
    assert!((angle.v1 - exact.v1).abs() < 1e-14 && (angle.v2 - exact.v2).abs() < 1e-13);
}

#[test]
fn at_a_dead_point_the_value_exists_and_the_derivative_does_not() {
    let slack = Scalar::slack(variable(1.0));
    assert_eq!((slack.lane(0), slack.0.eps), (8.0 * f64::EPSILON, 0.0));
    let root = variable(-1e-16).root_with::<false>(slack, constant(1.0));
    assert_eq!(root.lane(0), 0.0);
    assert!(!root.0.eps.is_finite());
}

#[test]
fn where_nothing_can_be_assembled_everything_is_nan() {
    for nowhere in [
        variable(-1.0).root_with::<false>(constant(1e-15), constant(1.0)),
        variable(f64::NAN).root_with::<false>(constant(1e-15), constant(1.0)),
        D::select(variable(f64::NAN), constant(1.0), constant(2.0)),
        Scalar::min(variable(f64::NAN), constant(2.0)),
        Scalar::max(constant(2.0), variable(f64::NAN)),
    ] {
        assert!(nowhere.lane(0).is_nan() && nowhere.0.eps.is_nan());
    }
}

#[test]
fn operators_keep_derivatives() {
    let mut x = variable(3.0);
    x += constant(1.0);
    x *= variable(3.0);
    x -= constant(2.0);
    x /= constant(2.0);
    // ((x + 1) x - 2) / 2 and (2 x + 1) / 2
    assert_eq!((x.0.re, x.0.eps, (-x).0.eps), (5.0, 3.5, -3.5));
}
