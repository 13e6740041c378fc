//! The search on slacks that are formulas.

use super::{RangeFindingKind, RangeReport, Ranged, Unchecked, check_range};
use crate::data::Input;
use crate::structure::Group;
use alloc::string::ToString;
use alloc::vec::Vec;
use core::f64::consts::{PI, TAU};
use linkage_core::range_check::Slack;

const GROUP: Group = Group {
    class: 2,
    order: 2,
    kind: "RRR",
    loops: &[1],
    joints: "",
    unknowns: &["theta", "psi"],
    mode: Some(0),
    method: "",
};

const INPUT: Input = Input {
    name: "phi",
    unit: "rad",
    reference: 0.5,
    range: Some((0.0, TAU)),
};

fn report(
    inputs: &'static [Input],
    slacks: &[Slack],
    slack: &dyn Fn(f64) -> Vec<f64>,
) -> RangeReport {
    const GROUPS: [Group; 2] = [
        GROUP,
        Group {
            loops: &[2],
            joints: "joint `c` of `rocker`",
            unknowns: &["chi"],
            ..GROUP
        },
    ];
    let ranged = Ranged {
        mechanism: "Test",
        inputs,
        groups: &GROUPS[..slacks.len()],
        slacks,
        units: &["mm", "mm"],
        repeats: true,
    };
    check_range(
        &ranged,
        &|x| {
            let mut survey = slack(x[0]);
            survey.insert(0, survey.iter().fold(1.0, |a: f64, b| a.min(*b)));
            survey
        },
        &|x| {
            slack(x[0])
                .iter()
                .map(|slack| if *slack < -1e-14 { -10.0 * slack } else { 0.0 })
                .collect()
        },
    )
}

#[test]
fn what_touches_zero_is_a_change_point() {
    let found = report(&[INPUT], &[Slack::Number], &|x| {
        Vec::from([x.sin().powi(2)])
    });
    let kinds: Vec<_> = found.findings.iter().map(|finding| finding.kind).collect();
    assert_eq!(kinds, [RangeFindingKind::ChangePoint; 3]);
    for (finding, at) in found.findings.iter().zip([0.0, PI, TAU]) {
        assert!(
            (finding.from - at).abs() < 1e-7 && finding.from == finding.to,
            "{finding:?}"
        );
    }
    assert_eq!(
        found.to_string(),
        "Test: the mechanism comes apart in this range: loop 1 (`theta`, `psi`) reaches a change point at `phi = 0deg`, \
         `phi = 180deg` and `phi = 360deg`; there two of its assemblies meet, and it may go on in either; around the reference \
         it works from 0.01deg to 179.99deg\n\
         help: write `in 0.01deg..179.99deg`, or change a length so that they do not meet"
    );
}

#[test]
fn beside_a_change_point_nothing_is_found() {
    for beside in [1e-6, 1e-9] {
        let found = report(&[INPUT], &[Slack::Number], &|x| {
            Vec::from([beside + x.sin().powi(2)])
        });
        assert!(found.is_sound(), "{found}");
        let expected = "Test: no change point and no dead point for `phi` in 0deg..360deg";
        assert_eq!(found.to_string(), expected);
    }
}

#[test]
fn a_gap_has_both_ends_and_the_largest_miss() {
    let found = report(&[INPUT], &[Slack::Number], &|x| Vec::from([0.6 + x.cos()]));
    let [gap] = found.findings[..] else {
        panic!("{found:?}");
    };
    let end = f64::acos(-0.6);
    assert_eq!(gap.kind, RangeFindingKind::Gap);
    assert!((gap.from - end).abs() < 1e-10 && (gap.to - (TAU - end)).abs() < 1e-10);
    assert!((gap.miss - 4.0).abs() < 1e-9);
    assert!((found.works[0] + end).abs() < 1e-8 && (found.works[1] - end).abs() < 1e-8);
    let text = found.to_string();
    let part = "reaches a dead point at `phi = 126.8699deg`, beyond which it misses by up to 4mm; it closes again at \
                `phi = 233.1301deg`; around the reference it works from -126.86deg to 126.86deg\nhelp: write `in 0deg..126.86deg`, \
                or change the lengths";
    assert!(text.contains(part), "{text}");
}

/// Of a text with joints and links, the joint is named.
#[test]
fn a_gap_names_its_joint() {
    let found = report(&[INPUT], &[Slack::Number, Slack::Number], &|x| {
        Vec::from([1.0, 0.6 + x.cos()])
    });
    let text = found.to_string();
    let part = "apart in this range: joint `c` of `rocker` (`chi`) reaches a dead point";
    assert!(text.contains(part), "{text}");
}

