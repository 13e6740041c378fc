//! `f64` and `f32` as scalars: special values, and properties on many numbers.
#![cfg(any(feature = "std", feature = "libm"))]

use core::f64::consts::{PI, TAU};
use linkage_core::Scalar;
use linkage_random::Random;

macro_rules! special_values {
    ($float:ident) => {
        mod $float {
            use linkage_core::Scalar;

            const NAN: $float = $float::NAN;
            const INF: $float = $float::INFINITY;

            #[test]
            fn a_root_forgives_rounding_only() {
                let tiny = $float::EPSILON;
                let slack = |x: $float| Scalar::slack(x);
                let root = |q: $float, slack, size| Scalar::root_with::<false>(q, slack, size);
                assert_eq!(slack(-3.0), 24.0 * tiny);
                assert!(slack(NAN).is_nan() && slack(-INF).is_nan());
                let one = slack(1.0);
                assert_eq!(root(4.0, one, 100.0), 2.0);
                assert_eq!(root(0.0, one, 100.0), 0.0);
                assert_eq!(root(-0.0, 0.0, 0.0).to_bits(), 0);
                assert_eq!(root(-7.0 * tiny, one, 1.0), 0.0);
                assert_eq!(root(-8.0 * tiny, slack(-0.5), 2.0), 0.0);
                assert!(root(-9.0 * tiny, one, 1.0).is_nan());
                assert!(root(-1.0, one, 0.0).is_nan());
                assert!(root(NAN, one, 1.0).is_nan());
                assert!(root(-1.0, one, NAN).is_nan());
                assert!(root(4.0, NAN, 1.0).is_nan());
                assert!(root(-INF, one, INF).is_nan());
                assert!(root(-INF, one, 1.0).is_nan());
                assert_eq!(root(4.0, one, INF), 2.0);
                assert_eq!(root(INF, one, 1.0), INF);
            }

            #[test]
            fn choices_follow_the_sign_and_pass_nan_on() {
                assert_eq!($float::select(0.0, 1.0, 2.0), 1.0);
                assert_eq!($float::select(-0.0, 1.0, 2.0), 1.0);
                assert_eq!($float::select(-1e-30, 1.0, 2.0), 2.0);
                assert_eq!($float::select(1.0, 1.0, NAN), 1.0);
                assert!($float::select(NAN, 1.0, 2.0).is_nan());
                assert_eq!(Scalar::sign(-0.0 as $float), 1.0);
                assert_eq!(Scalar::sign(-3.0 as $float), -1.0);
                assert!(Scalar::sign(NAN).is_nan());
                assert_eq!(<$float as Scalar>::min(INF, INF), INF);
                assert_eq!(<$float as Scalar>::min(1.0, 2.0), 1.0);
                assert_eq!(<$float as Scalar>::max(1.0, 2.0), 2.0);
                for other in [-1.0, 0.0, INF, NAN] {
                    assert!(<$float as Scalar>::min(NAN, other).is_nan());
                    assert!(<$float as Scalar>::min(other, NAN).is_nan());
                    assert!(<$float as Scalar>::max(NAN, other).is_nan());
                    assert!(<$float as Scalar>::max(other, NAN).is_nan());
                }
            }

            #[test]
            fn whole_numbers_are_the_nearest_and_then_even() {
                for (x, whole) in [
                    (0.49, 0.0),
                    (-0.49, 0.0),
                    (0.5, 0.0),
                    (1.5, 2.0),
                    (-2.5, -2.0),
                ] {
                    assert_eq!(
                        $float::whole(x).to_bits(),
                        (whole as $float).to_bits(),
                        "{x}"
                    );
                }
                let large = 0.25 / $float::EPSILON;
                assert_eq!($float::whole(large + 1.0), large + 1.0);
                assert_eq!($float::whole(-INF), -INF);
                assert!($float::whole(NAN).is_nan());
            }

            #[test]
            fn scales_are_finite_powers_of_two() {
                for x in [0.0, -0.0, INF, -INF, NAN, 1.0, -1.0, 1.99] {
                    assert_eq!(Scalar::inverse_scale(x), 1.0, "{x}");
                }
                assert_eq!(Scalar::inverse_scale(-1024.0 as $float), 1.0 / 1024.0);
                for x in [$float::MAX, $float::MIN_POSITIVE, $float::from_bits(1), 0.3] {
                    let scale = Scalar::inverse_scale(x);
                    assert!(scale.is_finite() && scale > 0.0, "{x}");
                    assert_eq!(scale * Scalar::inverse_scale(scale), 1.0, "{x}");
                }
            }

            #[test]
            fn a_length_neither_overflows_nor_underflows() {
                assert_eq!(Scalar::hypot(3.0 as $float, -4.0), 5.0);
                assert_eq!(Scalar::hypot(0.0 as $float, 0.0), 0.0);
                assert_eq!(Scalar::hypot(0.0 as $float, $float::MAX), $float::MAX);
                let least = $float::from_bits(1);
                assert_eq!(Scalar::hypot(least, 0.0), least);
                assert_eq!(Scalar::hypot(3.0 * least, 4.0 * least), 5.0 * least);
                assert_eq!(Scalar::hypot(INF, 1.0), INF);
                assert!(Scalar::hypot(1.0, NAN).is_nan());
            }

            #[test]
            fn an_angle_that_does_not_exist_is_nan() {
                let (sin, cos) = Scalar::sin_cos(INF);
                assert!(sin.is_nan() && cos.is_nan());
                assert!($float::angle_near(NAN, 1.0, 0.0).is_nan());
                assert!($float::angle_near(1.0, NAN, 0.0).is_nan());
                assert!($float::angle_near(1.0, 1.0, NAN).is_nan());
            }
        }
    };
}

