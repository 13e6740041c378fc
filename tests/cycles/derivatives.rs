//! Derivatives of all figures against differences.

use super::{
    N, Rocker, RockerAssembly, changed, course, distance, errors, figure, margin, speed, tip,
    tolerances,
};
use linkage::Dimensions;
use linkage::design::{
    Candidate, Chosen, CycleWish, Dwell, Figure, Highest, Lowest, Motion, Peak, RootMeanSquare,
    Stroke, TimeRatio,
};
use std::f64::consts::TAU;

fn slopes_agree(what: &impl Figure<RockerAssembly, N>) {
    const STEP: f64 = 1e-3;
    let (value, slopes) = figure(what, &Rocker::default());
    assert!(
        value != 0.0 && slopes.iter().any(|slope| slope.abs() > 1e-6 * value.abs()),
        "{}",
        what.title()
    );
    for (k, slope) in slopes.into_iter().enumerate() {
        let [up, down] = [STEP, -STEP].map(|step| figure(what, &changed(k, step)).0);
        let difference = (up - down) / (2.0 * STEP);
        let size = slopes
            .iter()
            .fold(0.0, |most: f64, slope| most.max(slope.abs()));
        assert!(
            (slope - difference).abs() < 1e-6 * size,
            "{} by {k}: {slope} and {difference}",
            what.title()
        );
    }
}

#[test]
fn slopes_of_figures_are_those_of_differences() {
    slopes_agree(&Highest(tip()));
    slopes_agree(&Lowest(tip()));
    slopes_agree(&Stroke(tip()));
    slopes_agree(&Peak(speed()));
    slopes_agree(&Highest(distance()));
    slopes_agree(&Lowest(margin()));
    slopes_agree(&RootMeanSquare(speed()));
    slopes_agree(&TimeRatio::new(tip(), |rocker: &RockerAssembly, phi| {
        rocker.slopes(phi).ev
    }));
    slopes_agree(&errors(true));
    slopes_agree(&errors(false));
}

#[test]
fn errors_are_those_of_effects() {
    let assembly = Rocker::default().assemble().expect("assembles");
    let largest = |error: &dyn Fn(&linkage::tolerance::Effects<N, 1>) -> f64| {
        let at = |i: i32| error(&tolerances().effects(&assembly.slopes(0.5 * f64::from(i)).e));
        (0..12).map(at).fold(0.0, f64::max)
    };
    let (worst, _) = figure(&errors(true), &Rocker::default());
    let exact = largest(&|effects| effects.worst_case()[0]);
    assert!(worst >= exact && worst < exact * 1.005, "{worst} {exact}");
    let (root, _) = figure(&errors(false), &Rocker::default());
    assert!((root - largest(&|effects| effects.root_sum_square()[0])).abs() < 1e-12);
}

#[test]
fn slopes_of_a_dwell_are_those_of_differences() {
    let limit = course(&Rocker::default()).position().highest;
    let own = [limit.at - 0.3, 0.8, limit.value - 2.0, 3.0];
    let dwell = Dwell::longest(tip(), own[3]);
    let all = |values: [f64; N + 4]| {
        let mechanism = Rocker::from_values(&std::array::from_fn(|k| values[k]));
        let assembly = mechanism.assemble().expect("assembles");
        let motion = Motion {
            assembly: &assembly,
            range: (0.0, TAU),
            closed: true,
            positions: 121,
        };
        let assemble = |other: &Rocker| other.assemble().ok();
        let candidate = Candidate::new(&mechanism, motion, &assemble);
        let asked = dwell
            .evaluate(
                &candidate,
                Chosen {
                    own: &values[N..],
                    added: &[],
                },
            )
            .expect("runs through the interval");
        asked
            .conditions
            .into_iter()
            .chain([asked.goal])
            .flatten()
            .collect::<Vec<_>>()
    };
    let nominal = Rocker::default().values();
    let place: [f64; N + 4] = std::array::from_fn(|k| if k < N { nominal[k] } else { own[k - N] });
    let pieces = all(place);
    // What is sampled, above and below, the limit above, and the goal.
    assert_eq!(pieces.len(), 2 * Dwell::<RockerAssembly, N>::SAMPLES + 2);
    for k in 0..N + 4 {
        const STEP: f64 = 1e-5;
        let [up, down] = [STEP, -STEP].map(|step| {
            let mut other = place;
            other[k] += step;
            all(other)
        });
        for ((piece, up), down) in pieces.iter().zip(&up).zip(&down) {
            let slope = if k < N {
                piece.parameters[k]
            } else {
                piece.own[k - N]
            };
            let difference = (up.value - down.value) / (2.0 * STEP);
            assert!(
                (slope - difference).abs() < 1e-6,
                "{k} {:?}: {slope} and {difference}",
                piece.place
            );
        }
    }
}
