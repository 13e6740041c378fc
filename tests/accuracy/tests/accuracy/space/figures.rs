//! Figures known from elsewhere: the reference against them, and the programs.

use crate::space::rssr::RSSR;
use linkage_reference::Reference;

/// Input and both solutions of `psi`, its first and second derivative, in degrees and radians.
const RSSR_FIGURES: [(f64, [[f64; 3]; 2]); 2] = [
    (
        60.0,
        [
            [76.04048544635, 0.3580596926249, 0.745059650552],
            [-67.83038355607, -0.9335941527843, 0.472932088408],
        ],
    ),
    (
        200.0,
        [
            [149.8851105343, 0.2025347350933, -0.479806988609],
            [-98.54348523532, 0.4057311345574, 0.367678291596],
        ],
    ),
];

/// Asserts that an angle and its derivatives are those given, to the digits that are given.
#[track_caller]
fn agree(found: [f64; 3], expected: [f64; 3]) {
    for ((found, expected), digits) in found.into_iter().zip(expected).zip([1e-10, 1e-12, 2e-11]) {
        assert!((found - expected).abs() < digits, "{found} {expected}");
    }
}

#[test]
fn rssr_of_the_reference() {
    for (theta, solutions) in RSSR_FIGURES {
        for expected in solutions {
            let data = [
                1.0,
                5.0,
                3.0,
                0.0,
                4.0,
                1.0,
                0.5,
                50f64.to_radians(),
                0.0,
                f64::to_radians(theta),
            ];
            let start = [(expected[0] + 1.0).to_radians()];
            let mut found = Reference::new(&RSSR, &data, &start).expect("assembles");
            let value = found.value(0).to_degrees();
            let [first, second] = [vec![9], vec![9, 9]].map(|by| found.derivative(&by)[0].to_f64());
            agree([value, first, second], expected);
        }
    }
}

linkage_interpreted::interpreted! {
    struct Rssr {
        param crank = 1m;
        param coupler = 5m;
        param rocker = 3m;
        param pivot = (4m, 1m, 0.5m);
        param gamma = 50deg;
        input theta = 60deg in 0deg..360deg;
        unknown psi = 76deg;
        let pin = turn((crank, 0m, 0m), (0, 0, 1), theta);
        let axis = (sin(gamma), 0, cos(gamma));
        let end = pivot + turn(rocker * (cos(gamma), 0, -sin(gamma)), axis, psi);
        loop distance(pin, end) = coupler;
    }

    impl Rssr {
        fn motion(theta) -> RssrMotion { psi, first: velocity(psi), second: acceleration(psi) }
    }
}

#[test]
fn rssr_of_the_program() {
    let assemblies = Rssr::default().assemblies().expect("two modes");
    assert_eq!(assemblies.len(), 2);
    let usual = Rssr::default().assemble().expect("closes");
    assert_eq!(assemblies[0].modes(), usual.modes());
    for (theta, solutions) in RSSR_FIGURES {
        for (assembly, expected) in assemblies.iter().zip(solutions) {
            let found = assembly.motion(theta.to_radians());
            agree(
                [found.psi.to_degrees(), found.first, found.second],
                expected,
            );
        }
    }
}

linkage_interpreted::interpreted! {
    struct Universal {
        param bend = 30deg;
        input phi = 45deg in 0deg..360deg;
        unknown psi = 41deg;
        let axis = (sin(bend), 0, cos(bend));
        let u = turn((0, 1, 0), (0, 0, 1), phi);
        loop dot(u, turn((cos(bend), 0, -sin(bend)), axis, psi)) = 0;
    }

    impl Universal {
        fn motion(phi) -> UniversalMotion { psi, ratio: velocity(psi) }
    }
}

/// By figures at 45 degrees, elsewhere by `tan(out) = cos(bend) tan(in)`.
#[test]
fn universal_joint() {
    let joint = Universal::default().assemble().expect("closes");
    let found = joint.motion(45f64.to_radians());
    assert!((found.psi.to_degrees() - 40.8933946491).abs() < 1e-10);
    assert!((found.ratio - 0.989743318611).abs() < 1e-12);
    for k in 0..72 {
        let phi = f64::from(5 * k).to_radians();
        let (bend, found) = (30f64.to_radians(), joint.motion(phi));
        let ratio = bend.cos() / (1.0 - (bend.sin() * phi.sin()).powi(2));
        let expected = (bend.cos() * phi.sin()).atan2(phi.cos());
        let turns = (found.psi - expected) / core::f64::consts::TAU;
        assert!((turns - turns.round()).abs() < 1e-15, "{phi}: {turns}");
        assert!(
            (found.ratio - ratio).abs() < 1e-14,
            "{phi}: {} {ratio}",
            found.ratio
        );
    }
}
