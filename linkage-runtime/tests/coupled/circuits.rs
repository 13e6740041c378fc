//! Assemblies over the range of an input.

use linkage_core::range_check::Slack;
use linkage_runtime::support::{
    Chosen, Level, Levels, NoPrograms, Searched, SurveyedUnknown, circuits,
};
use linkage_runtime::{AssemblyError, AssemblyMode, BranchEnd, Circuits, Cycle, Group};
use std::f64::consts::{PI, TAU};

const TURN: Cycle = Cycle {
    low: 0.0,
    high: TAU,
    angle: true,
    samples: 73,
};

const GROUP: Group = Group {
    class: 2,
    order: 2,
    kind: "RRR",
    loops: &[1],
    joints: "joint `c` of `rocker`",
    unknowns: &["joint"],
    mode: Some(0),
    method: "",
};

/// A four-bar of crank, coupler, rocker and frame, as generated code would describe it.
#[derive(Clone, Copy)]
struct FourBar([f64; 4]);

impl FourBar {
    /// The margin, the slack, and the rocker's joint in one of two modes.
    fn at(self, mode: f64, x: f64) -> [f64; 4] {
        let [crank, coupler, rocker, frame] = self.0;
        let c = [frame - crank * x.cos(), -crank * x.sin()];
        let square = c[0] * c[0] + c[1] * c[1];
        let foot = 0.5 * (square + (coupler - rocker) * (coupler + rocker));
        let slack = coupler * coupler * square - foot * foot;
        let area = slack.sqrt();
        let at = |a: usize, b: usize, sign: f64| (foot * c[a] + sign * mode * area * c[b]) / square;
        [
            area / (coupler * rocker),
            slack / (coupler * rocker).powi(2),
            at(0, 1, -1.0),
            at(1, 0, 1.0),
        ]
    }
}

impl Levels for FourBar {
    type Assembly = (Self, f64);
    type Survey = [f64; 4];
    type Programs = NoPrograms;

    fn searched(&self) -> Searched {
        Searched {
            name: "FourBar",
            input: "phi",
            reference: 0.5,
            levels: &[Level::Modes(0)],
            groups: &[GROUP],
            slacks: &[Slack::Number],
            unknowns: &[SurveyedUnknown {
                name: "joint",
                unit: "mm",
                angle: false,
                numbers: 2,
            }],
            modes: 1,
            coupled: 0,
        }
    }

    fn surveyor(&self, chosen: &Chosen, _at: f64) -> Self::Assembly {
        let mode = match chosen.modes[0] {
            AssemblyMode::Plus => 1.0,
            AssemblyMode::Minus => -1.0,
        };
        (*self, mode)
    }

    fn survey(&self, &(four_bar, mode): &Self::Assembly, at: f64) -> [f64; 4] {
        four_bar.at(mode, at)
    }

    fn assembled(&self, chosen: &Chosen, at: f64) -> Result<Self::Assembly, AssemblyError> {
        Ok(self.surveyor(chosen, at))
    }

    fn check(&self, _at: f64) -> Result<(), AssemblyError> {
        Ok(())
    }
}

fn search(lengths: [f64; 4], cycle: &Cycle) -> Circuits<(FourBar, f64)> {
    circuits(&FourBar(lengths), cycle).expect("a list")
}

/// Two links of one length on one pivot can turn together: no assembly is listed.
#[test]
fn links_that_lie_on_each_other_are_undetermined() {
    let found = search([1e-9, 80.0, 80.0, 1e-9], &TURN);
    assert!(found.branches.is_empty() && found.meetings.is_empty());
    let text = found.to_string();
    let expected = "\nundetermined from 0 deg to 360 deg: joint `c` of `rocker` (joint; RRR), whose links lie on each other";
    assert!(text.contains(expected), "{text}");
    // A drawing that is a little off has two assemblies.
    assert_eq!(search([1e-3, 80.0, 80.0, 1e-4], &TURN).branches.len(), 2);
}

#[test]
fn a_crank_rocker_has_two_circuits() {
    let found = search([50.0, 100.0, 80.0, 110.0], &TURN);
    assert_eq!(found.whole().count(), 2);
    assert_eq!(found.branches.len(), 2);
    assert_ne!(found.branches[0].circuit, found.branches[1].circuit);
    // The transmission angle is smallest where the crank is in line with the frame.
    for branch in &found.branches {
        assert!(branch.closed && branch.margin > 0.5 && (branch.at % PI).abs() < 1e-3);
    }
}

