//! Random sums of three harmonics against a dense search.

use crate::{TAU, turn};
use linkage_random::Random;

pub(crate) struct Harmonics(pub(crate) [[f64; 2]; 3]);

impl Harmonics {
    /// The `k`th derivative.
    pub(crate) fn at(&self, x: f64, k: i32) -> f64 {
        let term = |(i, [a, b]): (usize, &[f64; 2])| {
            let n = (i + 1) as f64;
            let (sin, cos) = (n * x).sin_cos();
            let turned = match k.rem_euclid(4) {
                0 => a * cos + b * sin,
                1 => b * cos - a * sin,
                2 => -a * cos - b * sin,
                _ => a * sin - b * cos,
            };
            turned * n.powi(k)
        };
        self.0.iter().enumerate().map(term).sum()
    }

    /// The roots of the `k`th derivative: sign changes between 20000 positions, bisected.
    fn roots(&self, k: i32) -> Vec<f64> {
        const STEPS: usize = 8_000;
        // Off the grid of the courses.
        let place = |i: usize| -0.0123 + TAU * i as f64 / STEPS as f64;
        let value = |x: f64| self.at(x, k);
        let mut roots = Vec::new();
        for i in 0..STEPS {
            let (mut a, mut b) = (place(i), place(i + 1));
            if value(a).signum() == value(b).signum() {
                continue;
            }
            for _ in 0..80 {
                let middle = 0.5 * (a + b);
                if value(middle).signum() == value(a).signum() {
                    a = middle;
                } else {
                    b = middle;
                }
            }
            roots.push(a.rem_euclid(TAU));
        }
        roots.sort_by(f64::total_cmp);
        roots
    }
}

fn compare(function: &Harmonics, k: i32, found: Vec<f64>) {
    let known = function.roots(k);
    assert_eq!(
        found.len(),
        known.len(),
        "derivative {k}: {found:?} {known:?}"
    );
    for known in known {
        let away = |x: f64| (x - known).abs().min(TAU - (x - known).abs());
        let nearest = found.iter().map(|&x| away(x)).fold(f64::INFINITY, f64::min);
        // Rounding of the derivative over its slope.
        let size: f64 = function.0.iter().flatten().map(|a| a.abs()).sum::<f64>() * 3f64.powi(k);
        let tolerance = 1e-15 + 1e-15 * size / function.at(known, k + 1).abs();
        assert!(
            nearest <= tolerance.max(1e-14),
            "derivative {k}: {nearest:e} beside {known}"
        );
    }
}

#[test]
fn all_places_of_standstill() {
    let mut random = Random::new(0x9E37_79B9_7F4A_7C15);
    for _ in 0..100 {
        let function = Harmonics(std::array::from_fn(|_| {
            [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]
        }));
        let places = |points: &[linkage_analysis::summary::Extreme]| {
            points.iter().map(|point| point.at).collect()
        };

        let course = turn(|x| [0, 1, 2, 3].map(|k| function.at(x, k)));
        compare(&function, 1, places(&course.position().points));
        compare(&function, 2, places(&course.velocity().points));
        compare(&function, 3, places(&course.acceleration().points));
        let course = turn(|x| [0, 1, 2].map(|k| function.at(x, k)));
        compare(&function, 1, places(&course.position().points));
        compare(&function, 2, places(&course.velocity().points));
        let course = turn(|x| [0, 1].map(|k| function.at(x, k)));
        compare(&function, 1, places(&course.position().points));
    }
}

/// The longest interval within a band, by moving a window over dense samples.
#[test]
fn longest_dwells() {
    const STEPS: usize = 4000;
    let mut random = Random::new(0xD1B5_4A32_D192_ED03);
    for _ in 0..60 {
        let function = Harmonics(std::array::from_fn(|i| {
            let share = 1.0 / (1.0 + i as f64);
            [
                share * random.between(-1.0, 1.0),
                share * random.between(-1.0, 1.0),
            ]
        }));
        // Half of them advance over the turn, some with ways back.
        let advance = random.between(-1.0, 1.0).max(0.0);
        let values: Vec<f64> = (0..2 * STEPS)
            .map(|i| {
                let x = TAU * i as f64 / STEPS as f64;
                function.at(x, 0) + advance * x
            })
            .collect();
        let course = turn(|x| {
            let [q, v, a] = [0, 1, 2].map(|k| function.at(x, k));
            [q + advance * x, v + advance, a]
        });
        for band in [0.003, 0.05, 0.4] {
            let stays = |start: usize| {
                let (mut low, mut high) = (values[start], values[start]);
                let stay = values[start..].iter().take(STEPS).take_while(|&&value| {
                    (low, high) = (low.min(value), high.max(value));
                    high - low <= band
                });
                stay.count() - 1
            };
            let longest = (0..STEPS).map(stays).max().unwrap_or(0) as f64;
            let dwell = course.longest_dwell(band).expect("a dwell");
            let steps = dwell.interval.range / TAU * STEPS as f64;
            assert!(
                steps >= longest - 1e-9 && steps <= longest + 2.0,
                "{steps} and {longest} for {band}, advance {advance}"
            );
            assert!(dwell.highest - dwell.lowest <= band * (1.0 + 1e-9));
            assert!(dwell.ripple <= band * (1.0 + 1e-9));
        }
    }
}
