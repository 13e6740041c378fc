//! Mechanisms whose summaries are known.

use crate::{PI, TAU, near, turn};
use linkage_analysis::summary::{Curve, Kind};

/// A slider-crank with an offset: the slide and three derivatives.
fn slider_crank(crank: f64, rod: f64, offset: f64) -> impl Fn(f64) -> [f64; 4] {
    move |phi: f64| {
        let (sin, cos) = phi.sin_cos();
        let h = crank * sin - offset;
        // w^2 = rod^2 - h^2, differentiated as often as needed.
        let [h1, h2, h3] = [crank * cos, -crank * sin, -crank * cos];
        let w = ((rod - h) * (rod + h)).sqrt();
        let w1 = -h * h1 / w;
        let w2 = -(h1 * h1 + h * h2 + w1 * w1) / w;
        let w3 = -(3.0 * h1 * h2 + h * h3 + 3.0 * w1 * w2) / w;
        [
            crank * cos + w,
            -crank * sin + w1,
            -crank * cos + w2,
            crank * sin + w3,
        ]
    }
}

#[test]
fn slider_crank_in_line() {
    let course = turn(slider_crank(50.0, 150.0, 0.0));
    assert!(course.is_cycle() && !course.has_gaps());
    let position = course.position();
    near(position.highest.value, 200.0, 1e-12);
    near(position.lowest.value, 100.0, 1e-12);
    near(position.highest.at, 0.0, 1e-12);
    near(position.lowest.at, PI, 1e-12);
    assert_eq!(position.points.len(), 2);
    let time = course.time_ratio().expect("two strokes");
    near(time.ratio(), 1.0, 1e-12);

    // The extreme velocity: sin^6 l^4 - sin^4 l^4 - sin^2 l^2 + l^2 ... is a cubic in s = sin^2 with l = rod / crank:
    // s^3 - l^2 s^2 - l^4 s + l^4 = 0.
    let l2: f64 = 9.0;
    let mut s: f64 = 0.8;
    for _ in 0..50 {
        let value = s * s * s - l2 * s * s - l2 * l2 * s + l2 * l2;
        s -= value / (3.0 * s * s - 2.0 * l2 * s - l2 * l2);
    }
    let velocity = course.velocity();
    near(velocity.largest().at.sin().powi(2), s, 1e-12);
    near(velocity.highest.value, -velocity.lowest.value, 1e-12);

    // Accelerations at the dead centres.
    let acceleration = course.acceleration();
    near(acceleration.lowest.value, -50.0 * (1.0 + 1.0 / 3.0), 1e-11);
    near(acceleration.lowest.at, 0.0, 1e-12);
    let inner = acceleration
        .points
        .iter()
        .find(|point| (point.at - PI).abs() < 1e-9);
    near(
        inner.expect("standstill at the inner centre").value,
        50.0 * (1.0 - 1.0 / 3.0),
        1e-11,
    );
}

#[test]
fn slider_crank_with_offset() {
    let (crank, rod) = (50.0_f64, 150.0_f64);
    for offset in [1.0_f64, 30.0, 70.0, 95.0, 99.999] {
        let course = turn(slider_crank(crank, rod, offset));
        let (outer, inner) = (rod + crank, rod - crank);
        let far = ((outer - offset) * (outer + offset)).sqrt();
        let close = ((inner - offset) * (inner + offset)).sqrt();
        near(course.position().stroke(), far - close, 1e-12 * far);
        let angle = (offset / inner).asin() - (offset / outer).asin();
        let time = course.time_ratio().expect("two strokes");
        // The inner limit is ill-conditioned where the rod is nearly across the guide.
        let tolerance = if offset < 99.0 { 1e-12 } else { 1e-9 };
        near(time.ratio(), (PI + angle) / (PI - angle), tolerance);
        near(time.rise + time.fall, TAU, 1e-15);
    }
}

#[test]
fn transmission_of_a_crank_rocker() {
    // Angle between coupler 100 and rocker 80 at a frame of 100 and a crank of 40.
    let angle = |phi: f64| {
        let (sin, cos) = phi.sin_cos();
        let [c, c1, c2] = [0.3 + 0.5 * cos, -0.5 * sin, -0.5 * cos];
        let s = (1.0 - c * c).sqrt();
        [c.acos(), -c1 / s, -(c2 / s) - c * c1 * c1 / (s * s * s)]
    };
    let course = turn(angle);
    let [least, greatest] = course.transmission_angle();
    // With the crank along the frame: a triangle of 60, 100, 80.
    near(least.angle, 0.8_f64.acos(), 1e-14);
    near(least.at, 0.0, 1e-12);
    assert_eq!(greatest.angle, 0.5 * PI);
    near(greatest.at.cos(), -0.6, 1e-14);
    // The angle itself is obtuse with the crank turned round.
    near(course.position().highest.value, (-0.2_f64).acos(), 1e-14);
}

#[test]
fn transmission_over_several_right_angles() {
    // From -0.1 to 2 pi: twice in line, perpendicular at pi/2 first.
    let course = Curve::new((-0.1, 6.0), 50, |x: f64| [x, 1.0]).expect("a course");
    let [least, greatest] = course.transmission_angle();
    assert_eq!((least.angle, greatest.angle), (0.0, 0.5 * PI));
    near(least.at, 0.0, 1e-15);
    near(greatest.at, 0.5 * PI, 1e-15);
    for (from, to) in [
        (0.3, 0.9),
        (PI + 0.3, PI + 0.9),
        (-PI - 0.9, -PI - 0.3),
        (2.0 * PI - 0.9, 2.0 * PI - 0.3),
    ] {
        let course = Curve::new((from, to), 10, |x: f64| [x, 1.0]).expect("a course");
        let [least, greatest] = course.transmission_angle();
        near(least.angle, 0.3, 1e-14);
        near(greatest.angle, 0.9, 1e-14);
    }
}

#[test]
fn rotating_output() {
    // Turns once with the input, faster and slower: no limits but the ends, extreme speeds wrapped once.
    let course = turn(|x: f64| [x + 0.5 * x.sin(), 1.0 + 0.5 * x.cos(), -0.5 * x.sin()]);
    assert!(!course.is_cycle());
    let position = course.position();
    assert!(position.points.len() == 2 && position.points.iter().all(|point| point.end));
    near(position.stroke(), TAU, 1e-14);
    let velocity = course.velocity();
    assert_eq!(velocity.points.len(), 2);
    near(velocity.highest.value, 1.5, 1e-15);
    near(velocity.highest.at, 0.0, 1e-14);
    near(velocity.lowest.at, PI, 1e-14);
    assert_eq!(course.time_ratio(), None);

    // A pilgrim step: turns back for a while.
    let course = turn(|x: f64| [x + 2.0 * x.sin(), 1.0 + 2.0 * x.cos(), -2.0 * x.sin()]);
    let kinds: Vec<Kind> = course.position().limits().map(|limit| limit.kind).collect();
    assert_eq!(kinds, [Kind::High, Kind::Low]);
    near(course.position().points[1].at, 2.0 * PI / 3.0, 1e-14);
}
