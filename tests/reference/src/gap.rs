//! Distance of a group from its dead point, and whether a position can be assembled at all.

use crate::{Big, Kind, ROUNDOFF, Space, System};

// How far a group is from its dead point, from the known sides alone.

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

/// For a bar of the given length between a point and a circle in space (its axis a unit vector): 0
/// where it reaches the nearest or the farthest point of the circle.
pub fn circle_gap(
    length: &Big,
    point: &Space,
    (centre, axis, radius): (&Space, &Space, &Big),
) -> Big {
    let from_centre = point.clone() - centre.clone();
    let height = from_centre.dot(axis);
    let distance = from_centre.cross(axis).norm();
    let at = |across: Big| (&across * &across + &height * &height).sqrt();
    let radius = radius.abs();
    let (nearest, farthest) = (at(&distance - &radius), at(&distance + &radius));
    let long = (length - &nearest) / (length + &nearest);
    let short = (&farthest - length) / (&farthest + length);
    if long < short { long } else { short }
}

/// For a bar of the given length between a point and a line: 0 where it is square to the line.
pub fn line_gap(length: &Big, point: &Space, (on_line, direction): (&Space, &Space)) -> Big {
    let from_line = point.clone() - on_line.clone();
    let distance = from_line.cross(direction).norm() / direction.norm();
    (length - &distance) / (length + &distance)
}

/// A point of the line in which two planes `normal . x = offset` meet, and its direction.
pub fn planes_line([one, two]: [(&Space, &Big); 2]) -> (Space, Space) {
    let direction = one.0.cross(two.0);
    let square = direction.dot(&direction);
    let sum = two.0.cross(&direction).times(one.1) + direction.cross(one.0).times(two.1);
    (sum.times(&(Big::one() / square)), direction)
}

// Whether a position can be assembled, as far as rounding lets anybody tell.

/// Within so many times the uncertainty of the gap itself a position may count as either side of
/// the dead point.
pub(crate) const GAP_ROUNDINGS: f64 = 40.0;

/// Whether a geometry can be assembled.
pub(crate) enum Standing {
    /// It can.
    Closed,
    /// It cannot.
    Apart,
    /// A change of some roundoffs decides.
    DeadPoint,
}

/// Tells it for all data of a position.
pub(crate) fn standing(system: &System, data: &[f64]) -> Standing {
    let exact: Vec<Big> = data.iter().map(|&x| Big::from(x)).collect();
    let gap = system.gap_at(&exact);
    let distance = gap.abs().to_f64();
    if distance < GAP_ROUNDINGS * gap_uncertainty(system, &exact, &gap) {
        Standing::DeadPoint
    } else if gap.is_negative() || gap.is_invalid() {
        Standing::Apart
    } else {
        Standing::Closed
    }
}

pub(crate) fn gap_uncertainty(system: &System, data: &[Big], gap: &Big) -> f64 {
    let mut sum = 1.0;
    for index in 0..data.len() {
        let step = (data[index].abs()
            + f64::from(u8::from(system.data[index].kind == Kind::Angle)))
            * Big::power_of_two(-200);
        let mut moved = data.to_vec();
        moved[index] = &moved[index] + step;
        let change = system.gap_at(&moved) - gap;
        sum += (change.abs() * Big::power_of_two(200)).to_f64();
    }
    sum * ROUNDOFF
}
