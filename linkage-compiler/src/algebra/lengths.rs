//! Lengths of vectors, vectors known to have length 1, and what lengths were made of.

use linkage_symbolic::{NodeId, SymbolId, numerically_equal, numerically_equal_within, substitute};

use super::Algebra;

/// What rounding may add to the square of a direction.
const UNIT: f64 = 8.0 * f64::EPSILON;


    /// The length of a vector.
    pub(crate) fn length(algebra: &mut Algebra<'_>, v: &[NodeId]) -> NodeId {
        let length = match *v {
            [x, y] => algebra.graph.hypot(x, y),
            _ => {
                let square = algebra.sum_of_squares(v);
                algebra.graph.sqrt(square)
            }
        };
        algebra.norms.insert(length, v.to_vec());
        length
    }

    /// `v . v`
    pub(crate) fn sum_of_squares(algebra: &mut Algebra<'_>, v: &[NodeId]) -> NodeId {
        let zero = algebra.graph.zero();
        let square = v.iter().fold(zero, |sum, &x| {
            let x2 = algebra.graph.square(x);
            algebra.graph.add(sum, x2)
        });
        algebra.squares.insert(square, v.to_vec());
        square
    }

    /// A vector's length and the unit vector along it. Directions of the language are known to be unit vectors.
    pub(crate) fn length_and_unit<const N: usize>(
        algebra: &mut Algebra<'_>,
        v: [NodeId; N],
    ) -> (NodeId, [NodeId; N]) {
        if algebra.is_unit(&v) {
            return (algebra.graph.one(), v);
        }
        let length = algebra.length(&v);
        let unit = v.map(|x| algebra.graph.div(x, length));
        algebra.mark_unit(&unit);
        (length, unit)
    }

    /// The direction of a space vector. What has length 1 by its formula, as `(cos t, 0, sin t)`, is not divided.
    pub(crate) fn unit_vector(algebra: &mut Algebra<'_>, v: [NodeId; 3]) -> [NodeId; 3] {
        if !algebra.is_unit(&v) {
            let (square, one) = (algebra.sum_of_squares(&v), algebra.graph.one());
            if numerically_equal_within(&algebra.graph, square, one, UNIT) {
                algebra.mark_unit(&v);
            }
        }
        algebra.length_and_unit(v).1
    }

    /// Remembers that a vector has length 1.
    pub(crate) fn mark_unit(algebra: &mut Algebra<'_>, v: &[NodeId]) {
        let back: Vec<NodeId> = v.iter().map(|&x| algebra.graph.neg(x)).collect();
        if let ([x, y], [back_x, back_y]) = (v, &back[..]) {
            algebra.units.extend([vec![*back_y, *x], vec![*y, *back_x]]);
        }
        algebra.units.extend([v.to_vec(), back]);
    }

    /// True if a vector is known to have length 1.
    pub(crate) fn is_unit(algebra: &Algebra<'_>, v: &[NodeId]) -> bool {
        let constants: Option<Vec<f64>> = v.iter().map(|&x| algebra.graph.constant_value(x)).collect();
        match constants {
            Some(numbers) => {
                let square: f64 = numbers.iter().map(|x| x * x).sum();
                (square - 1.0).abs() <= 2.0 * f64::EPSILON
            }
            None => algebra.units.contains(v),
        }
    }

    /// True if two vectors are perpendicular and of one length. Not by a product that vanishes: rounded constants leave a rest of it, which
    /// is small only beside the squares.
    pub(crate) fn is_turned(algebra: &mut Algebra<'_>, a: &[NodeId], b: &[NodeId]) -> bool {
        let [first, second] = [a, b].map(|v| algebra.sum_of_squares(v));
        let pairs = a.iter().zip(b);
        let sum: Vec<NodeId> = pairs.map(|(&x, &y)| algebra.graph.add(x, y)).collect();
        let whole = algebra.sum_of_squares(&sum);
        let parts = algebra.graph.add(first, second);
        numerically_equal(&algebra.graph, first, second) && numerically_equal(&algebra.graph, whole, parts)
    }

    /// Lengths in `roots` stay known as lengths of vectors when symbols are replaced.
    pub(crate) fn substitute_norms(
        algebra: &mut Algebra<'_>,
        roots: &[NodeId],
        map: &linkage_symbolic::lookup::Map<SymbolId, NodeId>,
    ) {
        let Algebra {
            graph,
            norms,
            squares,
            ..
        } = algebra;
        for node in graph.reachable(roots) {
            for known in [&mut *norms, &mut *squares] {
                if let Some(vector) = known.get(&node) {
                    let all = [&[node], &vector[..]].concat();
                    let renewed = substitute(graph, &all, map);
                    known.insert(renewed[0], renewed[1..].to_vec());
                }
            }
        }
    }

