//! Linear systems of cores in the freedoms of their bodies.
//!
//! Two perpendicular directions `u` and `w` of length 1 are six unknowns with three equations of their own, `u.du = p`, `w.dw = q`,
//! `w.du + u.dw = r`. All their solutions are `du = t x u + p u + r w/2`, `dw = t x w + q w + r u/2` with a turn `t`. So a system is solved in the
//! turns instead: three unknowns and three equations less for each body, and fewer pivots that can vanish where nothing is singular.

#[cfg(test)]
mod tests;

use crate::algebra::pivots;
use linkage_symbolic::{Ex, V3, Vector, numerically_equal};

use super::pivots::parity;
use super::{Algebra, InOrder, Order};

/// Two directions of a core that their own equations keep perpendicular and of length 1.
#[derive(Clone, Debug)]
pub(crate) struct Body<'m> {
    /// The places of their components among the unknowns.
    pub(crate) columns: [[usize; 3]; 2],
    /// Their equations: both lengths and the right angle.
    rows: [usize; 3],
    /// The directions themselves.
    pub(crate) axes: [V3<'m>; 2],
}

/// The bodies of a core, and what is not theirs.
#[derive(Clone, Debug)]
pub(crate) struct Bodies<'m> {
    pub(crate) all: Vec<Body<'m>>,
    /// The other equations and unknowns.
    pub(crate) rows: Vec<usize>,
    pub(crate) columns: Vec<usize>,
    sign: f64,
}

/// How a system that is too large for cofactors is solved.
#[derive(Clone, Debug)]
pub(crate) struct Scheme<'m> {
    pub(crate) bodies: Bodies<'m>,
    /// The matrix by the freedoms, without the equations of the bodies.
    pub(crate) freedoms: Vec<Vec<Ex<'m>>>,
    /// Of the freedoms: the other unknowns, then three turns for each body.
    pub(crate) order: Order,
}

