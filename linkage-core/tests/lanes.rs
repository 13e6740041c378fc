//! SIMD types give in every lane what plain numbers give.
#![cfg(all(feature = "simba", feature = "std"))]

use linkage_core::{Lanes, Scalar};
use linkage_random::Random;
use simba::simd::{AutoF32x4, AutoF64x4, WideF32x8, WideF64x4};

/// Compares every function lane by lane with type `$plain`, to `$places` units in the last place.
macro_rules! compare {
    ($name:ident, $simd:ty, $plain:ident, $lanes:expr, $places:expr) => {
        #[test]
        fn $name() {
            type L = Lanes<$simd>;
            assert_eq!(L::LANES, $lanes);
            let mut random = Random::new(11);
            let special = [0.0, -0.0, 1.0, -1.0, f64::NAN, 1e-9, -1e-18, f64::INFINITY];
            for round in 0..400 {
                let mut draw = |index: usize| match round {
                    0..8 => special[(round + index * 3) % 8],
                    8..16 => special[(round + index * 5) % 8] * 0.5,
                    _ => f64::from(random.between(-1.0, 1.0) as $plain),
                };
                let [a, b, c] = std::array::from_fn(|_| L::from_lanes(&mut draw));
                let same =
                    |what: &str, vector: L, plain: &dyn Fn($plain, $plain, $plain) -> $plain| {
                        for lane in 0..L::LANES {
                            let [a, b, c] = [a, b, c].map(|x| x.lane(lane) as $plain);
                            let (found, exact) = (vector.lane(lane) as $plain, plain(a, b, c));
                            let error = (found - exact).abs();
                            let near = found == exact
                                || found.is_nan() && exact.is_nan()
                                || error <= $places * $plain::EPSILON * exact.abs().max(1.0);
                            assert!(near, "{what} of {a} {b} {c}: {found}, not {exact}");
                        }
                    };
                same("abs", a.abs(), &|a, _, _| Scalar::abs(a));
                same("sqrt", a.sqrt(), &|a, _, _| Scalar::sqrt(a));
                same("tan", a.tan(), &|a, _, _| Scalar::tan(a));
                same("asin", a.asin(), &|a, _, _| Scalar::asin(a));
                same("acos", a.acos(), &|a, _, _| Scalar::acos(a));
                same("atan", a.atan(), &|a, _, _| Scalar::atan(a));
                same("sin", a.sin_cos().0, &|a, _, _| Scalar::sin_cos(a).0);
                same("cos", a.sin_cos().1, &|a, _, _| Scalar::sin_cos(a).1);
                same("atan2", a.atan2(b), &|a, b, _| Scalar::atan2(a, b));
                same("hypot", a.hypot(b), &|a, b, _| Scalar::hypot(a, b));
                same("min", a.min(b), &|a, b, _| Scalar::min(a, b));
                same("max", a.max(b), &|a, b, _| Scalar::max(a, b));
                same("sign", a.sign(), &|a, _, _| Scalar::sign(a));
                same("whole", a.whole(), &|a, _, _| Scalar::whole(a));
                same("scale", a.inverse_scale(), &|a, _, _| {
                    Scalar::inverse_scale(a)
                });
                same("slack", a.slack(), &|a, _, _| Scalar::slack(a));
                let slack = L::from_f64(1e-6);
                same("root", a.root_with::<false>(slack, b), &|a, b, _| {
                    Scalar::root_with::<false>(a, 1e-6, b)
                });
                same("unless_negative", L::unless_negative(a, b), &|a, b, _| {
                    Scalar::unless_negative(a, b)
                });
                same("select", L::select(a, b, c), &|a, b, c| {
                    $plain::select(a, b, c)
                });
                let guide = c * L::from_f64(100.0);
                same("angle", L::angle_near(a, b, guide), &|a, b, c| {
                    $plain::angle_near(a, b, c * 100.0)
                });
                same("sum", (a + b) * c - a / b, &|a, b, c| (a + b) * c - a / b);
                let mut assigned = a;
                assigned += b;
                assigned *= c;
                assigned -= a / b;
                same("assigned", -assigned, &|a, b, c| -((a + b) * c - a / b));
            }
        }
    };
}

compare!(automatic_f64, AutoF64x4, f64, 4, 2.0);
compare!(automatic_f32, AutoF32x4, f32, 4, 2.0);
compare!(wide_f64, WideF64x4, f64, 4, 4.0);
compare!(wide_f32, WideF32x8, f32, 8, 4.0);
