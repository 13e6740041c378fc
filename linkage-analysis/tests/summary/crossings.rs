//! Where quantities pass values, in cycles, over seams and in parts of a turn.

use crate::harmonics::Harmonics;
use crate::{TAU, near, turn};
use linkage_analysis::summary::{Curve, positions};
use linkage_random::Random;

/// All changes of side between many positions, and nothing else.
#[test]
fn all_changes_of_side() {
    let mut random = Random::new(31);
    let mut count = 0;
    for _ in 0..40 {
        let mut number = || [random.between(-3.0, 3.0), random.between(-3.0, 3.0)];
        let function = Harmonics([number(), number(), number()]);
        let jet = |x: f64| [0, 1, 2].map(|k| function.at(x, k));
        let course = turn(jet);
        let extremes = course.position();
        for share in [0.1, 0.35, 0.5, 0.8] {
            let level = extremes.lowest.value + share * extremes.stroke();
            let found = course.crossings(level);
            let above = |i: usize| function.at(TAU * (i as f64 + 0.37) / 5000.0, 0) > level;
            let known = (0..5000)
                .filter(|&i| above(i) != above((i + 1) % 5000))
                .count();
            assert_eq!(found.len(), known, "{level}");
            assert!(found.is_sorted_by(|a, b| a.at < b.at));
            for passage in &found {
                assert_eq!(passage.jet, jet(passage.at));
                near(passage.jet[0], level, 1e-13);
            }
            count += found.len();
        }
    }
    assert!(count > 400, "{count}");
}

/// An angle that turns with the input, a little to and fro: each value is passed where the angle has it, not a turn later.
#[test]
fn a_quantity_that_advances() {
    let angle = |x: f64| [x + 1.5 * x.sin(), 1.0 + 1.5 * x.cos(), -1.5 * x.sin()];
    let course = turn(angle);
    for level in [-0.2, 0.1, 1.0, 3.0, 3.3, 6.0, 6.4] {
        let found = course.crossings(level);
        let above = |i: u32| angle(TAU * f64::from(i) / 20_000.0)[0] > level;
        let known = (0..20_000).filter(|&i| above(i) != above(i + 1)).count();
        assert_eq!(found.len(), known, "{level}");
        for passage in found {
            near(angle(passage.at)[0], level, 1e-14);
        }
    }
}

/// Rows of a sweep in the place of calls: the same course.
#[test]
fn rows_of_a_sweep() {
    let function = Harmonics([[1.0, -0.4], [0.3, 0.2], [-0.1, 0.5]]);
    let jet = |x: f64| [0, 1, 2, 3].map(|k| function.at(x, k));
    let rows: Vec<[f64; 4]> = positions((0.0, TAU), 91).map(jet).collect();
    let calls = std::cell::Cell::new(0);
    let counted = |x: f64| {
        calls.set(calls.get() + 1);
        jet(x)
    };
    let swept = Curve::swept((0.0, TAU), 91, |i| rows[i], counted).expect("a course");
    let own = Curve::new((0.0, TAU), 91, jet).expect("a course");
    assert_eq!(swept.position(), own.position());
    assert_eq!(swept.acceleration(), own.acceleration());
    // Six roots of each of three derivatives at most, each in some fifteen calls.
    assert!(calls.get() < 300, "{}", calls.get());
}
