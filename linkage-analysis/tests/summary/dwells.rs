//! Dwells and bands with known ends.

use crate::{PI, TAU, near, turn};
use linkage_analysis::summary::Curve;

#[test]
fn around_limits() {
    let course = turn(|x: f64| [x.cos(), -x.sin(), -x.cos()]);
    let band = 1.0 - 0.2_f64.cos();
    let dwells = course.dwells(band);
    assert_eq!(dwells.len(), 2);
    // Around pi, and across the seam; sorted by their beginnings.
    near(dwells[0].interval.from, PI - 0.2, 1e-14);
    near(dwells[0].interval.to, PI + 0.2, 1e-14);
    near(dwells[1].interval.from, TAU - 0.2, 1e-14);
    near(dwells[1].interval.to, 0.2, 1e-14);
    for dwell in dwells {
        near(dwell.interval.range, 0.4, 1e-13);
        near(dwell.highest - dwell.lowest, band, 1e-15);
        assert_eq!(dwell.ripple, 0.0);
    }
    assert_eq!(course.dwells(2.5).len(), 1);
    near(course.dwells(2.5)[0].interval.range, TAU, 0.0);
    assert!(course.dwells(0.0).is_empty() && course.dwells(-1.0).is_empty());
    assert!(course.dwells(f64::NAN).is_empty() && course.longest_dwell(0.0).is_none());
}

/// x^4 - 2 x^2 has two hollows of -1 and a summit of 0 between them.
fn double_hollow(x: f64) -> [f64; 4] {
    let s = x * x;
    [
        s * s - 2.0 * s,
        4.0 * x * (s - 1.0),
        12.0 * s - 4.0,
        24.0 * x,
    ]
}

#[test]
fn ripple() {
    let course = Curve::new((-2.0, 2.0), 80, double_hollow).expect("a course");
    // Wide enough for the summit: one dwell, from one slope to the other. (s - 1)^2 = 1.21 there.
    let dwell = course.longest_dwell(1.21).expect("a dwell");
    near(dwell.interval.from, -(2.1_f64.sqrt()), 1e-14);
    near(dwell.interval.to, 2.1_f64.sqrt(), 1e-14);
    near(dwell.ripple, 1.0, 1e-15);
    // Too narrow for it: two hollows and the summit, 0.25 = (s - 1)^2 beside the hollows.
    let dwells = course.dwells(0.25);
    let near_hollow = dwells
        .iter()
        .find(|dwell| dwell.lowest < -0.9 && dwell.interval.from > 0.0);
    let hollow = near_hollow.expect("the right hollow");
    near(hollow.interval.from, 0.5_f64.sqrt(), 1e-14);
    near(hollow.interval.to, 1.5_f64.sqrt(), 1e-14);
    assert_eq!(hollow.ripple, 0.0);
}

#[test]
fn around_an_inflection() {
    let cube = |x: f64| [x * x * x, 3.0 * x * x, 6.0 * x];
    let falling = |x: f64| cube(x).map(|value| -value);
    for course in [
        Curve::new((-1.0, 1.3), 50, &cube as &dyn Fn(f64) -> [f64; 3]),
        Curve::new((-1.0, 1.3), 50, &falling),
    ] {
        let dwells = course.expect("a course").dwells(2e-6);
        let dwell = dwells
            .iter()
            .find(|dwell| dwell.interval.from < 0.0 && dwell.interval.to > 0.0);
        let interval = dwell.expect("a dwell").interval;
        // The speeds at the ends are equal to rounding, which leaves a few units of the last place of the length.
        near(interval.from, -0.01, 1e-12);
        near(interval.range, 0.02, 1e-15);
    }
}

#[test]
fn a_pilgrim_step() {
    // Rises by 2 pi in a turn, with a way back around pi: the dwell is symmetrical to it.
    let course = turn(|x: f64| [x + 1.2 * x.sin(), 1.0 + 1.2 * x.cos(), -1.2 * x.sin()]);
    let dwell = course.longest_dwell(0.3).expect("a dwell");
    near(dwell.interval.from + dwell.interval.to, TAU, 1e-12);
    near(dwell.highest - dwell.lowest, 0.3, 1e-14);
    let back = (1.0_f64 / 1.2).acos();
    near(dwell.ripple, 2.0 * (1.2 * back.sin() - back), 1e-14);

    // Half a turn on, across the seam.
    let course = turn(|x: f64| [x - 1.2 * x.sin(), 1.0 - 1.2 * x.cos(), 1.2 * x.sin()]);
    let across = course.longest_dwell(0.3).expect("a dwell");
    near(across.interval.range, dwell.interval.range, 1e-13);
    near(across.interval.from + across.interval.to, TAU, 1e-12);
    assert!(across.interval.to < 2.0 && across.interval.from > 4.0);
}

#[test]
fn within_bounds() {
    let course = turn(|x: f64| [x.cos(), -x.sin(), -x.cos()]);
    let found = course.within(0.5, 2.0);
    assert_eq!(found.len(), 1);
    near(found[0].from, TAU - PI / 3.0, 1e-14);
    near(found[0].to, PI / 3.0, 1e-14);
    near(found[0].range, TAU / 3.0, 1e-14);
    let found = course.within(-0.5, 0.5);
    assert_eq!(found.len(), 2);
    near(found[0].from, PI / 3.0, 1e-14);
    near(found[1].to, TAU - PI / 3.0, 1e-14);
    assert_eq!(course.within(-2.0, f64::INFINITY).len(), 1);
    assert_eq!(course.within(-2.0, 2.0)[0].range, TAU);
    assert!(course.within(2.0, 3.0).is_empty() && course.within(0.5, -0.5).is_empty());
    assert!(course.within(f64::NAN, 1.0).is_empty());

    // An angle that advances over the turn: no interval goes across the end of the range.
    let course = turn(|x: f64| [x + 0.5 * x.sin(), 1.0 + 0.5 * x.cos(), -0.5 * x.sin()]);
    let found = course.within(-1.0, PI);
    assert_eq!(found.len(), 1);
    near(found[0].from, 0.0, 1e-15);
    near(found[0].to, PI, 1e-14);
    let found = course.within(PI, 7.0);
    assert_eq!(found.len(), 1);
    near(found[0].to, TAU, 1e-15);
    assert_eq!(course.within(-1.0, 7.0).len(), 1);
}
