//! The greatest length of a vector of the plane whose parts turn: the measure of a margin.

use linkage_symbolic::{Ex, V2};

use crate::algebra::{Algebra, turning_parts};
use crate::solve::contour;
use crate::solve::group_context::GroupContext;

/// The margin of a group whose determinant is `h = sqrt(vector.vector - level^2)`: over the largest
/// value that it has for these lengths. Where nothing moves, and where it is not known how far (in
/// space), over the vector's length.
///
/// `h` is scaled, the others are not.
pub(super) fn root_margin<'m>(
    algebra: &Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    h: Ex<'m>,
    vector: V2<'m>,
    level: Ex<'m>,
    scale: Ex<'m>,
) -> Ex<'m> {
    // What leads to a point in several ways bounds it in each of them; the shortest way is the same
    // however the vector is written.
    let ways = if vector.is_fixed() {
        Vec::new()
    } else {
        contour::ways_to(
            algebra,
            group.earlier,
            contour::without_explicit(algebra, group.earlier, vector),
        )
    };
    let lengths = ways.into_iter().filter_map(|way| longest(algebra, way));
    let Some(longest) = lengths.reduce(|least, length| least.min(length)) else {
        return h / (scale * vector).length();
    };
    let longest = scale * longest;
    let largest = if level.is_fixed() {
        longest.difference_of_squares(scale * level).sqrt()
    } else {
        longest
    };
    // Where all is in line both are equal, apart from rounding.
    (h / largest).min(h.number(1.0))
}

/// The sum of the lengths of a vector's parts, if they can all point the same way: each turns, and
/// keeps its length.
fn longest<'m>(algebra: &Algebra<'m>, vector: V2<'m>) -> Option<Ex<'m>> {
    let parts = turning_parts::parts(&algebra.names, vector);
    let mut turning = parts.turning.iter().map(|(_, part)| part);
    let rigid = turning.all(|part| part.is_rotor() && part.arm().is_fixed());
    let arms = parts.turning.iter().map(|(_, part)| part.arm().length());
    (parts.rest_is_fixed && rigid)
        .then(|| arms.fold(parts.fixed.length(), |sum, length| sum + length))
}
