//! An angle equal to that of a known direction, or half a turn from it.

use std::f64::consts::{PI, TAU};

use linkage_symbolic::{Ex, Vector};

use crate::algebra::{Algebra, Scalar, nominal, scalar};
use crate::solve::closed::{ClosedForm, GapIn};
use crate::solve::group_context::GroupContext;
use crate::solve::{definitions, plane};

use super::plane::{defined_gap, where_finite};

/// `u = w e^(i value)`: no root, and the angle turns as the direction does.
pub(super) fn parallel_angle<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    angle: usize,
    value: &Scalar<'m>,
    arm: Ex<'m>,
) -> ClosedForm<'m> {
    let w = definitions::mode_sign(algebra, group);
    let unit = scalar::direction(&mut algebra.names, value);
    let Vector([cos, sin]) = unit.map(|x| w * x);
    let number = scalar::value_of(&algebra.names, value);
    let number = number + turns_to_estimate(algebra, group, angle, number, w);
    definitions::define_relation(algebra, angle, [cos, sin, number]);
    let (zero, one) = (algebra.zero(), algebra.one());
    plane::push_single(algebra, Vec::new(), one);
    ClosedForm {
        kind: "angle relation".into(),
        class: 0,
        order: 0,
        method: "sum of angles, or half a turn more",
        two_modes: true,
        margin: one,
        slack: where_finite(one, &[value.rest]),
        slack_scale: one,
        gap: defined_gap(where_finite(zero, &[value.rest]), arm),
        gap_in: GapIn::Loop,
    }
}

/// Returns the whole or half turns from the direction's angle to the one nearest to the estimate.
fn turns_to_estimate<'m>(
    algebra: &Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    angle: usize,
    number: Ex<'m>,
    w: Ex<'m>,
) -> Ex<'m> {
    let estimate = algebra.names.angles[angle].estimate(group.nominal);
    let values = nominal::at_estimates(&algebra.names, group.nominal, &[number]);
    let apart = estimate - values[0];
    let [same, opposite] = [0.0, PI].map(|half| {
        let turns = ((apart - half) / TAU).round();
        if turns.is_finite() {
            half + turns * TAU
        } else {
            half
        }
    });
    0.5 * (same + opposite) + 0.5 * (same - opposite) * w
}
