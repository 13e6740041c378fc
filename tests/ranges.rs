//! The check of the declared range at run time, and what is at change points: assemblies that meet, positions without derivatives.

use linkage::{RangeFindingKind, RangeReport, Unchecked, mechanism};
use linkage_random::Random;
use std::f64::consts::{PI, TAU};

mechanism! {
    struct FourBar {
        unit mm;
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param frame = 140mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(crank, phi) + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
    }
    impl FourBar {
        fn motion(phi) -> Motion { psi, v: velocity(psi), a: acceleration(psi), m: margin() }
    }
}

mechanism! {
    struct SliderCrank {
        unit mm;
        param crank = 40mm;
        param rod = 150mm;
        param offset = 10mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -5deg;
        unknown slide = 180mm;
        loop polar(crank, phi) + polar(rod, theta) = (slide, offset);
    }
    impl SliderCrank {
        fn stroke(phi) -> Stroke { slide, v: velocity(slide) }
    }
}

// The second dyad hangs on the first; another function has the name of the check.
mechanism! {
    struct SixBar {
        unit mm;
        param crank = 50mm;
        param coupler = 120mm;
        param rod = 200mm;
        param height = 60mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        unknown chi = 10deg;
        unknown slide = 360mm;
        loop polar(crank, phi) + polar(coupler, theta) = (140mm, 0) + polar(100mm, psi);
        loop (140mm, 0) + polar(100mm, psi) + polar(rod, chi) = (slide, height);
    }
    impl SixBar {
        fn stroke(phi) -> SixStroke { slide }
    }
}

mechanism! {
    struct Free {
        unit mm;
        param coupler = 120mm;
        param rocker = 100mm;
        input phi = 30deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(50mm, phi) + polar(coupler, theta) = (140mm, 0) + polar(rocker, psi);
    }
    impl Free {
        fn check_range(phi) -> FreeAngle { psi }
    }
}

mechanism! {
    struct TwoDrives {
        unit mm;
        param rod = 100mm;
        input alpha = 30deg in 0deg..90deg;
        input beta = 140deg in 90deg..150deg;
        unknown theta = 60deg;
        unknown psi = 120deg;
        loop polar(40mm, alpha) + polar(rod, theta) = (120mm, 0) + polar(40mm, beta) + polar(rod, psi);
    }
    impl TwoDrives {
        fn tip(alpha, beta) -> Tip { p: polar(40mm, alpha) + polar(rod, theta) }
    }
}

type Expected = (RangeFindingKind, f64, f64);

/// Four lengths: what is found in a turn, from where the diagonal between crank and rocker is too long or too short for both. `None` where it is
/// at a limit all the way, or beyond one.
fn expected(crank: f64, coupler: f64, rocker: f64, frame: f64) -> Option<Vec<Expected>> {
    let (inner, outer) = ((frame - crank).abs(), frame + crank);
    let (near, far) = ((coupler - rocker).abs(), coupler + rocker);
    let same = |a: f64, b: f64| (a - b).abs() < 1e-13 * outer;
    let angle = |distance: f64| {
        let cosine = (crank * crank + frame * frame - distance * distance) / (2.0 * crank * frame);
        cosine.clamp(-1.0, 1.0).acos()
    };
    // Where both links nearly fold onto a diagonal that nearly vanishes, the slack is near what counts as a dead point over a stretch, and the
    // ends of a gap are as uncertain.
    if !same(inner, near) && inner.max(near) < 3e-3 * outer {
        return None;
    }
    if inner > far || same(inner, far) || outer < near || same(outer, near) {
        return None;
    }
    let mut found = Vec::new();
    match (same(inner, near), inner < near) {
        (true, _) => {
            found.push((RangeFindingKind::ChangePoint, 0.0, 0.0));
            found.push((RangeFindingKind::ChangePoint, TAU, TAU));
        }
        // It is open at both ends of the turn.
        (false, true) => {
            found.push((RangeFindingKind::DeadPoint, 0.0, angle(near)));
            found.push((RangeFindingKind::DeadPoint, TAU - angle(near), TAU));
        }
        _ => {}
    }
    match (same(outer, far), outer > far) {
        (true, _) => found.push((RangeFindingKind::ChangePoint, PI, PI)),
        (false, true) => found.push((RangeFindingKind::Gap, angle(far), TAU - angle(far))),
        _ => {}
    }
    found.sort_by(|a, b| a.1.total_cmp(&b.1));
    Some(found)
}