#[test]
fn a_range_closes_if_it_is_a_turn_of_an_angle() {
    let closed = |more: f64, angle: bool| {
        let cycle = Cycle {
            high: TURN.high + more,
            angle,
            ..TURN
        };
        let found = search([50.0, 100.0, 80.0, 110.0], &cycle);
        assert_eq!(found.branches.len(), 2);
        found.branches.iter().all(|branch| branch.closed)
    };
    assert!(closed(0.0, true) && closed(5e-10, true) && closed(-5e-10, true));
    assert!(!closed(2e-9, true) && !closed(-2e-9, true) && !closed(1e-6, true));
    assert!(!closed(0.0, false));
}

#[test]
fn a_double_rocker_has_turning_points_and_one_circuit() {
    let [crank, coupler, rocker, frame] = [100.0, 50.0, 80.0, 110.0];
    let cycle = Cycle {
        low: -PI,
        high: PI,
        ..TURN
    };
    let found = search([crank, coupler, rocker, frame], &cycle);
    let reach = coupler + rocker;
    let least = rocker - coupler;
    let angle = |side: f64| {
        f64::acos((crank * crank + frame * frame - side * side) / (2.0 * crank * frame))
    };
    assert_eq!(found.branches.len(), 4);
    for branch in &found.branches {
        let mut ends = branch.ends.map(|end| {
            assert!(matches!(end, BranchEnd::TurningPoint(_)));
            end.x().abs()
        });
        ends.sort_by(f64::total_cmp);
        for (end, exact) in ends.iter().zip([angle(least), angle(reach)]) {
            assert!((end - exact).abs() < 1e-12 * TAU, "{end} {exact}");
        }
        assert_eq!(branch.margin, 0.0);
    }
    let circuits: Vec<usize> = found.branches.iter().map(|branch| branch.circuit).collect();
    assert_eq!(circuits, [0, 0, 1, 1]);
}

#[test]
fn a_change_point_that_is_passed_ends_nothing() {
    // A parallelogram is stretched at 0 and folded at 180 degrees.
    let cycle = Cycle {
        low: -1.0,
        high: 5.0,
        angle: true,
        samples: 73,
    };
    let found = search([50.0, 110.0, 50.0, 110.0], &cycle);
    assert_eq!(found.whole().count(), 2);
    assert!(found.branches.iter().all(|branch| branch.margin < 1e-6));
}

#[test]
fn a_narrow_gap_and_a_narrow_assembly_are_found() {
    // They are missed by less than a hundredth of the distance of samples.
    let off = 1e-6;
    let gap = search([50.0, 110.0, 50.0 - off, 110.0], &TURN);
    let ends: Vec<BranchEnd> = gap.branches.iter().flat_map(|branch| branch.ends).collect();
    let turning = |end: &&BranchEnd| matches!(end, BranchEnd::TurningPoint(_));
    assert!(ends.iter().filter(turning).count() >= 4, "{gap}");
    // Coupler and rocker are just long enough where the crank is in line with the frame.
    let assembly = search([50.0, 30.0, 30.0 + off, 110.0], &TURN);
    assert_eq!(assembly.branches.len(), 4, "{assembly}");
}

#[test]
fn the_table_shows_estimates() {
    let found = search([100.0, 80.0, 80.0, 110.0], &TURN);
    let text = found.to_string();
    assert!(
        text.lines()
            .next()
            .is_some_and(|title| title.ends_with("phi          joint")),
        "{text}"
    );
    for branch in &found.branches {
        let [estimate] = &branch.unknowns[..] else {
            panic!("{text}")
        };
        let written = estimate.to_string();
        assert!(
            written.starts_with("joint = (") && written.ends_with("mm)"),
            "{written}"
        );
        let (four_bar, mode) = branch.assembly;
        assert_eq!(estimate.numbers[..], four_bar.at(mode, branch.input)[2..]);
    }
}

#[test]
fn nothing_to_find_is_an_empty_table() {
    let empty = search([10.0, 20.0, 30.0, 500.0], &TURN);
    assert_eq!(
        empty.to_string(),
        "assembly  circuit  from  to  least margin  at\n"
    );
}
