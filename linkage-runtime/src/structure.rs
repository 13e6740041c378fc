//! The structure that the compiler found in a mechanism.

use crate::data::Operations;
#[cfg(feature = "alloc")]
use alloc::string::String;
use core::fmt;
use linkage_core::format::{join, numbers, printed};
#[cfg(feature = "alloc")]
use linkage_core::range_check::joints_or_loops;

/// The structure of a mechanism: its Assur groups in the order in which they are solved, and the
/// cost of each generated function.
///
/// ```
/// use linkage_runtime::{Group, Operations, Structure};
///
/// const FOUR_BAR: Structure = Structure {
///     mobility: 1,
///     groups: &[Group {
///         class: 2,
///         order: 2,
///         kind: "RRR",
///         loops: &[1],
///         joints: "",
///         unknowns: &["theta", "psi"],
///         mode: Some(0),
///         method: "closed form",
///     }],
///     functions: &[],
///     prepare: Operations { add: 3, mul: 4, div: 0, sqrt: 0, sin_cos: 0, atan2: 0, other: 0 },
/// };
/// assert_eq!(
///     FOUR_BAR.to_string(),
///     "mobility 1\n\
///      group  kind  class  order  mode  loops  unknowns    method\n\
///      1      RRR   2      2      0     1      theta, psi  closed form\n\
///      assemble: 7 operations (3 add, 4 mul)\n"
/// );
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Structure {
    /// Number of independent inputs that the mechanism needs.
    pub mobility: usize,
    /// The groups, each depending on inputs and earlier groups only.
    pub groups: &'static [Group],
    /// The generated functions.
    pub functions: &'static [FunctionInfo],
    /// The part that `assemble()` computes once from the parameters.
    pub prepare: Operations,
}

/// An Assur group: equations that are solved together for as many unknowns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Group {
    /// Class; 0 where the word does not apply (an angle relation).
    pub class: u8,
    /// Order; 0 where the word does not apply.
    pub order: u8,
    /// Its joints, such as `RRR`.
    pub kind: &'static str,
    /// Its loops, the first loop of the mechanism being 1.
    pub loops: &'static [usize],
    /// The joints and links that its loops stand for: ``joint `c` of `rocker` ``. Empty if all of
    /// them are written as loops.
    pub joints: &'static str,
    /// The unknowns that it determines.
    pub unknowns: &'static [&'static str],
    /// Index among the assembly's modes; `None` for a group with one solution.
    pub mode: Option<usize>,
    /// The closed form, or its absence.
    pub method: &'static str,
}

#[cfg(feature = "alloc")]
impl Group {
    /// Returns the joints and links that its loops stand for, or the numbers of the loops:
    /// `loops 2 and 3`.
    #[must_use]
    pub fn loop_names(&self) -> String {
        joints_or_loops(self.joints, self.loops)
    }
}

/// A generated function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FunctionInfo {
    /// Its name.
    pub name: &'static str,
    /// The operations for one position.
    pub operations: Operations,
}

/// A table of the groups, then the operation counts.
impl fmt::Display for Structure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "mobility {}", self.mobility)?;
        if !self.groups.is_empty() {
            groups(f, self.groups)?;
        }
        cost(f, "assemble", &self.prepare)?;
        self.functions
            .iter()
            .try_for_each(|function| cost(f, function.name, &function.operations))
    }
}

fn groups(f: &mut fmt::Formatter<'_>, groups: &[Group]) -> fmt::Result {
    let width = |title: &str, cell: &dyn Fn(&Group) -> usize| {
        groups.iter().map(cell).fold(title.len(), usize::max)
    };
    let kinds = width("kind", &|group| group.kind.len());
    let linked = groups.iter().any(|group| !group.joints.is_empty());
    let title = if linked { "joints" } else { "loops" };
    let loops = width(title, &|group| length(&loops_of(group)));
    let unknowns = width("unknowns", &|group| length(&join(group.unknowns, ", ")));

    writeln!(
        f,
        "group  {:kinds$}  class  order  mode  {title:loops$}  {:unknowns$}  method",
        "kind", "unknowns"
    )?;
    for (index, group) in groups.iter().enumerate() {
        write!(f, "{:<5}  {:kinds$}  ", index + 1, group.kind)?;
        write!(f, "{:<5}  {:<5}  ", group.class, group.order)?;
        match group.mode {
            Some(mode) => write!(f, "{mode:<4}  ")?,
            None => write!(f, "-     ")?,
        }
        padded(f, &loops_of(group), loops)?;
        padded(f, &join(group.unknowns, ", "), unknowns)?;
        writeln!(f, "{}", group.method)?;
    }
    Ok(())
}

/// The joints of a group, or the numbers of its loops.
fn loops_of(group: &Group) -> impl fmt::Display {
    let Group { joints, loops, .. } = *group;
    printed(move |f| match joints {
        "" => write!(f, "{}", numbers(loops, ", ")),
        _ => f.write_str(joints),
    })
}

fn cost(f: &mut fmt::Formatter<'_>, name: &str, operations: &Operations) -> fmt::Result {
    let total = operations.total();
    writeln!(f, "{name}: {total} operations ({operations})")
}

/// A cell and the blank columns up to the next one.
fn padded(f: &mut fmt::Formatter<'_>, cell: &dyn fmt::Display, width: usize) -> fmt::Result {
    let blanks = width - length(cell) + 2;
    write!(f, "{cell}{:blanks$}", "")
}

/// Printed length, without a buffer.
fn length(cell: &dyn fmt::Display) -> usize {
    struct Counter(usize);
    impl fmt::Write for Counter {
        fn write_str(&mut self, s: &str) -> fmt::Result {
            self.0 += s.chars().count();
            Ok(())
        }
    }
    let mut counter = Counter(0);
    // The counter never refuses, and the cells print plain words and numbers.
    let _ = fmt::write(&mut counter, format_args!("{cell}"));
    counter.0
}
