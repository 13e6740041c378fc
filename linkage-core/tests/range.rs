//! Where a margin fails in a range.

use linkage_core::numeric::range::{first_failure, minimum};
use std::f64::consts::PI;

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}");
}

#[test]
fn a_margin_that_stays_positive_does_not_fail() {
    assert_eq!(
        first_failure(0.0, 2.0 * PI, 0.5, 100, |x| 1.2 + x.sin()),
        None
    );
    assert_eq!(first_failure(0.0, 2.0 * PI, 0.5, 100, |_| 1.0), None);
    assert_eq!(first_failure(1.0, 1.0, 1.0, 100, |_| 1.0), None);
}

#[test]
fn a_sign_change_is_located() {
    let failure = first_failure(0.0, 10.0, 1.0, 7, |x| 5.3 - x).unwrap();
    close(failure.at, 5.3, 1e-11);
    assert!(failure.above && failure.margin < 0.0);

    let failure = first_failure(0.0, 10.0, 9.0, 7, |x| x - 5.3).unwrap();
    close(failure.at, 5.3, 1e-11);
    assert!(!failure.above);
}

#[test]
fn the_interval_is_counted_from_the_lower_end() {
    let failure = first_failure(0.0, 10.0, 0.0, 10, |x| 5.3 - x).unwrap();
    assert_eq!(failure.index, 5);
    let failure = first_failure(0.0, 10.0, 10.0, 10, |x| x - 0.3).unwrap();
    assert_eq!(failure.index, 0);
}

#[test]
fn beyond_the_boundary_the_margin_may_be_nan() {
    let margin = |x: f64| (1.0 - x * x).sqrt();
    let failure = first_failure(-0.5, 3.0, 0.0, 20, margin).unwrap();
    close(failure.at, 1.0, 1e-11);
    assert!(failure.margin.is_nan() && failure.above);

    let failure = first_failure(-3.0, 0.5, 0.0, 20, margin).unwrap();
    close(failure.at, -1.0, 1e-11);
    assert!(!failure.above);
}

#[test]
fn the_failure_nearest_to_the_lower_end_is_reported() {
    // Works in 1..2, 3..4 and 5..6.
    let margin = |x: f64| -(PI * x).sin();
    let failure = first_failure(1.2, 5.8, 5.5, 200, margin).unwrap();
    close(failure.at, 2.0, 1e-11);
    assert!(failure.above);
    let failure = first_failure(0.2, 5.8, 5.5, 200, margin).unwrap();
    close(failure.at, 1.0, 1e-11);
    assert!(!failure.above);
}

#[test]
fn a_dip_between_samples_is_found() {
    let bottom = 3.123_456;
    for depth in [1e-2, 1e-6, 1e-10] {
        let margin = |x: f64| (x - bottom).powi(2) - depth;
        let failure = first_failure(0.0, 2.0 * PI, 0.1, 12, margin).unwrap();
        close(
            failure.at,
            bottom - depth.sqrt(),
            1e-10 + 1e-3 * depth.sqrt(),
        );
        assert!(failure.above && failure.margin < 0.0);
    }
    // The bottom has no margin at all.
    let margin = |x: f64| ((x - bottom).powi(2) - 1e-4).sqrt();
    let failure = first_failure(0.0, 2.0 * PI, 0.1, 12, margin).unwrap();
    close(failure.at, bottom - 1e-2, 1e-10);
}

#[test]
fn a_dip_beside_an_end_is_found() {
    for bottom in [0.05, 2.0 * PI - 0.05] {
        let margin = |x: f64| (x - bottom).powi(2) - 1e-6;
        let failure = first_failure(0.0, 2.0 * PI, 3.0, 12, margin).unwrap();
        close(failure.at, bottom - 1e-3, 1e-10);
    }
}

#[test]
fn touching_zero_is_no_failure() {
    for touch in [1.0, 2.345_678_9, 3.0] {
        let square = |x: f64| x * x - 2.0 * touch * x + touch * touch;
        assert_eq!(first_failure(0.0, 6.0, 0.5, 60, square), None);
        let corner = |x: f64| (x - touch).abs();
        assert_eq!(first_failure(0.0, 6.0, 0.5, 60, corner), None);
    }
    // At the ends of the range too.
    assert_eq!(first_failure(0.0, PI, 1.0, 60, f64::sin), None);
}

#[test]
fn a_slow_failure_near_the_end_is_found() {
    let failure = first_failure(0.0, 1000.0, 1.0, 50, |x| (999.5 - x) * 1e-6).unwrap();
    close(failure.at, 999.5, 1e-8);
}

#[test]
fn a_range_of_several_turns_is_searched_throughout() {
    // Fails first in the fifth turn.
    let margin = |x: f64| 1.0 - 0.2 * x / (2.0 * PI) + 0.1 * x.cos();
    let failure = first_failure(0.0, 12.0 * PI, 0.5, 720, margin).unwrap();
    assert!(failure.at > 8.0 * PI && failure.at < 10.0 * PI);
    close(margin(failure.at), 0.0, 1e-11);
}

#[test]
fn a_margin_that_is_nowhere_positive_fails_at_the_lower_end() {
    for value in [-1.0, f64::NAN] {
        let failure = first_failure(-2.0, 3.0, 0.0, 10, |_| value).unwrap();
        assert_eq!((failure.at, failure.index, failure.above), (-2.0, 0, true));
    }
}

#[test]
fn the_minimum_is_refined() {
    let (x, margin) = minimum(0.0, 6.0, 13, |x| 2.0 + (x - 4.567).powi(2));
    close(x, 4.567, 1e-6);
    close(margin, 2.0, 1e-12);
    let (x, margin) = minimum(0.0, 6.0, 13, |x| (x - 4.567).abs());
    close(x, 4.567, 1e-9);
    close(margin, 0.0, 1e-9);
    assert_eq!(minimum(1.0, 6.0, 13, |x| x), (1.0, 1.0));
    assert_eq!(minimum(1.0, 6.0, 13, |x| -x), (6.0, -6.0));
}

#[test]
fn the_minimum_is_nan_where_the_margin_is() {
    let (x, margin) = minimum(0.0, 6.0, 13, |x| (4.0 - x).sqrt());
    assert!(x > 4.0 && margin.is_nan());
}
