//! The results of `assemble`, and the texts for them.

use linkage_compiler::ir::{CompiledMechanism, Group};

use crate::c_names::plain;

/// A number that `assemble` may return.
#[derive(Clone, Debug)]
pub(crate) struct Code {
    pub(crate) why: Why,
    /// The name of the constant.
    pub(crate) name: String,
    pub(crate) text: String,
}

/// Why a mechanism is not assembled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Why {
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
    /// Numbers are not rounded to nearest.
    Rounding,
    /// Numbers have more or fewer digits than their type.
    Digits,
    /// Sums are computed in another order.
    Reordered,
}

impl Why {
    /// Returns true for findings of the test of the arithmetic.
    pub(crate) fn is_of_arithmetic(self) -> bool {
        OF_ARITHMETIC.iter().any(|(why, ..)| *why == self)
    }
}

/// The findings of the test of the arithmetic.
const OF_ARITHMETIC: [(Why, &str, &str); 3] = [
    (
        Why::Rounding,
        "rounding",
        "numbers are not rounded to nearest here: call fesetround(FE_TONEAREST) before assembling, and leave it so while functions are called",
    ),
    (
        Why::Digits,
        "digits",
        "numbers are computed with more or fewer digits than their type has: compile without -fsingle-precision-constant, for an x86 of 32 bits \
         with -msse2 -mfpmath=sse; where a double has 32 bits, export with --scalar float",
    ),
    (
        Why::Reordered,
        "reordered",
        "the compiler computes sums in another order, which makes positions wrong: compile without -funsafe-math-optimizations, \
         -fassociative-math and -ffast-math",
    ),
];

/// All that may happen to a mechanism, in the order of their numbers.
pub(crate) fn codes(title: &str, prefix: &str, unit: &CompiledMechanism) -> Vec<Code> {
    let mut codes = Vec::new();
    let mut add = |why: Why, name: &str, text: String| {
        let name = format!("{prefix}_{}", plain(&name.replace('.', "_"))).to_uppercase();
        let taken = codes.iter().any(|code: &Code| code.name == name);
        codes.push(Code {
            why,
            // Names that differ in the case of letters only.
            name: if taken {
                format!("{name}_{}", codes.len() + 1)
            } else {
                name
            },
            text: format!("{}: {text}", plain(title)),
        });
    };
    let mut needed: Vec<usize> = unit
        .groups
        .iter()
        .flat_map(|group| group.parameters.clone())
        .collect();
    needed.sort_unstable();
    needed.dedup();
    for dimension in needed {
        let name = unit
            .scalars()
            .nth(dimension)
            .map_or("", |scalar| &scalar.name[..]);
        let text = format!("the dimension {name} is no finite number");
        add(
            Why::NotFinite(dimension),
            &format!("{name}_not_finite"),
            text,
        );
    }
    for (index, group) in unit.groups.iter().enumerate() {
        let (name, subject) = (constant(index, group), group_text(index, group));
        let gap = match &group.gap_unit[..] {
            "" => String::new(),
            unit => format!(", in {unit}"),
        };
        let text = format!(
            "{subject} cannot close at the reference input: by how much it misses stands in `miss`{gap}"
        );
        add(
            Why::CannotClose(index),
            &format!("{name}_cannot_close"),
            text,
        );
        let text = format!(
            "{subject} has no solution at the reference input: with these dimensions a root or an arc function is out of its range, \
             a length is negative, something is divided by zero, or joints or guides coincide"
        );
        add(Why::Undefined(index), &format!("{name}_undefined"), text);
    }
    if !unit.groups.is_empty() && unit.scalars().next().is_some() {
        let text =
            "a dimension is too large to be computed with: its square is beyond the largest number";
        add(Why::TooLarge, "too_large", text.to_owned());
    }
    for (number, angle) in unit.angles.iter().enumerate() {
        let name = &unit.unknowns[angle.unknown].name;
        let text = format!("the turns of {name} cannot be counted over the range of the input");
        add(Why::NoTurns(number), &format!("{name}_no_turns"), text);
    }
    for (number, coupled) in unit.coupled.iter().enumerate() {
        let group = &unit.groups[coupled.group];
        let (name, subject) = (
            constant(coupled.group, group),
            group_text(coupled.group, group),
        );
        let text = format!(
            "{subject} is prepared as a table for the dimensions of the declaration, and these are too far from them for its Newton steps: \
             a limit of exported C. Export it with these dimensions as defaults"
        );
        add(Why::TooFar(number), &format!("{name}_too_far"), text);
    }
    for (why, name, text) in OF_ARITHMETIC {
        add(why, name, text.to_owned());
    }
    codes
}

/// `loops_1_2`
fn constant(index: usize, group: &Group) -> String {
    let numbers: Vec<String> = group.loops.iter().map(|index| index.to_string()).collect();
    match &numbers[..] {
        [] => format!("group_{}", index + 1),
        [only] => format!("loop_{only}"),
        several => format!("loops_{}", several.join("_")),
    }
}

/// `loop 1 (theta, psi; RRR)`
fn group_text(index: usize, group: &Group) -> String {
    let numbers: Vec<String> = group.loops.iter().map(|index| index.to_string()).collect();
    let loops = match &numbers[..] {
        [] => format!("group {}", index + 1),
        [only] => format!("loop {only}"),
        [first @ .., last] => format!("loops {} and {last}", first.join(", ")),
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
