//! Where a figure is largest.

use std::f64::consts::{PI, TAU};

use linkage_analysis::tolerance::{ToleranceError, largest, largest_at};

use super::near;

#[test]
fn inside_and_at_the_ends() {
    let inside = largest(0.0..TAU, 50, |x| (x - 1.0).cos()).expect("it is assembled");
    near(inside.at, 1.0, 1e-7);
    near(inside.value, 1.0, 1e-15);
    let corner = largest(0.0..TAU, 50, |x| -(x - 2.0).abs()).expect("it is assembled");
    near(corner.at, 2.0, 1e-12);
    assert_eq!(
        largest(-1.0..2.0, 9, |x| x).expect("it is assembled").at,
        2.0
    );
    assert_eq!(
        largest(-1.0..2.0, 9, |x| -x).expect("it is assembled").at,
        -1.0
    );
    assert_eq!(
        largest(0.0..1.0, 2, |_| 3.0)
            .expect("it is assembled")
            .value,
        3.0
    );
}

/// The highest sample is not on the highest summit.
#[test]
fn the_right_one_of_two_summits() {
    let figure = |x: f64| {
        let narrow = 1.0 - 30.0 * (x - 1.05).abs();
        narrow.max(0.9 - (x - 4.0).powi(2))
    };
    let found = largest(0.0..6.0, 61, figure).expect("it is assembled");
    near(found.at, 1.05, 1e-9);
}

#[test]
fn what_is_not_assembled_is_left_out() {
    let figure = |x: f64| if x > PI { f64::NAN } else { x };
    let found = largest(0.0..TAU, 101, figure).expect("half of it is assembled");
    assert_eq!(found.missing, 50);
    near(found.at, PI, 1e-9);
    assert_eq!(
        largest(0.0..1.0, 10, |_| f64::NAN),
        Err(ToleranceError::NotAssembled)
    );
    assert_eq!(
        largest_at(&[1.0], |_| f64::NAN),
        Err(ToleranceError::NotAssembled)
    );
}

#[test]
fn bad_ranges() {
    let nothing = |range| {
        matches!(
            largest(range, 10, |x| x),
            Err(ToleranceError::Nothing { .. })
        )
    };
    assert!(nothing(1.0..1.0) && nothing(1.0..0.0) && nothing(0.0..f64::INFINITY));
    assert!(nothing(f64::NAN..1.0) && nothing(-f64::MAX..f64::MAX));
    assert!(largest(0.0..1.0, 1, |x| x).is_err() && largest_at(&[], |x| x).is_err());
}

#[test]
fn work_is_bounded() {
    let mut calls = 0;
    let wild = |x: f64| {
        calls += 1;
        (1e4 * x).sin()
    };
    largest(0.0..TAU, 1000, wild).expect("it is assembled");
    assert!(calls < 3000, "{calls}");
}
