//! Parameters that put an event at a wanted angle, against dense search.

use crate::{TAU, TURN};
use linkage_analysis::cyclogram::{
    Band, CyclogramError, Event, Member, Motion, Setting, SettingError, set_event,
};
use linkage_analysis::summary::Curve;
use linkage_random::Random;

const POSITIONS: usize = 73;
const BAND: f64 = 1.5;

/// A sinker on two eccentrics, each with a lead of its own; sensitivities are to both leads. `second` is the stroke of the faster one.
fn sinker_of(second: f64, leads: [f64; 2]) -> Result<Member, CyclogramError> {
    let angles = move |x: f64| [(x + leads[0]).sin_cos(), (2.0 * x + leads[1]).sin_cos()];
    let lift = move |x: f64| {
        let [(s, c), (s2, c2)] = angles(x);
        [
            10.0 * c + second * c2,
            -10.0 * s - 2.0 * second * s2,
            -10.0 * c - 4.0 * second * c2,
        ]
    };
    let value = move |x: f64| {
        let [(s, _), (s2, _)] = angles(x);
        [-10.0 * s, -second * s2]
    };
    let rate = move |x: f64| {
        let [(_, c), (_, c2)] = angles(x);
        [-10.0 * c, -2.0 * second * c2]
    };
    let course = Curve::new(TURN, POSITIONS, lift).expect("a course");
    Ok(Member::new("sinker", &course, &[Band::Top(BAND)])?.sensitivities(value, rate))
}

/// One highest position, whatever the leads are.
const GENTLE: f64 = 2.0;
/// With some leads there are two, and dwells begin anew.
const STRONG: f64 = 4.0;

fn sinker(leads: [f64; 2]) -> Result<Member, CyclogramError> {
    sinker_of(GENTLE, leads)
}

fn begins(event: &Event) -> bool {
    event.begins == Motion::Dwell(0)
}

fn away(at: f64, wanted: f64) -> f64 {
    let off = (at - wanted) % TAU;
    [off, off - TAU, off + TAU]
        .into_iter()
        .min_by(|a, b| a.abs().total_cmp(&b.abs()))
        .expect("three")
}

/// The angles at which dwells begin, from values alone: where they rise above the bound among many positions, between two of them by a
/// straight line.
fn dense(second: f64, leads: [f64; 2]) -> Vec<f64> {
    const MANY: u32 = 1440;
    let lift = |x: f64| 10.0 * (x + leads[0]).cos() + second * (2.0 * x + leads[1]).cos();
    let at = |k: u32| TAU * f64::from(k) / f64::from(MANY);
    let values: Vec<f64> = (0..=MANY).map(|k| lift(at(k))).collect();
    let bound = values.iter().copied().fold(f64::NEG_INFINITY, f64::max) - BAND;
    let rises =
        (0..MANY).filter(|&k| values[k as usize] < bound && values[k as usize + 1] >= bound);
    rises
        .map(|k| {
            let [a, b] = [values[k as usize], values[k as usize + 1]];
            at(k) + (at(k + 1) - at(k)) * (bound - a) / (b - a)
        })
        .collect()
}

