//! Cyclograms of harmonics: bands, events, what is told.

use crate::{TAU, TURN};
use linkage_analysis::cyclogram::{
    Band, Cause, Cyclogram, CyclogramError, Member, Motion, nearest_slot,
};
use linkage_analysis::summary::Curve;
use linkage_analysis::tolerance::Tolerances;
use linkage_random::Random;
use linkage_runtime::Parameter;

fn wave(a: [f64; 4]) -> impl Fn(f64) -> [f64; 3] {
    move |x: f64| {
        let ((s, c), (s2, c2)) = (x.sin_cos(), (2.0 * x).sin_cos());
        [
            a[0] * c + a[1] * s + a[2] * c2 + a[3] * s2,
            a[1] * c - a[0] * s + 2.0 * (a[3] * c2 - a[2] * s2),
            -a[0] * c - a[1] * s - 4.0 * (a[2] * c2 + a[3] * s2),
        ]
    }
}

pub(crate) fn member(
    name: &str,
    function: impl Fn(f64) -> [f64; 3],
    bands: &[Band],
) -> Result<Member, CyclogramError> {
    let course = Curve::new(TURN, 73, function).expect("a course");
    Member::new(name, &course, bands)
}

/// At each of many angles an organ does what value and slope say.
#[test]
fn motions_at_samples() {
    let mut random = Random::new(9);
    let mut turns = 0;
    for _ in 0..30 {
        let factors = std::array::from_fn(|_| random.between(-10.0, 10.0));
        let function = wave(factors);
        let course = Curve::new(TURN, 73, &function).expect("a course");
        let (low, high) = (
            course.position().lowest.value,
            course.position().highest.value,
        );
        let stroke = high - low;
        let middle = [low + 0.4 * stroke, low + 0.55 * stroke];
        let bands = [
            Band::Top(0.1 * stroke),
            Band::Bottom(0.2 * stroke),
            Band::Between(middle[0], middle[1]),
        ];
        let member = member("wave", &function, &bands).expect("an organ");
        for i in 0..2000 {
            let x = TAU * (f64::from(i) + 0.5) / 2000.0;
            let [y, v, _] = function(x);
            let expected = if y > high - 0.1 * stroke {
                Motion::Dwell(0)
            } else if y < low + 0.2 * stroke {
                Motion::Dwell(1)
            } else if y > middle[0] && y < middle[1] {
                Motion::Dwell(2)
            } else if v > 0.0 {
                Motion::Advance
            } else {
                Motion::Return
            };
            let beside = member
                .events()
                .iter()
                .any(|event| (event.at - x).abs() < 1e-9);
            assert!(
                beside || member.motion(x) == expected,
                "{x}: {:?} {expected:?}",
                member.motion(x)
            );
        }
        let whole: f64 = member.intervals().map(|(_, interval)| interval.range).sum();
        assert!((whole - TAU).abs() < 1e-12);
        for event in member.events() {
            let [y, v, a] = function(event.at);
            assert_eq!([event.value, event.slope, event.bend], [y, v, a]);
            turns += usize::from(event.cause == Cause::Turn);
            assert!(event.cause != Cause::Turn || v.abs() < 1e-12);
        }
    }
    assert!(turns > 5, "{turns}");
}

/// Angles of bounds and turns are shifted as a changed factor says, by all rules.
#[test]
fn sensitivities_are_differences() {
    let factors = [3.0, -5.0, 4.0, 1.0];
    let value = |x: f64| {
        let ((s, c), (s2, c2)) = (x.sin_cos(), (2.0 * x).sin_cos());
        [c, s, c2, s2]
    };
    let rate = |x: f64| {
        let ((s, c), (s2, c2)) = (x.sin_cos(), (2.0 * x).sin_cos());
        [-s, c, -2.0 * s2, 2.0 * c2]
    };
    let bands = [Band::Top(0.5), Band::Bottom(0.7), Band::Between(1.0, 1.5)];
    let nominal = member("wave", wave(factors), &bands).expect("an organ");
    let nominal = nominal.sensitivities(value, rate);
    let mut causes = std::collections::BTreeSet::new();
    for p in 0..4 {
        const H: f64 = 1e-6;
        let [more, less] = [H, -H].map(|h| {
            let mut factors = factors;
            factors[p] += h;
            member("wave", wave(factors), &bands).expect("an organ")
        });
        for (index, event) in nominal.events().iter().enumerate() {
            let difference = (more.events()[index].at - less.events()[index].at) / (2.0 * H);
            let found = nominal.sensitivity(index).expect("sensitivities")[p];
            assert!(
                (found - difference).abs() < 1e-7,
                "{event:?}: {found} {difference}"
            );
            causes.insert(match event.cause {
                Cause::Bound { band } => band,
                Cause::Turn => 3,
            });
        }
    }
    assert_eq!(causes.len(), 4, "every band, and a turn");

    let parameter = |name| Parameter {
        name,
        unit: "mm",
        nominal: 1.0,
        tolerance: 0.01,
    };
    let parameters = ["a", "b", "c", "d"].map(parameter);
    let tolerances = Tolerances::<4>::complete(&parameters).expect("tolerances");
    assert_eq!(nominal.shift(0), None);
    let sizes: f64 = nominal
        .sensitivity(0)
        .expect("sensitivities")
        .iter()
        .map(|x| 0.01 * x.abs())
        .sum();
    let nominal = nominal.tolerances(&tolerances).expect("as many");
    assert!((nominal.shift(0).expect("a shift") - sizes).abs() < 1e-15);
    let fewer = Tolerances::<3>::complete(&parameters[..3]).expect("tolerances");
    let error = nominal.tolerances(&fewer).expect_err("fewer");
    assert_eq!(
        error.to_string(),
        "`wave` has sensitivities to 4 parameters, and there are 3 tolerances"
    );
    let error = member("wave", wave(factors), &bands)
        .expect("an organ")
        .tolerances(&fewer)
        .expect_err("none");
    assert_eq!(
        error.to_string(),
        "`wave` has no sensitivities that tolerances could be multiplied by\nhelp: call `sensitivities` first"
    );
}

