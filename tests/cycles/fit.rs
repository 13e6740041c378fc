//! Values at positions beside figures of the cycle.

use super::{N, Rocker, RockerAssembly, design, figure, margin, slopes_of_pieces_agree, speed};
use linkage::Dimensions;
use linkage::design::{Design, DesignError, Figure, Fit, Lowest, Peak, Targets, Timing};
use linkage_random::Random;

const INPUTS: [f64; 7] = [0.3, 0.9, 1.7, 2.6, 3.4, 4.5, 5.6];

/// Points of a rocker that differs in the lengths which vary.
fn points() -> [[f64; 2]; 7] {
    let other = Rocker {
        crank: 53.0,
        coupler: 126.0,
        rocker: 94.0,
        ..Rocker::default()
    };
    let assembly = other.assemble().expect("assembles");
    INPUTS.map(|phi| {
        let point = assembly.point(phi).point;
        [point.x, point.y]
    })
}

fn path() -> Targets {
    Targets::new("point", points()).at_inputs(INPUTS)
}

/// The sum of the squares of all distances at given inputs, and the largest difference of a coordinate.
fn missed(rocker: &Rocker) -> [f64; 2] {
    let assembly = rocker.assemble().expect("assembles");
    let differences = INPUTS.iter().zip(points()).flat_map(|(&phi, wanted)| {
        let point = assembly.point(phi).point;
        [point.x - wanted[0], point.y - wanted[1]]
    });
    differences.fold([0.0, 0.0], |[sum, most], difference| {
        [
            sum + difference * difference,
            f64::max(most, difference.abs()),
        ]
    })
}

macro_rules! computed {
    ($targets:expr) => {
        $targets.computed_by(RockerAssembly::point_sweep_sets_into)
    };
}

#[test]
fn slopes_are_those_of_differences() {
    let place = Rocker::default().values();
    slopes_of_pieces_agree(&Fit::least(computed!(path())), &place);
    slopes_of_pieces_agree(&Fit::closest(computed!(path().weights([1.0, 3.0]))), &place);
    let free: Vec<f64> = place.into_iter().chain(INPUTS).collect();
    let in_order = || path().timing(Timing::InOrder);
    slopes_of_pieces_agree(&Fit::least(computed!(in_order())), &free);
    slopes_of_pieces_agree(&Fit::within(computed!(in_order()), 0.5), &free);
}

/// A path that can be met is met, with inputs given and free, as by the search of least squares.
#[test]
fn a_path_is_met() -> Result<(), DesignError> {
    for timing in [Timing::Given(INPUTS.to_vec()), Timing::InOrder] {
        let found = design()
            .want(Fit::least(computed!(path().timing(timing.clone()))))
            .run()?;
        assert!(found.converged && found.goal < 1e-6, "{timing:?}: {found}");
        let values = [53.0, 126.0, 94.0];
        let Rocker {
            crank,
            coupler,
            rocker,
            ..
        } = found.mechanism;
        for (value, known) in [crank, coupler, rocker].into_iter().zip(values) {
            assert!((value - known).abs() < 1e-3, "{timing:?}: {value} {known}");
        }
    }
    Ok(())
}

/// A path with a margin that is kept and a peak that is limited: both cost something, and no mechanism nearby that holds them is better.
#[test]
fn a_path_with_figures_of_the_cycle() -> Result<(), DesignError> {
    let freely = design().want(Fit::least(computed!(path()))).run()?;
    let lowest = figure(&Lowest(margin()), &freely.mechanism).0;
    let peak = figure(&Peak(speed()), &freely.mechanism).0;
    let (least, most) = (lowest + 0.02, 0.99 * peak);
    let wishes = || {
        design()
            .want(Lowest(margin()).at_least(least))
            .want(Peak(speed()).at_most(most))
    };
    let found = wishes().want(Fit::least(computed!(path()))).run()?;
    let [sum, _] = missed(&found.mechanism);
    assert!(found.converged && (found.goal - sum).abs() < 1e-9 * sum);
    assert!(sum > 0.01, "{sum}");
    let holds = |rocker: &Rocker| {
        figure(&Lowest(margin()), rocker).0 >= least - 1e-9
            && figure(&Peak(speed()), rocker).0 <= most * (1.0 + 1e-9)
    };
    assert!(holds(&found.mechanism));
    let mut random = Random::new(5);
    let mut held = 0;
    for _ in 0..2000 {
        let Rocker {
            crank,
            coupler,
            rocker,
            ..
        } = found.mechanism;
        let mut near =
            |x: f64, low: f64, high: f64| (x + random.between(-0.3, 0.3)).clamp(low, high);
        let other = Rocker {
            crank: near(crank, 45.0, 55.0),
            coupler: near(coupler, 108.0, 132.0),
            rocker: near(rocker, 90.0, 110.0),
            ..found.mechanism
        };
        if holds(&other) {
            held += 1;
            assert!(missed(&other)[0] > sum * (1.0 - 1e-6), "{other:?}");
        }
    }
    assert!(held > 50, "{held}");

    // The largest difference instead of the sum.
    let closest = wishes().want(Fit::closest(computed!(path()))).run()?;
    let [_, largest] = missed(&closest.mechanism);
    assert!((closest.goal - largest).abs() < 1e-6 * largest);
    assert!(largest < 0.99 * missed(&found.mechanism)[1]);
    assert!(holds(&closest.mechanism));

    // And the other way round: the least peak of mechanisms that come as near.
    let near = design()
        .want(Lowest(margin()).at_least(least))
        .want(Fit::within(computed!(path()), largest))
        .want(Peak(speed()).least())
        .run()?;
    assert!(near.goal <= most * (1.0 + 1e-6), "{} {most}", near.goal);
    assert!(missed(&near.mechanism)[1] <= largest * (1.0 + 1e-6));
    Ok(())
}

/// Where nothing else is asked for, least squares by another method come to the same.
#[test]
fn least_squares_agree() -> Result<(), DesignError> {
    // Points that no rocker within the bounds meets.
    let far = || Targets::new("point", points().map(|[x, y]| [x + 4.0, y])).timing(Timing::InOrder);
    let found = design().want(Fit::least(computed!(far()))).run()?;
    let known = Design::<_, _, N>::new(
        Rocker::default(),
        Rocker::assemble,
        Rocker::assemblies,
        Rocker::circuits,
    )?;
    let known = ["crank", "coupler", "rocker"]
        .into_iter()
        .fold(known, |design, name| design.vary_by(name, 0.1))
        .want(computed!(far()))
        .starts(64)
        .run()?;
    let sums: Vec<f64> = known.designs.iter().map(|design| design.sum).collect();
    assert!(sums[0] > 0.1, "{sums:?}");
    let same = |sum: &&f64| (found.goal - **sum).abs() < 1e-5 * **sum;
    assert!(sums.iter().find(same).is_some(), "{} {sums:?}", found.goal);
    Ok(())
}

/// What is wrong with targets is told as by least squares.
#[test]
fn mistakes_are_told_together() {
    let wrong = Targets::new("trace", [[1.0, 2.0]]).at_inputs([0.1]);
    let run = design()
        .vary("crnk", 1.0, 2.0)
        .want(Fit::within(computed!(wrong), 1.0))
        .run();
    let text = run.expect_err("three mistakes").to_string();
    for part in [
        "3 mistakes",
        "no parameter `crnk`",
        "no quantity `trace`",
        "no wish is a goal",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
}
