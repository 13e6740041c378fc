//! How far a dyad is from its dead point, from the known sides alone.

use crate::Big;

/// For two links of the given lengths between two points at the given distance: 0 where they fold
/// or stretch out.
pub fn triangle_gap(one: &Big, two: &Big, distance: &Big) -> Big {
    let (one, two) = (one.abs(), two.abs());
    let (sum, difference) = (&one + &two, (&one - &two).abs());
    let stretched = (&sum - distance) / &sum;
    let folded = (distance - &difference) / (distance + &difference);
    if stretched < folded {
        stretched
    } else {
        folded
    }
}

/// For a link whose end must lie at the given distance from its pivot's foot on a line: 0 where it
/// is square to it.
pub fn reach_gap(link: &Big, offset: &Big) -> Big {
    (link.abs() - offset.abs()) / (link.abs() + offset.abs())
}
