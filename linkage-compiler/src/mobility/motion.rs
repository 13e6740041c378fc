//! Null vectors as motions: shifts, turns and screws of bodies, changes of other unknowns.

use std::f64::consts::TAU;

use crate::model::{Dimension, Type};
use crate::vector::{Vector, cross, dot, norm};

use crate::message_format::numbers;
use crate::mobility::null_space::{LITTLE, largest, null_vectors};
use crate::mobility::position::{LoopRows, Movable, Position};

/// The greatest number of motions in a message.
const MOST_MOTIONS: usize = 3;

/// Shown shares are rounded to this.
const THOUSANDTH: f64 = 1e-3;

/// Shown coordinates are rounded to this part of the longest length: differences know no more.
const SHOWN: f64 = 1e-4;

/// `body` can turn about ..., `a` and `b` can change in the ratio ...
pub(crate) fn motion(position: &Position<'_, '_>, rows: &LoopRows, last: f64) -> Option<String> {
    let all = simple(
        null_vectors(&rows.matrix, rows.columns.len(), last),
        rows,
        position,
    );
    let count = all.len();
    let told = all
        .iter()
        .take(MOST_MOTIONS)
        .map(|one| motion_text(position, one, rows));
    let told: Vec<String> = told.collect();
    match count {
        0 => None,
        _ if count > MOST_MOTIONS => Some(format!(
            "{}, and {} more",
            told.join("; "),
            count - MOST_MOTIONS
        )),
        _ => Some(told.join("; ")),
    }
}

fn motion_text(position: &Position<'_, '_>, vector: &[f64], rows: &LoopRows) -> String {
    let most = largest(vector);
    let mut parts: Vec<String> = Vec::new();
    let mut unknowns: Vec<(usize, Vec<f64>)> = Vec::new();
    for (index, mover) in position.movers.iter().enumerate() {
        let share = own_part(vector, rows, index);
        if largest(&share) <= LITTLE * most {
            continue;
        }
        match mover {
            Movable::Body { name, origin, .. } => {
                let origin = [0, 1, 2].map(|k| position.values[*origin][k]);
                parts.push(format!("`{name}` can {}", twist(position, &share, origin)));
            }
            Movable::Component { unknown, component } => {
                let count = position.values[*unknown].len();
                if unknowns.last().is_none_or(|(last, _)| last != unknown) {
                    unknowns.push((*unknown, vec![0.0; count]));
                }
                if let Some((_, change)) = unknowns.last_mut() {
                    change[*component] = share[0] / most;
                }
            }
        }
    }
    if !unknowns.is_empty() {
        let changes = unknowns
            .iter()
            .enumerate()
            .map(|(index, (unknown, change))| {
                let item = &position.mechanism.unknowns[*unknown];
                let change: Vec<f64> = change
                    .iter()
                    .map(|x| shown(position, *unknown, *x))
                    .collect();
                let can = if index == 0 { " can change" } else { "" };
                let change = position.words.coordinate(&item.ty, &change);
                format!("`{}`{can} by {change}", item.name)
            });
        let together = if unknowns.len() > 1 { " together" } else { "" };
        parts.push(format!("{}{together}", list(changes.collect())));
    }
    parts.join(" while ")
}

/// A share of an unknown as the change of an angle by a degree, or as far as the longest length
/// turns by it.
fn shown(position: &Position<'_, '_>, unknown: usize, share: f64) -> f64 {
    let degree = 1_f64.to_radians();
    let dimension = position.mechanism.unknowns[unknown].ty.dimension();
    match dimension.is_some_and(|dimension| dimension.half_lengths != 0) {
        true => rounded(share * degree * position.length, degree * position.length),
        // Whole thousandths of a degree.
        false => (share / THOUSANDTH).round() * THOUSANDTH * degree,
    }
}

