//! Words.

use crate::turn;
use linkage_analysis::summary::{Curve, SummaryError};

#[test]
fn a_cycle() {
    let course = turn(|x: f64| [x.cos(), -x.sin(), -x.cos(), x.sin()]);
    assert_eq!(
        course.describe("rad", "rad").to_string(),
        "lowest          -57.2958 deg at 180 deg\n\
         highest         57.2958 deg at 0 deg\n\
         stroke          114.592 deg\n\
         least velocity  -1 rad/rad at 90 deg\n\
         most velocity   1 rad/rad at 270 deg\n\
         least accel.    -1 rad/rad^2 at 0 deg\n\
         most accel.     1 rad/rad^2 at 180 deg\n\
         time ratio      1, rises in 180 deg, falls in 180 deg\n"
    );
}

#[test]
fn gaps() {
    let course = Curve::new((0.0, 4.0), 9, |x: f64| {
        [(x - 1.0).sqrt(), 0.5 / (x - 1.0).sqrt()]
    });
    assert_eq!(
        course.expect("a course").describe("mm", "mm").to_string(),
        "lowest          1.49012e-8 mm at 1 mm\n\
         highest         1.73205 mm at 4 mm\n\
         stroke          1.73205 mm\n\
         only from       1 mm to 4 mm\n"
    );
}

#[test]
fn errors() {
    for (error, words) in [
        (
            SummaryError::Range { from: 2.0, to: 1.0 },
            "the range 2 to 1 is empty or infinite: give finite ends, the lower one first",
        ),
        (
            SummaryError::Positions { positions: 1 },
            "1 positions show no course: give at least 2, 360 for a turn",
        ),
        (
            SummaryError::NotAssembled { positions: 9 },
            "the quantity or a derivative is not finite at any of 9 positions: the mechanism cannot be assembled in \
             this range",
        ),
        (
            SummaryError::Length {
                link: "input",
                length: 0.0,
            },
            "the input has a length of 0: lengths are positive and finite",
        ),
    ] {
        assert_eq!(error.to_string(), words);
    }
}
