//! What operations do to numbers at the borders of their definitions.

use std::f64::consts::{PI, TAU};

use linkage_symbolic::program::{Binary, Fused, Ternary, Unary};

fn same(found: f64, expected: f64) -> bool {
    found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan()
}

#[test]
fn a_sign_is_one_or_minus_one() {
    for (number, sign) in [
        (0.0, 1.0),
        (-0.0, 1.0),
        (5e-324, 1.0),
        (-5e-324, -1.0),
        (f64::INFINITY, 1.0),
        (-3.0, -1.0),
        (f64::NAN, f64::NAN),
    ] {
        assert!(same(Unary::Sign.apply([number]), sign), "{number}");
    }
}

#[test]
fn scales_are_powers_of_two() {
    for exponent in -1022..=1022 {
        let power = 2.0_f64.powi(exponent);
        for number in [power, -power, power * 1.999] {
            let scale = Unary::InverseScale.apply([number]);
            assert_eq!(scale * power, 1.0, "{number}");
        }
    }
    for number in [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        assert_eq!(Unary::InverseScale.apply([number]), 1.0, "{number}");
    }
    // Where the mirrored exponent is that of no normal number, the next one is taken.
    for (number, exponent) in [(5e-324, 1022), (1e-310, 1022), (f64::MAX, -1022)] {
        assert_eq!(
            Unary::InverseScale.apply([number]),
            2.0_f64.powi(exponent),
            "{number}"
        );
    }
}

#[test]
fn the_smaller_and_the_larger_of_two() {
    let numbers = [f64::NEG_INFINITY, -2.0, -0.0, 0.0, 1.5, f64::INFINITY];
    for (i, &a) in numbers.iter().enumerate() {
        for (k, &b) in numbers.iter().enumerate() {
            let [least, most] = [numbers[i.min(k)], numbers[i.max(k)]];
            assert!(same(Binary::Min.apply([a, b]), least), "{a} {b}");
            // Of two zeros the negative one, here as there.
            let most = if most == 0.0 && (a == b) { least } else { most };
            assert!(same(Binary::Max.apply([a, b]), most), "{a} {b}");
        }
        for op in [Binary::Min, Binary::Max] {
            assert!(op.apply([a, f64::NAN]).is_nan() && op.apply([f64::NAN, a]).is_nan());
        }
    }
}

/// What the table says of signs.
#[test]
fn what_is_never_negative_is_so_of_all_numbers() {
    let numbers = [
        f64::NAN,
        f64::NEG_INFINITY,
        -1e300,
        -2.5,
        -0.0,
        1e-300,
        0.7,
        f64::INFINITY,
    ];
    let is_negative = |x: f64| x < 0.0;
    for a in numbers {
        for op in Unary::ALL.iter().filter(|op| op.row().never_negative) {
            assert!(!is_negative(op.apply([a])), "{op:?} {a}");
        }
        for b in numbers {
            for op in Binary::ALL.iter().filter(|op| op.row().never_negative) {
                assert!(!is_negative(op.apply([a, b])), "{op:?} {a} {b}");
            }
            for c in numbers {
                for op in Ternary::ALL.iter().filter(|op| op.row().never_negative) {
                    assert!(!is_negative(op.apply([a, b, c])), "{op:?} {a} {b} {c}");
                }
            }
        }
    }
}

/// 8 roundoffs of the scale below 0 are the dead point, and no more.
#[test]
fn roots_end_at_the_dead_point() {
    let root = |q: f64, scale: f64| {
        let slack = Unary::Slack.apply([scale]);
        Ternary::GuardedSqrt.apply([q, slack, 1.0])
    };
    assert_eq!([root(2.25, 1.0), root(1e-40, 1e9)], [1.5, 1e-20]);
    assert!(root(4.0, f64::NAN).is_nan());
    for scale in [1.0, -1.0, 3.7e5, 1e-12] {
        let limit = 8.0 * f64::EPSILON * f64::abs(scale);
        for (q, expected) in [
            (0.0, 0.0),
            (-0.0, 0.0),
            (-limit / 2.0, 0.0),
            (-limit, 0.0),
            (-limit * 1.001, f64::NAN),
            (-limit.sqrt(), f64::NAN),
        ] {
            assert!(same(root(q, scale), expected), "{q} {scale}");
        }
    }
    for (q, scale) in [(0.0, f64::NAN), (-1.0, f64::INFINITY), (f64::NAN, 1.0)] {
        assert!(root(q, scale).is_nan(), "{q} {scale}");
    }
}

#[test]
fn an_angle_is_the_nearest_to_its_guide() {
    for angle in [0.3, -2.9, 1.7, PI - 0.1] {
        for turns in -3..=3 {
            for off in [-3.0, -0.5, 0.0, 2.9] {
                let continued = angle + f64::from(turns) * TAU;
                let [y, x] = [2.5 * angle.sin(), 2.5 * angle.cos()];
                let found = Ternary::AngleNear.apply([y, x, continued + off]);
                assert!(
                    (found - continued).abs() < 1e-14,
                    "{angle} {turns} {off}: {found}"
                );
            }
        }
    }
}

#[test]
fn a_choice_is_by_the_sign() {
    for (s, expected) in [
        (1e-300, 7.0),
        (0.0, 7.0),
        (-0.0, 7.0),
        (-1e-300, 9.0),
        (f64::NAN, f64::NAN),
    ] {
        assert!(same(Ternary::Select.apply([s, 7.0, 9.0]), expected), "{s}");
    }
}

#[test]
fn products_and_sums_are_of_their_operands() {
    let operands = [3.0, 5.0, 7.0];
    let found = [Fused::MulAdd, Fused::MulSub, Fused::SubMul].map(|op| op.apply(operands));
    assert_eq!(found, [22.0, 8.0, -8.0]);
}

/// Functions are calls: they take the time and the place of many additions, and their results come late.
#[test]
fn functions_cost_more_than_sums() {
    let sum = Binary::Add.row();
    let functions = [
        Unary::Sin,
        Unary::Cos,
        Unary::Tan,
        Unary::Asin,
        Unary::Acos,
        Unary::Atan,
    ];
    for op in functions {
        let row = op.row();
        assert!(row.latency > 3 * sum.latency, "{op:?}");
        assert!(
            row.time >= 20 * sum.time && row.size >= 20 * sum.size,
            "{op:?}"
        );
    }
    let (two, three) = (Binary::Atan2.row(), Ternary::AngleNear.row());
    assert!(two.latency > 3 * sum.latency);
    for (time, size) in [(two.time, two.size), (three.time, three.size)] {
        assert!(time >= 20 * sum.time && size >= 20 * sum.size);
    }
}