special_values!(f64);
special_values!(f32);

#[test]
fn lanes_of_a_plain_number() {
    assert_eq!((<f64 as Scalar>::LANES, <f32 as Scalar>::LANES), (1, 1));
    assert_eq!(f64::from_lanes(|index| 2.5 + index as f64).lane(0), 2.5);
    assert_eq!(<f32 as Scalar>::from_f64(0.1).lane(0), f64::from(0.1_f32));
}

#[cfg(feature = "std")]
#[test]
fn elementary_functions_are_those_of_the_library() {
    let mut random = Random::new(3);
    for _ in 0..1000 {
        let x = random.between(-1.0, 1.0);
        assert_eq!(Scalar::sqrt(x.abs()), x.abs().sqrt());
        assert_eq!(Scalar::tan(x), x.tan());
        assert_eq!(Scalar::asin(x), x.asin());
        assert_eq!(Scalar::acos(x), x.acos());
        assert_eq!(Scalar::atan(x), x.atan());
        let (sin, cos) = Scalar::sin_cos(x);
        assert!((sin - x.sin()).abs() <= f64::EPSILON && (cos - x.cos()).abs() <= f64::EPSILON);
        let angle = x.atan2(-0.5);
        assert!((Scalar::atan2(x, -0.5) - angle).abs() <= 2.0 * f64::EPSILON * angle.abs());
    }
}

#[test]
fn a_length_is_accurate_at_every_size() {
    let mut random = Random::new(1);
    for _ in 0..20_000 {
        let size = 2.0_f64.powf(random.between(-1000.0, 1000.0));
        let (a, b) = (
            random.between(-1.0, 1.0) * size,
            random.between(-1.0, 1.0) * size,
        );
        let (length, exact) = (Scalar::hypot(a, b), a.hypot(b));
        assert!(
            (length - exact).abs() <= 2.0 * f64::EPSILON * exact,
            "{a} {b}"
        );

        let scale = Scalar::inverse_scale(a);
        assert!(scale * a.abs() >= 0.99 && scale * a.abs() < 2.0, "{a}");
        if (1e-150..1e150).contains(&a.abs()) {
            assert!((scale * scale).is_normal(), "{a}");
        }
    }
}

#[test]
fn an_angle_counts_its_turns_to_the_last_place() {
    // A turn in radians in three parts, the first two short enough for exact products.
    let parts = [
        6.283185303211212,
        3.968374317722936e-9,
        2.4492935982947064e-16,
    ];
    assert_eq!(parts[0] + parts[1], TAU);
    let mut random = Random::new(2);
    for round in 0..50_000 {
        let most = if round % 2 == 0 { 3.0 } else { 1e6 };
        let turns = random.between(-most, most).round();
        let size = random.between(0.1, 100.0);
        let (sin, cos) = random.between(-PI, PI).sin_cos();
        let (y, x) = (size * sin, size * cos);
        let guide = y.atan2(x) + turns * TAU + random.between(-3.1, 3.1);
        let angle = f64::angle_near(y, x, guide);

        // Take the turns off again, largest part first.
        let rest = ((angle - turns * parts[0]) - turns * parts[1]) - turns * parts[2];
        let error = rest - y.atan2(x);
        let place = (angle.abs().max(1.0) * f64::EPSILON).max(4.0 * f64::EPSILON);
        assert!(error.abs() <= 1.5 * place, "{turns} turns: {error:e}");
    }
}

#[test]
fn an_angle_in_single_precision_counts_its_turns() {
    let mut random = Random::new(4);
    for _ in 0..20_000 {
        let turns = random.between(-2000.0, 2000.0).round();
        let (sin, cos) = random.between(-PI, PI).sin_cos();
        let (y, x) = (sin as f32, cos as f32);
        let exact = f64::from(y).atan2(f64::from(x)) + turns * TAU;
        let angle = f32::angle_near(y, x, (exact + random.between(-3.0, 3.0)) as f32);
        let place = exact.abs().max(4.0) * f64::from(f32::EPSILON);
        assert!((f64::from(angle) - exact).abs() <= place, "{turns} turns");
    }
}
