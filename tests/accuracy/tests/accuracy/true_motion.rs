//! Motions: values of angles over several turns, and velocity, acceleration and jerk in time.

use core::f64::consts::TAU;
use linkage::{Dual, mechanism, true_acceleration, true_jerk, true_velocity};
use linkage_reference::Big;
use num_dual::Dual3_64;

// Velocity, acceleration and jerk in time, of a slider-crank whose crank follows a law, against differences over time in 154
// digits of the position alone, and against dual numbers whose variable is time.

mechanism! {
    struct Ram {
        unit mm;
        param crank = 40mm;
        param rod = 120mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown slide = 150mm;
        let q = polar(crank, phi) + polar(rod / 2, theta);
        loop polar(crank, phi) + polar(rod, theta) = (slide, 0);
    }
    impl Ram {
        fn motion(phi) -> Motion {
            slide, v: velocity(slide), a: acceleration(slide), j: jerk(slide),
            q, vq: velocity(q), aq: acceleration(q), jq: jerk(q),
        }
        fn places(phi) -> Places { slide, q }
    }
}

/// The angle and its derivatives by time at time 0; all of them are exact numbers of `f64`.
const LAWS: [[f64; 4]; 5] = [
    [0.75, 12.0, 0.0, 0.0],
    [2.5, -9.5, 40.0, 0.0],
    [4.0, 3.25, -700.0, 5000.0],
    [5.5, 0.0, 0.0, 900.0],
    [1.25, 20.0, -350.0, -8000.0],
];
/// The largest error that is allowed, in roundoffs of the sum of the sizes of the terms.
const LIMIT: f64 = 4.0;
/// What the differences leave out at most.
const TRUNCATION: f64 = 1e-50;

/// The slide and the middle of the rod, in any arithmetic with roots.
fn by_hand(phi: &Big) -> [Big; 3] {
    let (sin, cos) = phi.sin_cos();
    let [crank, rod] = [40.0, 120.0].map(Big::from);
    let height = &crank * &sin;
    let foot = (&(&rod * &rod) - &(&height * &height)).sqrt();
    let along = &crank * &cos;
    let half = Big::from(0.5);
    [&along + &foot, &along + &(&foot * &half), &height * &half]
}

/// Three derivatives by time, by differences of positions at four places beside time 0.
fn by_differences([phi, omega, epsilon, zeta]: [f64; 4]) -> [[f64; 3]; 3] {
    // The error of the formulas is that of its square, some 1e-60; rounding in 154 digits divided by its cube is 1e-64.
    let step = Big::power_of_two(-100);
    let at = |steps: f64| {
        let time = &step * &Big::from(steps);
        let square = &time * &time;
        let cube = &square * &time;
        let second = &square * &Big::from(epsilon / 2.0);
        // Sixths are no numbers of `f64`.
        let third = &(&cube * &Big::from(zeta)) / &Big::from(6.0);
        by_hand(&(&(&(&Big::from(phi) + &(&time * &Big::from(omega))) + &second) + &third))
    };
    let [before_two, before, now, after, after_two] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(at);
    let two = Big::from(2.0);
    core::array::from_fn(|k| {
        let first = &(&after[k] - &before[k]) / &(&two * &step);
        let second = &(&(&after[k] - &(&two * &now[k])) + &before[k]) / &(&step * &step);
        let outer = &after_two[k] - &before_two[k];
        let inner = &two * &(&after[k] - &before[k]);
        let cube = &(&step * &step) * &step;
        let third = &(&outer - &inner) / &(&two * &cube);
        [first.to_f64(), second.to_f64(), third.to_f64()]
    })
}

#[test]
fn they_are_differences_over_time() {
    let ram = Ram::default().assemble().expect("it closes");
    let mut worst = 0.0_f64;
    for law in LAWS {
        let [phi, omega, epsilon, zeta] = law;
        let m = ram.motion(phi);
        let v = true_velocity(m.vq, omega);
        let a = true_acceleration(m.vq, m.aq, omega, epsilon);
        let j = true_jerk(m.vq, m.aq, m.jq, omega, epsilon, zeta);
        let found = [
            [
                true_velocity(m.v, omega),
                true_acceleration(m.v, m.a, omega, epsilon),
                true_jerk(m.v, m.a, m.j, omega, epsilon, zeta),
            ],
            [v.x, a.x, j.x],
            [v.y, a.y, j.y],
        ];
        let (w, e, z) = (omega.abs(), epsilon.abs(), zeta.abs());
        // Derivatives by the angle are of the size of the crank here.
        let sizes = [w, w * w + e, w * w * w + 3.0 * w * e + z].map(|x| 40.0 * x);
        for (found, known) in found.iter().zip(by_differences(law)) {
            for order in 0..3 {
                let error = (found[order] - known[order]).abs();
                let roundoffs = (error - TRUNCATION) / (sizes[order] * f64::EPSILON / 2.0);
                // Of no speed at all the size is zero.
                let roundoffs = if error <= TRUNCATION { 0.0 } else { roundoffs };
                assert!(
                    roundoffs <= LIMIT,
                    "{law:?}: {roundoffs} roundoffs in derivative {}",
                    order + 1
                );
                worst = worst.max(roundoffs);
            }
        }
    }
    println!("true motion: {worst:.2} roundoffs");
}

#[test]
fn they_are_derivatives_of_numbers_that_know_time() {
    let ram = Ram::default().assemble().expect("it closes");
    let timed = Ram::default()
        .cast::<Dual<Dual3_64>>()
        .assemble()
        .expect("it closes");
    for [phi, omega, epsilon, zeta] in LAWS {
        let m = ram.motion(phi);
        let time = Dual3_64::new(0.0, 1.0, 0.0, 0.0);
        let law = time * (time * (time * (zeta / 6.0) + epsilon / 2.0) + omega) + phi;
        let Dual(slide) = timed.places(Dual(law)).slide;
        assert!((slide.re - m.slide).abs() < 1e-12);
        let jerk = true_jerk(m.v, m.a, m.j, omega, epsilon, zeta);
        let size = 40.0 * (omega.abs().powi(3) + 3.0 * (omega * epsilon).abs() + zeta.abs());
        let near = |x: f64, y: f64| (x - y).abs() <= 1e-13 * size;
        assert!(near(jerk, slide.v3), "{jerk} {}", slide.v3);
    }
}

// Values of angles: nearest to the estimate at the reference, and continuous over several turns.

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
