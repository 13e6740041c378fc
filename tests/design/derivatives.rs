//! Rows of wishes: their derivatives against differences of the rows of other dimensions and inputs.

use super::{FourBar, FourBarAssembly, PathColumns, PoseColumns, SpeedColumns, evenly, points};
use linkage::design::{Candidates, Objective, Rows, Targets, Timing};
use linkage::{Cycle, Dimensions};
use std::f64::consts::TAU;

const CYCLE: Cycle = Cycle {
    low: 0.0,
    high: TAU,
    angle: true,
    samples: 73,
};

/// The rows of a wish for one mechanism.
fn rows(
    wish: &dyn Objective<FourBar, FourBarAssembly>,
    mechanism: FourBar,
    free: &[f64],
) -> Vec<(f64, Vec<f64>, Vec<f64>)> {
    let assembly = FourBar::default().assemble().expect("it assembles");
    // Beside another one, as in a search.
    let other = FourBar {
        crank: 12.0,
        ..mechanism
    };
    let doubled: Vec<f64> = free.iter().chain(free).copied().collect();
    let mut rows = Rows::new(wish.rows(), 9, free.len());
    let candidates = Candidates {
        assembly: &assembly,
        mechanisms: &[other, mechanism],
        free: &doubled,
    };
    rows.reset(2);
    wish.evaluator().evaluate(&candidates, &mut rows);
    let row = |k| {
        let (value, by, free) = rows.row(1, k);
        (value, by.to_vec(), free.to_vec())
    };
    (0..wish.rows()).map(row).collect()
}

/// Compares all derivatives with central differences, whose error is some 1e-9 of the third derivatives.
fn compare(wish: &dyn Objective<FourBar, FourBarAssembly>, free: &[f64]) {
    let mechanism = FourBar {
        crank: 13.0,
        tilt: 0.3,
        ..FourBar::default()
    };
    let here = rows(wish, mechanism, free);
    let step = 1e-5;
    for parameter in 0..9 {
        let at = |by: f64| {
            let mut values = mechanism.values();
            values[parameter] += by;
            rows(wish, FourBar::from_values(&values), free)
        };
        let (above, below) = (at(step), at(-step));
        for (row, (above, below)) in here.iter().zip(above.iter().zip(&below)) {
            let known = (above.0 - below.0) / (2.0 * step);
            assert!(
                (row.1[parameter] - known).abs() < 1e-7 * (1.0 + known.abs()),
                "{} and {known}",
                row.1[parameter]
            );
        }
    }
    for input in 0..free.len() {
        let at = |by: f64| {
            let mut free = free.to_vec();
            free[input] += by;
            rows(wish, mechanism, &free)
        };
        let (above, below) = (at(step), at(-step));
        for (row, (above, below)) in here.iter().zip(above.iter().zip(&below)) {
            let known = (above.0 - below.0) / (2.0 * step);
            assert!(
                (row.2[input] - known).abs() < 1e-7 * (1.0 + known.abs()),
                "{} and {known}",
                row.2[input]
            );
        }
    }
}

#[test]
fn of_a_path_with_every_timing() {
    let inputs = evenly(0.4, 0.7, 5);
    let targets = || Targets::new("tracer", points(&inputs)).weights([1.0, 2.5]);
    let path = FourBarAssembly::path_sweep_sets_into;
    compare(&targets().at_inputs(inputs.clone()).computed_by(path), &[]);
    for timing in [Timing::InOrder, Timing::Backwards, Timing::Free] {
        let wish = targets().timing(timing).computed_by(path);
        assert_eq!(
            Objective::<FourBar, FourBarAssembly>::free(&wish, &CYCLE)
                .expect("they are free")
                .count,
            5
        );
        compare(&wish, &[0.3, 0.9, 1.6, 2.0, 2.2]);
    }
    compare(
        &targets().timing(Timing::Evenly(-0.4)).computed_by(path),
        &[0.8],
    );
}

#[test]
fn of_poses_and_velocities() {
    let poses = [[20.0, 20.0, 0.4], [25.0, 22.0, 0.7]];
    let wish = Targets::of_all(["tracer", "theta"], poses).weights([1.0, 1.0, 20.0]);
    compare(
        &wish.computed_by(FourBarAssembly::pose_sweep_sets_into),
        &[0.5, 1.1],
    );
    let wish = Targets::new("v", [[0.3], [0.2], [-0.1]]);
    compare(
        &wish.computed_by(FourBarAssembly::speed_sweep_sets_into),
        &[0.5, 1.1, 3.0],
    );
}

/// Velocities of a point, with inputs free: two numbers at each position.
#[test]
fn of_the_velocity_of_a_point() {
    let going = FourBarAssembly::going_sweep_sets_into;
    let wanted = [[3.0, -4.0], [1.0, 2.0], [-6.0, 0.5]];
    compare(
        &Targets::new("v", wanted)
            .weights([1.0, 2.0])
            .computed_by(going),
        &[0.5, 1.1, 3.0],
    );
    // Those of a four-bar lead back to it, up to a rotation of nothing: lengths and the place of the point.
    let known = FourBar {
        crank: 14.0,
        rocker: 32.0,
        arm: [18.0, 12.0].into(),
        ..FourBar::default()
    };
    let assembly = known.assemble().expect("it assembles");
    let inputs = evenly(0.2, 0.9, 7);
    let velocities: Vec<[f64; 2]> = inputs
        .iter()
        .map(|&phi| assembly.going(phi).v.into())
        .collect();
    let wish = Targets::new("v", velocities)
        .at_inputs(inputs)
        .computed_by(going);
    let design = ["crank", "rocker", "arm.x", "arm.y"]
        .into_iter()
        .fold(super::problem_of_nothing(), |design, name| {
            design.vary_by(name, 0.3)
        });
    let found = design.want(wish).starts(16).run().expect("it can be found");
    let best = found.best();
    assert!(best.sum < 1e-18, "{found}");
    for (value, known) in best.mechanism.values().iter().zip(known.values()) {
        assert!((value - known).abs() < 1e-7, "{value} {known}");
    }
}

/// The residual itself is the difference, an angle's without whole turns.
#[test]
fn residuals_are_differences() {
    let pose = FourBar::default()
        .assemble()
        .expect("it assembles")
        .pose(0.5);
    let turned = pose.theta + TAU + 0.01;
    let targets = Targets::of_all(
        ["tracer", "theta"],
        [[pose.tracer.x - 1.0, pose.tracer.y + 2.0, turned]],
    );
    let wish = targets
        .weights([1.0, 10.0, 100.0])
        .at_inputs([0.5])
        .computed_by(FourBarAssembly::pose_sweep_sets_into);
    let found = rows(&wish, FourBar::default(), &[]);
    for (row, known) in found.iter().zip([1.0, -20.0, -1.0]) {
        assert!((row.0 - known).abs() < 1e-10, "{} and {known}", row.0);
    }
}

/// Columns know their quantities: what is looked up by name is what single calls give.
#[test]
fn columns_have_the_names_of_quantities() {
    use linkage::Table;
    let names = |table: &dyn Table| -> Vec<&str> {
        table
            .heading()
            .columns
            .iter()
            .map(|c| c.name)
            .take(2)
            .collect()
    };
    assert_eq!(names(&PathColumns::default()), ["tracer.x", "tracer.y"]);
    assert_eq!(names(&PoseColumns::default()), ["tracer.x", "tracer.y"]);
    assert_eq!(names(&SpeedColumns::default()), ["v", "a"]);
}
