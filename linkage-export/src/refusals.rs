//! The reasons for which assembling fails, and the texts for them.

use linkage_compiler::ir::{CompiledMechanism, Group};
use linkage_core::range_check::joints_or_loops;

/// A reason for which a mechanism is not assembled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The cause.
    pub cause: RefusalCause,
    /// The end of the name of a constant: `loop_1_cannot_close`.
    pub name: String,
    /// The cause as a text.
    pub text: String,
}

/// The cause of a refusal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RefusalCause {
    /// A dimension, by its scalar, is NaN or infinite.
    NotFinite(usize),
    /// A group's links do not reach each other.
    CannotClose(usize),
    /// A group has no solution in numbers.
    Undefined(usize),
    /// A number computed from a dimension overflows.
    TooLarge,
    /// An angle, among those that are followed, cannot be followed through the ranges.
    NoTurns(usize),
    /// The table of a coupled group, by its number among them, does not serve these dimensions.
    TooFar(usize),
}

/// Returns all refusals of a mechanism, in the order in which languages number them.
pub fn refusals(unit: &CompiledMechanism) -> Vec<Refusal> {
    let mut refusals = Vec::new();
    let mut add = |cause, name: String, text: String| {
        refusals.push(Refusal { cause, name, text });
    };
    let mut needed: Vec<usize> = unit
        .groups
        .iter()
        .flat_map(|group| group.parameters.clone())
        .collect();
    needed.sort_unstable();
    needed.dedup();
    let scalars: Vec<_> = unit.scalars().collect();
    for dimension in needed {
        let name = scalars.get(dimension).map_or("", |scalar| &scalar.name[..]);
        add(
            RefusalCause::NotFinite(dimension),
            format!("{name}_not_finite"),
            format!("the dimension {name} is no finite number"),
        );
    }
    for (index, group) in unit.groups.iter().enumerate() {
        let (name, subject) = (group_name(index, group), group_text(index, group));
        let gap = match &group.gap_unit[..] {
            "" => String::new(),
            unit => format!(", in {unit}"),
        };
        add(
            RefusalCause::CannotClose(index),
            format!("{name}_cannot_close"),
            format!(
                "{subject} cannot close at the reference input: by how much it misses stands in `miss`{gap}"
            ),
        );
        add(
            RefusalCause::Undefined(index),
            format!("{name}_undefined"),
            format!(
                "{subject} has no solution at the reference input: with these dimensions a root or an arc function is out of its range, \
                 a length is negative, something is divided by zero, or joints or guides coincide"
            ),
        );
    }
    if !unit.groups.is_empty() && !scalars.is_empty() {
        add(
            RefusalCause::TooLarge,
            "too_large".to_owned(),
            "a dimension is too large to be computed with: its square is beyond the largest number"
                .to_owned(),
        );
    }
    for (number, angle) in unit.angles.iter().enumerate() {
        let name = &unit.unknowns[angle.unknown].name;
        add(
            RefusalCause::NoTurns(number),
            format!("{name}_no_turns"),
            format!("the turns of {name} cannot be counted over the range of the input"),
        );
    }
    for (number, coupled) in unit.coupled.iter().enumerate() {
        let group = &unit.groups[coupled.group];
        let (name, subject) = (
            group_name(coupled.group, group),
            group_text(coupled.group, group),
        );
        add(
            RefusalCause::TooFar(number),
            format!("{name}_too_far"),
            format!(
                "{subject} is prepared as a table for the dimensions of the declaration, and these are too far from them for its Newton steps: \
                 a limit of exported C. Export it with these dimensions as defaults"
            ),
        );
    }
    refusals
}

/// Returns the loops of a group as a name: `loops_1_2`.
fn group_name(index: usize, group: &Group) -> String {
    let numbers: Vec<String> = group.loops.iter().map(|index| index.to_string()).collect();
    match &numbers[..] {
        [] => format!("group_{}", index + 1),
        [only] => format!("loop_{only}"),
        several => format!("loops_{}", several.join("_")),
    }
}

/// Returns the loops of a group, or the joints that they stand for, with its unknowns and its kind:
/// `loop 1 (theta, psi; RRR)`. `index` is that among all groups.
pub fn group_text(index: usize, group: &Group) -> String {
    let loops = match group.loops[..] {
        [] => format!("group {}", index + 1),
        _ => joints_or_loops(&group.joints, &group.loops),
    };
    let about = [group.unknowns.join(", "), group.kind.clone()];
    let about: Vec<String> = about
        .into_iter()
        .filter(|unknown| !unknown.is_empty())
        .collect();
    match about.is_empty() {
        true => loops,
        false => format!("{loops} ({})", about.join("; ")),
    }
}
