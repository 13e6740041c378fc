//! How large the determinant of a coupled group can become: what its margin is measured by.
//!
//! It is as large as it gets when every link and guide may point anywhere while the bodies between them stay where they are. So it follows from
//! the mechanism, not from the choice of unknowns, of loops, or of what is eliminated from them.

mod parts;
mod plane;

use crate::algebra::elimination;
use crate::algebra::partial;
use linkage_symbolic::{Ex, V3};

use crate::solve::Solver;
use crate::structure::{Block, Link, Private};

use super::equations::Equations;
use super::vector;

/// Nothing that the determinant of the core can be is larger.
pub(super) fn largest_core_determinant<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
) -> Ex<'m> {
    let blocks = &equations.form.blocks;
    if let Some(large) = &equations.large {
        // Of the links as they are, whatever was subtracted from them for derivatives.
        return large.share.abs() * product_of_sides(solver, &large.matrix);
    }
    if blocks.iter().all(|block| block.rows.len() == 2) {
        return plane::largest_in_plane(solver, equations);
    }
    if blocks.iter().all(|block| block.rows.len() == 3) {
        return product_of_columns(solver, equations);
    }
    let links: Option<Vec<&Link>> = blocks.iter().map(|b| b.distance.as_ref()).collect();
    match links {
        Some(links) => largest_of_links(solver, equations, &links),
        // What a scalar loop measures, nobody knows: the determinant without its signs changes with its scale as the determinant does.
        None => permanent(solver, &equations.matrix, (1 << equations.matrix.len()) - 1),
    }
}

/// Where what the links could do at most is too much to compute: a volume is at most the product of the lengths of its rows; and where all
/// rows have length 1, at most the product of the lengths of its columns, which is less where bodies are small beside their links.
fn product_of_sides<'m>(solver: &Solver<'_, 'm>, matrix: &[Vec<Ex<'m>>]) -> Ex<'m> {
    let product = |squares: &[Ex<'m>]| {
        let lengths = squares.iter().map(|square| square.sqrt());
        lengths.fold(solver.algebra.one(), |product, length| product * length)
    };
    let of_rows: Vec<Ex> = matrix
        .iter()
        .map(|row| elimination::product_sum(solver.algebra, row, row))
        .collect();
    let columns = (0..matrix.len()).map(|column| {
        let entries = matrix.iter().zip(&of_rows);
        let parts = entries.map(|(row, &square)| row[column].square() / square);
        parts.fold(solver.algebra.zero(), |sum, part| sum + part)
    });
    let of_columns = product(&columns.collect::<Vec<Ex>>());
    product(&of_rows) * of_columns.min(of_columns.number(1.0))
}

/// Loops of three rows: the volume of their columns is at most the product of their lengths.
fn product_of_columns<'m>(solver: &Solver<'_, 'm>, equations: &Equations<'_, 'm>) -> Ex<'m> {
    let columns = (0..equations.matrix.len()).map(|k| {
        let column: Vec<Ex> = equations.matrix.iter().map(|row| row[k]).collect();
        vector(&column).length()
    });
    columns.fold(solver.algebra.one(), |product, length| product * length)
}

/// Links in space, each of which may point anywhere. For one and two it is reached; for more it is the volume that the motions of their
/// ends span, of which links along those motions would leave all.
fn largest_of_links<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
    links: &[&Link<'m>],
) -> Ex<'m> {
    let ends: Vec<Vec<V3>> = links
        .iter()
        .zip(&equations.form.blocks)
        .map(|(link, block)| motions(solver, equations, link, block))
        .collect();
    if let [first, second] = &ends[..] {
        return largest_of_two(first, second);
    }
    let unknowns = 0..equations.form.core.len();
    let gram: Vec<Vec<Ex>> = unknowns
        .clone()
        .map(|a| {
            let entry = |b: usize| {
                let products = ends.iter().map(|columns| columns[a].dot(columns[b]));
                products.fold(solver.algebra.zero(), |sum, product| sum + product)
            };
            unknowns.clone().map(entry).collect()
        })
        .collect();
    elimination::determinant(solver.algebra, &gram).sqrt()
}

/// The derivatives of a link's vector, scaled as the columns of the core are.
fn motions<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
    link: &Link<'m>,
    block: &Block<'m>,
) -> Vec<V3<'m>> {
    let unknowns = equations.variables.iter().zip(&equations.form.core);
    let columns = unknowns.map(|(&variable, &core)| {
        let slope = link
            .vector
            .map(|x| partial::partial(solver.algebra, x, variable));
        equations.column_scale(block, core) * slope
    });
    columns.collect()
}

/// What the row of a loop across its private unknown is multiplied by, beside a row across a unit vector.
fn weight<'m>(solver: &Solver<'_, 'm>, equations: &Equations<'_, 'm>, block: &Block<'m>) -> Ex<'m> {
    match &block.private {
        Some(Private::Rotor(rotor)) => equations.scale * rotor.z.length(),
        Some(Private::Slide { guide, .. }) => guide.length_and_unit().0,
        None => solver.algebra.one(),
    }
}

/// The determinant without its signs, of the last rows and the columns in a set.
fn permanent<'m>(solver: &Solver<'_, 'm>, matrix: &[Vec<Ex<'m>>], columns: u32) -> Ex<'m> {
    let [row, below @ ..] = matrix else {
        return solver.algebra.one();
    };
    let mut sum = solver.algebra.zero();
    for (column, &entry) in row.iter().enumerate() {
        if columns >> column & 1 == 1 && !entry.is_zero() {
            sum += entry.abs() * permanent(solver, below, columns & !(1 << column));
        }
    }
    sum
}

/// The largest value of `(u.a)(v.d) - (u.b)(v.c)` for directions `u` and `v`: the larger singular value of `a d' - b c'`, from the sum of the squares
/// of both and from their product.
fn largest_of_two<'m>(first: &[V3<'m>], second: &[V3<'m>]) -> Ex<'m> {
    let ([a, b], [c, d]) = (first, second) else {
        unreachable!("two links, two unknowns")
    };
    let [a, b, c, d] = [*a, *b, *c, *d];
    let crossed = a.dot(b) * c.dot(d);
    let squares = a.square() * d.square() + b.square() * c.square() - 2.0 * crossed;
    let product = a.cross(b).length() * c.cross(d).length();
    // Rounding must not make a root of what is 0.
    let difference = (squares - 2.0 * product).max(squares.number(0.0));
    0.5 * ((squares + 2.0 * product).sqrt() + difference.sqrt())
}