#[test]
fn messages() {
    let lift = |x: f64| [10.0 * x.sin(), 10.0 * x.cos(), -10.0 * x.sin()];
    let told = |bands: &[Band]| match member("press", lift, bands) {
        Err(error) => error.to_string(),
        Ok(_) => String::new(),
    };
    assert_eq!(
        told(&[
            Band::Between(12.0, 13.0),
            Band::Top(0.0),
            Band::Top(30.0),
            Band::Top(1.0),
            Band::Between(8.5, 9.5)
        ]),
        "`press`: nothing reaches the band 12 to 13: the motion is from -10 to 10\n\
         `press`: the band top 0 has no positive width\n\
         `press`: the whole motion, from -10 to 10, is in the band top 30: there is nothing but a dwell\n\
         `press`: the bands top 1 and 8.5 to 9.5 overlap by 0.5: the motion is from -10 to 10"
    );
    let half = Curve::new((0.0, 3.0), 73, lift).expect("a course");
    let error = Member::new("press", &half, &[]).expect_err("no cycle");
    assert_eq!(
        error.to_string(),
        "`press` does not repeat itself from 0 to 171.887 deg: there it is 0 and 1.4112, or a derivative differs\n\
         help: give the range of a whole cycle, one or several turns"
    );
    let gap = |x: f64| {
        if (2.0..2.5).contains(&x) {
            [f64::NAN; 3]
        } else {
            lift(x)
        }
    };
    let gap = Curve::new(TURN, 73, gap).expect("a course");
    let error = Member::new("press", &gap, &[]).expect_err("a gap");
    assert_eq!(
        error.to_string(),
        "`press` cannot be assembled over the whole cycle, only from 143.239 to 114.592 deg"
    );
    let error = member("press", |_| [3.0, 0.0, 0.0], &[]).expect_err("it stands still");
    assert_eq!(
        error.to_string(),
        "`press` stands still at 3 over the whole cycle"
    );
    let twice = Curve::new((0.0, 2.0 * TAU), 73, lift).expect("a course");
    let members = [
        member("press", lift, &[]),
        Member::new("sinker", &twice, &[]),
    ];
    let error =
        Cyclogram::new(members.map(|member| member.expect("an organ"))).expect_err("two ranges");
    assert_eq!(
        error.to_string(),
        "`press` has a cycle from 0 to 360 deg, `sinker` one from 0 to 720 deg\n\
         help: follow all organs over the same range of the main shaft's angle"
    );
}

/// Overlaps go across the seam, and are told once.
#[test]
fn what_happens_together() {
    let lift = |lead: f64| move |x: f64| [(x + lead).cos(), -(x + lead).sin(), -(x + lead).cos()];
    let width = 1.0 - 40f64.to_radians().cos();
    let members = [0.0, 50.0, 180.0].map(|lead: f64| {
        member("organ", lift(lead.to_radians()), &[Band::Top(width)]).expect("an organ")
    });
    let machine = Cyclogram::new(members).expect("a machine");
    let degrees = |found: Vec<linkage_analysis::summary::Interval>| -> Vec<[f64; 3]> {
        let of = |i: &linkage_analysis::summary::Interval| {
            [i.from, i.to, i.range].map(|x| (x.to_degrees() * 1e9).round() / 1e9)
        };
        found.iter().map(of).collect()
    };
    let both =
        |a: usize, b: usize| degrees(machine.together(|m| m[a].is_dwell() && m[b].is_dwell()));
    assert_eq!(both(0, 1), [[320.0, 350.0, 30.0]]);
    assert_eq!(both(0, 2), [[0.0; 3]; 0]);
    assert_eq!(
        degrees(machine.together(|m| m[0].is_dwell())),
        [[320.0, 40.0, 80.0]]
    );
    assert_eq!(degrees(machine.together(|_| true)), [[0.0, 360.0, 360.0]]);
    assert_eq!(
        degrees(machine.together(|m| !m[0].is_dwell())),
        [[40.0, 320.0, 280.0]]
    );

    // The dwell of the second organ is to begin at 300 degrees, not at 270; the gear has 48 slots.
    let second = &machine.members()[1];
    let begin = second
        .events()
        .iter()
        .position(|event| event.begins.is_dwell())
        .expect("a dwell");
    let lead = second.lead(begin, 300f64.to_radians());
    assert!((lead.to_degrees() + 30.0).abs() < 1e-12);
    let slot = nearest_slot(lead, TAU / 48.0);
    assert!(slot.step == -4 && slot.off.abs() < 1e-12);
    let set = member(
        "organ",
        lift(50f64.to_radians() + slot.angle),
        &[Band::Top(width)],
    )
    .expect("an organ");
    let begins = |event: &&linkage_analysis::cyclogram::Event| event.begins.is_dwell();
    let begin = set.events().iter().find(begins).expect("a dwell").at;
    assert!((begin.to_degrees() - 300.0).abs() < 1e-12, "{begin}");
}
