//! Small linear systems by cofactors: no choice of pivots, which would be a branch.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, Graph};

/// The sum of products, of any number.
pub(crate) fn product_sum<'m>(graph: &'m Graph, a: &[Ex<'m>], b: &[Ex<'m>]) -> Ex<'m> {
    let pairs = a.iter().zip(b);
    pairs.fold(graph.number(0.0), |sum, (&x, &y)| sum + x * y)
}

/// The adjugate of a matrix times a vector: the solution of the linear system times the
/// determinant.
pub(crate) fn cofactor_products<'m>(
    graph: &'m Graph,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
) -> Vec<Ex<'m>> {
    let size = matrix.len();
    let all = (1_u32 << size) - 1;
    let mut minors = Minors::new(graph, matrix);
    let zero = graph.number(0.0);
    (0..size)
        .map(|column| {
            (0..size).fold(zero, |sum, row| {
                let minor = minors.minor(all & !(1 << row), all & !(1 << column));
                let product = minor * right[row];
                match (row + column) % 2 {
                    0 => sum + product,
                    _ => sum - product,
                }
            })
        })
        .collect()
}

/// Returns the solution for one right-hand side times the determinant, and the determinant, by
/// Cramer's rule. The right-hand side is a further column, so that fewer minors are needed than for
/// several.
pub(crate) fn cramer<'m>(
    graph: &'m Graph,
    matrix: &[Vec<Ex<'m>>],
    right: &[Ex<'m>],
) -> (Vec<Ex<'m>>, Ex<'m>) {
    let size = matrix.len();
    if size < 3 {
        // There is nothing to save.
        let numerators = cofactor_products(graph, matrix, right);
        return (numerators, determinant(graph, matrix));
    }
    let pairs = matrix.iter().zip(right);
    let wide: Vec<Vec<Ex>> = pairs
        .map(|(row, &known)| [&row[..], &[known]].concat())
        .collect();
    let mut minors = Minors::new(graph, &wide);
    let (rows, all) = ((1_u32 << size) - 1, (1_u32 << (size + 1)) - 1);
    let numerators = (0..size).map(|column| {
        // The last column instead of this one: behind those that it passes.
        let minor = minors.minor(rows, all & !(1 << column));
        match (size - 1 - column) % 2 {
            0 => minor,
            _ => -minor,
        }
    });
    let numerators = numerators.collect();
    (numerators, minors.minor(rows, rows))
}

pub(crate) fn determinant<'m>(graph: &'m Graph, matrix: &[Vec<Ex<'m>>]) -> Ex<'m> {
    let all = (1_u32 << matrix.len()) - 1;
    Minors::new(graph, matrix).minor(all, all)
}

/// The minors of a matrix that are known already.
struct Minors<'a, 'm> {
    graph: &'m Graph,
    matrix: &'a [Vec<Ex<'m>>],
    /// Minors by the sets of rows and of columns, as bits.
    known: Map<(u32, u32), Ex<'m>>,
}

impl<'a, 'm> Minors<'a, 'm> {
    fn new(graph: &'m Graph, matrix: &'a [Vec<Ex<'m>>]) -> Self {
        Self {
            graph,
            matrix,
            known: Map::new(),
        }
    }

    /// The determinant of the rows and columns in two sets, by its first row.
    fn minor(&mut self, rows: u32, columns: u32) -> Ex<'m> {
        if rows == 0 {
            return self.graph.number(1.0);
        }
        if let Some(&minor) = self.known.get(&(rows, columns)) {
            return minor;
        }
        let row = rows.trailing_zeros() as usize;
        let mut sum = self.graph.number(0.0);
        let among = (0..self.matrix[row].len()).filter(|&column| columns >> column & 1 == 1);
        for (index, column) in among.enumerate() {
            let below = self.minor(rows & !(1 << row), columns & !(1 << column));
            let product = self.matrix[row][column] * below;
            sum = match index % 2 {
                0 => sum + product,
                _ => sum - product,
            };
        }
        self.known.insert((rows, columns), sum);
        sum
    }
}
