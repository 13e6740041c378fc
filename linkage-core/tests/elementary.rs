//! Special values of the elementary functions, with and without fused multiply-add.
#![cfg(any(feature = "std", feature = "libm"))]

use linkage_core::Scalar;

macro_rules! special_values {
    ($float:ident, $limit:expr) => {
        mod $float {
            use super::*;
            use core::$float::consts::{FRAC_PI_2, FRAC_PI_4, PI};

            const INFINITE: $float = $float::INFINITY;

            /// With fused multiply-add and without; of single calls, and of rows.
            fn sine_pairs(x: $float) -> [($float, $float); 4] {
                [
                    x.sin_cos_with::<true>(),
                    x.sin_cos_with::<false>(),
                    x.sin_cos_shortest::<true, false>(),
                    x.sin_cos_shortest::<true, true>(),
                ]
            }

            #[test]
            fn the_sine_pair_of_zero_is_exact() {
                assert_eq!(sine_pairs(0.0), [(0.0, 1.0); 4]);
                assert_eq!(sine_pairs(-0.0), [(0.0, 1.0); 4]);
                let least = $float::from_bits(1);
                assert_eq!(sine_pairs(least), [(least, 1.0); 4]);
                assert_eq!(sine_pairs(-least), [(-least, 1.0); 4]);
            }

            #[test]
            fn the_sine_pair_is_nan_from_the_limit_on() {
                let limit: $float = $limit;
                for x in [
                    limit,
                    limit.next_up(),
                    $float::MAX,
                    $float::INFINITY,
                    $float::NAN,
                ] {
                    for (s, c) in [sine_pairs(x), sine_pairs(-x)].concat() {
                        assert!(s.is_nan() && c.is_nan(), "{x:e}");
                    }
                }
                for (s, c) in sine_pairs(limit.next_down()) {
                    assert!((s * s + c * c - 1.0).abs() < 4.0 * $float::EPSILON);
                }
            }

            #[test]
            fn sine_is_odd_and_cosine_even() {
                for k in 1..2000 {
                    let x = 0.37 * k as $float;
                    for ((s, c), (t, d)) in sine_pairs(x).into_iter().zip(sine_pairs(-x)) {
                        assert_eq!((s, c), (-t, d));
                    }
                }
            }

            /// The bits of both numbers; all NaN are one.
            fn bits((s, c): ($float, $float)) -> [Option<[u8; size_of::<$float>()]>; 2] {
                [s, c].map(|x| (!x.is_nan()).then(|| x.to_ne_bytes()))
            }

            #[test]
            fn the_sine_pair_of_rows_is_that_of_single_numbers_to_the_last_bit() {
                let special = [
                    0.0,
                    -0.0,
                    $float::MIN_POSITIVE,
                    $limit,
                    $float::NAN,
                    INFINITE,
                ];
                let turns = (-4000..4000).map(|k| 0.1 * k as $float);
                let right_angles = (-40..40).map(|k| k as $float * FRAC_PI_2);
                let large = (0..40).map(|k| $limit / (1.0 + k as $float));
                for x in turns.chain(right_angles).chain(large).chain(special) {
                    let [fused, plain, ..] = sine_pairs(x).map(bits);
                    assert_eq!(bits(x.sin_cos_in_rows::<true, true>()), fused, "{x:e}");
                    assert_eq!(bits(x.sin_cos_in_rows::<false, true>()), plain, "{x:e}");
                    assert_eq!(bits(x.sin_cos_in_rows::<true, false>()), fused, "{x:e}");
                    for rows in [
                        x.sin_cos_shortest::<false, true>(),
                        x.sin_cos_shortest::<false, false>(),
                    ] {
                        assert_eq!(bits(rows), plain, "{x:e}");
                    }
                }
            }

            fn angles(y: $float, x: $float) -> [$float; 2] {
                [y.atan2_with::<true>(x), y.atan2_with::<false>(x)]
            }

            /// `angle` to the last bit, for the vector and its mirror image.
            fn angle_is(y: $float, x: $float, angle: $float) {
                for (found, mirrored) in angles(y, x).into_iter().zip(angles(-y, x)) {
                    assert_eq!(found.to_bits(), angle.to_bits(), "{y:e} {x:e}");
                    assert_eq!(mirrored.to_bits(), (-angle).to_bits(), "-{y:e} {x:e}");
                }
            }

            #[test]
            fn angles_along_the_axes_and_diagonals_are_exact() {
                let least = $float::from_bits(1);
                for size in [least, 1.0, 3.0e-20, $float::MAX, INFINITE] {
                    angle_is(0.0, size, 0.0);
                    angle_is(0.0, -size, PI);
                    angle_is(size, 0.0, FRAC_PI_2);
                    angle_is(size, -0.0, FRAC_PI_2);
                    angle_is(size, size, FRAC_PI_4);
                    angle_is(size, -size, 3.0 * FRAC_PI_4);
                }
                angle_is(0.0, 0.0, 0.0);
                angle_is(0.0, -0.0, PI);
            }

            #[test]
            fn angles_of_infinite_vectors_are_those_of_their_directions() {
                for size in [0.0, 1.0, 1e20] {
                    angle_is(size, INFINITE, 0.0);
                    angle_is(size, -INFINITE, PI);
                    angle_is(INFINITE, size, FRAC_PI_2);
                    angle_is(INFINITE, -size, FRAC_PI_2);
                }
            }

            #[test]
            fn angles_pass_nan_on() {
                for x in [0.0, 1.0, INFINITE, $float::NAN] {
                    for angle in [angles($float::NAN, x), angles(x, $float::NAN)].concat() {
                        assert!(angle.is_nan(), "{x:e}");
                    }
                }
            }
        }
    };
}

special_values!(f64, 1_073_741_824.0);
special_values!(f32, 1_048_576.0);

/// Fewer digits need no other way: in single precision the shortest is that of all.
#[test]
fn single_sine_pairs_are_the_same_in_all_ways() {
    for k in -40_000..40_000 {
        let x = 0.037 * k as f32;
        let pair = x.sin_cos_with::<true>();
        assert_eq!(x.sin_cos_shortest::<true, true>(), pair, "{x:e}");
        assert_eq!(x.sin_cos_shortest::<true, false>(), pair, "{x:e}");
    }
}