/// Whether a report is that.
fn compare(report: &RangeReport, expected: &[Expected], case: &str) {
    let found: Vec<_> = report.findings.iter().map(|own| own.kind).collect();
    let kinds: Vec<_> = expected.iter().map(|own| own.0).collect();
    assert_eq!(found, kinds, "{case}: {report:?}");
    for (own, (kind, from, to)) in report.findings.iter().zip(expected) {
        let near = |a: f64, b: f64| (a - b).abs() < 2e-7;
        assert!(
            near(own.from, *from) && near(own.to, *to),
            "{case}: {own:?}"
        );
        assert_eq!(
            own.miss > 0.0,
            *kind != RangeFindingKind::ChangePoint,
            "{case}"
        );
    }
}

fn four_bar([crank, coupler, rocker, frame]: [f64; 4]) -> FourBar {
    FourBar {
        crank,
        coupler,
        rocker,
        frame,
    }
}

/// Lengths at a change point: a parallelogram, a kite of either kind, or the longest and the shortest as long as the others.
fn special(random: &mut Random) -> [f64; 4] {
    let [a, b, c] = [0; 3].map(|_| random.between(20.0, 200.0));
    match random.below(6) {
        0 => [a, b, a, b],
        1 => [a, a, b, b],
        2 => [a, b, b, a],
        3 => [a, b, c, b + c - a],
        4 => [a, b, c, a + b - c],
        _ => [a, b, c, a + c - b],
    }
}

#[test]
fn random_four_bars_have_what_their_lengths_say() {
    let mut random = Random::new(42);
    let count = match std::env::var_os("LINKAGE_LONG") {
        Some(_) => 100_000,
        None => 1500,
    };
    let mut kinds = [0; 4];
    for round in 0..count {
        let mut lengths = special(&mut random);
        match round % 3 {
            // As near to a change point as a millionth.
            1 => lengths[random.below(4)] *= 1.0 + random.pick(&[1e-6, -1e-6]),
            2 => lengths = lengths.map(|own| own * random.between(0.5, 2.0)),
            _ => {}
        }
        let [a, b, c, d] = lengths;
        let Some(expected) = expected(a, b, c, d).filter(|_| lengths.iter().all(|x| *x > 5.0))
        else {
            continue;
        };
        let Ok(assembly) = four_bar(lengths).assemble() else {
            continue;
        };
        compare(&assembly.check_range(), &expected, &format!("{lengths:?}"));
        kinds[round % 3] += usize::from(!expected.is_empty());
        kinds[3] += usize::from(expected.is_empty());
    }
    assert!(kinds.iter().all(|own| *own > count / 20), "{kinds:?}");
}

#[test]
fn a_rod_as_long_as_its_crank_meets_itself_at_right_angles() {
    let mut random = Random::new(7);
    for _ in 0..200 {
        let crank = random.between(10.0, 100.0);
        let own = SliderCrank {
            crank,
            rod: crank,
            offset: 0.0,
        };
        let point = |x: f64| (RangeFindingKind::ChangePoint, x, x);
        let found = own.assemble().expect("it closes").check_range();
        compare(
            &found,
            &[point(0.5 * PI), point(1.5 * PI)],
            &format!("{crank}"),
        );
        let longer = SliderCrank {
            rod: crank * (1.0 + 1e-6),
            ..own
        };
        assert!(
            longer
                .assemble()
                .expect("it closes")
                .check_range()
                .is_sound()
        );
        // An offset that only one side reaches.
        let offset = random.between(0.01, 0.4) * crank;
        let end = ((own.rod - offset) / crank).asin();
        let low = SliderCrank {
            offset: -offset,
            ..own
        };
        let gap = (RangeFindingKind::Gap, end, PI - end);
        compare(
            &low.assemble().expect("it closes").check_range(),
            &[gap],
            &format!("{crank} {offset}"),
        );
    }
}

#[test]
fn the_words_are_those_of_the_compiler() {
    let own = four_bar([50.0, 140.0, 50.0, 140.0])
        .assemble()
        .expect("it closes");
    assert_eq!(
        own.check_range().to_string(),
        "FourBar: the mechanism comes apart in this range: loop 1 (`theta`, `psi`) reaches a change point at `phi = 0deg`, \
         `phi = 180deg` and `phi = 360deg`; there two of its assemblies meet, and it may go on in either; around the reference \
         it works from 0.01deg to 179.99deg\n\
         help: write `in 0.01deg..179.99deg`, or change a length so that they do not meet"
    );
    let sound = FourBar::default()
        .assemble()
        .expect("it closes")
        .check_range();
    assert!(sound.is_sound() && sound.unchecked.is_none());
    assert_eq!(sound.input.map(|own| own.name), Some("phi"));
}

