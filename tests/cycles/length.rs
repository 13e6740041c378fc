//! An input that is a length, over a range that is as long as a turn is in radians.

use linkage::design::{Curve, CycleDesign, Figure, RootMeanSquare};
use linkage::mechanism;
use std::f64::consts::TAU;

mechanism! {
    /// A lever that a cylinder turns; its length happens to grow by 2 pi.
    #[derive(Clone, Copy)]
    struct Lever {
        unit mm;
        param arm = 40mm;
        input x = 53mm in 50mm..56.283185307179586mm;
        unknown theta = 40deg;
        unknown psi = 120deg;
        loop polar(x, theta) = (60mm, 0mm) + polar(arm, psi);
    }
    impl Lever {
        fn turning(x) -> LeverTurning { psi, v: velocity(psi), a: acceleration(psi) }
        fn accuracy(x) -> LeverAccuracy { e: sensitivity(psi) }
    }
}

/// The mean over a length, with both of its ends, whatever the number is by which it grows.
#[test]
fn a_length_does_not_turn() {
    let jet = |lever: &LeverAssembly, x| {
        let turning = lever.turning(x);
        [turning.psi, turning.v, turning.a]
    };
    let psi = Curve::new(jet, |lever: &LeverAssembly, x| lever.accuracy(x).e);
    let design = CycleDesign::new(
        Lever::default(),
        Lever::assemble,
        Lever::assemble_from,
        Lever::circuits,
    );
    let design = design.expect("assembles").vary("arm", 39.0, 41.0);
    let found = design.want(RootMeanSquare(psi).least()).run();
    let found = found.expect("a lever within the bounds");
    // By the law of cosines, in the middle of many short steps.
    let arm = found.mechanism.arm;
    let square = |k: i32| {
        let x = 50.0 + TAU * (f64::from(k) + 0.5) / 10_000.0;
        let cosine = (x * x - 3600.0 - arm * arm) / (120.0 * arm);
        cosine.acos().powi(2) / 10_000.0
    };
    let mean = (0..10_000).map(square).sum::<f64>().sqrt();
    assert!(
        (found.goal - mean).abs() < 1e-5 * mean,
        "{} and {mean}",
        found.goal
    );
}
