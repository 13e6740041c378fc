//! Groups in space against published figures and against identities.

use crate::space::rssr::RSSR;
use linkage_reference::{Random, Reference, identities};

// Figures known from elsewhere: the reference against them, and the programs.

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

// Euler's theorem on homogeneous functions, in space: all sensitivities of values, velocities and
// accelerations at once.

/// Numbers within 3 % of those given.
fn near(random: &mut Random, numbers: &[f64]) -> Vec<f64> {
    let mut near = |x: &f64| x * random.between(0.97, 1.03);
    numbers.iter().map(&mut near).collect()
}

// RSSR, and RSSP on the rocker.
identities!(
    rssr_and_rssp(phi), angles [psi psi_by], lengths [end end_by, s s_by],
    |random| near(random, &[
        10.0, 50.0, 30.0, 3.0, 40.0, 10.0, 5.0, 50f64.to_radians(), 10f64.to_radians(), 90.0,
        30.0, 1.0, -60.0, 0.9, 0.3, 0.4,
    ]),
    {
        unit mm;
        param crank = 10mm;
        param coupler = 50mm;
        param rocker = 30mm;
        param lift = 3mm;
        param pivot = (40mm, 10mm, 5mm);
        param gamma1 = 50deg;
        param gamma2 = 10deg;
        param rod = 90mm;
        param rail = (30mm, 0mm, -60mm);
        param guide = (0.9, 0.3, 0.4);
        input phi = 60deg in 0deg..360deg;
        unknown psi = 100deg;
        unknown s = 0mm;
        let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
        let x = turn((1, 0, 0), (0, 1, 0), gamma1);
        let axis = turn(turn((0, 0, 1), (0, 1, 0), gamma1), x, gamma2);
        let end = pivot + turn(rocker * x + lift * axis, axis, psi);
        loop distance(pin, end) = coupler;
        loop distance(end, rail + s * guide) = rod;
    }
);

// A tripod whose feet stand on a crank and on the frame, and a bar from its top to a plane.
identities!(
    tripod(phi), angles [], lengths [p p_by, q q_by],
    |random| near(random, &[
        10.0, 60.0, 5.0, 3.0, 20.0, 55.0, -2.0, 45.0, 57.0, 52.0, 70.0, 80.0, 0.1, 0.9, 0.2, 13.0,
    ]),
    {
        unit mm;
        param crank = 10mm;
        param two = (60mm, 5mm, 3mm);
        param three = (20mm, 55mm, -2mm);
        param l1 = 45mm;
        param l2 = 57mm;
        param l3 = 52mm;
        param bar = 70mm;
        param arm = 80mm;
        param normal = (0.1, 0.9, 0.2);
        param height = 13mm;
        input phi = 30deg in 0deg..360deg;
        unknown p = (26mm, 20mm, -40mm);
        unknown q = (90mm, 13mm, -60mm);
        let one = turn((crank, 0mm, 0mm), (0, 1, 0), phi);
        loop distance(p, one) = l1;
        loop distance(p, two) = l2;
        loop distance(p, three) = l3;
        loop distance(q, p) = bar;
        loop distance(q, two) = arm;
        loop dot(normal, q) = height;
    }
);

// Two slides and a link in a loop of three rows; a direction square to the link's arm; then
// three slides.
identities!(
    loops_of_three_rows(phi), angles [psi psi_by, n n_by], lengths [s s_by, v v_by],
    |random| near(random, &[
        15.0, 60.0, 30.0, -15.0, 25.0, 10f64.to_radians(), 60f64.to_radians(), 25f64.to_radians(),
        15.0, 90.0, 70.0, 80.0,
    ]),
    {
        unit mm;
        param crank = 15mm;
        param link = 60mm;
        param base = (30mm, -15mm, 25mm);
        param one = 10deg;
        param two = 60deg;
        param tilt = 25deg;
        param shadow = 15mm;
        param far = (90mm, 70mm, 80mm);
        input phi = 30deg in 0deg..360deg;
        unknown s = 60mm;
        unknown t = 10mm;
        unknown psi = 37deg;
        unknown n = (0.5, 0.5, 0.5);
        unknown u = 270mm;
        unknown v = 90mm;
        unknown w = -190mm;
        let pin = turn((crank, 0mm, 0mm), (0, 0, 1), phi);
        let axis = (sin(tilt), 0, cos(tilt));
        let arm = turn(link * (cos(tilt), 0, -sin(tilt)), axis, psi);
        loop pin + s * (cos(one), sin(one), 0) + t * (0, cos(two), sin(two)) = base + arm;
        loop norm(n) = 1;
        loop dot(n, arm) = shadow;
        loop dot(n, axis) = 0.3;
        loop base + arm + u * n + v * (1, 0, 0) + w * (0.1, 1, 0.2) = far;
    }
);
