//! The largest determinant of a coupled group: the measure of its margin.
//!
//! The determinant is largest when every link and guide may point anywhere while the bodies between
//! them stay where they are. The value follows from the mechanism, not from the choice of unknowns,
//! of loops, or of eliminated unknowns.

mod parts;
mod plane;
use linkage_symbolic::{Ex, V3};

use crate::algebra::{Algebra, cofactors, derivatives::partial};
use crate::structure::{Block, SpaceLink};

use super::equations::{Equations, vector};

/// Nothing that the determinant of the core can be is larger.
pub(super) fn largest_core_determinant<'m>(
    algebra: &mut Algebra<'m>,
    equations: &Equations<'_, 'm>,
) -> Ex<'m> {
    let blocks = &equations.form.blocks;
    if let Some(large) = &equations.large {
        // Of the links as they are, whatever was subtracted from them for derivatives.
        return large.share.abs() * product_of_sides(algebra, &large.matrix);
    }
    if blocks.iter().all(|block| block.rows.len() == 2) {
        return plane::largest_in_plane(algebra, equations);
    }
    if blocks.iter().all(|block| block.rows.len() == 3) {
        return product_of_columns(algebra, equations);
    }
    let links: Option<Vec<&SpaceLink>> = blocks.iter().map(|b| b.distance.as_ref()).collect();
    match links {
        Some(links) => largest_of_links(algebra, equations, &links),
        // What a scalar loop measures, nobody knows: the determinant without its signs changes with
        // its scale as the determinant does.
        None => permanent(
            algebra,
            &equations.matrix,
            (1 << equations.matrix.len()) - 1,
        ),
    }
}

/// A bound for links whose largest determinant is too expensive. A volume is at most the product of
/// the lengths of its rows. If all rows have length 1, it is at most the product of the lengths of
/// its columns, which is less if bodies are small compared with their links.
fn product_of_sides<'m>(algebra: &Algebra<'m>, matrix: &[Vec<Ex<'m>>]) -> Ex<'m> {
    let product = |squares: &[Ex<'m>]| {
        let lengths = squares.iter().map(|square| square.sqrt());
        lengths.fold(algebra.one(), |product, length| product * length)
    };
    let of_rows: Vec<Ex> = matrix
        .iter()
        .map(|row| cofactors::product_sum(algebra.graph, row, row))
        .collect();
    let columns = (0..matrix.len()).map(|column| {
        let entries = matrix.iter().zip(&of_rows);
        let parts = entries.map(|(row, &square)| row[column].square() / square);
        parts.fold(algebra.zero(), |sum, part| sum + part)
    });
    let of_columns = product(&columns.collect::<Vec<Ex>>());
    product(&of_rows) * of_columns.min(of_columns.number(1.0))
}

/// Loops of three rows: the volume of their columns is at most the product of their lengths.
fn product_of_columns<'m>(algebra: &Algebra<'m>, equations: &Equations<'_, 'm>) -> Ex<'m> {
    let columns = (0..equations.matrix.len()).map(|k| {
        let column: Vec<Ex> = equations.matrix.iter().map(|row| row[k]).collect();
        vector(&column).length()
    });
    columns.fold(algebra.one(), |product, length| product * length)
}

/// Links in space, each of which may point anywhere. For one and two it is reached; for more it is
/// the volume that the motions of their ends span, of which links along those motions would leave
/// all.
fn largest_of_links<'m>(
    algebra: &mut Algebra<'m>,
    equations: &Equations<'_, 'm>,
    links: &[&SpaceLink<'m>],
) -> Ex<'m> {
    let ends: Vec<Vec<V3>> = links
        .iter()
        .zip(&equations.form.blocks)
        .map(|(link, block)| motions(algebra, equations, link, block))
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
                products.fold(algebra.zero(), |sum, product| sum + product)
            };
            unknowns.clone().map(entry).collect()
        })
        .collect();
    cofactors::determinant(algebra.graph, &gram).sqrt()
}

/// The derivatives of a link's vector, scaled as the columns of the core are.
fn motions<'m>(
    algebra: &mut Algebra<'m>,
    equations: &Equations<'_, 'm>,
    link: &SpaceLink<'m>,
    block: &Block<'m>,
) -> Vec<V3<'m>> {
    let unknowns = equations.variables.iter().zip(&equations.form.core);
    let columns = unknowns.map(|(&variable, &core)| {
        let slope = link.vector.map(|x| partial::partial(algebra, x, variable));
        equations.column_scale(block, core) * slope
    });
    columns.collect()
}

/// The determinant without its signs, of the last rows and the columns in a set.
fn permanent<'m>(algebra: &Algebra<'m>, matrix: &[Vec<Ex<'m>>], columns: u32) -> Ex<'m> {
    let [row, below @ ..] = matrix else {
        return algebra.one();
    };
    let mut sum = algebra.zero();
    for (column, &entry) in row.iter().enumerate() {
        if columns >> column & 1 == 1 && !entry.is_zero() {
            sum += entry.abs() * permanent(algebra, below, columns & !(1 << column));
        }
    }
    sum
}

/// The largest value of `(u.a)(v.d) - (u.b)(v.c)` for directions `u` and `v`: the larger singular
/// value of `a d' - b c'`, from the sum of the squares of both and from their product.
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
