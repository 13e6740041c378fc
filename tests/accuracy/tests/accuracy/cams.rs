//! Plate cams against 25 digits: contacts, extremes of pressure angle and curvature; their polylines against dense points.

mod followers;
mod quantities;
mod undercut;

use linkage::cam::{Cam, Follower, Stationary};
use std::f64::consts::TAU;

linkage_interpreted::interpreted! {
    /// A follower's motion.
    struct Plate {
        unit mm;
        param lift = 18mm;
        param rise = 150deg;
        param back = 310deg;
        input theta = 60deg in 0deg..360deg;
        let s = piecewise(theta, [
            (0deg, 0mm), (40deg, 0mm), (rise, lift, modified_sine), (190deg, lift), (back, 0mm, poly345),
            (360deg, 0mm),
        ]);
    }

    impl Plate {
        fn motion(theta) -> Motion { s, first: velocity(s), second: acceleration(s), third: jerk(s) }
    }
}

/// The dimensions of a case; its lift is 1, and the motion is multiplied by what the case has.
fn plate(case: &str) -> (Plate, Follower, f64) {
    let slow = Plate {
        lift: 1.0,
        ..Plate::default()
    };
    let [rise, back] = [100.0, 260.0].map(f64::to_radians);
    let fast = Plate { rise, back, ..slow };
    let roller = |base, offset, radius| Follower::Roller {
        base,
        offset,
        radius,
    };
    match case {
        "roller" => (slow, roller(40.0, 7.0, 9.0), 18.0),
        "swinging" => {
            let follower = Follower::Swinging {
                base: 42.0,
                pivot: 95.0,
                arm: 80.0,
                radius: 10.0,
            };
            (slow, follower, 24.0_f64.to_radians())
        }
        "flat" => (slow, Follower::Flat { base: 38.0 }, 15.0),
        "swinging_undercut" => {
            let follower = Follower::Swinging {
                base: 42.0,
                pivot: 95.0,
                arm: 80.0,
                radius: 38.0,
            };
            (fast, follower, 24.0_f64.to_radians())
        }
        "roller_undercut" => (fast, roller(30.0, 3.0, 17.0), 18.0),
        "flat_undercut" => (fast, Follower::Flat { base: 20.0 }, 15.0),
        other => panic!("{other}"),
    }
}

fn cam(case: &str) -> Cam<impl Fn(f64) -> [f64; 4]> {
    let (dimensions, follower, scale) = plate(case);
    let linkage = dimensions.assemble().expect("it has no loop");
    let motion = move |theta: f64| {
        let own = linkage.motion(theta);
        [own.s, own.first, own.second, own.third].map(|x| scale * x)
    };
    Cam::new(follower, motion).expect("a cam")
}

/// The lines of a kind: case and numbers.
fn references(kind: &'static str) -> impl Iterator<Item = (&'static str, Vec<f64>)> {
    let lines = include_str!("cams/references.txt").lines();
    lines
        .filter(|line| !line.starts_with('#'))
        .filter_map(move |line| {
            let mut words = line.split(' ');
            let (case, own) = (words.next()?, words.next()?);
            let numbers = words.map(|word| word.parse().expect("a number")).collect();
            (own == kind).then_some((case, numbers))
        })
}

#[test]
fn contacts_have_fourteen_digits() {
    let mut worst: f64 = 0.0;
    let mut close = |found: f64, expected: f64, size: f64, what: &str| {
        let error = (found - expected).abs() / expected.abs().max(size);
        worst = worst.max(error);
        assert!(error < 1e-13, "{what}: {found} {expected}");
    };
    let mut count = 0;
    for (case, numbers) in references("contact") {
        let [degrees, .., curvature, radius] = numbers[..] else {
            panic!("{case}")
        };
        let contact = cam(case).contact(degrees.to_radians());
        for k in 0..2 {
            close(contact.pitch[k], numbers[4 + k], 40.0, case);
            close(contact.profile[k], numbers[6 + k], 40.0, case);
        }
        close(contact.pressure_angle.to_degrees(), numbers[8], 50.0, case);
        if curvature != 0.0 {
            close(contact.pitch_curvature, curvature, 0.05, case);
        }
        close(contact.radius.recip(), radius.recip(), 0.05, case);
        count += 1;
    }
    assert_eq!(count, 60);
    println!("contacts: {worst:e}");
}

#[test]
fn extremes_are_roots_of_exact_derivatives() {
    for (kind, of) in [
        (
            "pressure",
            Cam::pressure_angles as fn(&_) -> Vec<Stationary>,
        ),
        ("curvature", Cam::curvatures),
    ] {
        for case in ["roller", "swinging", "roller_undercut"] {
            let found = of(&cam(case));
            let expected: Vec<Vec<f64>> = references(kind)
                .filter(|own| own.0 == case)
                .map(|own| own.1)
                .collect();
            for own in &expected {
                let degrees = |x: f64| {
                    if kind == "pressure" {
                        x.to_degrees()
                    } else {
                        x
                    }
                };
                let near = found
                    .iter()
                    .find(|next| (next.angle.to_degrees() - own[0]).abs() < 1e-6);
                let near =
                    near.unwrap_or_else(|| panic!("{kind} of {case} at {}: {found:?}", own[0]));
                let error = (degrees(near.value) - own[1]).abs();
                assert!(error < 1e-12, "{kind} of {case}: {error:e}");
                // Roundings of the derivative, over how fast that changes; a search without derivatives has half of the digits.
                let off = (near.angle.to_degrees() - own[0]).abs();
                assert!(off < 1e-9, "{kind} of {case} at {}: {off:e}", own[0]);
            }
            if kind == "pressure" {
                assert_eq!(found.len(), expected.len(), "{case}: {found:?}");
            }
        }
    }
    let largest = cam("roller").largest_pressure_angle();
    assert!((largest.value.to_degrees() + 26.035_108_874_270_29).abs() < 1e-12);
}

/// Chords stray by no more than allowed, and no fewer points would be needed by much.
#[test]
fn outlines_keep_to_the_chord_error() {
    for case in ["roller", "swinging", "flat"] {
        let cam = cam(case);
        for chord_error in [0.1, 2e-3] {
            let outline = cam.profile(chord_error).expect("no undercut");
            let count = outline.points.len();
            let mut largest: f64 = 0.0;
            for k in 0..count {
                let (from, to) = (outline.points[k], outline.points[(k + 1) % count]);
                let low = outline.angles[k];
                let high = outline.angles.get(k + 1).copied().unwrap_or(TAU);
                for part in 1..16 {
                    let angle = low + (high - low) * f64::from(part) / 16.0;
                    let [x, y] = cam.contact(angle).profile;
                    let chord = [to[0] - from[0], to[1] - from[1]];
                    let away = chord[0] * (y - from[1]) - chord[1] * (x - from[0]);
                    largest = largest.max(away.abs() / chord[0].hypot(chord[1]));
                }
            }
            assert!(largest <= chord_error, "{case} {chord_error}: {largest}");
            assert!(
                chord_error > 0.02 || largest > 0.5 * chord_error,
                "{case} {chord_error}: {largest}"
            );
        }
        let counts = [0.02, 2e-4].map(|own| cam.profile(own).expect("no undercut").points.len());
        // The error falls with the square of the step.
        assert!(
            (4..25).contains(&(counts[1] / counts[0])),
            "{case}: {counts:?}"
        );
    }
}

// What is said of cams that cannot be made.

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
