//! Random courses with gaps, over cycles and parts of turns: everything that is said holds at dense samples.

use crate::TAU;
use crate::harmonics::Harmonics;
use linkage_analysis::summary::{Curve, Interval};
use linkage_random::Random;

const SAMPLES: usize = 3000;
/// At borders, a sample may lie on either side.
const BORDER: f64 = 1e-9;

/// How far a place is inside an interval; negative outside.
fn depth(interval: &Interval, cycle: Option<f64>, x: f64) -> f64 {
    let from = x - interval.from;
    let from = match cycle {
        Some(width) if from < -BORDER => from + width,
        _ => from,
    };
    from.min(interval.range - from)
}

fn deepest(intervals: &[Interval], cycle: Option<f64>, x: f64) -> f64 {
    let depths = intervals.iter().map(|interval| depth(interval, cycle, x));
    depths.fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn all_statements_hold_at_samples() {
    let mut random = Random::new(0x2545_F491_4F6C_DD1D);
    let mut with_gaps = 0;
    for case in 0..150 {
        let function = Harmonics(std::array::from_fn(|_| {
            [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]
        }));
        let obstacle = Harmonics(std::array::from_fn(|_| {
            [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]
        }));
        let limit = 2.5 * random.between(-1.0, 1.0).abs();
        let advance = if case % 3 == 0 {
            random.between(-1.0, 1.0)
        } else {
            0.0
        };
        let low = 3.0 * random.between(-1.0, 1.0);
        let width = if case % 4 == 3 {
            1.0 + 4.0 * random.between(-1.0, 1.0).abs()
        } else {
            TAU
        };
        let at = |x: f64| match obstacle.at(x, 0) > limit {
            true => [f64::NAN; 3],
            false => [
                function.at(x, 0) + advance * x,
                function.at(x, 1) + advance,
                function.at(x, 2),
            ],
        };
        let Ok(course) = Curve::new((low, low + width), 200, at) else {
            continue;
        };
        with_gaps += u32::from(course.has_gaps());
        // Even with gaps, intervals go across the seam of a whole turn.
        let cycle = (width == TAU).then_some(TAU);
        let parts = course.parts();
        let position = course.position();
        let band = 0.3 * position.stroke();
        let bounds = [position.lowest.value + band, position.highest.value - band];
        let within = course.within(bounds[0], bounds[1]);
        let dwells = course.dwells(band);
        for i in 0..=SAMPLES {
            let x = low + width * i as f64 / SAMPLES as f64;
            let [value, _, _] = at(x);
            let inside = deepest(&parts, cycle, x);
            assert!(
                inside.abs() < BORDER || (inside > 0.0) == value.is_finite(),
                "case {case}: {x}"
            );
            if value.is_nan() {
                continue;
            }
            let seam = (x - low).min(low + width - x) < BORDER;
            assert!(
                value <= position.highest.value + 1e-12 && value >= position.lowest.value - 1e-12
            );
            let between = value > bounds[0] && value < bounds[1];
            let near = (value - bounds[0]).abs().min((value - bounds[1]).abs()) < BORDER;
            let inside = deepest(&within, cycle, x);
            assert!(
                near || seam || inside.abs() < BORDER || (inside > 0.0) == between,
                "case {case}: {x} {value} {bounds:?} {within:?}"
            );
            for dwell in &dwells {
                let inside = depth(&dwell.interval, cycle, x) > BORDER;
                let across = dwell.interval.to < dwell.interval.from && advance != 0.0;
                let holds = value > dwell.lowest - 1e-9 && value < dwell.highest + 1e-9;
                assert!(
                    !inside || across || holds,
                    "case {case}: {x} {value} {dwell:?}"
                );
            }
        }
        for dwell in &dwells {
            assert!(
                dwell.highest - dwell.lowest <= band * (1.0 + 1e-9),
                "case {case}: {dwell:?}"
            );
            assert!(dwell.interval.range > 0.0 && dwell.interval.range <= width);
        }
        for point in position.points.iter().filter(|point| !point.end) {
            let [value, slope, _] = at(point.at);
            assert!(
                (value - point.value).abs() < 1e-12 && slope.abs() < 1e-12,
                "case {case}: {point:?}"
            );
        }
    }
    assert!(with_gaps > 50, "{with_gaps} courses with gaps");
}
