//! Derivatives of all figures against differences.

use super::{
    N, Rocker, RockerAssembly, asked, changed, course, distance, figure, margin,
    slopes_of_pieces_agree, speed, tip,
};
use linkage::Dimensions;
use linkage::design::{Dwell, Figure, Highest, Lowest, Peak, RootMeanSquare, Stroke, TimeRatio};

pub(super) fn slopes_agree(what: &impl Figure<RockerAssembly, N>) {
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
}

#[test]
fn slopes_of_a_dwell_are_those_of_differences() {
    let limit = course(&Rocker::default()).position().highest;
    let own = [limit.at - 0.3, 0.8, limit.value - 2.0, 3.0];
    let dwell = Dwell::longest(tip(), own[3]);
    let nominal = Rocker::default().values();
    let place: [f64; N + 4] = std::array::from_fn(|k| if k < N { nominal[k] } else { own[k - N] });
    // What is sampled, above and below, the limit above, and the goal.
    let count = asked(&dwell, &place).len();
    assert_eq!(count, 2 * Dwell::<RockerAssembly, N>::SAMPLES + 2);
    slopes_of_pieces_agree(&dwell, &place);
    // Within given inputs there is a condition more, as a condition itself no goal.
    let window = Dwell::longest(tip(), own[3]).between(limit.at - 0.4, limit.at + 0.6);
    assert_eq!(asked(&window, &place).len(), count + 1);
    slopes_of_pieces_agree(&window, &place);
    let condition = Dwell::at_least(tip(), own[3], own[1]);
    assert_eq!(asked(&condition, &place).len(), count - 1);
    slopes_of_pieces_agree(&condition, &place);
}