/// A body's shift and turn, both as long as the longest length turns.
fn twist(position: &Position<'_, '_>, change: &[f64], origin: Vector) -> String {
    let shift: Vector = [0, 1, 2].map(|k| position.length * change[k]);
    let turn: Vector = [0, 1, 2].map(|k| change[3 + k]);
    if norm(turn) * position.length <= LITTLE * norm(shift) {
        return format!("shift along {}", direction(shift));
    }
    let square = dot(turn, turn);
    let foot = cross(turn, shift).map(|x| x / square);
    let point = [0, 1, 2].map(|k| rounded(origin[k] + foot[k], position.length));
    let lengths = Type::Vector(3, Dimension::LENGTH);
    let line = format!(
        "the line through {} along {}",
        position.words.vector(&lengths, &point),
        direction(turn)
    );
    let pitch = TAU * dot(shift, turn) / square;
    if pitch.abs() <= LITTLE * position.length {
        return format!("turn about {line}");
    }
    let pitch = rounded(pitch, position.length);
    format!(
        "turn about {line} and shift along it, by {} in a turn",
        position.words.scalar(Dimension::LENGTH, pitch)
    )
}

/// Without the digits that are rounding of something of this size.
fn rounded(x: f64, size: f64) -> f64 {
    let step = 10_f64.powf((SHOWN * size).log10().floor());
    (x / step).round() * step + 0.0
}

/// `a, b and c`
pub(crate) fn list(words: Vec<String>) -> String {
    match &words[..] {
        [before @ .., last] if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        _ => words.concat(),
    }
}

/// A direction of length 1, the first number that is not zero positive.
fn direction(v: Vector) -> String {
    let size = norm(v);
    let unit = v.map(|x| (x / size / SHOWN).round() * SHOWN);
    let first = unit.into_iter().find(|x| *x != 0.0).unwrap_or(1.0);
    let shown = numbers(&unit.map(|x| x * first.signum() + 0.0));
    format!("({})", shown.join(", "))
}

/// The shares of one that moves.
fn own_part(vector: &[f64], rows: &LoopRows, mover: usize) -> Vec<f64> {
    let pairs = vector.iter().zip(&rows.columns);
    let shares = pairs.filter(|(_, column)| column.0 == mover);
    shares.map(|(x, _)| *x).collect()
}

/// Motions that are easy to tell: shifts by themselves, and turns without shifts that are possible
/// without them.
fn simple(mut all: Vec<Vec<f64>>, rows: &LoopRows, position: &Position) -> Vec<Vec<f64>> {
    let is_turn = |(mover, way): (usize, usize)| {
        matches!(position.movers[mover], Movable::Body { .. }) && way >= 3
    };
    let turns: Vec<usize> = (0..rows.columns.len())
        .filter(|&k| is_turn(rows.columns[k]))
        .collect();
    // Turns are eliminated from one motion after the other, the largest first: the rest only
    // shifts.
    let mut turning = Vec::new();
    while let Some((index, column)) = largest_of(&all, &turns) {
        let turn = all.swap_remove(index);
        for other in all.iter_mut().chain(&mut turning) {
            let factor = other[column] / turn[column];
            take(other, factor, &turn);
        }
        turning.push(turn);
    }
    let mut shifts: Vec<Vec<f64>> = Vec::new();
    for mut motion in all {
        shifts
            .iter()
            .for_each(|before| project(&mut motion, before));
        shifts.push(motion);
    }
    for motion in &mut turning {
        shifts.iter().for_each(|shift| project(motion, shift));
    }
    let mut all = turning;
    all.extend(shifts);
    all.sort_by_key(|motion| {
        motion
            .iter()
            .filter(|x| x.abs() > LITTLE * largest(motion))
            .count()
    });
    all
}

/// The motion and the place of the largest turn; nothing if none turns.
fn largest_of(all: &[Vec<f64>], turns: &[usize]) -> Option<(usize, usize)> {
    let places = (0..all.len()).flat_map(|index| turns.iter().map(move |&column| (index, column)));
    let share = |&(index, column): &(usize, usize)| all[index][column].abs() / largest(&all[index]);
    let best = places.max_by(|a, b| share(a).total_cmp(&share(b)))?;
    (share(&best) > LITTLE).then_some(best)
}

fn take(from: &mut [f64], factor: f64, direction: &[f64]) {
    from.iter_mut()
        .zip(direction)
        .for_each(|(x, y)| *x -= factor * y);
}

fn project(from: &mut [f64], onto: &[f64]) {
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let factor = product(from, onto) / product(onto, onto);
    take(from, factor, onto);
}
