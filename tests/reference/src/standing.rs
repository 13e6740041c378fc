//! Whether a position can be assembled, as far as rounding lets anybody tell.

use crate::{Big, Kind, ROUNDOFF, System};

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
