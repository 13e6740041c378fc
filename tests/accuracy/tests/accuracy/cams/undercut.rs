//! Where profiles are undercut: against 25 digits, turned all the way round, and against points of profiles.

use std::f64::consts::TAU;

use linkage::cam::{Cam, CamError, Follower, Undercut};

use crate::cams::{cam, plate, references};

/// The cam of a case with its motion turned ahead, and another follower.
fn turned(case: &str, ahead: f64, follower: Option<Follower>) -> Cam<impl Fn(f64) -> [f64; 4]> {
    let (dimensions, own, scale) = plate(case);
    let linkage = dimensions.assemble().expect("it has no loop");
    let motion = move |theta: f64| {
        let own = linkage.motion((theta + ahead) % TAU);
        [own.s, own.first, own.second, own.third].map(|x| scale * x)
    };
    Cam::new(follower.unwrap_or(own), motion).expect("a cam")
}

fn undercut<F: Fn(f64) -> [f64; 4]>(cam: &Cam<F>) -> Undercut {
    match cam.check() {
        Err(CamError::Undercut { undercut, .. }) => undercut,
        other => panic!("{other:?}"),
    }
}

#[test]
fn undercut_is_told_with_what_would_do() {
    for case in ["roller", "swinging", "flat"] {
        assert_eq!(cam(case).check(), Ok(()), "{case}");
    }
    for case in ["roller_undercut", "flat_undercut"] {
        let Err(CamError::Undercut { undercut, follower }) = cam(case).check() else {
            panic!("{case} is undercut");
        };
        let crossings: Vec<f64> = references("undercut")
            .filter(|own| own.0 == case)
            .map(|own| own.1[0])
            .collect();
        let found = undercut.intervals.iter().flat_map(|own| [own.from, own.to]);
        let found: Vec<f64> = found.map(f64::to_degrees).collect();
        assert_eq!(found.len(), crossings.len(), "{case}: {undercut:?}");
        for (found, expected) in found.iter().zip(&crossings) {
            assert!((found - expected).abs() < 1e-11, "{case}: {undercut:?}");
        }
        assert_eq!(undercut.worst, undercut.intervals[0], "{case}");
        // A hair on either side of the limit.
        let (dimensions, _, scale) = plate(case);
        let linkage = dimensions.assemble().expect("it has no loop");
        let motion = |theta: f64| {
            let own = linkage.motion(theta);
            [own.s, own.first, own.second, own.third].map(|x| scale * x)
        };
        for (share, does) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
            let other = match follower {
                Follower::Roller { base, offset, .. } => Follower::Roller {
                    base,
                    offset,
                    radius: undercut.limit * share,
                },
                _ => Follower::Flat {
                    base: undercut.limit / share,
                },
            };
            let cam = Cam::new(other, motion).expect("a cam");
            let Err(CamError::Undercut { undercut, .. }) = cam.check() else {
                assert!(does, "{case} {share}");
                continue;
            };
            // It is far shorter than the steps in which it is looked for.
            assert!(!does, "{case} {share}");
            let [only] = undercut.intervals[..] else {
                panic!("{undercut:?}");
            };
            assert!(
                only.from <= undercut.at && undercut.at <= only.to && only.range < 1e-3,
                "{undercut:?}"
            );
        }
    }
    for (case, numbers) in references("radius") {
        let found = cam(case).least_radius();
        assert!(
            (found.value - numbers[1]).abs() < 1e-12,
            "{case}: {found:?}"
        );
        assert!(
            (found.angle.to_degrees() - numbers[0]).abs() < 1e-9,
            "{case}: {found:?}"
        );
    }
}

