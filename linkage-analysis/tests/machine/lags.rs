//! Angles between events of organs, and what organs do at once, against samples and differences.

use crate::cyclogram::member;
use crate::{TAU, TURN};
use linkage_analysis::cyclogram::{Band, Cyclogram, CyclogramError, Member, Moment, Motion};
use linkage_analysis::summary::Curve;
use linkage_analysis::tolerance::Tolerances;
use linkage_random::Random;
use linkage_runtime::Parameter;

/// Two organs on one shaft: `size` is a radius that both have, the leads are their own.
fn members(size: f64, leads: [f64; 2]) -> [Member; 2] {
    [0, 1].map(|k| {
        let harmonics = [[1.0, 0.3], [0.8, -0.4]][k];
        let angles = move |x: f64| [(x + leads[k]).sin_cos(), (2.0 * x).sin_cos()];
        let lift = move |x: f64| {
            let [(s, c), (s2, c2)] = angles(x);
            let [a, b] = harmonics;
            [
                size * a * c + b * c2,
                -size * a * s - 2.0 * b * s2,
                -size * a * c - 4.0 * b * c2,
            ]
        };
        let by_lead = |own: usize, x: f64| if own == k { x } else { 0.0 };
        let value = move |x: f64| {
            let [(s, c), _] = angles(x);
            let lead = -size * harmonics[0] * s;
            [harmonics[0] * c, by_lead(0, lead), by_lead(1, lead)]
        };
        let rate = move |x: f64| {
            let [(s, c), _] = angles(x);
            let lead = -size * harmonics[0] * c;
            [-harmonics[0] * s, by_lead(0, lead), by_lead(1, lead)]
        };
        let course = Curve::new(TURN, 73, lift).expect("a course");
        let name = ["hook", "eye"][k];
        let member = Member::new(name, &course, &[Band::Top(0.2)]).expect("an organ");
        member.unit("mm").sensitivities(value, rate)
    })
}

#[test]
fn lags_and_their_sensitivities_are_differences() {
    const SIZE: f64 = 2.0;
    const LEADS: [f64; 2] = [0.3, -1.1];
    let machine = |size, leads| Cyclogram::new(members(size, leads)).expect("a machine");
    let nominal = machine(SIZE, LEADS);
    let count = nominal.moments().len();
    assert!(count > 5);
    let angle = |of: &Cyclogram, [i, k]: [usize; 2]| {
        let moments: Vec<_> = of.moments().collect();
        of.after(&moments[i], &moments[k]).angle
    };
    for i in 0..count {
        for k in 0..count {
            let moments: Vec<_> = nominal.moments().collect();
            let lag = nominal.after(&moments[i], &moments[k]);
            let between = if i == k {
                0.0
            } else {
                let passed =
                    (i + 1..=if k > i { k } else { k + count }).map(|m| moments[m % count].after);
                passed.sum::<f64>()
            };
            assert!((lag.angle - between).abs() < 1e-14, "{lag}");
            let found = lag.sensitivity().expect("both have them");
            const H: f64 = 1e-6;
            for (p, found) in found.iter().enumerate() {
                let changed = |by: f64| {
                    let mut leads = LEADS;
                    if p > 0 {
                        leads[p - 1] += by;
                    }
                    angle(
                        &machine(if p == 0 { SIZE + by } else { SIZE }, leads),
                        [i, k],
                    )
                };
                let difference = (changed(H) - changed(-H)) / (2.0 * H);
                assert!(
                    (found - difference).abs() < 1e-7,
                    "{lag} {p}: {found} {difference}"
                );
            }
        }
    }
}

