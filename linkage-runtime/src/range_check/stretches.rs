//! Stretches of an input where a level is not positive: between samples, and at dips that no sample
//! shows.

use alloc::vec::Vec;
use linkage_core::numeric::golden_section::{Point, descend};
use linkage_core::range_check::{DEAD, END, ROUNDING};

/// Halvings until the end of a stretch is known to the last digit.
const HALVINGS: usize = 64;

/// A stretch that does not work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stretch {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// True if the assembly works before the stretch, and after it.
    pub(crate) works: [bool; 2],
    /// True if the level is a number at all of its samples.
    pub(crate) finite: bool,
}

/// A sample: an input and its level; `None` where nothing is known of the level.
pub(crate) type Sample = (f64, Option<f64>);

/// All stretches that do not work, from a level at samples in order and at any input between them.
pub(crate) fn stretches(
    mut samples: Vec<Sample>,
    level: &mut dyn FnMut(f64) -> Option<f64>,
) -> Vec<Stretch> {
    let more: Vec<Sample> = (0..samples.len())
        .filter_map(|middle| between(&samples, middle, level))
        .collect();
    samples.extend(more);
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut found = Vec::new();
    let mut open: Option<Stretch> = None;
    let mut before: Option<Sample> = None;
    for sample in samples {
        let works = |sample: Sample| sample.1.is_some_and(|level| !fails(level));
        match sample.1 {
            None => found.extend(open.take()),
            Some(slack) if fails(slack) => {
                let stretch = Stretch {
                    from: sample.0,
                    to: sample.0,
                    works: [false; 2],
                    finite: !slack.is_nan(),
                };
                open = Some(match (open, before.filter(|&before| works(before))) {
                    (Some(so_far), _) => Stretch {
                        to: stretch.to,
                        finite: so_far.finite && stretch.finite,
                        ..so_far
                    },
                    (None, Some(before)) => Stretch {
                        from: edge(before.0, sample.0, level),
                        works: [true, false],
                        ..stretch
                    },
                    (None, None) => stretch,
                });
            }
            Some(_) => found.extend(open.take().map(|stretch| Stretch {
                to: edge(sample.0, stretch.to, level),
                works: [stretch.works[0], true],
                ..stretch
            })),
        }
        before = Some(sample);
    }
    found.extend(open);
    found
}

/// The inputs between `low` and `high` where a slack of about 1 touches zero and is positive on
/// both sides; at an end, on its side.
pub(crate) fn touches(
    [low, high]: [f64; 2],
    samples: usize,
    slack: &mut dyn FnMut(f64) -> f64,
) -> Vec<f64> {
    let inside = |x: f64| (x - low).min(high - x) > END * (high - low);
    let mut level = |x: f64| Some(slack(x) - if inside(x) { DEAD } else { 0.0 });
    let at = |k: usize| {
        if k == samples {
            high
        } else {
            low + (high - low) * (k as f64 / samples as f64)
        }
    };
    let points: Vec<Sample> = (0..=samples).map(|k| (at(k), level(at(k)))).collect();
    let found = stretches(points, &mut level);
    let mut lowest = |stretch: &Stretch| lowest(stretch, [low, high], &mut |x| slack(x));
    found
        .iter()
        .map(&mut lowest)
        .filter(|(_, slack)| slack.abs() < DEAD)
        .map(|(x, _)| x)
        .collect()
}

/// The input with the lowest level in and next to a narrow stretch, and that level.
pub(crate) fn lowest(
    stretch: &Stretch,
    [low, high]: [f64; 2],
    level: &mut dyn FnMut(f64) -> f64,
) -> (f64, f64) {
    let width = stretch.to - stretch.from;
    let [from, to] = [
        (stretch.from - width).max(low),
        (stretch.to + width).min(high),
    ];
    linkage_core::numeric::range::minimum(from, to, 8, level)
}

/// Returns true if a level is not that of a position that works.
pub(crate) fn fails(level: f64) -> bool {
    level.is_nan() || level < -ROUNDING
}

/// A place next to a sample that differs from the sample and its neighbours: the bottom
/// of a dip, the top of a hill.
fn between(
    samples: &[Sample],
    middle: usize,
    level: &mut dyn FnMut(f64) -> Option<f64>,
) -> Option<Sample> {
    let last = samples.len() - 1;
    let indices = [middle.saturating_sub(1), middle, (middle + 1).min(last)];
    let mut levels = [0.0; 3];
    for (level, &index) in levels.iter_mut().zip(&indices) {
        *level = samples[index].1?;
    }
    let fail = fails(levels[1]);
    let sign = if fail { -1.0 } else { 1.0 };
    let [fall, rise] = [levels[0], levels[2]].map(|level| sign * (level - levels[1]));
    let alike = levels.iter().all(|&level| fails(level) == fail);
    if !(alike && fall >= 0.0 && rise >= 0.0 && fall + rise > 0.0) {
        return None;
    }
    // The samples are of numbers here: NaN between them does not end a search for a hill.
    let mut depth = |x: f64| match level(x) {
        None => f64::INFINITY,
        Some(slack) if slack.is_nan() && fail => f64::INFINITY,
        Some(slack) => sign * slack,
    };
    let point = |index: usize, margin: f64| Point {
        x: samples[index].0,
        margin: sign * margin,
    };
    let ends = [point(indices[0], levels[0]), point(indices[2], levels[2])];
    let other = |point: Point| fails(sign * point.margin) != fail;
    let bottom = descend(ends[0], ends[1], &mut depth, other);
    other(bottom).then_some((bottom.x, Some(sign * bottom.margin)))
}

/// The border between a working position and another one.
fn edge(works: f64, broken: f64, level: &mut dyn FnMut(f64) -> Option<f64>) -> f64 {
    let (mut good, mut bad) = (works, broken);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (good + bad);
        if middle == good || middle == bad {
            break;
        }
        if level(middle).is_some_and(|reserve| reserve > 0.0) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    bad
}
