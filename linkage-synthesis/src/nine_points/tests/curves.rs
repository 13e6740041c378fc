//! Points on circles and lines are refused at once, with the numbers of the circle.

use super::super::super::error::Unsolved;
use super::super::{TRIPLES, nine_points_reporting};
use core::f64::consts::TAU;
use std::string::ToString;

/// Returns the refusal before the first path is followed.
fn refused(points: [[f64; 2]; 9]) -> Unsolved {
    nine_points_reporting(&points, |_| false).expect_err("it is refused or stopped")
}

const SEARCHED: Unsolved = Unsolved::Stopped {
    done: 0,
    count: TRIPLES,
};

/// Points of a circle about (300, -40), in no order, over a part of the turn, with some of them
/// moved away from the centre.
fn on_circle(radius: f64, turn: f64, moved: [f64; 9]) -> [[f64; 2]; 9] {
    core::array::from_fn(|i| {
        let angle = (4 * i % 9) as f64 + 0.3 * (i as f64 * 1.7).sin();
        let (sin, cos) = (turn * angle / 9.0).sin_cos();
        let length = radius + moved[i];
        [300.0 + length * cos, -40.0 + length * sin]
    })
}

#[test]
fn points_on_a_circle_are_refused_with_the_circle() {
    // Whole turns, and arcs that are nearly lines.
    for (radius, turn) in [(50.0, TAU), (50.0, 2.0), (0.001, TAU), (2000.0, 0.1)] {
        let refused = refused(on_circle(radius, turn, [0.0; 9]));
        let Unsolved::OnCircle {
            count: 9,
            centre: [x, y],
            radius: found,
            off,
        } = refused
        else {
            panic!("{refused}");
        };
        assert!((x - 300.0).hypot(y + 40.0) < 1e-6 * radius, "{refused}");
        assert!((found - radius).abs() < 1e-6 * radius, "{refused}");
        assert!(off < 1e-9 * radius, "{refused}");
    }
}

#[test]
fn seven_points_on_a_circle_are_too_many_and_six_are_not() {
    let moved =
        |count: usize| core::array::from_fn(|i| if i < count { 1.0 + i as f64 } else { 0.0 });
    let seven = refused(on_circle(50.0, TAU, moved(2)));
    assert!(
        matches!(seven, Unsolved::OnCircle { count: 7, .. }),
        "{seven}"
    );
    assert_eq!(refused(on_circle(50.0, TAU, moved(3))), SEARCHED);
}

#[test]
fn points_next_to_a_circle_are_searched() {
    let next = |way: f64| core::array::from_fn(|i| way * (i as f64 * 2.3).sin());
    assert_eq!(refused(on_circle(50.0, TAU, next(2e-2))), SEARCHED);
    // Rounded coordinates.
    let rounded = refused(on_circle(50.0, TAU, next(1e-5)));
    assert!(matches!(rounded, Unsolved::OnCircle { .. }), "{rounded}");
}

#[test]
fn points_on_a_line_are_refused() {
    let line = |way: f64| -> [[f64; 2]; 9] {
        core::array::from_fn(|i| {
            let x = 7.0 * i as f64 + (i as f64 * 1.3).sin();
            let off = if i < 2 { way } else { 0.0 };
            [x - 20.0, 5.0 + 0.3 * x + off]
        })
    };
    for (way, count) in [(0.0, 9), (4.0, 7)] {
        let found = refused(line(way));
        assert!(
            matches!(found, Unsolved::OnLine { count: counted, off } if counted == count && off < 1e-9),
            "{found}"
        );
    }
}

#[test]
fn the_message_says_what_to_do() {
    let square = |x: f64, y: f64| [[x, y], [-x, y], [x, -y], [-x, -y]];
    let [a, b] = [square(3.0, 4.0), square(4.0, 3.0)].map(|corners| corners.to_vec());
    let mut points = [a, b].concat();
    points.push([5.0, 0.0]);
    let points = points.try_into().expect("nine points");
    let text = refused(points).to_string();
    let [start, end] = [
        "9 points are on a circle about (0, 0) with radius 5 (off it by ",
        " at most); a coupler curve meets a circle in six points at most unless it contains the circle, so that infinitely many \
         mechanisms meet these points, or none; use a crank of that radius about that centre, or move all but six points off \
         the circle",
    ];
    assert!(text.starts_with(start) && text.ends_with(end), "{text}");
    let line = core::array::from_fn(|i| [i as f64, 2.0 * i as f64]);
    let text = refused(line).to_string();
    assert!(text.starts_with("9 points are on a line"), "{text}");
}
