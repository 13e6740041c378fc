//! The check of the declared range at run time, and what is at change points: assemblies that meet, positions without derivatives.

mod points;

use linkage::{RangeFindingKind, RangeReport, mechanism};
use linkage_random::four_bar::{Limit, lengths, limits};
use linkage_random::{Random, is_long};
use std::f64::consts::PI;

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

fn four_bar([crank, coupler, rocker, frame]: [f64; 4]) -> FourBar {
    FourBar {
        crank,
        coupler,
        rocker,
        frame,
    }
}

// Findings of random lengths against what the lengths say.

type Expected = (Limit, f64, f64);

fn limit(kind: RangeFindingKind) -> Option<Limit> {
    match kind {
        RangeFindingKind::ChangePoint => Some(Limit::ChangePoint),
        RangeFindingKind::DeadPoint => Some(Limit::DeadPoint),
        RangeFindingKind::Gap => Some(Limit::Gap),
        RangeFindingKind::Undefined => None,
    }
}

/// Whether a report is that.
fn compare(report: &RangeReport, expected: &[Expected], case: &str) {
    let found: Vec<_> = report.findings.iter().map(|own| limit(own.kind)).collect();
    let kinds: Vec<_> = expected.iter().map(|own| Some(own.0)).collect();
    assert_eq!(found, kinds, "{case}: {report:?}");
    for (own, (kind, from, to)) in report.findings.iter().zip(expected) {
        let near = |a: f64, b: f64| (a - b).abs() < 2e-7;
        assert!(
            near(own.from, *from) && near(own.to, *to),
            "{case}: {own:?}"
        );
        assert_eq!(own.miss > 0.0, *kind != Limit::ChangePoint, "{case}");
    }
}

#[test]
fn random_four_bars_have_what_their_lengths_say() {
    let mut random = Random::new(42);
    let count = if is_long() { 100_000 } else { 1500 };
    let mut kinds = [0; 4];
    for round in 0..count {
        let lengths = lengths(&mut random, round);
        let Some(expected) = limits(lengths).filter(|_| lengths.iter().all(|x| *x > 5.0)) else {
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
        let point = |x: f64| (Limit::ChangePoint, x, x);
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
        let gap = (Limit::Gap, end, PI - end);
        compare(
            &low.assemble().expect("it closes").check_range(),
            &[gap],
            &format!("{crank} {offset}"),
        );
    }
}
