//! Quintic splines: pieces by values, slopes and curvatures at their ends. Where slopes are given,
//! curvatures follow from continuous third derivatives, a tridiagonal system whose diagonal
//! dominates; where they are not, slopes and curvatures follow from continuous third and fourth
//! derivatives, in blocks of two. That system says where the integral of the squared third
//! derivative is least, so it is symmetric and positive, and needs no search for pivots. Points
//! that are numbers give numbers; parameters among them stay parameters.
//!
//! Source: C. de Boor, A Practical Guide to Splines; the pieces are Hermite's.

use linkage_symbolic::Ex;

use crate::algebra::motion_law::piecewise::Choice;
use crate::algebra::motion_law::spline::{solved, solved_in_circle};
use crate::algebra::motion_law::spline_blocks::{
    Block, Shape, SplineRow, added, eliminated, in_circle, plus,
};
use crate::algebra::motion_law::zones::ORDERS;
use crate::algebra::motion_law::{profile, zones};
use crate::model::Ends;

/// The width of a piece, and the difference of the values at its ends.
struct Span<'m> {
    width: Ex<'m>,
    height: Ex<'m>,
}

/// The value of a spline through points at `along`, or a derivative.
pub(crate) fn value<'m>(
    along: Ex<'m>,
    points: &[(Ex<'m>, Ex<'m>)],
    slopes: Option<&[Ex<'m>]>,
    ends: Ends,
    order: usize,
) -> Ex<'m> {
    let spans: Vec<Span> = points
        .windows(2)
        .map(|ends| Span {
            width: ends[1].0 - ends[0].0,
            height: ends[1].1 - ends[0].1,
        })
        .collect();
    let shapes = match slopes {
        Some(slopes) => by_slopes(&spans, slopes, ends),
        None => by_points(&spans, ends),
    };
    let zero = along.number(0.0);
    // The middle of each piece, then the coefficients of the powers of the way from there, which is
    // short: little cancels.
    let pieces = points.windows(2).zip(&spans).zip(shapes.windows(2));
    let mut pieces: Vec<[Ex; 7]> = pieces
        .map(|((ends, span), shapes)| {
            let [a, b, c, d, e, f] = span.powers([ends[0].1, ends[1].1], [shapes[0], shapes[1]]);
            [ends[0].0 + 0.5 * span.width, a, b, c, d, e, f]
        })
        .collect();
    let places: Vec<Ex> = points.iter().map(|point| point.0).collect();
    let borders = match ends {
        Ends::Periodic => &places[1..places.len() - 1],
        Ends::Natural | Ends::Clamped => {
            // It goes on with its slope and curvature: both are 0 where it is clamped.
            let beyond = |at: usize| {
                let ((abscissa, value), [slope, curvature]) = (points[at], shapes[at]);
                [abscissa, value, slope, 0.5 * curvature, zero, zero, zero]
            };
            pieces.insert(0, beyond(0));
            pieces.push(beyond(points.len() - 1));
            &places[..]
        }
    };
    let are_numbers = |piece: &[Ex; 7]| piece.iter().all(|x| x.constant_value().is_some());
    let known = pieces.iter().all(are_numbers);
    let choice = Choice::new(along, borders);
    let [from, coefficients @ ..] = [0, 1, 2, 3, 4, 5, 6].map(|k| {
        let all: Vec<Ex> = pieces.iter().map(|piece| piece[k]).collect();
        choice.among_pieces(&all)
    });
    let way = along - from;
    // The last one comes first: each derivative is known when the expression is made whose slope it
    // is.
    let mut all = [along; ORDERS];
    for order in (0..ORDERS).rev() {
        let powers = coefficients.iter().enumerate().skip(order);
        let powers: Vec<Ex> = powers.map(|(k, &c)| zones::falling(k, order) * c).collect();
        let sum = profile::scheme(&powers, way);
        all[order] = match all.get(order + 1) {
            // Coefficients that are no numbers are differentiated, too.
            Some(&slope) if known => sum.with_slope(along, slope),
            _ => sum,
        };
    }
    all[order]
}

impl<'m> Span<'m> {
    /// Returns the coefficients of the powers of the distance from its middle, from the values,
    /// slopes and curvatures at its ends.
    fn powers(&self, values: [Ex<'m>; 2], shapes: [Shape<'m>; 2]) -> [Ex<'m>; 6] {
        let half = 0.5 * self.width;
        let [[p, c], [q, e]] = shapes;
        let square = half * half;
        // Halves of sums and differences of the values at the ends, as if the piece went from -1 to
        // 1: sums belong to even derivatives.
        let (middle, rise) = (0.5 * (values[0] + values[1]), 0.5 * self.height);
        let (slope, turn) = (0.5 * half * (p + q), 0.5 * half * (q - p));
        let (bend, twist) = (0.5 * square * (c + e), 0.5 * square * (e - c));
        let fourth = 0.125 * (bend - turn);
        let second = 0.25 * (3.0 * turn - bend);
        let missing = slope - rise;
        let fifth = 0.125 * (twist - 3.0 * missing);
        let third = 0.25 * (5.0 * missing - twist);
        let all = [
            middle - second - fourth,
            rise - third - fifth,
            second,
            third,
            fourth,
            fifth,
        ];
        let mut scale = half.number(1.0);
        all.map(|x| {
            let scaled = x / scale;
            scale = scale * half;
            scaled
        })
    }

