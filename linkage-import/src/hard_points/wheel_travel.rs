//! The wheel carrier: what holds it, and how far it goes.

use crate::placement::{Placement, Vector, cross, difference, dot, length, unit};

/// Travels to each side that are tried.
const TRIES: usize = 100;

/// A pivot below this part of that of the drawn position is a dead point.
const FLAT: f64 = 0.05;

/// A condition that holds the carrier, with points where they are drawn.
#[derive(Clone, Debug)]
pub(super) enum Hold {
    /// A rod from a fixed point to one of the carrier.
    Rod { fixed: Vector, moving: Vector },
    /// A fixed point that is on a line of the carrier: through a point, with two normals.
    Line {
        fixed: Vector,
        moving: Vector,
        normals: [Vector; 2],
    },
}

/// The largest travels down and up, at most `most`, in which the carrier is held, can move on, and
/// another condition holds.
pub(super) fn reach(
    holds: &[Hold],
    centre: Vector,
    most: f64,
    size: f64,
    is_reached: impl Fn(&Placement) -> bool,
) -> [f64; 2] {
    let drawn = Placement::shifted([0.0; 3]);
    let margin = solve(holds, centre, &drawn, 0.0, size).map_or(0.0, |(_, _, pivot)| pivot);
    [-most, most].map(|end| {
        let mut placement = drawn;
        for number in 1..=TRIES {
            let travel = end * number as f64 / TRIES as f64;
            match settled(holds, centre, &placement, travel, size) {
                Some((next, pivot)) if pivot > FLAT * margin && is_reached(&next) => {
                    placement = next
                }
                _ => return end * (number - 1) as f64 / TRIES as f64,
            }
        }
        end
    })
}

/// The placement at a travel, by Newton's method, and the smallest pivot.
fn settled(
    holds: &[Hold],
    centre: Vector,
    start: &Placement,
    travel: f64,
    size: f64,
) -> Option<(Placement, f64)> {
    let mut placement = *start;
    for _ in 0..30 {
        let (step, error, pivot) = solve(holds, centre, &placement, travel, size)?;
        if error < 1e-12 {
            return Some((placement, pivot));
        }
        let [a, b, c, x, y, z] = step;
        let angle = length([a, b, c]);
        // Without a limit for small angles, which would end the convergence.
        let turned = match angle > 0.0 {
            true => Placement::turned([a, b, c].map(|part| part / angle), angle),
            false => Placement::shifted([0.0; 3]),
        };
        let now = placement.point(centre);
        let moved = [now[0] + size * x, now[1] + size * y, now[2] + size * z];
        // About the wheel centre.
        let about = turned.then(&Placement {
            origin: [0.0; 3],
            ..placement
        });
        placement = Placement {
            origin: difference(moved, about.direction(centre)),
            ..about
        };
    }
    None
}

/// The step of rotation and shift (as part of the size) that closes all conditions, the largest
/// error, and the smallest pivot.
fn solve(
    holds: &[Hold],
    centre: Vector,
    placement: &Placement,
    travel: f64,
    size: f64,
) -> Option<([f64; 6], f64, f64)> {
    let now = placement.point(centre);
    let mut rows: Vec<[f64; 7]> = Vec::new();
    let mut add = |at: Vector, along: Vector, error: f64| {
        let turn = cross(difference(at, now), along);
        let [a, b, c] = turn.map(|component| component / size);
        rows.push([a, b, c, along[0], along[1], along[2], -error / size]);
    };
    for hold in holds {
        match hold {
            Hold::Rod { fixed, moving } => {
                let at = placement.point(*moving);
                let apart = difference(at, *fixed);
                let along = unit(apart)?;
                let drawn = length(difference(*moving, *fixed));
                add(at, along, length(apart) - drawn);
            }
            Hold::Line {
                fixed,
                moving,
                normals,
            } => {
                let at = placement.point(*moving);
                for normal in normals {
                    let normal = placement.direction(*normal);
                    // The point of the carrier that is where the fixed point is.
                    add(*fixed, normal, dot(difference(at, *fixed), normal));
                }
            }
        }
    }
    add(now, [0.0, 0.0, 1.0], now[2] - centre[2] - travel);
    let error = rows
        .iter()
        .fold(0.0, |most: f64, row| most.max(row[6].abs()));
    if rows.len() != 6 {
        return None;
    }
    let mut least = f64::INFINITY;
    for column in 0..6 {
        let pivot = (column..6).max_by(|i, j| {
            let [a, b] = [*i, *j].map(|row: usize| rows[row][column].abs());
            a.total_cmp(&b)
        })?;
        rows.swap(column, pivot);
        let pivot = rows[column];
        least = least.min(pivot[column].abs());
        if pivot[column].abs() <= 1e-9 || pivot[column].is_nan() {
            return None;
        }
        for row in &mut rows[column + 1..] {
            let factor = row[column] / pivot[column];
            for (number, pivot) in row.iter_mut().zip(pivot) {
                *number -= factor * pivot;
            }
        }
    }
    let mut step = [0.0; 6];
    for index in (0..6).rev() {
        let known: f64 = (index + 1..6)
            .map(|other| rows[index][other] * step[other])
            .sum();
        step[index] = (rows[index][6] - known) / rows[index][index];
    }
    Some((step, error, least))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A carrier on five rods.
    #[test]
    fn five_rods_go_until_one_is_stretched() {
        let rods = [
            ([110.0, 420.0, 430.0], [15.0, 690.0, 455.0]),
            ([-85.0, 435.0, 440.0], [-30.0, 685.0, 460.0]),
            ([265.0, 480.0, 265.0], [40.0, 700.0, 215.0]),
            ([-60.0, 255.0, 215.0], [-25.0, 705.0, 200.0]),
            ([-190.0, 316.0, 258.0], [-150.0, 690.0, 262.0]),
        ];
        let holds = rods.map(|(fixed, moving)| Hold::Rod { fixed, moving });
        let centre = [0.0, 760.0, 320.0];
        let found = reach(&holds, centre, 80.0, 600.0, |_| true);
        assert_eq!(found, [-80.0, 80.0]);
        let [low, high] = reach(&holds, centre, 500.0, 600.0, |_| true);
        assert!(low > -500.0 && high < 500.0 && low < -80.0 && high > 80.0);
    }
}
