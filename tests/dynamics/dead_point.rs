//! A four-bar that its rocker drives into a dead point.

use linkage::dynamics::{Cause, Problem, Reduced};
use linkage::mechanism;

mechanism! {
    struct Rocker {
        unit mm;
        input psi = 120deg in 92deg..151deg at omega;
        unknown theta = 20deg;
        unknown phi = 75deg;
        loop polar(50mm, phi) + polar(120mm, theta) = (140mm, 0) + polar(100mm, psi);
        body crank = pin on frame at (0, 0), turns phi, inertia 3000kg*mm^2;
        body coupler = pin on crank at polar(50mm, phi), turns theta;
        body rocker = pin on frame at (140mm, 0), turns psi;
        pin c = coupler on rocker at (140mm, 0) + polar(100mm, psi);
    }
    impl Rocker {
        fn crank(psi) -> Crank { phi, slope: velocity(phi) }
        fn parts(psi, omega) -> Parts { j: inertia(psi), bias: bias(psi) }
    }
}

/// Only the crank has inertia, so that it turns evenly: the dead point is where it has turned to the line of the
/// coupler, which lengths determine.
#[test]
fn a_rocker_ends_at_its_dead_point() {
    let rocker = Rocker::default().assemble().expect("an assembly");
    let start = 120_f64.to_radians();
    let equation = |_, [psi]: [f64; 1], [omega]: [f64; 1]| {
        let parts = rocker.parts(psi, omega);
        Reduced::from_parts(1e-3, [[parts.j]], [parts.bias], [0.0])
    };
    for (reach, sign) in [(170.0, -1.0), (70.0, 1.0)] {
        let problem = Problem::reduced(equation)
            .start([start], [sign * 3.0])
            .tolerance(1e-11);
        let error = problem.until(10.0).expect_err("a dead point");
        let Cause::DeadPoint { state, input: 0 } = error.cause() else {
            panic!("{error}");
        };
        let cos: f64 = (reach * reach - 29_600.0) / 28_000.0;
        let last = cos.acos();
        assert!((state.inputs[0] - last).abs() < 1e-7, "{error}");
        let crank = rocker.crank(start);
        let speed = sign * 3.0 * crank.slope;
        let line = (100.0 * last.sin()).atan2(140.0 + 100.0 * last.cos());
        let line = if reach < 100.0 {
            line + std::f64::consts::PI
        } else {
            line
        };
        let turned = (line - crank.phi + 0.5 * std::f64::consts::TAU)
            .rem_euclid(std::f64::consts::TAU)
            - 0.5 * std::f64::consts::TAU;
        let time = turned / speed;
        assert!((state.time - time).abs() < 1e-6 * time, "{error} {time}");
        // The motion up to there is kept: half of the turn at half of the time.
        let middle = error.motion().state(0.5 * time).inputs[0];
        let crank_there = rocker.crank(middle).phi;
        assert!((crank_there - crank.phi - 0.5 * turned).abs() < 1e-8);
    }
}
