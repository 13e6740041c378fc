//! Bodies of the plane whose angles follow from the same unknown, for messages.

use crate::algebra::Algebra;
use crate::algebra::value::Atom;
use crate::diagnostic::text::list;
use crate::forces::geometry::BodyTurn;
use crate::forces::multibody::Multibody;

/// Describes the bodies whose angles follow from one unknown, if one of `concerned` is among
/// several such bodies; empty otherwise.
pub(super) fn described(algebra: &Algebra, bodies: &Multibody, concerned: &[usize]) -> String {
    let mechanism = algebra.mechanism;
    let angles = concerned
        .iter()
        .filter_map(|&body| only_angle(bodies, body));
    let groups = angles.map(|angle| {
        let turning = 0..mechanism.bodies.len();
        let group = turning.filter(|&body| only_angle(bodies, body) == Some(angle));
        (angle, group.collect::<Vec<usize>>())
    });
    let Some((angle, group)) = groups.into_iter().find(|(_, group)| group.len() > 1) else {
        return String::new();
    };
    let Some(unknown) = algebra.names.angles[angle].unknown else {
        return String::new();
    };
    let names: Vec<&str> = group
        .iter()
        .map(|&body| mechanism.bodies[body].name.as_str())
        .collect();
    format!(
        "; the angles of {} follow from one unknown, `{}`",
        list(&names),
        mechanism.unknowns[unknown].name
    )
}

/// The unknown angle of the algebra from which alone the angle of a body follows.
fn only_angle(bodies: &Multibody, body: usize) -> Option<usize> {
    let BodyTurn::Angle(angle) = &bodies.geometry.turning[body] else {
        return None;
    };
    match angle.terms[..] {
        [(Atom::Angle(angle), _)] => Some(angle),
        _ => None,
    }
}