/// Wherever the turn begins, the same is told: an undercut across angle 0 is one interval, and no sound one.
#[test]
fn the_beginning_of_the_turn_does_not_matter() {
    for case in ["flat_undercut", "roller_undercut", "swinging_undercut"] {
        let here = undercut(&turned(case, 0.0, None));
        let mut across = 0;
        for degrees in (0..360).step_by(17).chain([91, 92, 207]) {
            let ahead = f64::from(degrees).to_radians();
            let there = undercut(&turned(case, ahead, None));
            assert_eq!(
                there.intervals.len(),
                here.intervals.len(),
                "{case} {degrees}"
            );
            let mut expected: Vec<[f64; 3]> = here
                .intervals
                .iter()
                .map(|own| {
                    let [from, to] = [own.from, own.to].map(|x| (x - ahead).rem_euclid(TAU));
                    [from, to, own.range]
                })
                .collect();
            expected.sort_by(|a, b| a[0].total_cmp(&b[0]));
            for (found, expected) in there.intervals.iter().zip(&expected) {
                let errors = [
                    found.from - expected[0],
                    found.to - expected[1],
                    found.range - expected[2],
                ];
                assert!(
                    errors.iter().all(|x| x.abs() < 1e-11),
                    "{case} {degrees}: {found:?} {expected:?}"
                );
                across += usize::from(found.to < found.from);
            }
            let begin = (here.worst.from - ahead).rem_euclid(TAU);
            assert!(
                (there.worst.from - begin).abs() < 1e-11,
                "{case} {degrees}: {there:?}"
            );
            let at = (there.at - there.worst.from).rem_euclid(TAU);
            assert!(at < there.worst.range, "{case} {degrees}: {there:?}");
            assert!(
                (there.radius - here.radius).abs() < 1e-11 * here.radius.abs(),
                "{case} {degrees}"
            );
        }
        assert!(across > 1, "{case}: {across}");
    }
    let error = turned("flat_undercut", 91.0_f64.to_radians(), None)
        .check()
        .expect_err("undercut");
    assert_eq!(
        error.to_string(),
        "the profile is undercut from 104.13 deg to 126.618 deg and from 344.848 deg to 6.70292 deg: at 1.18166 deg its radius of \
         curvature is -40.9306 where the face begins 20 from the centre; begin more than 60.9306 from it, or take a slower motion"
    );
}

/// Where a profile is undercut it runs back while its pitch curve runs on: differences of points say where. A roller that swings.
#[test]
fn points_of_an_undercut_profile_run_back() {
    const POSITIONS: u32 = 18_000;
    let follower = |radius| Follower::Swinging {
        base: 42.0,
        pivot: 95.0,
        arm: 80.0,
        radius,
    };
    let step = TAU / f64::from(POSITIONS);
    for (radius, degrees) in [(30.0, 0.0), (38.0, 0.0), (38.0, 90.0), (30.0, 205.0)] {
        let ahead = f64::to_radians(degrees);
        let cam = turned("swinging_undercut", ahead, Some(follower(radius)));
        let contacts: Vec<_> = (0..=POSITIONS)
            .map(|k| cam.contact(step * f64::from(k)))
            .collect();
        let back = |k: usize| {
            let [from, to] = [contacts[k], contacts[k + 1]];
            let way =
                |of: fn(&linkage::cam::Contact) -> [f64; 2], i: usize| of(&to)[i] - of(&from)[i];
            (0..2)
                .map(|i| way(|own| own.profile, i) * way(|own| own.pitch, i))
                .sum::<f64>()
                < 0.0
                && from.pitch_curvature > 0.0
        };
        let backs: Vec<bool> = (0..POSITIONS as usize).map(back).collect();
        let last = backs.len() - 1;
        let begins = |k: &usize| backs[*k] && !backs[k.checked_sub(1).unwrap_or(last)];
        let ends = |k: &usize| !backs[*k] && backs[k.checked_sub(1).unwrap_or(last)];
        let places = |of: &dyn Fn(&usize) -> bool| -> Vec<f64> {
            (0..backs.len())
                .filter(of)
                .map(|k| step * k as f64)
                .collect()
        };
        let (from, to) = (places(&begins), places(&ends));
        let found = undercut(&cam);
        assert_eq!(
            (found.intervals.len(), from.len(), to.len()),
            (2, 2, 2),
            "{radius} {ahead}: {found:?}"
        );
        for own in &found.intervals {
            for (place, among) in [(own.from, &from), (own.to, &to)] {
                assert!(
                    among.iter().any(|x| (x - place).abs() < 2.0 * step),
                    "{radius} {ahead}: {place} {among:?}"
                );
            }
        }
        // A roller of the radius that would do, a hair less and a hair more.
        for (share, does) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
            let other = turned(
                "swinging_undercut",
                ahead,
                Some(follower(found.limit * share)),
            );
            assert_eq!(other.check().is_ok(), does, "{radius} {ahead} {share}");
        }
    }
}

/// A motion that begins far below the base: nothing of the profile is sound.
#[test]
fn an_undercut_may_last_the_whole_turn() {
    let cam = Cam::new(Follower::Flat { base: 20.0 }, |x: f64| {
        let (sin, cos) = x.sin_cos();
        [cos - 30.0, -sin, -cos, sin]
    });
    let found = undercut(&cam.expect("a cam"));
    let [only] = found.intervals[..] else {
        panic!("{found:?}");
    };
    assert_eq!([only.from, only.to, only.range], [0.0, TAU, TAU]);
    assert!((found.radius + 10.0).abs() < 1e-12 && (found.limit - 30.0).abs() < 1e-12);
}
