//! What is said of cams that cannot be made.

use linkage::cam::{Cam, Follower};

use crate::cams::cam;

#[test]
fn messages_have_the_numbers() {
    let text = |case| cam(case).profile(0.01).expect_err("undercut").to_string();
    assert_eq!(
        text("roller_undercut"),
        "the profile is undercut from 88.1868 deg to 94.0427 deg: at 92.4703 deg the pitch curve has a radius of 16.4041, and the \
         roller one of 17; take a roller of less than that, a larger cam or a slower motion"
    );
    assert_eq!(
        text("flat_undercut"),
        "the profile is undercut from 75.8479 deg to 97.7029 deg and from 195.13 deg to 217.618 deg: at 92.1817 deg its radius of curvature is -40.9306 where the face \
         begins 20 from the centre; begin more than 60.9306 from it, or take a slower motion"
    );
    let made = |follower, motion: fn(f64) -> [f64; 4]| {
        Cam::new(follower, motion)
            .map(|_| ())
            .map_err(|own| own.to_string())
    };
    let rest = |_: f64| [0.0; 4];
    let roller = |base, offset, radius| Follower::Roller {
        base,
        offset,
        radius,
    };
    for (found, expected) in [
        (
            made(roller(40.0, 50.0, 9.0), rest),
            "the offset is 50, and must be less than the radius of the pitch circle, which the guide meets",
        ),
        (
            made(roller(40.0, 5.0, 45.0), rest),
            "the radius of the roller is 45, and must be 0 for a point, and less than that of the pitch circle",
        ),
        (
            made(
                Follower::Swinging {
                    base: 40.0,
                    pivot: 90.0,
                    arm: 20.0,
                    radius: 5.0,
                },
                rest,
            ),
            "the radius of the pitch circle is 40, and must be the third side of a triangle with the distance of the pivot and the arm",
        ),
        (
            made(Follower::Flat { base: -1.0 }, rest),
            "the distance of the face is -1, and must be positive and finite",
        ),
        (
            made(Follower::Flat { base: 30.0 }, |x| [x, 1.0, 0.0, 0.0]),
            "the motion ends a turn 6.28319 from where it began: a cam needs a motion that comes back",
        ),
        (
            made(Follower::Flat { base: 30.0 }, |x| {
                [if x > 1.0 { f64::NAN } else { 0.0 }, 0.0, 0.0, 0.0]
            }),
            "the motion is no number at 57.5 deg: give a value and three derivatives over the whole turn",
        ),
    ] {
        assert_eq!(found, Err(expected.to_owned()));
    }
    let error = cam("flat").profile(0.0).expect_err("no error");
    assert_eq!(
        error.to_string(),
        "the chord error is 0, and must be positive and finite"
    );
}
