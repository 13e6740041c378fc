//! The motion of all joints over the range of the input, and the joint that drives.

use linkage_compiler::{length_as_written, shortened};

use super::coordinates::{Coordinate, built, coordinates, distance, values_at};
use super::jointed_links::Pose;
use super::skeleton::Skeleton;
use super::space_vectors::{difference, length};
use crate::failure::{Failure, listed};

/// Cells of the grid on which polynomials are fitted and bounded.
pub(super) const CELLS: usize = 2048;

/// A joint whose bodies move otherwise than it allows differs by more than this part of the size.
const CLOSE: f64 = 1e-9;

/// A coordinate that moves by less than this (radians, or parts of the size) stands still.
const STILL: f64 = 1e-11;

/// A coordinate that differs from a multiple of the input by less than this part of its range is
/// that multiple.
const LINEAR: f64 = 1e-9;

/// The values of all coordinates over a range of the input.
pub(super) struct Motion {
    pub(super) coordinates: Vec<Coordinate>,
    /// Values of the input, increasing, with the reference among them.
    pub(super) inputs: Vec<f64>,
    /// For each coordinate, its values at those of the input.
    pub(super) values: Vec<Vec<f64>>,
    /// The index of the coordinate that drives.
    pub(super) driver: usize,
    /// The value of the input for a value of the driving coordinate of 1, if the latter is a
    /// multiple of the input.
    pub(super) rate: Option<f64>,
}

/// The name and the unit of the running input.
#[derive(Clone, Copy)]
pub(super) struct RunningName<'a> {
    pub(super) name: &'a str,
    pub(super) unit: &'a str,
}

impl RunningName<'_> {
    /// A value of the input as it is written.
    pub(super) fn written(&self, value: f64) -> String {
        let (value, unit) = match self.unit {
            "rad" => (value.to_degrees(), "deg"),
            unit => length_as_written(value, unit),
        };
        format!("{}{unit}", rounded(value))
    }
}

/// A number with the digits that a message needs.
pub(super) fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

impl Motion {
    /// Returns the motion over a range that contains the reference.
    pub(super) fn over(
        skeleton: &Skeleton,
        [low, high]: [f64; 2],
        input: RunningName,
        driver: Option<&str>,
    ) -> Result<Self, Failure> {
        let coordinates = coordinates(&skeleton.links);
        let reference = skeleton.reference();
        let inputs = grid(low, high, reference);
        let middle = inputs.iter().position(|x| *x == reference);
        let middle = middle.unwrap_or_default();
        let mut rows: Vec<Vec<f64>> = vec![Vec::new(); inputs.len()];
        // Angles without turns go on from the reference in both directions.
        let upwards = middle..inputs.len();
        let downwards = (0..middle).rev();
        for (index, before) in upwards
            .clone()
            .zip(std::iter::once(None).chain(upwards.map(Some)))
            .chain(downwards.map(|index| (index, Some(index + 1))))
        {
            let poses = skeleton.poses(inputs[index]);
            let before = before.map(|before| &rows[before][..]);
            let row = values_at(skeleton, &poses, before);
            check(skeleton, &poses, &row, inputs[index], input)?;
            rows[index] = row;
        }
        let column = |number: usize| rows.iter().map(|row| row[number]).collect();
        let values: Vec<Vec<f64>> = (0..coordinates.len()).map(column).collect();
        let (driver, rate) = driving(skeleton, &coordinates, &inputs, &values, driver, input)?;
        Ok(Self {
            coordinates,
            inputs,
            values,
            driver,
            rate,
        })
    }

    /// The coordinates that follow, without those that stand still.
    pub(super) fn passive(&self) -> impl Iterator<Item = usize> {
        (0..self.coordinates.len()).filter(|index| *index != self.driver)
    }
}

/// Returns true if values do not change.
pub(super) fn stands_still(values: &[f64], scale: f64) -> bool {
    values.iter().all(|value| value.abs() < STILL * scale)
}

/// Evenly spaced values on both sides of the reference.
fn grid(low: f64, high: f64, reference: f64) -> Vec<f64> {
    let share = (reference - low) / (high - low);
    let below = ((CELLS as f64 * share).round() as usize).clamp(1, CELLS - 1);
    let side = |from: f64, to: f64, count: usize| {
        (0..count).map(move |k| from + (to - from) * k as f64 / count as f64)
    };
    let mut inputs: Vec<f64> = Vec::with_capacity(CELLS + 1);
    if reference > low {
        inputs.extend(side(low, reference, below));
    }
    if high > reference {
        inputs.extend(side(reference, high, CELLS - below));
        inputs.push(high);
    } else {
        inputs.push(reference);
    }
    inputs
}

