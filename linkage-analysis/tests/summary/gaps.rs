//! Positions that cannot be assembled.

use crate::{PI, TAU, near, turn};
use linkage_analysis::summary::{Curve, Kind, minimise};

/// sqrt(c - cos x) with three derivatives: a gap around 0.
fn gap_at_seam(c: f64) -> impl Fn(f64) -> [f64; 4] {
    move |x: f64| {
        let (sin, cos) = x.sin_cos();
        let q = (c - cos).sqrt();
        let q1 = 0.5 * sin / q;
        let q2 = (0.5 * cos - q1 * q1) / q;
        let q3 = (-0.5 * sin - 3.0 * q1 * q2) / q;
        [q, q1, q2, q3]
    }
}

#[test]
fn a_gap_at_the_ends() {
    let course = turn(gap_at_seam(0.5));
    assert!(course.has_gaps() && !course.is_cycle());
    let parts = course.parts();
    assert_eq!(parts.len(), 1);
    near(parts[0].from, PI / 3.0, 1e-14);
    near(parts[0].to, TAU - PI / 3.0, 1e-14);
    let highest = course.position().highest;
    near(highest.at, PI, 1e-12);
    near(highest.value, 1.5_f64.sqrt(), 1e-15);
    assert_eq!(course.position().points.len(), 3);
    assert!(course.position().lowest.end && course.position().lowest.value < 1e-7);
    assert_eq!(course.time_ratio(), None);
}

#[test]
fn a_gap_within_a_cycle_leaves_one_part_across_the_seam() {
    let function = gap_at_seam(0.5);
    let course = turn(move |x| function(x - PI));
    let parts = course.parts();
    assert_eq!(parts.len(), 1);
    near(parts[0].from, PI + PI / 3.0, 1e-14);
    near(parts[0].to, PI - PI / 3.0, 1e-14);
    near(parts[0].range, TAU * 2.0 / 3.0, 1e-13);
    let highest = course.position().highest;
    near(highest.at.min(TAU - highest.at), 0.0, 1e-12);
    // A dwell around the highest position crosses the seam.
    let dwell = course.longest_dwell(0.1).expect("a dwell");
    near(dwell.interval.from, TAU - dwell.interval.to, 1e-12);
    near(dwell.interval.range, 2.0 * dwell.interval.to, 1e-12);
    near(dwell.lowest, dwell.highest - 0.1, 1e-14);
}

#[test]
fn a_gap_narrower_than_the_spacing() {
    // Around the highest position, which is looked for.
    let course = turn(|x: f64| match (x - 1.5705).abs() < 1e-3 {
        true => [f64::NAN; 3],
        false => [x.sin(), x.cos(), -x.sin()],
    });
    let parts = course.parts();
    assert_eq!(parts.len(), 1);
    near(parts[0].from, 1.5715, 1e-12);
    near(parts[0].to, 1.5695, 1e-12);
    assert!(course.has_gaps());
    near(course.position().lowest.at, 1.5 * PI, 1e-14);
    let ends: Vec<Kind> = course
        .position()
        .points
        .iter()
        .filter(|point| point.end)
        .map(|point| point.kind)
        .collect();
    assert_eq!(ends, [Kind::High; 2]);
}

#[test]
fn several_gaps_and_single_positions() {
    let course = Curve::new((0.0, 10.0), 101, |x: f64| match (x as u64) % 2 {
        0 => [x.sin(), x.cos(), -x.sin()],
        _ => [f64::NAN; 3],
    });
    let course = course.expect("a course");
    let parts = course.parts();
    assert_eq!(parts.len(), 6);
    for (i, part) in parts.iter().enumerate() {
        near(part.from, 2.0 * i as f64, 1e-14);
        near(part.to, (2.0 * i as f64 + 1.0).min(10.0), 1e-14);
    }
    // The last one is a single position.
    assert_eq!(parts[5].range, 0.0);
    assert!(course.within(-2.0, 2.0).len() >= 5);
    assert!(course.dwells(3.0).len() >= 5);

    // Full of gaps: it ends, and gives what there is.
    let grain = |x: f64| {
        if x.to_bits().count_ones().is_multiple_of(2) {
            x.sin()
        } else {
            f64::NAN
        }
    };
    let course = turn(|x: f64| [grain(x), x.cos(), -x.sin()]);
    assert!(course.has_gaps());
    assert!(course.position().highest.value <= 1.0);
    let _ = (
        course.dwells(0.1),
        course.within(0.0, 0.5),
        course.transmission_angle(),
    );
}

#[test]
fn least_of_a_margin() {
    let margin = |x: f64| {
        if x > 5.0 {
            f64::NAN
        } else {
            0.4 + 0.3 * (x - 2.0).abs()
        }
    };
    let found = minimise((0.0, 6.0), 61, margin).expect("a margin");
    near(found.at, 2.0, 1e-9);
    near(found.value, 0.4, 1e-9);
    assert_eq!(found.missing, 10);
    assert!(minimise((0.0, 6.0), 61, |_| f64::NAN).is_err());
    assert!(minimise((1.0, 1.0), 61, margin).is_err() && minimise((0.0, 1.0), 1, margin).is_err());
}
