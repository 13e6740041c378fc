//! How long a vector of the plane can become when all that turns in it turns: what a margin is measured by.

use crate::algebra::parts;
use crate::solve::contour;
use linkage_symbolic::{Ex, V2};

use super::Solver;

/// The margin of a group whose determinant is `h = sqrt(vector.vector - level^2)`: over the largest value that it has for these lengths. Where
/// nothing moves, and where it is not known how far (in space), over the vector's length.
///
/// `h` is scaled, the others are not.
pub(super) fn root_margin<'m>(
    solver: &Solver<'_, 'm>,
    h: Ex<'m>,
    vector: V2<'m>,
    level: Ex<'m>,
    scale: Ex<'m>,
) -> Ex<'m> {
    // What leads to a point in several ways bounds it in each of them; the shortest way is the same however the vector is written.
    let ways = match vector.is_fixed() {
        true => Vec::new(),
        false => contour::ways_to(solver, contour::without_explicit(solver, vector)),
    };
    let lengths = ways.into_iter().filter_map(|way| longest(solver, way));
    let Some(longest) = lengths.reduce(|least, length| least.min(length)) else {
        return h / (scale * vector).length();
    };
    let longest = scale * longest;
    let largest = match level.is_fixed() {
        true => longest.difference_of_squares(scale * level).sqrt(),
        false => longest,
    };
    // Where all is in line both are equal but for rounding.
    (h / largest).min(h.number(1.0))
}

/// The sum of the lengths of a vector's parts, if they can all point the same way: each turns, and keeps its length.
fn longest<'m>(solver: &Solver<'_, 'm>, vector: V2<'m>) -> Option<Ex<'m>> {
    let parts = parts::parts(solver.algebra, vector);
    let mut turning = parts.turning.iter().map(|(_, part)| part);
    let rigid = turning.all(|part| part.is_rotor() && part.arm().is_fixed());
    let arms = parts.turning.iter().map(|(_, part)| part.arm().length());
    (parts.rest_is_fixed && rigid)
        .then(|| arms.fold(parts.fixed.length(), |sum, length| sum + length))
}
