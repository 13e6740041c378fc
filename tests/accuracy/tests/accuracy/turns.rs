//! Values of angles: nearest to the estimate at the reference, and continuous over several turns.

use core::f64::consts::TAU;

linkage_interpreted::interpreted! {
    /// A double crank: coupler and follower turn with the crank.
    struct DragLink {
        unit mm;
        param frame = 30mm;
        param crank = 80mm;
        param coupler = 70mm;
        param follower = 90mm;
        input phi = 60deg in -720deg..720deg;
        unknown theta = -20deg;
        unknown psi = 30deg;
        loop polar(crank, phi) + polar(coupler, theta) = (frame, 0) + polar(follower, psi);
        let geared = 2.5 * psi - theta / 4;
    }

    impl DragLink {
        fn angles(phi) -> Angles { theta, psi, geared }
        fn rates(phi) -> Rates {
            theta: velocity(theta), psi: velocity(psi), geared: velocity(geared),
        }
    }
}

/// Between samples every angle moves by its velocity, to second order, and never by a turn.
#[test]
fn angles_are_continuous_over_four_turns() {
    let linkage = DragLink::default().assemble().expect("closes");
    let step = TAU / 400.0;
    let sample = |k: i32| {
        let phi = f64::from(k) * step;
        let (a, r) = (linkage.angles(phi), linkage.rates(phi));
        ([a.theta, a.psi, a.geared], [r.theta, r.psi, r.geared])
    };
    for k in -800..800 {
        let ((before, rate), (after, rate_after)) = (sample(k), sample(k + 1));
        for i in 0..3 {
            let expected = 0.5 * (rate[i] + rate_after[i]) * step;
            assert!(
                (after[i] - before[i] - expected).abs() < 1e-3,
                "angle {i} at step {k}"
            );
        }
    }
}

#[test]
fn a_full_turn_of_the_input_is_a_full_turn_of_the_cranks() {
    let linkage = DragLink::default().assemble().expect("closes");
    let reference = linkage.angles(60f64.to_radians());
    assert!((reference.psi - 30f64.to_radians()).abs() < 0.1);
    assert!((reference.theta + 20f64.to_radians()).abs() < 0.1);
    for turns in [-2, -1, 1] {
        let a = linkage.angles(60f64.to_radians() + f64::from(turns) * TAU);
        let moved = f64::from(turns) * TAU;
        assert!((a.psi - reference.psi - moved).abs() < 1e-13);
        assert!((a.theta - reference.theta - moved).abs() < 1e-13);
        assert!((a.geared - reference.geared - 2.25 * moved).abs() < 1e-12);
    }
}
