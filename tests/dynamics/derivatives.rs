//! The integral of the energy over dual numbers: derivatives of times and inputs.

use linkage::dynamics::Conservative;
use linkage::{Dual, Scalar};
use num_dual::Dual64;

type Number = Dual<Dual64>;

/// A pendulum from rest at 2 rad: with the gravity `g` all times are those for `g = 1` over the root of `g`.
#[test]
fn times_and_inputs_with_respect_to_gravity() {
    let gravity = Dual(Dual64::new(9.81, 1.0));
    let function = |phi: Number| {
        let (_, cos) = phi.sin_cos();
        [Number::from_f64(1.0), gravity * cos]
    };
    let force = |phi: Number| -(gravity * phi.sin_cos().0);
    let [start, rest] = [2.0, 0.0].map(Number::from_f64);
    let pendulum = Conservative::new(function).start(start, rest).force(force);
    let time = pendulum.time(Number::from_f64(-1.0)).expect("a time").0;
    let known = -0.5 * time.re / 9.81;
    assert!((time.eps - known).abs() < 1e-13, "{} {known}", time.eps);
    // The input at a fixed time moves on as at a time that is longer by `time / (2 g)`.
    let input = pendulum.input(Number::from_f64(time.re)).expect("an input");
    let speed = -pendulum.speed(input).0.re;
    let known = speed * 0.5 * time.re / 9.81;
    assert!((input.0.re + 1.0).abs() < 1e-14);
    assert!(
        (input.0.eps - known).abs() < 1e-12,
        "{} {known}",
        input.0.eps
    );
}
