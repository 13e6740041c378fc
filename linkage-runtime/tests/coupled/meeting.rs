//! Which ends of assemblies belong together: every threshold from both sides.

use linkage_runtime::{BranchEnd, Circuits, Cycle, circuits};
use std::f64::consts::TAU;

const LINE: Cycle = Cycle {
    low: -2.0,
    high: 2.0,
    angle: false,
    samples: 9,
};

const TURN: Cycle = Cycle {
    low: 0.0,
    high: TAU,
    angle: true,
    samples: 9,
};

/// Assemblies that exist everywhere.
fn endless<A: Clone>(
    cycle: &Cycle,
    assemblies: &[A],
    place: impl Fn(&A, f64) -> Vec<f64>,
) -> Circuits<A> {
    circuits(
        cycle,
        |_| Ok::<_, ()>(assemblies.to_vec()),
        |_, _| 1.0,
        place,
    )
    .unwrap()
}

/// A half of a circle of radius `r`, above or below (`side` 1 or -1), a little off in another coordinate.
#[derive(Clone, Copy, Debug)]
struct Half {
    r: f64,
    side: f64,
    off: f64,
}

fn half(r: f64, side: f64, off: f64) -> Half {
    Half { r, side, off }
}

impl Half {
    fn height(self, x: f64) -> f64 {
        self.side * (self.r * self.r - x * x).sqrt()
    }
}

/// Whether two halves are of one circuit.
fn together(halves: [Half; 2]) -> bool {
    let found = circuits(
        &LINE,
        |x| {
            let there = halves.iter().filter(|half| x.abs() < half.r);
            Ok::<_, ()>(there.copied().collect())
        },
        |half, x| half.height(x).abs(),
        |half, x| vec![half.height(x), 1.0 + half.off],
    )
    .unwrap();
    let number = |half: &Half| {
        let same = |one: &Half| one.r == half.r && one.side == half.side && one.off == half.off;
        let mut branches = found.branches.iter();
        branches.find(|one| same(&one.assembly)).unwrap().circuit
    };
    number(&halves[0]) == number(&halves[1])
}

#[test]
fn assemblies_at_different_places_are_two() {
    let count = |distance: f64| {
        let found = endless(&LINE, &[0.0, distance], |off, x| vec![x, 1.0 + off]);
        found.branches.len()
    };
    assert_eq!((count(1e-7), count(1e-5), count(1e-3)), (1, 2, 2));
}

#[test]
fn an_assembly_is_recognised_although_its_place_is_rounded() {
    let mut listed = 0.0;
    let found = circuits(
        &LINE,
        |_| {
            listed += 1.0;
            Ok::<_, ()>(vec![1e-8 * listed])
        },
        |_, _| 1.0,
        |off, x| vec![x, 1.0 + off],
    );
    assert_eq!(found.unwrap().branches.len(), 1);
}

#[test]
fn halves_that_meet_are_one_circuit() {
    // Places at turning points are extrapolated: they may differ by a thousandth.
    for (off, expected) in [(0.0, true), (1e-4, true), (3e-3, false), (0.05, false)] {
        let halves = [half(1.0, 1.0, 0.0), half(1.0, -1.0, off)];
        assert_eq!(together(halves), expected, "{off}");
    }
}

#[test]
fn halves_that_end_apart_are_two_circuits() {
    // By how much the one ends further out, the range being 4 long.
    for (more, expected) in [(1e-6, true), (1e-5, false), (1e-3, false)] {
        let halves = [half(1.0, 1.0, 0.0), half(1.0 + more, -1.0, 0.0)];
        assert_eq!(together(halves), expected, "{more}");
    }
}

#[test]
fn a_turn_closes_where_the_place_is_the_same() {
    let closed = |rise: f64| {
        let place = |(): &(), x: f64| vec![x.cos(), x.sin() + rise * x];
        let found = endless(&TURN, &[()], place);
        assert_eq!(found.branches.len(), 1);
        found.branches[0].closed
    };
    assert!(closed(0.0) && closed(1e-8));
    assert!(!closed(1e-6) && !closed(1e-4) && !closed(0.1));
}

#[test]
fn a_range_closes_if_it_is_a_turn_of_an_angle() {
    let closed = |more: f64, angle: bool| {
        let high = TURN.high + more;
        let cycle = Cycle {
            high,
            angle,
            ..TURN
        };
        let place = |(): &(), x: f64| vec![(x * TAU / high).cos(), (x * TAU / high).sin()];
        endless(&cycle, &[()], place).branches[0].closed
    };
    assert!(closed(0.0, true) && closed(5e-10, true) && closed(-5e-10, true));
    assert!(!closed(2e-9, true) && !closed(-2e-9, true) && !closed(1e-6, true));
    assert!(!closed(0.0, false));
}

#[test]
fn a_margin_that_vanishes_nearby_is_a_turning_point() {
    // Not served up to its turning point at 1: lost if that is further away than a thousandth of the range.
    let end = |gap: f64| {
        let found = circuits(
            &LINE,
            |x| Ok::<_, ()>(if x < 1.0 - gap { vec![()] } else { vec![] }),
            |(), x| {
                if x < 1.0 - gap {
                    (1.0 - x).sqrt()
                } else {
                    f64::NAN
                }
            },
            |(), x| vec![(1.0 - x).sqrt(), 1.0],
        );
        found.unwrap().branches[0].ends[1]
    };
    for gap in [0.0, 1e-4, 3.9e-3] {
        let found = end(gap);
        let turning = matches!(found, BranchEnd::TurningPoint(x) if (x - 1.0).abs() < 4e-9);
        assert!(turning, "{gap}: {found:?}");
    }
    for gap in [4.1e-3, 1e-2, 0.03] {
        let found = end(gap);
        let lost = matches!(found, BranchEnd::Lost(x) if (x - 1.0 + gap).abs() < 1e-9);
        assert!(lost, "{gap}: {found:?}");
    }
}
