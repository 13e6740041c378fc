//! Assemblies over the range of an input.

use crate::triads::EyeNeedle;
use linkage_runtime::numeric::continuation::{Correction, Range, Table};
use linkage_runtime::numeric::roots::{System, Term, Variable, solve};
use linkage_runtime::{BranchEnd, Cycle, circuits};
use std::f64::consts::{PI, TAU};

const TURN: Cycle = Cycle {
    low: 0.0,
    high: TAU,
    angle: true,
    samples: 25,
};

/// A four-bar of crank, coupler, rocker and frame: the rocker's joint in one of two modes, and the margin.
fn four_bar(lengths: [f64; 4], mode: f64, x: f64) -> ([f64; 2], f64) {
    let [crank, coupler, rocker, frame] = lengths;
    let c = [frame - crank * x.cos(), -crank * x.sin()];
    let square = c[0] * c[0] + c[1] * c[1];
    let foot = 0.5 * (square + (coupler - rocker) * (coupler + rocker));
    let area = (coupler * coupler * square - foot * foot).sqrt();
    let at = |a: usize, b: usize, sign: f64| (foot * c[a] + sign * mode * area * c[b]) / square;
    ([at(0, 1, -1.0), at(1, 0, 1.0)], area / (coupler * rocker))
}

fn search(lengths: [f64; 4], cycle: &Cycle) -> linkage_runtime::Circuits<f64> {
    let exists = |x: f64| !four_bar(lengths, 1.0, x).1.is_nan();
    circuits(
        cycle,
        |x| {
            if exists(x) {
                Ok(vec![1.0, -1.0])
            } else {
                Err("apart")
            }
        },
        |&mode, x| four_bar(lengths, mode, x).1,
        |&mode, x| four_bar(lengths, mode, x).0.to_vec(),
    )
    .unwrap()
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
            assert!((end - exact).abs() < 1e-9 * TAU, "{end} {exact}");
        }
        assert_eq!(branch.margin, 0.0);
    }
    let circuits: Vec<usize> = found.branches.iter().map(|branch| branch.circuit).collect();
    assert_eq!(circuits, [0, 0, 1, 1]);
}

/// All assemblies of a triad at an input, each with a table that may end at turning points.
fn tables(triad: EyeNeedle, x: f64) -> Vec<Table> {
    let exponents: [[i8; 2]; 7] = [[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1], [1, -1], [-1, 1]];
    let terms: Vec<Term<'_>> = (0..2)
        .flat_map(|equation| exponents.iter().map(move |exponents| (equation, exponents)))
        .map(|(equation, exponents)| Term {
            equation,
            exponents,
        })
        .collect();
    let system = System {
        variables: &[Variable::Unit, Variable::Unit],
        terms: &terms,
    };
    let listing = solve(&system, &triad.system(x)).unwrap();
    let range = Range {
        low: 0.0,
        high: TAU,
        turn: true,
    };
    listing
        .real
        .iter()
        .filter_map(|values| {
            let mut triad = triad;
            Table::build(&mut triad, x, &values.concat(), range, true).ok()
        })
        .collect()
}

/// State and determinant as an evaluator gives them: NaN if they are not certain.
fn evaluate(triad: EyeNeedle, table: &Table, x: f64) -> ([f64; 4], f64) {
    let mut triad = triad;
    let mut state = [0.0; 4];
    let floor = table.state(x, &mut state);
    let step = triad.correct(&[x], &mut state);
    if step.size < 1e-7 && step.determinant * floor >= floor * floor {
        (state, triad.correct(&[x], &mut state).determinant.abs())
    } else {
        ([f64::NAN; 4], f64::NAN)
    }
}

#[test]
fn triads_have_circuits_and_turning_points() {
    for crank in [50.0, 80.0, 100.9, 120.0, 200.0] {
        let triad = EyeNeedle::with_crank(crank);
        let found = circuits(
            &TURN,
            |x| {
                let tables = tables(triad, x);
                if tables.is_empty() {
                    Err(())
                } else {
                    Ok(tables)
                }
            },
            |table, x| evaluate(triad, table, x).1,
            |table, x| evaluate(triad, table, x).0.to_vec(),
        )
        .unwrap();
        for branch in &found.branches {
            for end in branch.ends {
                // The tables have located the same turning points.
                if let BranchEnd::TurningPoint(x) = end {
                    let known = branch.assembly.ends().map(|end| match end {
                        linkage_runtime::numeric::continuation::End::TurningPoint(at) => {
                            (at - x).abs()
                        }
                        _ => f64::INFINITY,
                    });
                    assert!(known[0].min(known[1]) < 1e-9 * TAU, "{x} {known:?}");
                }
            }
        }
    }
}

#[test]
fn nothing_to_find_is_an_error() {
    let none = circuits(
        &TURN,
        |_| Err::<Vec<()>, _>("apart"),
        |(), _| 1.0,
        |(), _| vec![],
    );
    assert_eq!(none.unwrap_err(), "apart");
    let empty = circuits(
        &TURN,
        |_| Ok::<Vec<()>, ()>(vec![]),
        |(), _| 1.0,
        |(), _| vec![],
    );
    assert_eq!(
        empty.unwrap().to_string(),
        "assembly  circuit  from  to  least margin  at\n"
    );
}

#[test]
fn a_narrow_place_that_is_lost_is_no_turning_point() {
    // One assembly whose margin nearly vanishes at 0.5, and which is not served there.
    let margin = |_: &(), x: f64| {
        let off = x - 0.5;
        let margin = (off * off + 1e-9).sqrt();
        if off.abs() < 2e-5 { f64::NAN } else { margin }
    };
    let cycle = Cycle {
        low: 0.0,
        high: 1.0,
        angle: false,
        samples: 12,
    };
    let found = circuits(
        &cycle,
        |_| Ok::<_, ()>(vec![()]),
        margin,
        |(), x| vec![x, 1.0],
    )
    .unwrap();
    assert_eq!(found.branches.len(), 2);
    let lost = |end: BranchEnd| matches!(end, BranchEnd::Lost(x) if (x - 0.5).abs() < 1e-3);
    assert!(lost(found.branches[0].ends[1]) && lost(found.branches[1].ends[0]));
}
