//! Stretches in which a group with a closed form can be assembled: its slack is positive between
//! simple roots.

use super::parts::parts;
use super::slab::Slab;
use alloc::vec::Vec;
use linkage_core::Enclosure;
use linkage_core::numeric::golden_section::{Point, descend};

/// A slack that is negative by less, compared with the largest, is rounding: two turning points
/// that close are one place that the assembly passes.
const ROUNDING: f64 = -1e-14;

/// Steps that bring a border to the last digit, and how far apart its sides are then.
const STEPS: usize = 120;
const WIDTH: f64 = 4e-16;

/// An end of a stretch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Border {
    /// With the slab.
    Slab,
    /// A root of the slack.
    Root(f64),
    /// The end of the definition of the slack.
    Broken(f64),
}

/// The slack of a group.
pub(super) struct Slack<'a> {
    /// Its value at an input.
    pub(super) at: &'a dyn Fn(f64) -> f64,
    /// Bounds over inputs; without them it is known by samples only.
    pub(super) over: Option<&'a dyn Fn(Enclosure) -> Enclosure>,
    /// True if the sign does not matter: the group has one assembly wherever there is a slack.
    pub(super) single: bool,
    /// True if the slack is known up to the ends of the slab. Otherwise it is continued there.
    pub(super) served: bool,
    /// True if the slack is a smooth function of the input up to the ends of the slab: no group turns
    /// back there.
    pub(super) smooth: bool,
}

/// All stretches of a slab where the slack is positive, or, `single`, where there is one.
///
/// The stretches with a positive slack. Bounds prove the sign of every part between two ends.
/// Double zeros, and slacks without bounds, are searched with samples and the dips between them.
pub(super) fn stretches(slab: &Slab, samples: usize, group_slack: &Slack<'_>) -> Vec<[Border; 2]> {
    let mut slack = |u: f64| {
        let value = (group_slack.at)(slab.x(u));
        if group_slack.single {
            0.0 * value
        } else {
            value
        }
    };
    let last = samples.max(2);
    let at = |index: usize| 2.0 * (index as f64 / last as f64) - 1.0;
    let mut points: Vec<Point> = (0..=last)
        .map(|k| Point::evaluate(at(k), &mut slack))
        .collect();
    if !group_slack.served {
        trim(&mut points);
    }
    let size = points.iter().map(|point| point.margin.abs());
    let size = size.fold(0.0, |most: f64, size| if size > most { size } else { most });
    let works = |point: Point| point.margin >= ROUNDING * size;
    let shown = group_slack.over.is_some_and(|over| {
        let over = |u: Enclosure| match group_slack.smooth {
            true => over(slab.between(u)),
            false => over(slab.over(u)),
        };
        let parts = parts(&over, group_slack.single, ROUNDING * size);
        // Ends within the slab: where signs change there is one between two of them.
        let between = parts.ends.into_iter().filter(|u| u.abs() < 1.0);
        points.extend(between.map(|u| Point::evaluate(u, &mut slack)));
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        parts.shown
    });
    if !shown {
        refine(&mut points, &works, &mut slack);
    }

    let mut found = Vec::new();
    let mut from = points
        .first()
        .filter(|&&point| works(point))
        .map(|_| Border::Slab);
    for pair in points.windows(2) {
        match (works(pair[0]), works(pair[1])) {
            (false, true) => from = Some(border(pair[1], pair[0], slab, &works, &mut slack)),
            (true, false) => {
                let end = border(pair[0], pair[1], slab, &works, &mut slack);
                found.extend(from.take().map(|from| [from, end]));
            }
            _ => {}
        }
    }
    found.extend(from.map(|from| [from, Border::Slab]));
    found
}

/// Removes points that are not a number before the first and after the last valid one.
fn trim(points: &mut Vec<Point>) {
    let known = |point: &Point| !point.margin.is_nan();
    points.truncate(points.iter().rposition(known).map_or(0, |last| last + 1));
    points.drain(..points.iter().position(known).unwrap_or(0));
}

/// Adds the lowest points between samples that work and the highest ones between samples that do
/// not, where they are of the other kind.
fn refine(
    points: &mut Vec<Point>,
    works: &impl Fn(Point) -> bool,
    slack: &mut impl FnMut(f64) -> f64,
) {
    let mut more = Vec::new();
    for three in points.windows(3) {
        let [before, middle, after] = [three[0], three[1], three[2]];
        let kind = works(middle);
        if works(before) != kind || works(after) != kind || middle.margin.is_nan() {
            continue;
        }
        let sign = if kind { 1.0 } else { -1.0 };
        let lowest =
            |other: Point| other.margin.is_nan() || sign * (other.margin - middle.margin) >= 0.0;
        if !(lowest(before) && lowest(after))
            || before.margin == after.margin && before.margin == middle.margin
        {
            continue;
        }
        let depth = |point: Point| Point {
            x: point.x,
            margin: sign * point.margin,
        };
        let mut deep = |u: f64| {
            let value = sign * slack(u);
            if value.is_nan() && !kind {
                f64::INFINITY
            } else {
                value
            }
        };
        let other = |point: Point| works(depth(point)) != kind;
        let bottom = descend(depth(before), depth(after), &mut deep, other);
        if other(bottom) {
            more.push(depth(bottom));
        }
    }
    points.extend(more);
    points.sort_by(|a, b| a.x.total_cmp(&b.x));
}

/// The end between a valid place and an invalid one: by the secant, and every third time by
/// bisection.
fn border(
    works: Point,
    broken: Point,
    slab: &Slab,
    is_good: &impl Fn(Point) -> bool,
    slack: &mut impl FnMut(f64) -> f64,
) -> Border {
    let (mut good, mut bad) = (works, broken);
    for step in 0..STEPS {
        let between = good.margin > 0.0 && bad.margin < 0.0;
        let share = match step % 3 {
            0 | 1 if between => good.margin / (good.margin - bad.margin),
            _ => 0.5,
        };
        let middle = good.x + share * (bad.x - good.x);
        if (good.x - bad.x).abs() <= WIDTH {
            break;
        }
        let point = Point::evaluate(middle, slack);
        let better = if good.margin > 0.0 {
            point.margin > 0.0
        } else {
            is_good(point)
        };
        // The secant stays on one side of a bend: the end that it keeps counts half.
        if better {
            good = point;
            bad.margin *= 0.5;
        } else {
            bad = point;
            good.margin *= 0.5;
        }
    }
    // The last point at which it can be assembled: later groups are checked up to this point.
    let x = slab.x(good.x);
    if bad.margin.is_nan() {
        Border::Broken(x)
    } else {
        Border::Root(x)
    }
}
