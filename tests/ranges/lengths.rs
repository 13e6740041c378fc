//! Findings of random lengths against what the lengths say.

use std::f64::consts::{PI, TAU};

use linkage::{RangeFindingKind, RangeReport};
use linkage_random::Random;

use crate::{SliderCrank, four_bar};

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