/// What both organs have in common shifts both: the worst case of the angle between them is less than that of the two.
#[test]
fn tolerances_of_common_dimensions_cancel() {
    let machine = Cyclogram::new(members(2.0, [0.3, -1.1])).expect("a machine");
    let parameter = |name, tolerance| Parameter {
        name,
        unit: "mm",
        nominal: 1.0,
        tolerance,
    };
    let parameters = [
        parameter("size", 0.05),
        parameter("hook.lead", 0.01),
        parameter("eye.lead", 0.02),
    ];
    let tolerances = Tolerances::<3>::complete(&parameters).expect("tolerances");
    let dwell = Motion::Dwell(0);
    let begin = machine.begin("hook", dwell).expect("it dwells");
    let other = machine.end("eye", dwell).expect("it dwells");
    let of = |moment: &Moment<'_>| {
        let effects = moment
            .member
            .effects(moment.index, &tolerances)
            .expect("as many");
        effects.effects().map(|own| own[0])
    };
    let mut cancelled = 0.0_f64;
    for from in machine.moments() {
        for to in machine.moments() {
            let found = machine
                .after(&from, &to)
                .effects(&tolerances)
                .expect("as many")
                .worst_case()[0];
            let (a, b) = (of(&from), of(&to));
            let expected: f64 = (0..3).map(|p| (b[p] - a[p]).abs()).sum();
            assert!((found - expected).abs() < 1e-15);
            let apart: f64 = (0..3).map(|p| a[p].abs() + b[p].abs()).sum();
            assert!(found < apart + 1e-15);
            if from.member.name() != to.member.name() {
                cancelled = cancelled.max(apart - found);
            }
        }
    }
    // Of two organs, which have the size in common.
    assert!(cancelled > 1e-3, "{cancelled}");
    let lag = machine.after(&begin, &other);
    // Of one event after itself nothing is left.
    let itself = machine.after(&begin, &begin);
    assert_eq!(
        (
            itself.angle,
            itself.effects(&tolerances).expect("as many").worst_case()
        ),
        (0.0, [0.0])
    );

    assert_eq!(
        lag.to_string(),
        format!(
            "eye's dwell (top 0.2 mm) ends {:.4} deg after hook's dwell (top 0.2 mm) begins",
            lag.angle.to_degrees()
        )
    );
    assert!(
        machine.begin("press", dwell).is_none() && machine.begin("eye", Motion::Dwell(1)).is_none()
    );
    let end = machine.end("eye", dwell).expect("it dwells");
    assert_eq!((end.event.ends, end.member.name()), (dwell, "eye"));

    // Without sensitivities there are none of the angle, and the organ is named.
    let plain = member(
        "press",
        |x: f64| [x.sin(), x.cos(), -x.sin()],
        &[Band::Top(0.1)],
    )
    .expect("an organ");
    let [hook, _] = members(2.0, [0.3, -1.1]);
    let mixed = Cyclogram::new([hook, plain]).expect("a machine");
    let [from, to] = ["hook", "press"].map(|name| mixed.begin(name, dwell).expect("it dwells"));
    let lag = mixed.after(&from, &to);
    assert_eq!(lag.sensitivity(), None);
    let Err(CyclogramError::Parameters { member, .. }) = lag.effects(&tolerances) else {
        panic!("no sensitivities");
    };
    assert_eq!(member, "press");
}

/// At each of many angles two organs do the same exactly if an overlap says so.
#[test]
fn overlaps_at_samples() {
    let mut random = Random::new(7);
    let mut twice = 0;
    for _ in 0..40 {
        let bands = [
            Band::Top(random.between(0.1, 0.9)),
            Band::Bottom(random.between(0.1, 0.9)),
        ];
        let leads = [0, 1, 2].map(|_| random.between(0.0, TAU));
        let members = leads.map(|lead| {
            let lift = |x: f64| {
                let ((s, c), (s2, c2)) = ((x + lead).sin_cos(), (2.0 * (x + lead)).sin_cos());
                [c + 0.4 * c2, -s - 0.8 * s2, -c - 1.6 * c2]
            };
            member("organ", lift, &bands).expect("an organ")
        });
        let machine = Cyclogram::new(members).expect("a machine");
        let overlaps = machine.overlaps();
        let sorted = overlaps.all().windows(2);
        assert!(sorted.into_iter().all(|own| {
            let key = |own: &linkage_analysis::cyclogram::Overlap| (own.members, own.interval.from);
            key(&own[0]) <= key(&own[1])
        }));
        for own in overlaps.all() {
            let interval = own.interval;
            assert!(
                (0.0..TAU).contains(&interval.from) && interval.to <= TAU,
                "{own:?}"
            );
            let turned = (interval.from + interval.range - interval.to).abs();
            assert!(turned < 1e-12 || (turned - TAU).abs() < 1e-12, "{own:?}");
        }
        for members in [[0, 1], [0, 2], [1, 2]] {
            for k in 0..1000 {
                let x = TAU * (f64::from(k) + 0.5) / 1000.0;
                let motions = members.map(|member| machine.members()[member].motion(x));
                let same = motions[0] == motions[1] || motions.iter().all(|own| own.is_dwell());
                let holds = overlaps.all().iter().filter(|own| {
                    let after = (x - own.interval.from).rem_euclid(TAU);
                    own.members == members && after < own.interval.range
                });
                let found: Vec<_> = holds.map(|own| own.motions).collect();
                let beside = members.iter().any(|&member| {
                    let events = machine.members()[member].events();
                    events.iter().any(|event| (event.at - x).abs() < 1e-9)
                });
                let expected = if same { vec![motions] } else { Vec::new() };
                assert!(beside || found == expected, "{x}: {found:?} {expected:?}");
            }
            // Two advances, each longer than half a turn, may have two intervals in common.
            let advances = overlaps.all().iter();
            let advances =
                advances.filter(|own| own.members == members && own.motions[0] == own.motions[1]);
            let mut kinds: Vec<_> = advances
                .map(|own| format!("{:?}", own.motions[0]))
                .collect();
            let all = kinds.len();
            kinds.dedup();
            twice += usize::from(kinds.len() < all);
        }
    }
    assert!(twice > 3, "{twice}");
}