#[test]
fn every_setting_of_a_dense_search_is_found() {
    const MANY: u32 = 400;
    let mut random = Random::new(22);
    let (mut found_in_all, mut unreached) = (0, 0);
    for case in 0..30 {
        let second = if case % 2 == 0 { GENTLE } else { STRONG };
        let first = random.between(-1.0, 1.0);
        let range = (random.between(-3.0, 0.0), random.between(0.2, 3.0));
        let wanted =
            dense(second, [first, 0.5 * (range.0 + range.1)])[0] + random.between(-0.4, 0.4);
        let build = |lead| sinker_of(second, [first, lead]);
        let found = set_event(range, 1, build, begins, wanted);
        // Where one of the dwells is on different sides of the angle with neighbouring values.
        let value = |k: u32| range.0 + (range.1 - range.0) * f64::from(k) / f64::from(MANY);
        let step = value(1) - value(0);
        let looks: Vec<Vec<f64>> = (0..=MANY)
            .map(|k| dense(second, [first, value(k)]))
            .collect();
        let offs = |k: u32| looks[k as usize].iter().map(|&at| away(at, wanted));
        let crosses =
            |k: &u32| offs(*k).any(|a| offs(*k + 1).any(|b| a * b <= 0.0 && (a - b).abs() < 0.1));
        let expected: Vec<f64> = (0..MANY)
            .filter(crosses)
            .map(|k| value(k) + 0.5 * step)
            .collect();
        match found {
            Ok(found) => {
                let values: Vec<f64> = found.iter().map(|own| own.value).collect();
                let near = |a: f64, b: f64| (a - b).abs() < 2.0 * step;
                assert!(
                    expected
                        .iter()
                        .all(|&own| values.iter().any(|&x| near(x, own))),
                    "{values:?} {expected:?}"
                );
                // Beside its beginning an event that appears is too fast for the search here.
                assert!(
                    second != GENTLE || values.len() == expected.len(),
                    "{values:?} {expected:?}"
                );
                assert!(
                    values.windows(2).all(|own| own[1] - own[0] > 1e-6),
                    "{values:?}"
                );
                for Setting {
                    value,
                    member,
                    event,
                } in &found
                {
                    let event = member.events()[*event];
                    assert!(
                        begins(&event) && away(event.at, wanted).abs() < 1e-13,
                        "{event:?} {wanted}"
                    );
                    let same = build(*value).expect("an organ");
                    assert!(same.events().contains(&event));
                    found_in_all += 1;
                }
            }
            Err(SettingError::Unreached { nearest, value, .. }) => {
                assert_eq!(expected, [0.0; 0], "{range:?} {wanted}");
                let member = build(value).expect("an organ");
                let mut there = member.events().iter().filter(|own| begins(own));
                assert!(there.any(|own| own.at == nearest));
                let least = (0..=MANY)
                    .flat_map(offs)
                    .fold(f64::INFINITY, |least, off| least.min(off.abs()));
                let own = away(nearest, wanted).abs();
                assert!(
                    second != GENTLE || (own - least).abs() < 1e-3,
                    "{own} {least}"
                );
                unreached += 1;
            }
            Err(error) => panic!("{error}"),
        }
    }
    assert!(
        found_in_all >= 10 && unreached >= 3,
        "{found_in_all} {unreached}"
    );
}

/// The nearest angle is where it stands still by the parameter, and no nearer value was looked at.
#[test]
fn the_nearest_angle_is_told_to_the_last_digits() {
    let error = set_event((-3.0, 3.0), 1, |lead| sinker([0.0, lead]), begins, 1.5);
    let Err(SettingError::Unreached { nearest, value, .. }) = error else {
        panic!("{error:?}");
    };
    let member = sinker([0.0, value]).expect("an organ");
    let event = member
        .events()
        .iter()
        .position(|own| own.at == nearest)
        .expect("an event");
    let slope = member.sensitivity(event).expect("sensitivities")[1];
    assert!(slope.abs() < 1e-12, "{nearest} {value} {slope}");
    for by in [-1e-3, 1e-3] {
        let beside = sinker([0.0, value + by]).expect("an organ");
        let at = beside
            .events()
            .iter()
            .filter(|own| begins(own))
            .map(|own| away(own.at, 1.5).abs());
        assert!(at.fold(f64::INFINITY, f64::min) > away(nearest, 1.5).abs());
    }
}

#[test]
fn messages() {
    let told = |found: Result<Vec<Setting>, SettingError<CyclogramError>>| {
        found.expect_err("none").to_string()
    };
    let plain = |_: f64| {
        let course =
            Curve::new(TURN, POSITIONS, |x: f64| [x.sin(), x.cos(), -x.sin()]).expect("a course");
        Member::new("press", &course, &[Band::Top(0.5)])
    };
    assert_eq!(
        told(set_event((0.0, 1.0), 0, plain, begins, 1.0)),
        "`press` has no sensitivities, which lead to the wanted angle\nhelp: call `sensitivities` on the organ that is built"
    );
    let both = |lead| sinker([0.0, lead]);
    assert_eq!(
        told(set_event((0.0, 1.0), 2, both, begins, 1.0)),
        "`sinker` has sensitivities to 2 parameters, and none with the index 2"
    );
    assert_eq!(
        told(set_event(
            (0.0, 1.0),
            1,
            both,
            |own| own.begins == Motion::Dwell(3),
            1.0
        )),
        "`sinker` has no event that is meant, with any of the 33 values from 0 to 1 of the parameter that were looked at"
    );
    let still = |_: f64| {
        let course = Curve::new(TURN, POSITIONS, |_: f64| [3.0, 0.0, 0.0]).expect("a course");
        Member::new("press", &course, &[])
    };
    assert_eq!(
        told(set_event((0.0, 1.0), 0, still, begins, 1.0)),
        "there is no organ with any of the 33 values from 0 to 1 of the parameter that were looked at; with the first one: `press` stands \
         still at 3 over the whole cycle"
    );
    assert_eq!(
        told(set_event(
            (0.1, 0.2),
            0,
            |lead| sinker([lead, 0.0]),
            begins,
            2.0
        )),
        "no event of `sinker` that is meant is at 114.592 deg: the nearest angle is 332.862 deg, where the parameter is 0.1 (from 0.1 to 0.2)\n\
         help: give a wider range, or change another parameter"
    );
}
