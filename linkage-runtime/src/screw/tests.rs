use std::format;
use std::vec::Vec;

use linkage_core::Dual;
use linkage_random::Random;
use nalgebra::Vector3;

use super::Screw;

fn vector(v: [f64; 3]) -> Vector3<f64> {
    v.into()
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance * expected.abs(),
        "{found} instead of {expected}"
    );
}

/// Components, each as accurate as the vector is long.
fn near(found: Vector3<f64>, expected: [f64; 3], tolerance: f64) {
    let expected = vector(expected);
    let size = expected.amax();
    for (found, expected) in found.iter().zip(&expected) {
        let off = (found - expected).abs();
        assert!(off <= tolerance * size, "{found} instead of {expected}");
    }
}

/// An angular velocity of length 7 about a line through (1, -2, 3), a pitch of 5/2; the velocity is
/// given at (5, -2, 2).
const OMEGA: [f64; 3] = [2.0, 3.0, 6.0];
const VELOCITY: [f64; 3] = [2.0, 33.5, 3.0];
const AT: [f64; 3] = [5.0, -2.0, 2.0];

#[test]
fn a_screw_of_rational_numbers() {
    let screw: Screw = Screw::of(vector(OMEGA), vector(VELOCITY), vector(AT));
    near(screw.direction, OMEGA.map(|x| x / 7.0), 1e-16);
    let nearest = [53.0 / 49.0, -92.0 / 49.0, 159.0 / 49.0];
    near(screw.point, nearest, 3e-16);
    assert_eq!((screw.turn, screw.shift, screw.pitch()), (7.0, 17.5, 2.5));
    assert!(!screw.is_shift());
    let to_origin = screw.nearest(Vector3::zeros());
    near(to_origin, [3.0 / 7.0, -20.0 / 7.0, 9.0 / 7.0], 3e-16);
    // On the axis, elsewhere, and where it was given.
    near(
        screw.velocity(vector([3.0, 1.0, 9.0])),
        [5.0, 7.5, 15.0],
        5e-16,
    );
    near(
        screw.velocity(vector([1.0, -1.0, 3.0])),
        [-1.0, 7.5, 17.0],
        5e-16,
    );
    near(screw.velocity(vector(AT)), VELOCITY, 5e-16);
    // The other way round it is the same axis, and a screw of the same hand.
    let back: Screw = Screw::of(-vector(OMEGA), -vector(VELOCITY), vector(AT));
    assert_eq!(back.direction, -screw.direction);
    assert_eq!((back.point, back.pitch()), (screw.point, 2.5));
}

/// Exact quotients and a root in 60 digits, of the doubles as they are, rounded at last.
#[test]
fn screws_against_sixty_digits() {
    let screw: Screw = Screw::of(
        vector([0.1, -0.7, 0.3]),
        vector([12.5, 3.25, -40.0]),
        vector([100.0, 0.5, -7.0]),
    );
    let direction = [
        0.130_188_910_980_823_89,
        -0.911_322_376_865_767_1,
        0.390_566_732_942_471_63,
    ];
    near(screw.direction, direction, 2e-16);
    let point = [
        145.805_084_745_762_7,
        13.635_593_220_338_984,
        8.381_355_932_203_391,
    ];
    near(screw.point, point, 2e-16);
    close(screw.turn, 0.768_114_574_786_860_7, 2e-16);
    close(screw.shift, -16.957_105_655_252_31, 3e-16);
}

/// The axis is a million kilometres away, if lengths are millimetres.
#[test]
fn a_body_that_hardly_turns() {
    let omega = [3.0, -0.5, 10.0].map(|x| x * 2.0_f64.powi(-44));
    let at = vector([760.0, -20.5, 320.25]);
    let screw: Screw = Screw::of(vector(omega), vector([0.1, 0.7, -0.2]), at);
    let point = [
        -1_111_085_433_624.168_5,
        257_642_999_256.988_34,
        346_207_780_599.374_94,
    ];
    near(screw.point, point, 3e-16);
    close(screw.turn, 5.941_429_026_383_637e-13, 3e-16);
    close(screw.shift, -0.196_129_598_026_325_35, 1e-15);
    near(screw.velocity(at), [0.1, 0.7, -0.2], 5e-16);
}

#[test]
fn a_body_that_only_shifts_has_no_axis() {
    let (zero, at) = (Vector3::zeros(), vector(AT));
    let screw: Screw = Screw::of(zero, vector([-6.0, 2.0, 3.0]), at);
    assert!(screw.is_shift() && screw.pitch().is_infinite());
    near(screw.direction, [-6.0 / 7.0, 2.0 / 7.0, 3.0 / 7.0], 1e-16);
    assert_eq!((screw.turn, screw.shift, screw.point), (0.0, 7.0, at));
    near(screw.velocity(zero), [-6.0, 2.0, 3.0], 2e-16);
    // Its axis is farther away than any number.
    let far: Screw = Screw::of(vector([0.0, 0.0, 1e-200]), vector([1e200, 0.0, 0.0]), at);
    assert_eq!(
        far,
        Screw::of(vector([0.0; 3]), vector([1e200, 0.0, 0.0]), at)
    );
    let rest: Screw = Screw::of(zero, zero, at);
    assert!(rest.is_shift() && rest.pitch().is_nan());
    assert_eq!((rest.direction, rest.velocity(zero)), (zero, zero));
}

