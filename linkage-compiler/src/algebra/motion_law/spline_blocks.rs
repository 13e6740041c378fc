//! Linear systems in blocks of two, each point's rows by the point itself and its neighbours,
//! without search for pivots.

use linkage_symbolic::Ex;

/// Slope and curvature at a point.
pub(crate) type Shape<'m> = [Ex<'m>; 2];

/// Two rows of a system, by the slope and the curvature of one point.
pub(crate) type Block<'m> = [[Ex<'m>; 2]; 2];

/// A point's rows: by the point before, its own, by the point behind, and the right-hand sides, a
/// column for each system.
pub(crate) struct SplineRow<'m> {
    pub(crate) before: Block<'m>,
    pub(crate) diagonal: Block<'m>,
    pub(crate) behind: Block<'m>,
    pub(crate) right: Vec<Shape<'m>>,
}

/// Solves a system whose first and last rows mention each other: the first point is moved to the
/// right-hand side, and its own rows determine it.
pub(crate) fn in_circle<'m>(first: SplineRow<'m>, mut rest: Vec<SplineRow<'m>>) -> Vec<Shape<'m>> {
    let zero = first.diagonal[0][0].number(0.0);
    let last = rest.len() - 1;
    for (k, row) in rest.iter_mut().enumerate() {
        let mut moved = [[zero; 2]; 2];
        if k == 0 {
            moved = plus(moved, row.before);
        }
        if k == last {
            moved = plus(moved, row.behind);
        }
        row.right
            .extend([0, 1].map(|k| [-moved[0][k], -moved[1][k]]));
    }
    let found = eliminated(rest);
    let (next, end) = (&found[0], &found[last]);
    // The parts of the neighbours in the first rows: besides the number, by its slope and by its
    // curvature.
    let known = |column: usize| {
        added(
            times(first.behind, next[column]),
            times(first.before, end[column]),
        )
    };
    let [by_slope, by_curvature] = [known(1), known(2)];
    let block = plus(
        first.diagonal,
        [
            [by_slope[0], by_curvature[0]],
            [by_slope[1], by_curvature[1]],
        ],
    );
    let moved = quotient(block, less(first.right[0], known(0)));
    let others = found.iter().map(|columns| {
        let by = added(scaled(columns[1], moved[0]), scaled(columns[2], moved[1]));
        added(columns[0], by)
    });
    std::iter::once(moved).chain(others).collect()
}

/// Solutions for all right-hand sides, by row.
pub(crate) fn eliminated<'m>(mut rows: Vec<SplineRow<'m>>) -> Vec<Vec<Shape<'m>>> {
    for k in 1..rows.len() {
        let (done, open) = rows.split_at_mut(k);
        let (above, row) = (&done[k - 1], &mut open[0]);
        let removed = |column: Shape<'m>| times(row.before, quotient(above.diagonal, column));
        let columns = [0, 1].map(|k| removed([above.behind[0][k], above.behind[1][k]]));
        let right: Vec<Shape> = above.right.iter().map(|column| removed(*column)).collect();
        for (column, removed) in row.right.iter_mut().zip(right) {
            *column = less(*column, removed);
        }
        for (r, entries) in row.diagonal.iter_mut().enumerate() {
            for (c, entry) in entries.iter_mut().enumerate() {
                *entry -= columns[c][r];
            }
        }
    }
    let mut found: Vec<Vec<Shape>> = Vec::new();
    for row in rows.iter().rev() {
        let behind = found.last();
        let solved = row.right.iter().enumerate().map(|(column, &right)| {
            let right = match behind {
                Some(behind) => less(right, times(row.behind, behind[column])),
                None => right,
            };
            quotient(row.diagonal, right)
        });
        found.push(solved.collect());
    }
    found.reverse();
    found
}

pub(crate) fn plus<'m>(a: Block<'m>, b: Block<'m>) -> Block<'m> {
    [added(a[0], b[0]), added(a[1], b[1])]
}

pub(crate) fn added<'m>(a: Shape<'m>, b: Shape<'m>) -> Shape<'m> {
    [a[0] + b[0], a[1] + b[1]]
}

fn less<'m>(a: Shape<'m>, b: Shape<'m>) -> Shape<'m> {
    [a[0] - b[0], a[1] - b[1]]
}

fn scaled<'m>(a: Shape<'m>, by: Ex<'m>) -> Shape<'m> {
    a.map(|x| x * by)
}

fn times<'m>(block: Block<'m>, by: Shape<'m>) -> Shape<'m> {
    block.map(|row| row[0] * by[0] + row[1] * by[1])
}

/// `block^-1 right`
fn quotient<'m>([[a, b], [c, d]]: Block<'m>, [x, y]: Shape<'m>) -> Shape<'m> {
    let determinant = a * d - b * c;
    [(d * x - b * y) / determinant, (a * y - c * x) / determinant]
}