/// Refuses positions that do not exist, and bodies that do not move as their joints allow.
fn check(
    skeleton: &Skeleton,
    poses: &[Pose],
    row: &[f64],
    x: f64,
    input: RunningName,
) -> Result<(), Failure> {
    let size = skeleton.size();
    let at = format!("{} = {}", input.name, input.written(x));
    let from_joints = built(skeleton, row);
    for (index, link) in skeleton.links.iter().enumerate() {
        let miss = distance(&poses[index], &from_joints[index], size);
        if miss.is_nan() {
            return Err(Failure::Told(format!(
                "`{}` has no position at `{at}`\nhelp: choose a range by `--range LOW..HIGH` in which the mechanism can be assembled",
                shortened(&link.name)
            )));
        }
        if miss > CLOSE * size {
            return Err(Failure::Told(format!(
                "`{}` does not move as its joint allows: at `{at}` the joint misses by {miss:.3e} m",
                shortened(&link.name)
            )));
        }
    }
    for closure in &skeleton.closures {
        if closure.along.is_some() {
            continue;
        }
        let [a, b] = closure
            .bodies
            .map(|body| skeleton.carried(poses, body, closure.at));
        let gap = length(difference(a, b));
        if gap > CLOSE * size {
            return Err(Failure::Told(format!(
                "the joint `{}` does not hold: at `{at}` its points are {gap:.3e} m apart",
                shortened(&closure.name)
            )));
        }
    }
    Ok(())
}

/// The coordinate that drives: the named one, else the first that is a multiple of the input, else
/// the first that always moves in one direction.
fn driving(
    skeleton: &Skeleton,
    coordinates: &[Coordinate],
    inputs: &[f64],
    values: &[Vec<f64>],
    name: Option<&str>,
    input: RunningName,
) -> Result<(usize, Option<f64>), Failure> {
    let rate_of = |index: usize| rate(inputs, &values[index], skeleton.reference());
    if let Some(name) = name {
        let found = coordinates.iter().position(|c| c.name == name);
        let Some(index) = found else {
            return Err(Failure::Told(format!(
                "there is no joint `{}`; there is {}",
                shortened(name),
                listed(coordinates.iter().map(|c| c.name.as_str()))
            )));
        };
        return match is_monotonic(&values[index]) {
            true => Ok((index, rate_of(index))),
            false => Err(Failure::Told(format!(
                "`{}` turns back over this range, so the other joints are no functions of it\nhelp: choose another joint by `--drive`, or a shorter range by `--range`",
                shortened(name)
            ))),
        };
    }
    let all = 0..coordinates.len();
    let linear = all.clone().find(|index| rate_of(*index).is_some());
    let found = linear.or_else(|| all.clone().find(|index| is_monotonic(&values[*index])));
    match found {
        Some(index) => Ok((index, rate_of(index))),
        None => Err(Failure::Told(format!(
            "every joint turns back while `{}` goes through its range, so none can drive the others\nhelp: choose a shorter range by `--range LOW..HIGH`",
            shortened(input.name)
        ))),
    }
}

/// The change of the input for a change of 1 of a coordinate that is a multiple of it.
fn rate(inputs: &[f64], values: &[f64], reference: f64) -> Option<f64> {
    let last = inputs.len() - 1;
    let span = inputs[last] - inputs[0];
    let slope = (values[last] - values[0]) / span;
    let scale = slope.abs() * span;
    let fits = |(x, value): (&f64, &f64)| (value - slope * (x - reference)).abs() <= LINEAR * scale;
    let is_linear = inputs.iter().zip(values).all(fits);
    (scale > 0.0 && is_linear).then(|| 1.0 / slope)
}

fn is_monotonic(values: &[f64]) -> bool {
    let steps = values.windows(2).map(|pair| pair[1] - pair[0]);
    let mean = (values[values.len() - 1] - values[0]) / (values.len() - 1) as f64;
    // A step far below the others is next to a place where it turns back.
    steps
        .into_iter()
        .all(|step| step * mean > 1e-3 * mean * mean)
}