#[test]
fn narrow_gaps_and_hills_between_samples_are_found() {
    // A tenth of a sample wide.
    let width = 0.1 * TAU / 180.0;
    let dip = move |x: f64| ((x - 2.0) / width).powi(2) - 1.0;
    let found = report(&[INPUT], &[Slack::Relative], &|x| Vec::from([dip(x)]));
    let kinds: Vec<_> = found.findings.iter().map(|finding| finding.kind).collect();
    assert_eq!(kinds, [RangeFindingKind::Gap]);
    let found = report(&[INPUT], &[Slack::Relative], &|x| {
        Vec::from([(1.0 - x) * dip(x)])
    });
    let kinds: Vec<_> = found.findings.iter().map(|finding| finding.kind).collect();
    assert_eq!(kinds, [RangeFindingKind::Gap, RangeFindingKind::DeadPoint]);
}

#[test]
fn a_group_with_one_assembly_is_singular_where_its_slack_changes_sign() {
    let found = report(&[INPUT], &[Slack::Signed], &|x| {
        Vec::from([-1e9 * (x - 3.0)])
    });
    let [finding] = found.findings[..] else {
        panic!("{found:?}");
    };
    assert_eq!(finding.kind, RangeFindingKind::DeadPoint);
    assert!((finding.from - 3.0).abs() < 1e-8);
}

#[test]
fn a_group_is_not_blamed_for_one_before_it() {
    let found = report(&[INPUT], &[Slack::Number; 2], &|x| {
        let first = 0.5 + x.cos();
        Vec::from([first, if first < 0.0 { f64::NAN } else { 1.0 }])
    });
    let groups: Vec<_> = found.findings.iter().map(|finding| finding.group).collect();
    assert_eq!(groups, [0]);
    let found = report(&[INPUT], &[Slack::Number; 2], &|x| {
        Vec::from([1.0, if x > 4.0 { f64::NAN } else { 1.0 }])
    });
    let text = found.to_string();
    let help = "help: write `in 0deg..229.18deg`, or change what is not a finite number";
    assert!(text.contains(help), "{text}");
    let found: Vec<_> = found
        .findings
        .iter()
        .map(|finding| (finding.group, finding.kind))
        .collect();
    assert_eq!(found, [(1, RangeFindingKind::Undefined)]);
}

#[test]
fn a_turn_without_a_range_is_searched_for_change_points_alone() {
    const FREE: Input = Input {
        range: None,
        ..INPUT
    };
    let found = report(&[FREE], &[Slack::Number], &|x| {
        Vec::from([(0.5 * x).cos().powi(2)])
    });
    let inputs: Vec<_> = found.findings.iter().map(|finding| finding.from).collect();
    assert!(
        inputs.len() == 1 && (inputs[0] - PI).abs() < 1e-7,
        "{found:?}"
    );
    assert_eq!(
        found.to_string(),
        "Test: at `phi = 180deg` the mechanism passes through a change point: from there loop 1 (`theta`, `psi`) can go on in \
         another assembly\nhelp: give the input the range in which it is driven, `in LOW..HIGH`, or change a length"
    );
    let gap = report(&[FREE], &[Slack::Number], &|x| Vec::from([0.5 + x.cos()]));
    assert!(gap.is_sound());
}

#[test]
fn a_range_may_end_at_a_dead_point() {
    const HALF: Input = Input {
        reference: 1.0,
        range: Some((0.0, PI)),
        ..INPUT
    };
    let found = report(&[HALF], &[Slack::Number], &|x| Vec::from([x.sin()]));
    assert!(found.is_sound(), "{found}");
}

#[test]
fn what_is_not_checked_is_reported() {
    let several = report(&[INPUT, INPUT], &[Slack::Number], &|_| Vec::from([1.0]));
    assert_eq!(several.unchecked, Some(Unchecked::SeveralRanges));
    assert!(
        several
            .to_string()
            .starts_with("Test: the ranges are not checked: several inputs")
    );
    const SLIDE: Input = Input {
        unit: "mm",
        range: None,
        ..INPUT
    };
    let none = report(&[SLIDE], &[Slack::Number], &|_| Vec::from([1.0]));
    assert_eq!(none.unchecked, Some(Unchecked::NoRange));
}
