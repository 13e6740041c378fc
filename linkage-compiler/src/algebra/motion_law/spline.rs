//! Cubic splines: the second derivatives at the points solve a tridiagonal system, without search
//! for pivots, since its diagonal dominates. Points that are numbers give numbers; parameters among
//! them stay parameters, with exact derivatives.

use linkage_symbolic::Ex;

use crate::algebra::motion_law::piecewise::Choice;
use crate::model::Ends;

/// The value of a spline through points at `along`.
pub(crate) fn value<'m>(
    along: Ex<'m>,
    points: &[(Ex<'m>, Ex<'m>)],
    ends: Ends,
    order: usize,
) -> Ex<'m> {
    let curvatures = curvatures(points, ends);
    let zero = along.number(0.0);
    // The position of each point, and the coefficients of the powers of the distance from there.
    let mut pieces: Vec<[Ex; 5]> = Vec::new();
    for (ends, curvature) in points.windows(2).zip(curvatures.windows(2)) {
        let [(from, before), (to, after)] = [ends[0], ends[1]];
        let width = to - from;
        let mean = (2.0 * curvature[0] + curvature[1]) / 6.0;
        let slope = (after - before) / width - width * mean;
        let bend = (curvature[1] - curvature[0]) / (6.0 * width);
        pieces.push([from, before, slope, 0.5 * curvature[0], bend]);
    }
    let places: Vec<Ex> = points.iter().map(|point| point.0).collect();
    let borders = match ends {
        Ends::Periodic => &places[1..places.len() - 1],
        Ends::Natural | Ends::Clamped => {
            // It goes on as it ends: straight, or level.
            let (first, last) = (pieces[0], pieces[pieces.len() - 1]);
            let (end, at) = points[points.len() - 1];
            let width = end - last[0];
            let slope = match ends {
                Ends::Clamped => [zero; 2],
                Ends::Natural | Ends::Periodic => [
                    first[2],
                    last[2] + width * (2.0 * last[3] + 3.0 * width * last[4]),
                ],
            };
            pieces.insert(0, [first[0], first[1], slope[0], zero, zero]);
            pieces.push([end, at, slope[1], zero, zero]);
            &places[..]
        }
    };
    let choice = Choice::new(along, borders);
    let [from, value, slope, half, bend] = [0, 1, 2, 3, 4].map(|k| {
        let all: Vec<Ex> = pieces.iter().map(|piece| piece[k]).collect();
        choice.among_pieces(&all)
    });
    let way = along - from;
    match order {
        0 => value + way * (slope + way * (half + way * bend)),
        1 => slope + way * (2.0 * half + way * (3.0 * bend)),
        2 => 2.0 * half + way * (6.0 * bend),
        _ => 6.0 * bend,
    }
}

/// The second derivatives on the inner sides of the ends of a spline that is clamped there.
pub(crate) fn clamped_curvatures<'m>(points: &[(Ex<'m>, Ex<'m>)]) -> [Ex<'m>; 2] {
    let all = curvatures(points, Ends::Clamped);
    [all[0], all[all.len() - 1]]
}

/// The second derivatives at the points.
fn curvatures<'m>(points: &[(Ex<'m>, Ex<'m>)], ends: Ends) -> Vec<Ex<'m>> {
    let widths: Vec<Ex> = points
        .windows(2)
        .map(|points| points[1].0 - points[0].0)
        .collect();
    let ways = points.windows(2).zip(&widths);
    let slopes: Vec<Ex> = ways
        .map(|(points, &width)| (points[1].1 - points[0].1) / width)
        .collect();
    let zero = points[0].0.number(0.0);
    // Each row: the coefficients of the curvature before, here and behind, and the right-hand side.
    let inner = |left: usize, right: usize| {
        let (before, behind) = (widths[left], widths[right]);
        [
            before,
            2.0 * (before + behind),
            behind,
            6.0 * (slopes[right] - slopes[left]),
        ]
    };
    let last = widths.len() - 1;
    let within = (1..=last).map(|k| inner(k - 1, k));
    match ends {
        Ends::Natural => {
            let mut all = vec![zero];
            all.extend(solved(&within.collect::<Vec<_>>()));
            all.push(zero);
            all
        }
        Ends::Clamped => {
            let mut rows = vec![[zero, 2.0 * widths[0], widths[0], 6.0 * slopes[0]]];
            rows.extend(within);
            rows.push([widths[last], 2.0 * widths[last], zero, -6.0 * slopes[last]]);
            solved(&rows)
        }
        Ends::Periodic => {
            let mut rows = vec![inner(last, 0)];
            rows.extend(within);
            let mut all = solved_in_circle(&rows);
            all.push(all[0]);
            all
        }
    }
}

/// A tridiagonal system.
pub(crate) fn solved<'m>(rows: &[[Ex<'m>; 4]]) -> Vec<Ex<'m>> {
    let columns: Vec<Vec<Ex>> = rows.iter().map(|row| vec![row[3]]).collect();
    eliminated(rows, columns)
        .into_iter()
        .map(|columns| columns[0])
        .collect()
}

/// Solves a system whose first and last rows mention each other: the first unknown is moved to the
/// right-hand side, and its own row determines it.
pub(crate) fn solved_in_circle<'m>(rows: &[[Ex<'m>; 4]]) -> Vec<Ex<'m>> {
    let (first, rest) = (rows[0], &rows[1..]);
    let zero = first[0].number(0.0);
    let right = rest.iter().enumerate().map(|(k, row)| {
        // The unknown before the first of these rows and behind the last one is the one that was
        // moved.
        let before = if k == 0 { row[0] } else { zero };
        let behind = if k == rest.len() - 1 { row[2] } else { zero };
        vec![row[3], -(before + behind)]
    });
    let found = eliminated(rest, right.collect());
    let (next, last) = (&found[0], &found[found.len() - 1]);
    let known = |k: usize| first[2] * next[k] + first[0] * last[k];
    let moved = (first[3] - known(0)) / (first[1] + known(1));
    let others = found.iter().map(|columns| columns[0] + columns[1] * moved);
    std::iter::once(moved).chain(others).collect()
}

/// Solutions for several right-hand sides, by row.
fn eliminated<'m>(rows: &[[Ex<'m>; 4]], mut right: Vec<Vec<Ex<'m>>>) -> Vec<Vec<Ex<'m>>> {
    let mut diagonal: Vec<Ex> = rows.iter().map(|row| row[1]).collect();
    for k in 1..rows.len() {
        let factor = rows[k][0] / diagonal[k - 1];
        diagonal[k] -= factor * rows[k - 1][2];
        for column in 0..right[k].len() {
            let before = right[k - 1][column];
            right[k][column] -= factor * before;
        }
    }
    for k in (0..rows.len()).rev() {
        for column in 0..right[k].len() {
            let behind = right.get(k + 1).map(|next| rows[k][2] * next[column]);
            let numerator = behind.map_or(right[k][column], |next| right[k][column] - next);
            right[k][column] = numerator / diagonal[k];
        }
    }
    right
}