impl<'m> Bodies<'m> {
    /// The bodies that a matrix of derivatives by these unknowns shows; no angle is part of one.
    pub(crate) fn of(matrix: &[Vec<Ex<'m>>], unknowns: &[Option<Ex<'m>>]) -> Self {
        let filled = |row: &[Ex<'m>]| -> Vec<usize> {
            let columns = 0..row.len();
            columns.filter(|&k| !row[k].is_zero()).collect()
        };
        let is = |entry: Ex<'m>, column: usize| {
            unknowns[column].is_some_and(|x| numerically_equal(entry, x))
        };
        // The derivative of half the square of a direction is the direction.
        let lengths = matrix.iter().enumerate().filter_map(|(row, entries)| {
            let columns: [usize; 3] = filled(entries).try_into().ok()?;
            let own = columns.iter().all(|&k| is(entries[k], k));
            own.then_some((row, columns))
        });
        let lengths: Vec<(usize, [usize; 3])> = lengths.collect();
        let mut all: Vec<Body> = Vec::new();
        for (row, entries) in matrix.iter().enumerate() {
            let filled = filled(entries);
            let pair = |&(_, own): &&(usize, [usize; 3])| own.iter().all(|k| filled.contains(k));
            let of_pair: Vec<&(usize, [usize; 3])> = lengths.iter().filter(pair).collect();
            let [(first, u), (second, w)] = of_pair[..] else {
                continue;
            };
            let crossed = (0..3).all(|k| is(entries[u[k]], w[k]) && is(entries[w[k]], u[k]));
            let taken = all.iter().any(|body| {
                let mut own = body.columns.iter();
                own.any(|columns| columns == u || columns == w)
            });
            if filled.len() == 6 && crossed && !taken {
                let axis = |columns: &[usize; 3]| {
                    Vector(columns.map(|k| unknowns[k].expect("its value agrees")))
                };
                all.push(Body {
                    columns: [*u, *w],
                    rows: [*first, *second, row],
                    axes: [axis(u), axis(w)],
                });
            }
        }
        Self::with(all, matrix.len())
    }

    fn with(all: Vec<Body<'m>>, size: usize) -> Self {
        let of_bodies: Vec<usize> = all.iter().flat_map(|body| body.rows).collect();
        let in_bodies: Vec<usize> = all.iter().flat_map(|body| body.columns.concat()).collect();
        let others =
            |taken: &[usize]| -> Vec<usize> { (0..size).filter(|k| !taken.contains(k)).collect() };
        let (rows, columns) = (others(&of_bodies), others(&in_bodies));
        // Turns and what is missed are of one volume with the components; the turns of all bodies stand before all that is missed.
        let between = 9 * all.len() * all.len().saturating_sub(1) / 2;
        let sign = parity(&[&rows[..], &of_bodies].concat())
            * parity(&[&columns[..], &in_bodies].concat())
            * if between.is_multiple_of(2) { 1.0 } else { -1.0 };
        Self {
            all,
            rows,
            columns,
            sign,
        }
    }

    /// The determinant of a system over that in the freedoms: 1 or -1.
    pub(crate) fn sign(&self) -> f64 {
        self.sign
    }

    /// A row by the freedoms.
    fn by_freedoms(&self, row: &[Ex<'m>]) -> Vec<Ex<'m>> {
        let others = self.columns.iter().map(|&k| row[k]);
        let turns = self.all.iter().flat_map(|body| body.by_turns(row).0);
        others.chain(turns).collect()
    }

    /// How the directions change to make up for what the equations of the bodies miss.
    pub(super) fn shifts(&self, right: &[Ex<'m>]) -> Vec<Shifts<'m>> {
        let shifts = self.all.iter().map(|body| {
            let ([p, q, r], [u, w]) = (body.rows.map(|row| right[row]), body.axes);
            let half = 0.5 * r;
            [p * u + half * w, q * w + half * u]
        });
        shifts.collect()
    }

    /// The turns among the freedoms.
    fn turns(&self, freedoms: &[Ex<'m>]) -> Vec<V3<'m>> {
        let (_, turns) = freedoms.split_at(self.columns.len());
        let turns = turns.as_chunks::<3>().0.iter();
        turns.map(|&turn| Vector(turn)).collect()
    }

    /// The unknowns from the freedoms, where directions change by `shifts` besides.
    pub(super) fn unknowns(&self, freedoms: &[Ex<'m>], shifts: &[Shifts<'m>]) -> Vec<Ex<'m>> {
        let mut all = vec![None; self.columns.len() + 6 * self.all.len()];
        let (others, turns) = freedoms.split_at(self.columns.len());
        for (&column, &own) in self.columns.iter().zip(others) {
            all[column] = Some(own);
        }
        let turns = turns.as_chunks::<3>().0.iter();
        for ((body, &turn), shifts) in self.all.iter().zip(turns).zip(shifts) {
            for (k, columns) in body.columns.iter().enumerate() {
                let turned = Vector(turn).cross(body.axes[k]) + shifts[k];
                for (&column, own) in columns.iter().zip(turned.components()) {
                    all[column] = Some(own);
                }
            }
        }
        all.into_iter().flatten().collect()
    }
}

impl<'m> Body<'m> {
    /// Entries of a row as vectors.
    fn entries(&self, row: &[Ex<'m>]) -> [V3<'m>; 2] {
        self.columns.map(|columns| Vector(columns.map(|k| row[k])))
    }

    /// A row by the turns.
    pub(crate) fn by_turns(&self, row: &[Ex<'m>]) -> V3<'m> {
        let [u, w] = self.axes;
        let [by_u, by_w] = self.entries(row);
        u.cross(by_u) + w.cross(by_w)
    }
}

/// How the directions of a body change besides its turn.
pub(super) type Shifts<'m> = [V3<'m>; 2];

/// The solution of a system by a scheme.
pub(crate) struct SolvedByScheme<'m> {
    pub(crate) solution: Vec<Ex<'m>>,
    pub(crate) determinant: Ex<'m>,
    /// Of the bodies, if these do nothing but turn.
    pub(super) turns: Option<Vec<V3<'m>>>,
}

/// The solution where directions of bodies change besides, and the turns that are left.
pub(super) struct SolvedBeside<'m> {
    pub(super) solution: Vec<Ex<'m>>,
    pub(super) turns: Vec<V3<'m>>,
}

/// Solves a linear system by a scheme.
pub(crate) fn solve_by_scheme<'m>(
    algebra: &Algebra<'m>,
    scheme: &Scheme<'m>,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
) -> SolvedByScheme<'m> {
    let bodies = &scheme.bodies;
    let shifts = bodies.shifts(right);
    let known = bodies.rows.iter().map(|&row| {
        let own = bodies.all.iter().zip(&shifts);
        own.fold(right[row], |left, (body, shifts)| {
            let pairs = body.entries(&matrix[row]).into_iter().zip(shifts);
            pairs.fold(left, |left, (entries, &shift)| left - entries.dot(shift))
        })
    });
    let known: Vec<Ex> = known.collect();
    let InOrder {
        solution,
        determinant,
    } = pivots::solve_in_order(algebra, &scheme.order, &scheme.freedoms, &known);
    let still = shifts.iter().flatten().all(|shift| shift.is_zero());
    SolvedByScheme {
        turns: still.then(|| bodies.turns(&solution)),
        solution: bodies.unknowns(&solution, &shifts),
        determinant: bodies.sign * determinant,
    }
}

/// The same system where `left` is what shifts of directions leave of the right-hand side in the other equations.
pub(super) fn solve_left_by_scheme<'m>(
    algebra: &Algebra<'m>,
    scheme: &Scheme<'m>,
    shifts: &[Shifts<'m>],
    left: &[Ex<'m>],
) -> SolvedBeside<'m> {
    let bodies = &scheme.bodies;
    let left: Vec<Ex> = bodies.rows.iter().map(|&row| left[row]).collect();
    let freedoms = pivots::solve_in_order(algebra, &scheme.order, &scheme.freedoms, &left);
    SolvedBeside {
        solution: bodies.unknowns(&freedoms.solution, shifts),
        turns: bodies.turns(&freedoms.solution),
    }
}

/// Solves the transposed system: one number for each equation.
pub(crate) fn solve_transposed_by_scheme<'m>(
    algebra: &Algebra<'m>,
    scheme: &Scheme<'m>,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
) -> Vec<Ex<'m>> {
    let bodies = &scheme.bodies;
    let transposed: Vec<Vec<Ex>> = (0..scheme.freedoms.len())
        .map(|column| scheme.freedoms.iter().map(|row| row[column]).collect())
        .collect();
    let known = bodies.by_freedoms(right);
    let order = scheme.order.transposed();
    let others = pivots::solve_in_order(algebra, &order, &transposed, &known).solution;
    let mut all = vec![algebra.zero(); right.len()];
    for (&row, &own) in bodies.rows.iter().zip(&others) {
        all[row] = own;
    }
    for body in &bodies.all {
        let [mut by_u, mut by_w] = body.entries(right);
        for (&row, &own) in bodies.rows.iter().zip(&others) {
            let [of_u, of_w] = body.entries(&matrix[row]);
            (by_u, by_w) = (by_u - own * of_u, by_w - own * of_w);
        }
        let [u, w] = body.axes;
        let own = [by_u.dot(u), by_w.dot(w), 0.5 * (by_u.dot(w) + by_w.dot(u))];
        for (&row, own) in body.rows.iter().zip(own) {
            all[row] = own;
        }
    }
    all
}
