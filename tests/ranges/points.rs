//! Words, later groups, what is not checked; circuits and rates at change points.

use std::f64::consts::PI;

use linkage::{RangeFindingKind, Unchecked};

use crate::{FourBar, Free, SixBar, TwoDrives, four_bar};

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
    let groups = |six_bar: SixBar| {
        let linkage = six_bar.assemble().expect("it closes at the reference");
        let found = linkage.check_range().findings;
        let groups = found.iter().map(|finding| (finding.group, finding.kind));
        groups.collect::<Vec<_>>()
    };
    let own = SixBar {
        rod: 50.0,
        height: 100.0,
        ..SixBar::default()
    };
    assert_eq!(groups(own), [(1, RangeFindingKind::Gap)]);
    // Of a dyad that does not close, what hangs on it is not blamed.
    let both = SixBar {
        coupler: 60.0,
        ..SixBar::default()
    };
    assert_eq!(groups(both), [(0, RangeFindingKind::Gap)]);
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
    let said =
        "circuits 1 and 2 meet at phi = 0 deg and 180 deg (change points): assemblies 1 and 2\n";
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
