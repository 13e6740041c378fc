//! Checks of friction on numbers: coefficients and lengths, joints in which nothing moves, friction
//! that may jam.

use linkage_symbolic::Ex;

use crate::algebra::{Algebra, Translate};
use crate::diagnostic::Reporter;
use crate::forces::context::Memo;
use crate::forces::multibody::Multibody;
use crate::forces::positions::{EQUAL, Positions};
use crate::forces::speeds::{AngularVelocities, Speeds};
use crate::forces::{friction, names, positions, springs};
use crate::message_format::MessageFormat;
use crate::model::{Contact, Expr, Friction};

/// Steps of the power iteration, which gives three digits of the factor.
const POWER_STEPS: usize = 60;

/// Reports negative coefficients and lengths, and friction in joints in which nothing moves.
pub(super) fn check_numbers<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    positions: &Positions,
    reporter: &mut Reporter,
) {
    for friction in &algebra.mechanism.frictions {
        let name = names::joint_name(algebra.mechanism, friction.joint);
        for (declared, what, help) in declared_numbers(friction) {
            let value = [algebra.translate_number(declared)];
            let reference = positions.iter().next();
            let value = reference.map(|position| positions::numbers(position, &value));
            if let Some(value) = value
                && value[0] < 0.0
            {
                let value = MessageFormat::new(algebra.mechanism).value(&declared.ty, &value);
                let fact = format!("the {what} of {name} is {value}");
                reporter.error_with_help(declared.origin, fact, help);
            }
        }
        if rests(algebra, bodies, turns, positions, friction) {
            let fact = format!("nothing moves in {name}: its friction has no sense");
            reporter.error_with_help(friction.origin, fact, "leave it out");
        }
    }
}

/// The numbers that are not negative, with their names and a help.
fn declared_numbers(friction: &Friction) -> Vec<(&Expr, &'static str, &'static str)> {
    let coefficient = (
        &friction.coefficient,
        "coefficient of friction",
        "the sense of friction follows from the speed: write the coefficient without its sign",
    );
    let length = match &friction.contact {
        Contact::Pin(radius) => Some((radius, "radius")),
        Contact::Guide(length) => length.as_ref().map(|length| (length, "block's length")),
    };
    let length = length.map(|(value, what)| (value, what, "write it without its sign"));
    std::iter::once(coefficient).chain(length).collect()
}

/// True if no input moves a joint at any position.
fn rests<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    positions: &Positions,
    friction: &Friction,
) -> bool {
    let mechanism = algebra.mechanism;
    let rates: Vec<Ex> = (0..mechanism.inputs.len())
        .map(|input| {
            let speeds = Speeds::unit_speed(mechanism, input);
            springs::joint_speed(algebra, bodies, turns, &speeds, friction.joint)
        })
        .collect();
    let numbers = positions.numbers(&rates);
    !numbers.is_empty() && numbers.iter().flatten().all(|rate| rate.abs() <= EQUAL)
}

/// Warns of the first position at which friction can cause more contact force than it needs.
pub(super) fn warn_of_jams<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    positions: &Positions,
    reporter: &mut Reporter,
) {
    let mechanism = algebra.mechanism;
    let count = mechanism.frictions.len();
    let mut components = Vec::new();
    for number in 0..count {
        let forces = friction::unit_forces(algebra, bodies, memo, number);
        let sums = forces.iter().map(|surfaces| {
            let zero = algebra.zero();
            surfaces
                .iter()
                .fold(zero, |sum, force| sum + force.square().sqrt())
        });
        components.extend(sums);
    }
    for position in positions.iter() {
        let numbers = positions::numbers(position, &components);
        let columns: Vec<&[f64]> = numbers.chunks(count.max(1)).collect();
        let (factor, joint) = growth(&columns);
        // NaN where the mechanism does not close, or where a number is an argument.
        if factor.is_nan() || factor < 1.0 {
            continue;
        }
        let friction = &mechanism.frictions[joint];
        let name = names::joint_name(mechanism, friction.joint);
        let at = positions::described(position, mechanism);
        let percent = 100.0 * factor;
        let fact = format!(
            "friction may jam: {at}a contact force in {name} causes up to {percent:.0} % of itself"
        );
        let help = "results are NaN where it jams; reduce the coefficient or the radius, or let the \
                    block be longer";
        reporter.warning_with_help(friction.origin, fact, help);
        return;
    }
}

/// The factor by which contact forces grow in a step from each to the friction of all, if all add
/// up, and the joint with the largest: the largest eigenvalue of a matrix given by columns.
fn growth(columns: &[&[f64]]) -> (f64, usize) {
    let mut sizes = vec![1.0; columns.len()];
    let mut factor = 0.0;
    for _ in 0..POWER_STEPS {
        // With the sizes themselves, so that they do not take turns.
        let mut next = sizes.clone();
        for (column, size) in columns.iter().zip(&sizes) {
            for (sum, share) in next.iter_mut().zip(*column) {
                *sum += share * size;
            }
        }
        let largest = next.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        factor = largest - 1.0;
        sizes = next.iter().map(|size| size / largest).collect();
    }
    let largest = (0..sizes.len()).max_by(|&a, &b| sizes[a].total_cmp(&sizes[b]));
    let sum: f64 = sizes.iter().sum();
    (factor + 0.0 * sum, largest.unwrap_or_default())
}