#[test]
fn a_body_that_only_turns_does_not_shift() {
    for size in [5e-324, 1e-310, 1e-300, 1.0, 1e300] {
        let at = vector(AT);
        let screw: Screw = Screw::of(vector([0.0, -size, 0.0]), Vector3::zeros(), at);
        assert_eq!((screw.turn, screw.shift, screw.pitch()), (size, 0.0, 0.0));
        assert_eq!((screw.direction, screw.point), (-Vector3::y(), at));
    }
}

#[test]
fn what_has_no_position_has_no_screw() {
    let [nothing, something, infinite] = [f64::NAN, 1.0, f64::INFINITY].map(|x| vector([x; 3]));
    for (omega, velocity) in [
        (nothing, something),
        (something, nothing),
        (Vector3::zeros(), nothing),
        (infinite, something),
    ] {
        let screw: Screw = Screw::of(omega, velocity, something);
        assert!(screw.turn.is_nan() && screw.shift.is_nan() && !screw.is_shift());
        let vectors = [screw.direction, screw.point, screw.velocity(something)];
        assert!(vectors.iter().flatten().all(|x| x.is_nan()), "{screw:?}");
    }
}

/// The velocity of any point is that of the rigid body, which whole numbers give exactly; at all
/// sizes, and from bodies that hardly shift to bodies that hardly turn.
#[test]
fn velocities_are_those_of_the_body() {
    let mut random = Random::new(71);
    for _ in 0..4000 {
        let mut draw = || [0; 3].map(|_| random.below(2001) as i128 - 1000);
        let (omega, mut velocity, at, to) = (draw(), draw(), draw(), draw());
        // The ratio of the shift of the body to its turn, as a power of two; the other way round it
        // turns faster.
        let faster = random.below(90) as i32 - 20;
        let turning = 1_i128 << (-faster).max(0);
        velocity = velocity.map(|v| v << faster.max(0));
        let omega = omega.map(|w| w * turning);
        let exact = |to: [i128; 3]| {
            let arm: [i128; 3] = core::array::from_fn(|k| to[k] - at[k]);
            [
                velocity[0] + omega[1] * arm[2] - omega[2] * arm[1],
                velocity[1] + omega[2] * arm[0] - omega[0] * arm[2],
                velocity[2] + omega[0] * arm[1] - omega[1] * arm[0],
            ]
        };
        let [of_turning, of_lengths] = [0; 2].map(|_| random.below(900) as i32 - 450);
        let scaled = |v: [i128; 3], power: i32| vector(v.map(|x| x as f64 * 2.0_f64.powi(power)));
        let screw: Screw = Screw::of(
            scaled(omega, of_turning),
            scaled(velocity, of_turning + of_lengths),
            scaled(at, of_lengths),
        );
        let found = screw.velocity(scaled(to, of_lengths));
        let expected = scaled(exact(to), of_turning + of_lengths);
        // The sum of the roundings of the velocity, and of both points as they turn.
        let length = |v: [i128; 3]| v.iter().map(|x| (*x as f64).powi(2)).sum::<f64>().sqrt();
        let size = length(velocity) + length(omega) * (length(at) + length(to));
        let off = (found - expected).amax() * 2.0_f64.powi(-of_turning - of_lengths);
        assert!(off <= 1e-15 * size, "{off:e} of {size:e}: {screw:?}");
        close(screw.direction.norm(), 1.0, 5e-16);
        let arm = (screw.point - scaled(at, of_lengths)) * 2.0_f64.powi(-of_lengths);
        let along = arm.dot(&screw.direction);
        assert!(
            along.abs() <= 1e-15 * (arm.norm() + length(at)),
            "{screw:?}"
        );
    }
}

#[test]
fn single_precision_and_derivatives() {
    let single: Screw<f32> = Screw::of(
        vector(OMEGA).cast(),
        vector(VELOCITY).cast(),
        vector(AT).cast(),
    );
    assert_eq!(
        (single.turn, single.shift, single.pitch()),
        (7.0, 17.5, 2.5)
    );
    assert!((single.point.x - 53.0 / 49.0).abs() < 3e-7);
    let tiny: Screw<f32> = Screw::of(
        vector(OMEGA).cast() * 1e-30,
        vector(VELOCITY).cast() * 1e-30,
        vector(AT).cast(),
    );
    assert!((tiny.pitch() - 2.5).abs() < 1e-6 && (tiny.turn - 7e-30).abs() < 1e-36);
    // The divisor is the speed of the turn: with twice the speed the pitch is half, v / w.
    let number = |value: f64, slope: f64| Dual(num_dual::Dual64::new(value, slope));
    let constant = |v: [f64; 3]| Vector3::from(v.map(|x| number(x, 0.0)));
    let omega = Vector3::from(OMEGA.map(|x| number(x, x)));
    let screw = Screw::of(omega, constant(VELOCITY), constant(AT));
    assert_eq!((screw.turn.0.re, screw.turn.0.eps), (7.0, 7.0));
    close(screw.pitch().0.eps, -2.5, 5e-16);
    assert!(screw.shift.0.eps.abs() < 2e-14);
}

#[test]
fn it_is_shown_by_components() {
    let screw: Screw = Screw::of(Vector3::z(), Vector3::z() * 2.0, Vector3::x());
    let shown: Vec<&str> = Vec::from([
        "Screw { direction: {x: 0.0, y: 0.0, z: 1.0}",
        "point: {x: 1.0, y: 0.0, z: 0.0}",
        "turn: 1.0",
        "shift: 2.0 }",
    ]);
    assert_eq!(format!("{screw:?}"), shown.join(", "));
}