    /// Returns the part of the begin in the equations of the end: `24 / h^2` and the like.
    fn by_begin(&self) -> Block<'m> {
        let [first, second, third] = self.inverses();
        [
            [168.0 * third, 24.0 * second],
            [-24.0 * second, -3.0 * first],
        ]
    }

    /// The same of the end in the equations of the begin.
    fn by_end(&self) -> Block<'m> {
        let [[a, b], [c, d]] = self.by_begin();
        [[a, c], [b, d]]
    }

    /// `1 / h`, `1 / h^2`, `1 / h^3`
    fn inverses(&self) -> [Ex<'m>; 3] {
        let first = 1.0 / self.width;
        let second = first * first;
        [first, second, second * first]
    }

    /// Returns its part of the block of a point at its begin (1) or end (-1).
    fn diagonal_part(&self, side: f64) -> Block<'m> {
        let [first, second, third] = self.inverses();
        let mixed = side * 36.0 * second;
        [[192.0 * third, mixed], [mixed, 9.0 * first]]
    }

    /// Returns its part of the right-hand side there.
    fn right(&self, side: f64) -> Shape<'m> {
        let [_, _, third] = self.inverses();
        let cubed = self.height * third;
        [360.0 * cubed / self.width, side * 60.0 * cubed]
    }
}

/// Curvatures that make the third derivative continuous; none at ends that go on straight.
fn by_slopes<'m>(spans: &[Span<'m>], slopes: &[Ex<'m>], ends: Ends) -> Vec<Shape<'m>> {
    let zero = slopes[0].number(0.0);
    let row = |left: usize, right: usize, at: usize| {
        let (before, behind) = (&spans[left], &spans[right]);
        let [[_, _], [from_before, curvature_before]] = before.by_begin();
        let [[_, _], [from_behind, curvature_behind]] = behind.by_end();
        let [[_, _], [slope_before, own_before]] = before.diagonal_part(-1.0);
        let [[_, _], [slope_behind, own_behind]] = behind.diagonal_part(1.0);
        let known = from_before * slopes[left]
            + (slope_before + slope_behind) * slopes[at]
            + from_behind * slopes[right + 1];
        let right = before.right(-1.0)[1] + behind.right(1.0)[1];
        [
            curvature_before,
            own_before + own_behind,
            curvature_behind,
            right - known,
        ]
    };
    let last = spans.len() - 1;
    let within: Vec<[Ex; 4]> = (1..=last).map(|k| row(k - 1, k, k)).collect();
    let curvatures = match ends {
        Ends::Periodic => {
            let mut rows = vec![row(last, 0, 0)];
            rows.extend(within);
            let mut all = solved_in_circle(&rows);
            all.push(all[0]);
            all
        }
        Ends::Natural | Ends::Clamped => {
            let mut all = vec![zero];
            all.extend(solved(&within));
            all.push(zero);
            all
        }
    };
    let shapes = slopes.iter().zip(curvatures);
    shapes
        .map(|(&slope, curvature)| [slope, curvature])
        .collect()
}

/// Slopes and curvatures that make the third and the fourth derivative continuous. Natural ends
/// have none of them.
fn by_points<'m>(spans: &[Span<'m>], ends: Ends) -> Vec<Shape<'m>> {
    let zero = spans[0].width.number(0.0);
    let row = |left: Option<usize>, right: Option<usize>| {
        let sides = [(left, -1.0), (right, 1.0)];
        let sides = sides.map(|(span, side)| span.map(|span| (&spans[span], side)));
        let mut row = SplineRow {
            before: [[zero; 2]; 2],
            diagonal: [[zero; 2]; 2],
            behind: [[zero; 2]; 2],
            right: vec![[zero; 2]],
        };
        for (span, side) in sides.into_iter().flatten() {
            row.diagonal = plus(row.diagonal, span.diagonal_part(side));
            row.right[0] = added(row.right[0], span.right(side));
            if side < 0.0 {
                row.before = span.by_begin()
            } else {
                row.behind = span.by_end()
            }
        }
        row
    };
    let last = spans.len() - 1;
    let mut within: Vec<SplineRow> = (1..=last).map(|k| row(Some(k - 1), Some(k))).collect();
    let only = |rows: Vec<SplineRow<'m>>| -> Vec<Shape<'m>> {
        eliminated(rows).iter().map(|columns| columns[0]).collect()
    };
    match ends {
        Ends::Natural => {
            let mut rows = vec![row(None, Some(0))];
            rows.append(&mut within);
            rows.push(row(Some(last), None));
            only(rows)
        }
        Ends::Clamped => {
            let mut all = vec![[zero; 2]];
            all.extend(only(within));
            all.push([zero; 2]);
            all
        }
        Ends::Periodic => {
            let mut all = in_circle(row(Some(last), Some(0)), within);
            all.push(all[0]);
            all
        }
    }
}