#[test]
fn a_later_group_has_findings_of_its_own() {
    let own = SixBar {
        rod: 50.0,
        height: 100.0,
        ..SixBar::default()
    };
    let found = own
        .assemble()
        .expect("it closes at the reference")
        .check_range();
    let groups: Vec<_> = found
        .findings
        .iter()
        .map(|own| (own.group, own.kind))
        .collect();
    assert_eq!(groups, [(1, RangeFindingKind::Gap)], "{found}");
    // Of a dyad that does not close, what hangs on it is not blamed.
    let both = SixBar {
        coupler: 60.0,
        ..SixBar::default()
    };
    let found = both
        .assemble()
        .expect("it closes at the reference")
        .check_range();
    let groups: Vec<_> = found
        .findings
        .iter()
        .map(|own| (own.group, own.kind))
        .collect();
    assert_eq!(groups, [(0, RangeFindingKind::Gap)], "{found}");
    assert!(
        SixBar::default()
            .assemble()
            .expect("it closes")
            .check_range()
            .is_sound()
    );
}

#[test]
fn what_is_not_checked_is_said() {
    let found = TwoDrives::default()
        .assemble()
        .expect("it closes")
        .check_range();
    assert_eq!(found.unchecked, Some(Unchecked::SeveralRanges));
    // A function of the user keeps its name.
    let psi = Free::default()
        .assemble()
        .expect("it closes")
        .check_range(0.5)
        .psi;
    assert!(psi.is_finite());
}

#[test]
fn circuits_that_cross_say_where() {
    let kite = four_bar([60.0, 120.0, 80.0, 140.0])
        .circuits()
        .expect("it closes");
    assert_eq!(kite.branches.len(), 2);
    assert_eq!(kite.meetings.len(), 1);
    let meeting = &kite.meetings[0];
    assert_eq!(meeting.branches, [0, 1]);
    assert!(
        meeting.at.len() == 1 && (meeting.at[0] - PI).abs() < 1e-6,
        "{meeting:?}"
    );
    let said = "circuits 1 and 2 meet at phi = 180 deg (change point): assemblies 1 and 2\n";
    assert!(kite.to_string().ends_with(said), "{kite}");
    let all = four_bar([50.0, 140.0, 50.0, 140.0])
        .circuits()
        .expect("it closes");
    let said = "assemblies 1 and 2 of circuit 1 meet at phi = 0 deg and 180 deg (change points)\n";
    assert!(all.to_string().ends_with(said), "{all}");
    // Turning points, where two assemblies of one circuit end, are none.
    assert!(
        FourBar {
            crank: 200.0,
            ..FourBar::default()
        }
        .circuits()
        .expect("some")
        .meetings
        .is_empty()
    );
    assert!(
        FourBar::default()
            .circuits()
            .expect("some")
            .meetings
            .is_empty()
    );
}

/// The root is 0 there: positions exist, rates do not. Beside it they do.
#[test]
fn rates_are_no_numbers_at_a_change_point() {
    let mut points = 0;
    for lengths in [
        [50.0, 140.0, 50.0, 140.0],
        [60.0, 120.0, 80.0, 140.0],
        [50.0, 50.0, 140.0, 140.0],
        [120.0, 120.0, 100.0, 140.0],
    ] {
        let assembly = four_bar(lengths).assemble().expect("it closes");
        let single = four_bar(lengths)
            .cast::<f32>()
            .assemble()
            .expect("it closes");
        let found = assembly.check_range().findings;
        let places = found
            .iter()
            .filter(|own| own.kind == RangeFindingKind::ChangePoint);
        for at in places.map(|own| (own.from / PI).round() * PI) {
            let own = assembly.motion(at);
            let swept = assembly.motion_sweep(&[at; 9]);
            // A discriminant that rounding makes positive has a root, and rates that are noise.
            if own.m == 0.0 {
                points += 1;
                assert!(
                    own.psi.is_finite() && own.v.is_nan() && own.a.is_nan(),
                    "{lengths:?} {at}: {own:?}"
                );
                assert!(
                    swept.v().iter().chain(swept.a()).all(|x| x.is_nan()),
                    "{lengths:?} {at}"
                );
            }
            let beside = assembly.motion(at + 1e-4);
            assert!(
                beside.v.is_finite() && beside.a.is_finite(),
                "{lengths:?} {at}"
            );
        }
        let own = single.motion(0.0);
        assert!(own.m > 0.0 || own.psi.is_finite() && own.v.is_nan() && own.a.is_nan());
    }
    assert!(points >= 8, "{points}");
}
