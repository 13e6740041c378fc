//! Points as followers, and how followers slide, against what they do by themselves.

use linkage::cam::{Cam, Contact, Follower};

use crate::cams::{cam, plate, references};

/// The same follower with a roller of radius 0.
fn pointed(case: &str) -> (Cam<impl Fn(f64) -> [f64; 4]>, f64) {
    let (dimensions, follower, scale) = plate(case);
    let linkage = dimensions.assemble().expect("it has no loop");
    let motion = move |theta: f64| {
        let own = linkage.motion(theta);
        [own.s, own.first, own.second, own.third].map(|x| scale * x)
    };
    let point = match follower {
        Follower::Roller { base, offset, .. } => Follower::Roller {
            base,
            offset,
            radius: 0.0,
        },
        Follower::Swinging {
            base, pivot, arm, ..
        } => Follower::Swinging {
            base,
            pivot,
            arm,
            radius: 0.0,
        },
        other => panic!("{other:?} has no roller"),
    };
    (Cam::new(point, motion).expect("a cam"), follower.radius())
}

/// A point runs along the pitch curve of any roller, with its pressure angle and curvature; it undercuts nothing.
#[test]
fn the_profile_of_a_point_is_the_pitch_curve() {
    let mut count = 0;
    for case in ["roller", "swinging", "roller_undercut"] {
        let (point, radius) = pointed(case);
        let roller = cam(case);
        assert_eq!(point.check(), Ok(()), "{case}");
        for (_, numbers) in references("contact").filter(|own| own.0 == case) {
            let angle = numbers[0].to_radians();
            let contact = point.contact(angle);
            for k in 0..2 {
                assert!(
                    (contact.profile[k] - numbers[4 + k]).abs() < 4e-12,
                    "{case}: {contact:?}"
                );
                assert!(
                    (contact.pitch[k] - numbers[4 + k]).abs() < 4e-12,
                    "{case}: {contact:?}"
                );
            }
            assert!(
                (contact.pressure_angle.to_degrees() - numbers[8]).abs() < 1e-11,
                "{case}: {contact:?}"
            );
            assert!(
                (contact.pitch_curvature - numbers[9]).abs() < 1e-14,
                "{case}: {contact:?}"
            );
            assert!(
                (contact.radius.recip() - numbers[9]).abs() < 1e-14,
                "{case}: {contact:?}"
            );
            count += 1;
        }
        let [sharpest, other] = [point.least_radius(), roller.least_radius()];
        assert!((sharpest.angle - other.angle).abs() < 1e-9, "{case}");
        assert!(
            (sharpest.value - other.value - radius).abs() < 1e-12,
            "{case}"
        );
        let outline = point.profile(0.01).expect("a point undercuts nothing");
        assert_eq!(outline.points, outline.pitch, "{case}");
    }
    assert_eq!(count, 36);
}

type Vector = [f64; 2];

fn times([a, b]: Vector, [c, d]: Vector) -> Vector {
    [a * c - b * d, a * d + b * c]
}

/// Derivatives by five points, whose error is a 30th of the step's fourth power times the fifth derivative.
fn derivative(of: impl Fn(f64) -> Vector, at: f64) -> Vector {
    const STEP: f64 = 1e-3;
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| of(at + k * STEP));
    [0, 1].map(|k| (a[k] - 8.0 * b[k] + 8.0 * c[k] - d[k]) / (12.0 * STEP))
}

/// The place of contact wanders along the cam and along the follower. What it wanders more along the cam is what the follower slides.
#[test]
fn sliding_is_the_difference_of_what_contacts_wander() {
    for case in ["roller", "swinging", "flat"] {
        let (dimensions, follower, scale) = plate(case);
        let linkage = dimensions.assemble().expect("it has no loop");
        let cam = cam(case);
        // A direction that is fixed to the follower.
        let direction = |angle: f64| -> Vector {
            let Follower::Swinging {
                base, pivot, arm, ..
            } = follower
            else {
                return [1.0, 0.0];
            };
            let begin = ((pivot * pivot + arm * arm - base * base) / (2.0 * pivot * arm)).acos();
            let (sin, cos) = (begin + scale * linkage.motion(angle).s).sin_cos();
            [-cos, sin]
        };
        let turn = |angle: f64| -> Vector { [angle.cos(), angle.sin()] };
        // Seen from the follower's own middle, in its own directions.
        let own = |angle: f64| -> Vector {
            let Contact { profile, pitch, .. } = cam.contact(angle);
            let away = [profile[0] - pitch[0], profile[1] - pitch[1]];
            let [x, y] = direction(angle);
            times(times(turn(angle), away), [x, -y])
        };
        // No knot of the motion is within two steps.
        for degrees in [
            20.0_f64, 47.0, 61.0, 83.0, 99.0, 126.0, 141.0, 171.0, 205.0, 222.0, 249.0, 271.0,
            300.0, 333.0,
        ] {
            let angle = degrees.to_radians();
            let on_cam = times(turn(angle), derivative(|x| cam.contact(x).profile, angle));
            let on_follower = times(direction(angle), derivative(own, angle));
            let ahead = times(turn(angle), derivative(|x| cam.contact(x).pitch, angle));
            // A face is touched along itself; a roller's centre moves as its contact does.
            let ahead = if matches!(follower, Follower::Flat { .. }) {
                [1.0, 0.0]
            } else {
                ahead
            };
            let length = ahead[0].hypot(ahead[1]);
            let sliding = cam.contact(angle).sliding;
            for k in 0..2 {
                let found = on_cam[k] - on_follower[k];
                let expected = sliding * ahead[k] / length;
                assert!(
                    (found - expected).abs() < 2e-8 * sliding.abs(),
                    "{case} {degrees}: {found} {expected}"
                );
            }
        }
    }
}

/// Curvatures change their sign where 25 digits say.
#[test]
fn hollow_begins_and_ends_where_the_curvature_is_none() {
    let mut count = 0;
    for (case, numbers) in references("straight") {
        let cam = cam(case);
        let angle = numbers[0].to_radians();
        let [before, here, after] =
            [-1e-9, 0.0, 1e-9].map(|by| cam.contact(angle + by).pitch_curvature);
        assert!(
            before * after < 0.0,
            "{case} {}: {before} {after}",
            numbers[0]
        );
        assert!(here.abs() < 1e-14, "{case} {}: {here}", numbers[0]);
        count += 1;
    }
    assert_eq!(count, 6);
}
